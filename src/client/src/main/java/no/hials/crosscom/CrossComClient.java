package no.hials.crosscom;

import java.io.Closeable;
import java.io.IOException;
import java.net.InetAddress;
import java.net.SocketException;
import java.net.UnknownHostException;
import java.time.Duration;
import java.util.Arrays;
import java.util.List;
import java.util.Objects;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.Executor;
import java.util.concurrent.ThreadPoolExecutor;
import java.util.concurrent.locks.ReentrantLock;
import java.util.function.Consumer;
import no.hials.crosscom.KRL.KRLAny;
import no.hials.crosscom.KRL.KRLArray;
import no.hials.crosscom.KRL.KRLRealArray;
import no.hials.crosscom.KRL.KRLVariable;
import no.hials.crosscom.KRL.structs.KRLE6Axis;
import no.hials.crosscom.KRL.structs.KRLStruct;
import no.hials.crosscom.c3.ControllerFiles;
import no.hials.crosscom.c3.Information;
import no.hials.crosscom.c3.Motion;
import no.hials.crosscom.c3.Pendant;
import no.hials.crosscom.c3.Programs;
import no.hials.crosscom.internal.Cancellation;
import no.hials.crosscom.internal.c3.C3Files;
import no.hials.crosscom.internal.c3.C3Information;
import no.hials.crosscom.internal.c3.C3Motion;
import no.hials.crosscom.internal.c3.C3Pendant;
import no.hials.crosscom.internal.c3.C3Programs;
import no.hials.crosscom.protocol.Codec;
import no.hials.crosscom.protocol.MessageType;
import no.hials.crosscom.protocol.value.KrlValue;
import org.jspecify.annotations.Nullable;

/**
 * Reads and writes the variables of a KUKA robot controller on which KUKAVARPROXY or C3 Bridge
 * Interface runs.
 *
 * <p><b>A write can move a machine.</b> The client never repeats a write; if its outcome is
 * unknown, {@link CrossComException#isOutcomeUnknown} says so.
 *
 * <p>The client can be used by several threads: exchanges take place one at a time, in the order in
 * which they were asked for. The variables handed to it are for one thread at a time. A call blocks
 * until the answer is there: once its turn has come for the request time-out at most, if the
 * connection has to be made anew for the connect time-out too, and if a read is repeated for both
 * again.
 *
 * <p>A refused access or an unreadable value leaves the connection usable. After a time-out, a
 * broken connection or an answer that is not one, the connection is closed, and the next call makes
 * a new one, unless {@link ClientConfig#reconnect} says otherwise. A read that was under way when
 * the connection broke is repeated once; a write never is.
 *
 * <p>The client finds out by itself which of the two servers there is, when that matters, and uses
 * what it has: on C3 Bridge, texts beyond ISO 8859-1, messages for several variables, and the
 * objects that {@link #programs}, {@link #motion}, {@link #pendant}, {@link #files} and {@link
 * #information} give.
 *
 * <p>The client runs these daemon threads, where PORT is the server's: {@code
 * crosscom-watchdog-PORT} enforces the time-out; {@code crosscom-keepalive-PORT} uses the
 * connection when the program does not; {@code crosscom-events-PORT} calls the {@link
 * ConnectionListener}, {@code crosscom-async-PORT} does what the {@code ...Async} methods were
 * asked for, {@code crosscom-files-PORT} does so for transfers of files, and {@code
 * crosscom-callback-PORT} runs what the program does with the results, all four only while there is
 * something to do. Each {@link Watch} has threads of its own.
 */
public final class CrossComClient implements Closeable {
  private final ClientConfig config;
  private final ReconnectingConnection connection;
  private final ThreadPoolExecutor async;
  private final ThreadPoolExecutor transfers;
  private final Executor callbacks;
  private final Set<Watch> watches;
  private final ReentrantLock transferTurn;
  private final C3Channel channel;
  private final VariableExchange variables;
  private final Programs programs;
  private final Motion motion;
  private final Pendant pendant;
  private final ControllerFiles files;
  private final Information information;

  /**
   * Connects, with the default times: 5 s for connecting, 3 s for a request.
   *
   * @param host name or address of the controller
   * @param port the server's port, 1 to 65535, usually 7000
   * @throws CrossComConnectException if the host is unknown or no connection could be made
   * @throws UnknownHostException never; declared for programs of the original, which catch it. See
   *     {@link CrossComConnectException}
   * @throws IOException only as one of the above
   */
  public CrossComClient(String host, int port) throws UnknownHostException, IOException {
    this(ClientConfig.create(host, cfg -> cfg.port(port)));
  }

  /**
   * Connects.
   *
   * @param config what to connect to, and how
   * @throws CrossComConnectException if the host is unknown or no connection could be made
   */
  public CrossComClient(ClientConfig config) throws CrossComException {
    this.config = Objects.requireNonNull(config, "config");
    this.connection = new ReconnectingConnection(config);
    this.async = Threads.lazy("crosscom-async-" + config.port());
    this.transfers = Threads.lazy("crosscom-files-" + config.port());
    this.callbacks = Threads.forCallbacks("crosscom-callback-" + config.port());
    this.watches = ConcurrentHashMap.newKeySet();
    this.transferTurn = new ReentrantLock(true);
    this.channel = new C3Channel(connection, transfers, callbacks);
    this.variables = new VariableExchange(config, connection, channel, Cancellation.NEVER);
    this.programs = new C3Programs(channel);
    this.motion = new C3Motion(channel);
    this.pendant = new C3Pendant(channel);
    this.files = new C3Files(channel, transferTurn);
    this.information = new C3Information(channel);
    connection.start();
  }

  /** Creates a view of a client that commits a call before its first exchange. */
  private CrossComClient(CrossComClient client, Cancellation call) {
    this.config = client.config;
    this.connection = client.connection;
    this.async = client.async;
    this.transfers = client.transfers;
    this.callbacks = client.callbacks;
    this.watches = client.watches;
    this.transferTurn = client.transferTurn;
    this.channel = client.channel.forCall(call);
    this.variables = new VariableExchange(config, connection, channel, call);
    this.programs = new C3Programs(channel);
    this.motion = new C3Motion(channel);
    this.pendant = new C3Pendant(channel);
    this.files = new C3Files(channel, transferTurn);
    this.information = new C3Information(channel);
  }

  /**
   * Gives the configuration.
   *
   * @return what the client was made with
   */
  public ClientConfig getConfig() {
    return config;
  }

  /**
   * Finds out which server there is. It is asked at the first need only, once for each connection;
   * the other methods do so too where they have to know.
   *
   * @return the server of the connection that there is
   * @throws CrossComException if an exchange failed
   */
  public Server getServer() throws IOException {
    return channel.find("request for the kind of server", ServerDetector::server);
  }

  /**
   * Gives what selects, starts and stops programs. It needs C3 Bridge.
   *
   * @return always the same object; on KUKAVARPROXY its methods throw {@link
   *     CrossComUnsupportedException}
   */
  public Programs programs() {
    return programs;
  }

  /**
   * Gives what moves the robot to positions. It needs C3 Bridge.
   *
   * @return always the same object; on KUKAVARPROXY its methods throw {@link
   *     CrossComUnsupportedException}
   */
  public Motion motion() {
    return motion;
  }

  /**
   * Gives what presses keys of the teach pendant. It needs C3 Bridge.
   *
   * @return always the same object; on KUKAVARPROXY its methods throw {@link
   *     CrossComUnsupportedException}
   */
  public Pendant pendant() {
    return pendant;
  }

  /**
   * Gives what works with the files of the controller. It needs C3 Bridge.
   *
   * @return always the same object; on KUKAVARPROXY its methods throw {@link
   *     CrossComUnsupportedException}
   */
  public ControllerFiles files() {
    return files;
  }

  /**
   * Gives what asks the server about itself, and confirms messages. It needs C3 Bridge.
   *
   * @return always the same object; on KUKAVARPROXY its methods throw {@link
   *     CrossComUnsupportedException}
   */
  public Information information() {
    return information;
  }

  /**
   * Reads a variable of the controller into its local copy.
   *
   * @param variable names what to read and gets the value; as it was if reading fails
   * @throws CrossComAccessException if the controller refused, as for an unknown name
   * @throws CrossComValueException if what came is not of the variable's type
   * @throws CrossComException if the exchange failed
   */
  public void readVariable(KRLVariable variable) throws IOException {
    variables.read(variable);
  }

  /**
   * Writes the local copy of a variable to the controller, and updates it from the answer.
   *
   * <p>A structure is written whole; fields never set are written as 0.0. A whole array is written
   * element by element, one access each, in order.
   *
   * @param variable names what to write and has the value
   * @throws CrossComAccessException if the controller refused, as for a read-only variable; of an
   *     array, the elements before the named one were written
   * @throws CrossComValueException if the text is too long to be sent
   * @throws CrossComException if the exchange failed
   * @throws IllegalStateException if the variable has no value
   */
  public void writeVariable(KRLVariable variable) throws IOException {
    variables.write(variable);
  }

  /**
   * Writes some fields of a structure; the controller leaves the others as they are.
   *
   * @param struct names what to write and has the values
   * @param fields names of its fields, at least one
   * @throws CrossComAccessException if the controller refused
   * @throws CrossComException if the exchange failed
   * @throws IllegalArgumentException if there is no such field or it has no value
   */
  public void writeFields(KRLStruct struct, String... fields) throws IOException {
    variables.write(struct, struct.getStringValueOf(fields));
  }

  /**
   * Reads a whole array: in one access if the server can, else element by element if the array
   * knows how many there are.
   *
   * @param array names what to read and gets the elements; as it was if reading fails
   * @param progress hears how far it has come, if it goes element by element
   * @throws CrossComAccessException if the controller refused; {@link
   *     CrossComException#getElementsDone} says how far it had come
   * @throws CrossComValueException if what came is not of the array's type
   * @throws CrossComException if an exchange failed
   */
  public void readVariable(KRLArray array, ArrayProgress progress) throws IOException {
    variables.read(array, progress);
  }

  /**
   * Writes a whole array, element by element in order.
   *
   * @param array names what to write and has the elements
   * @param progress hears how far it has come
   * @throws CrossComAccessException if the controller refused an element; those before it were
   *     written, and {@link CrossComException#getElementsDone} says how many
   * @throws CrossComException if an exchange failed
   * @throws IllegalStateException if the array has no value
   */
  public void writeVariable(KRLArray array, ArrayProgress progress) throws IOException {
    variables.write(array, progress);
  }

  /**
   * Reads several variables: from C3 Bridge 1.2 or later in as few messages as they fit into, from
   * any other server one after the other, in order.
   *
   * <p>One that the controller refuses, or whose value is of another type, does not keep the others
   * from being read. If an exchange fails, so do all variables that it was for, and those behind
   * them are not tried. An array that cannot be read whole is read element by element, as by {@link
   * #readVariable(KRLArray, ArrayProgress)}.
   *
   * @param several what to read
   * @return what came of each, in the same order
   */
  public List<VariableResult> readVariables(List<? extends KRLVariable> several) {
    return variables.readAll(several);
  }

  /**
   * Reads several variables, as {@link #readVariables(List)}.
   *
   * @param several what to read
   * @return what came of each, in the same order
   */
  public List<VariableResult> readVariables(KRLVariable... several) {
    return readVariables(Arrays.asList(several));
  }

  /**
   * Writes several variables in order: to C3 Bridge 1.3 or later in as few messages as they fit
   * into, to any other server one after the other. An array takes a message for each element.
   *
   * <p>One that the controller refuses does not keep the others from being written. If an exchange
   * fails, the outcome of all variables that it was for may be unknown, and those behind them are
   * not tried.
   *
   * @param several what to write
   * @return what came of each, in the same order
   * @throws IllegalStateException if one has no value; nothing was written then
   */
  public List<VariableResult> writeVariables(List<? extends KRLVariable> several) {
    return variables.writeAll(several);
  }

  /**
   * Writes several variables, as {@link #writeVariables(List)}.
   *
   * @param several what to write
   * @return what came of each, in the same order
   * @throws IllegalStateException if one has no value; nothing was written then
   */
  public List<VariableResult> writeVariables(KRLVariable... several) {
    return writeVariables(Arrays.asList(several));
  }

  /**
   * Reads variables again and again.
   *
   * @param watchConfig what to read, and how often
   * @param listener takes the samples, in a thread of its own; more can be added
   * @return the watch, which runs already; it is to be closed
   */
  public Watch watch(WatchConfig watchConfig, Consumer<? super Sample> listener) {
    Watch watch = new Watch(variables, connection, watchConfig, watches::remove);
    watches.add(watch);
    watch.addListener(listener);
    watch.start();
    if (isClosed()) {
      watch.close();
    }
    return watch;
  }

  /**
   * Reads variables again and again.
   *
   * @param period from one reading to the next; at least 1 ms
   * @param listener takes the samples, in a thread of its own; more can be added
   * @param names the variables to read
   * @return the watch, which runs already; it is to be closed
   */
  public Watch watch(Duration period, Consumer<? super Sample> listener, String... names) {
    return watch(WatchConfig.create(Arrays.asList(names), cfg -> cfg.period(period)), listener);
  }

  /**
   * Reads a variable of any type as text.
   *
   * @param name the variable's name
   * @return its value as the controller printed it
   * @throws CrossComAccessException if the controller refused
   * @throws CrossComException if the exchange failed
   * @throws IllegalArgumentException if the name is blank, or not ISO 8859-1 and the server is not
   *     C3 Bridge
   */
  public String readText(String name) throws IOException {
    return variables.read(name).text();
  }

  /**
   * Reads a variable of any type as a tree of values.
   *
   * @param name the variable's name
   * @return its value
   * @throws CrossComAccessException if the controller refused
   * @throws CrossComValueException if what came is no KRL value
   * @throws CrossComException if the exchange failed
   */
  public KrlValue readValue(String name) throws IOException {
    KRLAny any = new KRLAny(name);
    readVariable(any);
    return Objects.requireNonNull(any.getValue());
  }

  /**
   * Writes a variable of any type from text.
   *
   * @param name the variable's name
   * @param value KRL text: {@code 50}, {@code TRUE}, {@code #T1}, {@code "text"} with its quotes,
   *     or an aggregate
   * @throws CrossComAccessException if the controller refused
   * @throws CrossComValueException if the text is too long to be sent, or not ISO 8859-1 and the
   *     server is not C3 Bridge
   * @throws CrossComException if the exchange failed
   * @throws IllegalArgumentException if the name is blank, or not ISO 8859-1 and the server is not
   *     C3 Bridge
   */
  public void writeText(String name, String value) throws IOException {
    variables.write(name, value);
  }

  /**
   * Checks what {@link #writeText} would refuse without asking the server, and sends nothing: so
   * that a mistake shows before a person is asked whether to write.
   *
   * @param name the variable's name
   * @param value KRL text
   * @throws CrossComValueException if the text is too long to be sent
   * @throws IllegalArgumentException if the name is blank
   */
  public void checkText(String name, String value) throws CrossComValueException {
    variables.checkWrite(name, value);
  }

  /**
   * Reads a variable and describes the access in one line.
   *
   * @param name the variable's name
   * @return {@code NAME #read time=Nms #value=VALUE}
   * @throws CrossComAccessException if the controller refused
   * @throws CrossComException if the exchange failed
   */
  public String simpleRead(String name) throws IOException {
    return describe(name, variables.read(name));
  }

  /**
   * Writes a variable and describes the access in one line.
   *
   * @param name the variable's name
   * @param val the value as KRL text
   * @return {@code NAME #read time=Nms #value=VALUE}, with the value that the server echoed
   * @throws CrossComAccessException if the controller refused
   * @throws CrossComException if the exchange failed
   */
  public String simpleWrite(String name, String val) throws IOException {
    return describe(name, variables.write(name, val));
  }

  private static String describe(String name, TextAnswer exchanged) {
    return name
        + " #read time="
        + exchanged.nanos() / 1_000_000
        + "ms  #value="
        + exchanged.text().strip();
  }

  /**
   * Reads or writes a variable by name.
   *
   * @param request what to do
   * @return what came of it
   * @throws CrossComAccessException if the controller refused
   * @throws CrossComException if the exchange failed
   * @deprecated use {@link #readVariable} and {@link #writeVariable}, or {@link #readText} and
   *     {@link #writeText} if the type is not known
   */
  @Deprecated
  public Callback sendRequest(Request request) throws IOException {
    String name = request.getVariable();
    String value = request.getValue();
    TextAnswer exchanged = value == null ? variables.read(name) : variables.write(name, value);
    return new Callback(
        name,
        request.getId(),
        (value == null ? MessageType.READ : MessageType.WRITE).code(),
        exchanged.text().strip(),
        exchanged.nanos());
  }

  /**
   * Reads the positions of the robot axes, {@code $AXIS_ACT}.
   *
   * @return a new array of six: A1 to A6 in degrees
   * @throws CrossComException if reading failed
   */
  public double[] readJointAngles() throws IOException {
    KRLE6Axis axes = KRLVariable.AXIS_ACT();
    readVariable(axes);
    try {
      return axes.asArrayA1ToA6();
    } catch (IllegalStateException e) {
      throw new CrossComValueException(
          axes.getName(), axes.getValue().toString(), "A1 to A6 are not all there", e);
    }
  }

  /**
   * Reads the torques of the robot axes in one access, {@code $TORQUE_AXIS_ACT[]}.
   *
   * @return a new array of six: A1 to A6 in Nm
   * @throws CrossComException if reading failed
   */
  public double[] readJointTorques() throws IOException {
    KRLRealArray torques = new KRLRealArray("$TORQUE_AXIS_ACT[]");
    readVariable(torques);
    if (torques.length() < 6) {
      throw new CrossComValueException(
          torques.getName(),
          torques.getStringValue(),
          "there must be at least 6 torques, there are " + torques.length(),
          null);
    }
    return Arrays.copyOf(Objects.requireNonNull(torques.getValue()), 6);
  }

  /**
   * Gives the 16-bit number of two bytes, the higher first.
   *
   * @param bytes has them
   * @param off the index of the first
   * @return 0 to 65535
   * @deprecated {@link Codec} decodes frames
   */
  @Deprecated
  @SuppressWarnings("InlineMeSuggester") // a migration tool's hint, for which there is no tool here
  public static int getInt(byte[] bytes, int off) {
    return (bytes[off] & 0xFF) << 8 | (bytes[off + 1] & 0xFF);
  }

  // --- in another thread

  /**
   * Runs operations in another thread, after those that wait there already, and returns their
   * result:
   *
   * <pre>{@code
   * CompletableFuture<String> mode = client.async(c -> c.readText("$MODE_OP"));
   * }</pre>
   *
   * <p>Cancelling the future before the first exchange means that nothing is sent. Later it does
   * nothing and returns false. That holds for the client that the function gets, which is a view of
   * this one with the same connection. The function takes its values when it runs, so a variable
   * must not be changed meanwhile.
   *
   * @param function uses the client that it gets
   * @param <T> the type of the result
   * @return the result to come; if the function throws, the future fails with the same exception
   */
  public <T extends @Nullable Object> CompletableFuture<T> async(CrossComFunction<T> function) {
    return AsyncCall.submit(
        async, callbacks, call -> function.apply(new CrossComClient(this, call)));
  }

  /**
   * Runs operations without a result in another thread, as {@link #async} does:
   *
   * <pre>{@code
   * client.asyncRun(c -> c.programs().start(Interpreter.ROBOT));
   * }</pre>
   *
   * @param action uses the client that it gets
   * @return the end to come; if the action throws, the future fails with the same exception
   */
  public CompletableFuture<Void> asyncRun(CrossComAction action) {
    return this.<@Nullable Void>async(
        client -> {
          action.run(client);
          return null;
        });
  }

  // --- what programs of the original call on the client as on a Socket

  /**
   * Says whether the client was connected. As with a Socket, this stays true after it was closed.
   *
   * @return true, since a client is made connected
   */
  public boolean isConnected() {
    return true;
  }

  /**
   * Says whether the client can no longer be used: it was closed, or its connection failed and is
   * not to be made again.
   *
   * @return true if so
   */
  public boolean isClosed() {
    return connection.isClosed();
  }

  /**
   * Gives the address of the controller.
   *
   * @return the address connected to
   */
  public InetAddress getInetAddress() {
    return connection.connection().remoteAddress();
  }

  /**
   * Gives the server's port.
   *
   * @return 1 to 65535
   */
  public int getPort() {
    return config.port();
  }

  /**
   * Gives the local port of the connection.
   *
   * @return 1 to 65535; another one after the connection was made anew
   */
  public int getLocalPort() {
    return connection.connection().localPort();
  }

  /**
   * Sets how long an exchange may take, for those that begin from now on.
   *
   * @param millis in ms; 0 for no limit
   * @throws SocketException never; declared for programs of the original, which may catch it
   * @throws IllegalArgumentException if the time is negative
   */
  public void setSoTimeout(int millis) throws SocketException {
    if (millis < 0) {
      throw new IllegalArgumentException("time-out must be 0 or more ms, is " + millis);
    }
    connection.setTimeout(Duration.ofMillis(millis).toNanos());
  }

  /**
   * Gives how long an exchange may take.
   *
   * @return in ms; 0 for no limit
   * @throws SocketException never; declared for programs of the original, which may catch it
   */
  public int getSoTimeout() throws SocketException {
    return (int) Duration.ofNanos(connection.timeoutNanos()).toMillis();
  }

  /**
   * Closes the connection for good. An exchange under way in another thread ends with {@link
   * CrossComClosedException}, unless its answer comes at the same moment, and what waits for its
   * turn ends so too. Closing again does nothing.
   *
   * @throws IOException never; declared for programs of the original, which may catch it
   */
  @Override
  public void close() throws IOException {
    connection.close();
    watches.forEach(Watch::close);
    transfers.shutdown();
    async.shutdown(); // what is queued fails soon, saying that the client is closed
  }

  @Override
  public String toString() {
    return "CrossComClient{"
        + config.host()
        + ":"
        + config.port()
        + (isClosed() ? ", closed" : "")
        + "}";
  }
}
