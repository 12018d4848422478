package no.hials.crosscom;

import java.io.IOException;
import java.lang.ref.Cleaner;
import java.net.UnknownHostException;
import java.time.Duration;
import java.util.Arrays;
import java.util.List;
import java.util.Objects;
import java.util.concurrent.CompletableFuture;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import no.hials.crosscom.ConnectionEvent.ChangeReason;
import no.hials.crosscom.KRL.KRLAny;
import no.hials.crosscom.KRL.KRLArray;
import no.hials.crosscom.KRL.KRLVariable;
import no.hials.crosscom.KRL.structs.KRLStruct;
import no.hials.crosscom.c3.ControllerFiles;
import no.hials.crosscom.c3.Information;
import no.hials.crosscom.c3.Motion;
import no.hials.crosscom.c3.Pendant;
import no.hials.crosscom.c3.Programs;
import no.hials.crosscom.internal.c3.C3Files;
import no.hials.crosscom.internal.c3.C3Information;
import no.hials.crosscom.internal.c3.C3Motion;
import no.hials.crosscom.internal.c3.C3Pendant;
import no.hials.crosscom.internal.c3.C3Programs;
import no.hials.crosscom.internal.exchange.Threads;
import no.hials.crosscom.protocol.Codec;
import no.hials.crosscom.protocol.value.KrlValue;
import org.jspecify.annotations.Nullable;

/**
 * Reads and writes the variables of a KUKA robot controller on which KUKAVARPROXY or C3 Bridge
 * Interface runs.
 *
 * <p><b>A write can move a machine.</b> The client never repeats a write. If its outcome is
 * unknown, {@link CrossComException#isOutcomeUnknown} returns true.
 *
 * <p>Several threads can use the client: exchanges take place one at a time, in the order of the
 * calls. Only one thread at a time may use a variable. A call blocks until its answer arrives. An
 * exchange takes at most the request time-out, its wait for those of other threads included, plus
 * the connect time-out if the client has to reconnect. A repeated read can take twice as long.
 *
 * <p>A refused access or an unreadable value leaves the connection usable. After a time-out, a
 * broken connection or an invalid answer, the connection is closed, and the next call reconnects,
 * unless {@link ClientConfig#reconnect} is off. After a failed attempt, calls fail at once until
 * the time of the next attempt ({@link ClientConfig#reconnectBackoff}). A read that was under way
 * when the connection broke is repeated once; a write never is.
 *
 * <p>A wrong call, such as one with a blank name, throws an unchecked exception and sends nothing.
 *
 * <p>The client detects the type of the server when needed, and uses its features: on C3 Bridge,
 * texts in UTF-16, messages for several variables, and {@link #programs}, {@link #motion}, {@link
 * #pendant}, {@link #files} and {@link #information}. These five always return the same objects,
 * whose methods throw {@link CrossComUnsupportedException} on KUKAVARPROXY.
 *
 * <p>The client and its watches use the threads of its {@link ClientRuntime}. It creates these
 * daemon threads while they have work, where PORT is the server's:
 *
 * <ul>
 *   <li>{@code crosscom-async-PORT} runs the operations of {@link #async}.
 *   <li>{@code crosscom-files-PORT} runs the transfers of files.
 * </ul>
 *
 * <p>The class is long because most of it is documentation.
 */
public final class CrossComClient extends OriginalAccess {
  private final ClientConfig config;
  private final ReconnectingConnection connection;
  private final Threads threads;
  private final C3Channel channel;
  private final VariableExchange variables;
  private final Programs programs;
  private final Motion motion;
  private final Pendant pendant;
  private final ControllerFiles files;
  private final Information information;
  private final Cleaner.Cleanable cleanable;

  /**
   * Connects, with the default times: 5 s for connecting, 3 s for a request.
   *
   * @param host name or address of the controller
   * @param port the server's port, 1 to 65535, usually 7000
   * @throws CrossComConnectException if the host is unknown or the client could not connect
   * @throws UnknownHostException never; declared for programs of the original, which catch it. See
   *     {@link CrossComConnectException}
   * @throws IOException only as one of the above
   */
  public CrossComClient(String host, int port) throws UnknownHostException, IOException {
    this(ClientConfig.create(host, cfg -> cfg.port(port)));
  }

  /**
   * Connects to the default port, 7000, with the default times.
   *
   * @param host name or address of the controller
   * @throws CrossComConnectException if the host is unknown or the client could not connect
   */
  public CrossComClient(String host) throws CrossComException {
    this(ClientConfig.create(host, cfg -> {}));
  }

  /**
   * Connects.
   *
   * @param config the address and the options
   * @throws CrossComConnectException if the host is unknown or the client could not connect
   */
  public CrossComClient(ClientConfig config) throws CrossComException {
    this(config, new ReconnectingConnection(config));
    try {
      connection.connectFirst();
    } catch (CrossComException e) {
      connection.close(ChangeReason.CLOSED_BY_PROGRAM);
      throw e;
    }
    connection.start();
  }

  private CrossComClient(ClientConfig config, ReconnectingConnection connection) {
    this.config = config;
    this.connection = connection;
    this.threads =
        new Threads(
            config.port(),
            config.runtime().timer(),
            config.maxPendingCalls(),
            config.runtime().callbacks(),
            config.runtime()::complete,
            () -> new CrossComClosedException("the client is closed", null, false));
    this.channel =
        new C3Channel(
            connection,
            new ServerDetector(connection, config.server().orElse(null)),
            threads,
            null);
    this.variables = new VariableExchange(config, connection, channel);
    this.programs = new C3Programs(channel);
    this.motion = new C3Motion(channel);
    this.pendant = new C3Pendant(channel);
    this.files = new C3Files(channel);
    this.information = new C3Information(channel);
    // of the channel, not of this client: programs() and the other views use it without the client
    this.cleanable = DroppedClient.register(channel, config, connection, threads);
  }

  /**
   * Creates a client that connects in the background, and again after each failed attempt until the
   * first connection. A call that finds no connection tries to connect itself, unless the next
   * attempt has to wait; it then fails with {@link CrossComConnectException}. After a loss, the
   * client connects as if the constructor had created it: by the next call, also of {@link
   * #connected}, or at the next keep-alive.
   *
   * @param config the address and the options
   * @return the client, which may not be connected yet
   * @throws CrossComConnectException if the {@link ClientRuntime} is closed, or the system starts
   *     no threads
   */
  public static CrossComClient lazy(ClientConfig config) throws CrossComException {
    if (config.runtime().isClosed()) {
      throw ConnectAttempt.failure(config, ConnectAttempt.runtimeClosed(null));
    }
    CrossComClient client = new CrossComClient(config, new ReconnectingConnection(config));
    try {
      client.connection.start();
    } catch (OutOfMemoryError e) {
      client.connection.close(ChangeReason.CLOSED_BY_PROGRAM);
      throw ConnectAttempt.failure(config, e);
    }
    return client;
  }

  /**
   * Returns a future that is completed when the client is connected. If there is no connection, the
   * client connects in the background, and again after each failed attempt and its {@link
   * ClientConfig#reconnectBackoff}, until it is connected or closed. A connection that broke while
   * idle counts as one until the next call or keep-alive finds out.
   *
   * @return a new future: already completed while there is a connection; fails with {@link
   *     CrossComClosedException} if {@link #isClosed} returns true, or when the client is closed
   */
  public CompletableFuture<@Nullable Void> connected() {
    return connection.connected();
  }

  /** Returns how many exchanges there were, how long they took, and how many failed. */
  public ClientStatistics statistics() {
    return connection.statistics();
  }

  @Override
  VariableExchange variables() {
    return variables;
  }

  @Override
  ReconnectingConnection connection() {
    return connection;
  }

  /** Returns the configuration of the constructor. */
  @Override
  public ClientConfig getConfig() {
    return config;
  }

  /**
   * Returns the type, version and features of the server. They are asked for once per connection,
   * when this method or another one needs them.
   *
   * @return the server of the current connection
   * @throws CrossComException if an exchange fails
   */
  public Server getServer() throws IOException {
    return channel.find("request for the kind of server", ServerDetector::server);
  }

  /** Returns the object that selects, starts and stops programs. It needs C3 Bridge. */
  public Programs programs() {
    return programs;
  }

  /** Returns the object that moves the robot to positions. It needs C3 Bridge. */
  public Motion motion() {
    return motion;
  }

  /** Returns the object that presses keys of the teach pendant. It needs C3 Bridge. */
  public Pendant pendant() {
    return pendant;
  }

  /** Returns the object that works with the files of the controller. It needs C3 Bridge. */
  public ControllerFiles files() {
    return files;
  }

  /**
   * Returns the object that asks the server about itself, and confirms messages. It needs C3
   * Bridge.
   */
  public Information information() {
    return information;
  }

  /**
   * Reads a variable of the controller into its local copy.
   *
   * @param variable receives the value; unchanged if reading fails
   * @throws CrossComAccessException if the controller refuses, for example an unknown name
   * @throws CrossComValueException if the controller's value is not of the variable's type, or is
   *     too long for an answer of C3 Bridge
   * @throws CrossComException if the exchange fails
   */
  @Override
  public void readVariable(KRLVariable variable) throws IOException {
    variables.read(Objects.requireNonNull(variable, "variable"));
  }

  /**
   * Writes the local copy of a variable to the controller, and updates it from the answer.
   *
   * <p>A structure is written whole; fields never set are written as 0.0. A whole array is written
   * element by element, one access each, in order.
   *
   * @param variable the variable and its value
   * @throws CrossComAccessException if the controller refuses, for example a read-only variable;
   *     the elements of an array before the named one were written
   * @throws CrossComValueException if the text is too long to be sent
   * @throws CrossComException if the exchange fails
   * @throws IllegalStateException if the variable has no value
   */
  @Override
  public void writeVariable(KRLVariable variable) throws IOException {
    variables.write(Objects.requireNonNull(variable, "variable"));
  }

  /**
   * Writes some fields of a structure; the controller leaves the others as they are.
   *
   * @param struct the structure and its values
   * @param fields names of its fields, at least one
   * @throws CrossComAccessException if the controller refuses
   * @throws CrossComException if the exchange fails
   * @throws IllegalArgumentException if a field does not exist or has no value
   */
  public void writeFields(KRLStruct struct, String... fields) throws IOException {
    Objects.requireNonNull(struct, "struct");
    variables.write(struct, struct.getStringValueOf(Objects.requireNonNull(fields, "fields")));
  }

  /**
   * Reads a whole array: in one access if the server supports it and the value fits into an answer,
   * otherwise element by element if the array has a declared length.
   *
   * @param array receives the value; unchanged if reading fails
   * @param progress called after each element if the array is read element by element
   * @throws CrossComAccessException if the controller refuses; {@link
   *     CrossComException#getElementsDone} returns the number of elements read
   * @throws CrossComValueException if the controller's value is not of the array's type, or is too
   *     long for an answer and the array has no declared length
   * @throws CrossComException if an exchange fails
   */
  public void readVariable(KRLArray array, ArrayProgress progress) throws IOException {
    variables.read(array, progress);
  }

  /**
   * Writes a whole array, element by element in order.
   *
   * @param array the array and its elements
   * @param progress called after each element
   * @throws CrossComAccessException if the controller refuses an element; the elements before it
   *     were written, and {@link CrossComException#getElementsDone} returns their number
   * @throws CrossComException if an exchange fails
   * @throws IllegalStateException if the array has no value
   */
  public void writeVariable(KRLArray array, ArrayProgress progress) throws IOException {
    variables.write(Objects.requireNonNull(array, "array"), progress);
  }

  /**
   * Reads several variables: from C3 Bridge 1.2 or later in as few messages as possible, from any
   * other server one after the other.
   *
   * <p>If the controller refuses a variable, or its value is of another type, the others are still
   * read. If an exchange fails, all its variables fail, and the variables after them are not tried.
   * An array that cannot be read whole is read element by element, as by {@link
   * #readVariable(KRLArray, ArrayProgress)}.
   *
   * @param several the variables
   * @return one result per variable, in the same order
   */
  @Override
  public List<VariableResult> readVariables(List<? extends KRLVariable> several) {
    return variables.readAll(checked(several));
  }

  /**
   * Reads several variables, as {@link #readVariables(List)}.
   *
   * @param several the variables
   * @return one result per variable, in the same order
   */
  public List<VariableResult> readVariables(KRLVariable... several) {
    return readVariables(Arrays.asList(Objects.requireNonNull(several, "variables")));
  }

  /**
   * Writes several variables in order: to C3 Bridge 1.3 or later in as few messages as possible, to
   * any other server one after the other. An array takes a message for each element.
   *
   * <p>If the controller refuses a variable, the others are still written. If an exchange fails,
   * the outcome of all its variables may be unknown, and the variables after them are not tried.
   *
   * @param several the variables
   * @return one result per variable, in the same order
   * @throws IllegalStateException if a variable has no value; then nothing was written
   */
  public List<VariableResult> writeVariables(List<? extends KRLVariable> several) {
    return variables.writeAll(checked(several));
  }

  /**
   * Writes several variables, as {@link #writeVariables(List)}.
   *
   * @param several the variables
   * @return one result per variable, in the same order
   * @throws IllegalStateException if a variable has no value; then nothing was written
   */
  public List<VariableResult> writeVariables(KRLVariable... several) {
    return writeVariables(Arrays.asList(Objects.requireNonNull(several, "variables")));
  }

  /** Refuses null before anything is sent. */
  private static <T extends KRLVariable> List<T> checked(List<T> several) {
    int index = 0;
    for (T variable : Objects.requireNonNull(several, "variables")) {
      if (variable == null) { // not by requireNonNull, as its message would be an object
        throw new NullPointerException("variables[" + index + "]");
      }
      index++;
    }
    return several;
  }

  /**
   * Reads variables at a fixed period.
   *
   * @param watchConfig the variables and the period
   * @param listener called with the samples in a separate thread; more listeners can be added
   * @return the running watch; the caller closes it
   * @throws CrossComClosedException if the client is closed
   * @throws IllegalArgumentException if a handle is of another client
   */
  public Watch watch(WatchConfig watchConfig, Consumer<? super Sample> listener)
      throws IOException {
    Objects.requireNonNull(listener, "listener");
    Watch watch = watch(watchConfig);
    watch.addListener(listener);
    return watch;
  }

  /**
   * Reads variables at a fixed period, for a loop that waits for each sample:
   *
   * <pre>{@code
   * try (Watch watch = client.watch(WatchConfig.create(List.of("$OV_PRO"), cfg -> {}))) {
   *   for (Sample sample : watch) {
   *     ...
   *   }
   * }
   * }</pre>
   *
   * @param watchConfig the variables and the period
   * @return the watch, which starts with its first listener, subscriber or iterator; the caller
   *     closes it
   * @throws CrossComClosedException if the client is closed
   * @throws IllegalArgumentException if a handle is of another client
   */
  public Watch watch(WatchConfig watchConfig) throws IOException {
    check(Objects.requireNonNull(watchConfig, "watchConfig").handles());
    connection.checkOpen();
    return new Watch(variables, connection, channel, watchConfig, config.runtime());
  }

  /**
   * Reads variables at a fixed period.
   *
   * @param period from one reading to the next; at least 1 ms
   * @param listener called with the samples in a separate thread; more listeners can be added
   * @param names the variables to read
   * @return the running watch; the caller closes it
   * @throws CrossComClosedException if the client is closed
   */
  public Watch watch(Duration period, Consumer<? super Sample> listener, String... names)
      throws IOException {
    return watch(
        WatchConfig.create(
            Arrays.asList(Objects.requireNonNull(names, "names")), cfg -> cfg.period(period)),
        listener);
  }

  /**
   * Reads a variable of any type as text.
   *
   * @param name the variable's name
   * @return its value as the controller printed it
   * @throws CrossComAccessException if the controller refuses
   * @throws CrossComException if the exchange fails
   * @throws IllegalArgumentException if the name is blank, or on KUKAVARPROXY has a character that
   *     {@link ClientConfig#charset} lacks
   */
  public String readText(String name) throws IOException {
    return variables.read(name).text();
  }

  /**
   * Reads a variable of any type as a tree of values.
   *
   * @param name the variable's name
   * @return its value
   * @throws CrossComAccessException if the controller refuses
   * @throws CrossComValueException if the answer is not a KRL value
   * @throws CrossComException if the exchange fails
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
   * @return the text of the answer, which normally repeats the value; empty if it has none
   * @throws CrossComAccessException if the controller refuses
   * @throws CrossComValueException if the text is too long to be sent, has a line break or NUL
   *     outside double quotes, or on KUKAVARPROXY has a character that {@link ClientConfig#charset}
   *     lacks
   * @throws CrossComException if the exchange fails
   * @throws IllegalArgumentException if the name is blank, has a line break or NUL, or on
   *     KUKAVARPROXY has a character that {@link ClientConfig#charset} lacks
   */
  public String writeText(String name, String value) throws IOException {
    return variables.write(name, value).text();
  }

  /**
   * Checks a write like {@link #writeText}, without sending it, so that mistakes show before a
   * person confirms the write. How a name or value with quotes or characters beyond ASCII is
   * encoded depends on the server, so its length and characters are only checked by the write.
   *
   * @param name the variable's name
   * @param value KRL text
   * @throws CrossComValueException if the text has several lines or is too long to be sent
   * @throws IllegalArgumentException if the name is blank
   */
  public void checkText(String name, String value) throws CrossComValueException {
    variables.checkWrite(name, value);
  }

  /**
   * Returns the 16-bit number of two bytes, the higher first.
   *
   * @param bytes contains both bytes
   * @param off the index of the first byte
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
   * Runs operations in another thread, one call after the other, and returns their result:
   *
   * <pre>{@code
   * CompletableFuture<String> mode = client.async(c -> c.readText("$MODE_OP"));
   * }</pre>
   *
   * <p>If the future is cancelled before the first exchange of the function's thread, nothing is
   * sent but the client's own questions about the type of the server. Later, {@code cancel} does
   * nothing and returns false. Do not change a variable before the function has used it. Calls of
   * this client by other threads can run between the exchanges of the function; only another {@code
   * async} waits until it ends. So a function that waits for the {@code async} of another thread
   * never ends; its own {@code async} runs at once, in the same thread.
   *
   * @param function gets this client
   * @param <T> the type of the result
   * @return a future of the result, which fails with the exception that the function throws
   */
  public <T extends @Nullable Object> CompletableFuture<T> async(CrossComFunction<T> function) {
    return async(function, () -> true);
  }

  /**
   * Runs operations in another thread, as {@link #async(CrossComFunction)} does, if a condition is
   * true directly before the first exchange, when the connection has its turn. Otherwise nothing is
   * sent, and the future is cancelled. For requests that must not be sent late.
   *
   * @param function gets this client
   * @param sendIf called by the function's thread; must not block
   * @param <T> the type of the result
   * @return a future of the result, which fails with the exception that the function throws
   */
  public <T extends @Nullable Object> CompletableFuture<T> async(
      CrossComFunction<T> function, BooleanSupplier sendIf) {
    Objects.requireNonNull(function, "function");
    Objects.requireNonNull(sendIf, "sendIf");
    return threads.async(
        call -> {
          call.commitIf(sendIf);
          return function.apply(this);
        });
  }

  /**
   * Runs operations without a result in another thread, as {@link #async} does:
   *
   * <pre>{@code
   * client.asyncRun(c -> c.programs().start(Interpreter.ROBOT));
   * }</pre>
   *
   * @param action gets this client
   * @return a future of the end, which fails with the exception that the action throws
   */
  public CompletableFuture<Void> asyncRun(CrossComAction action) {
    return asyncRun(action, () -> true);
  }

  /**
   * Runs operations without a result in another thread if a condition is true directly before the
   * first exchange, as {@link #async(CrossComFunction, BooleanSupplier)} does.
   *
   * @param action gets this client
   * @param sendIf called by the action's thread; must not block
   * @return a future of the end, which fails with the exception that the action throws
   */
  public CompletableFuture<Void> asyncRun(CrossComAction action, BooleanSupplier sendIf) {
    Objects.requireNonNull(action, "action");
    Objects.requireNonNull(sendIf, "sendIf");
    return threads.<@Nullable Void>async(
        call -> {
          call.commitIf(sendIf);
          action.run(this);
          return null;
        });
  }

  /**
   * Returns whether the client can no longer be used: it was closed, or its connection failed and
   * {@link ClientConfig#reconnect} is off.
   */
  public boolean isClosed() {
    return connection.isClosed();
  }

  /**
   * Closes the client. Running and waiting exchanges of other threads fail with {@link
   * CrossComClosedException}, unless an answer arrives at the same moment. Closing again does
   * nothing.
   *
   * @throws IOException never; declared for programs of the original, which may catch it
   */
  @Override
  public void close() throws IOException {
    connection.close(ChangeReason.CLOSED_BY_PROGRAM);
    cleanable.clean();
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
