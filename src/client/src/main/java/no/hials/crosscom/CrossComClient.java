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
import java.util.concurrent.Callable;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.Executor;
import java.util.concurrent.ThreadPoolExecutor;
import java.util.concurrent.locks.ReentrantLock;
import java.util.function.Consumer;
import no.hials.crosscom.CrossComAccessException.Operation;
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
import no.hials.crosscom.internal.Latin1;
import no.hials.crosscom.internal.VariableAccess;
import no.hials.crosscom.protocol.AnswerFrame;
import no.hials.crosscom.protocol.Codec;
import no.hials.crosscom.protocol.MessageType;
import no.hials.crosscom.protocol.ReadRequest;
import no.hials.crosscom.protocol.ReadUtf16Request;
import no.hials.crosscom.protocol.ServerType;
import no.hials.crosscom.protocol.Tail;
import no.hials.crosscom.protocol.TextResponse;
import no.hials.crosscom.protocol.TypedResponse;
import no.hials.crosscom.protocol.WriteRequest;
import no.hials.crosscom.protocol.WriteUtf16Request;
import no.hials.crosscom.protocol.value.KrlScanner;
import no.hials.crosscom.protocol.value.KrlSyntaxException;
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
  private static final ArrayProgress NO_PROGRESS = (done, total) -> {};

  /** A longer text makes no answer in UTF-16: 65,535 bytes less type, length and tail, halved. */
  private static final int MAX_UTF16_ANSWER = 32_764;

  private final ClientConfig config;
  private final ReconnectingConnection link;
  private final C3Channel messages;
  private final Programs programs;
  private final Motion motion;
  private final Pendant pendant;
  private final ControllerFiles files;
  private final Information information;
  private final ThreadPoolExecutor async;
  private final ThreadPoolExecutor transfers;
  private final Executor callbacks;
  private final ReentrantLock lock;
  private final Set<Watch> watches = ConcurrentHashMap.newKeySet();
  private final KrlScanner scanner = new KrlScanner();

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
    this.link = new ReconnectingConnection(config);
    this.lock = link.lock();
    this.callbacks = Threads.forCallbacks("crosscom-callback-" + config.port());
    this.async = Threads.lazy("crosscom-async-" + config.port());
    this.transfers = Threads.lazy("crosscom-files-" + config.port());
    this.messages = new C3Channel(link, async, transfers, callbacks);
    this.programs = new Programs(messages);
    this.motion = new Motion(messages);
    this.pendant = new Pendant(messages);
    this.files = new ControllerFiles(messages);
    this.information = new Information(messages);
    link.start();
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
    return messages.find("request for the kind of server", ServerDetector::server);
  }

  /**
   * Does what {@link #getServer} does, in another thread.
   *
   * @return the result to come; cancelling it before it is sent means that it is not sent
   */
  public CompletableFuture<Server> getServerAsync() {
    return callAsync(this::getServer);
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
    if (variable instanceof KRLArray array && array.getDeclaredLength() > 0) {
      readVariable(array, NO_PROGRESS);
    } else {
      readWhole(variable);
    }
  }

  private void readWhole(KRLVariable variable) throws CrossComException {
    VariableAccess access = VariableAccess.get();
    byte[] frame = access.readFrame(variable);
    String name = variable.getName();
    TextAnswer wide = null;
    String text = null;
    lock.lock();
    try {
      if (frame == null) {
        wide = readUtf16(name);
      } else {
        Answer answer = read(frame, name);
        wide = access.holdsText(variable) ? readDoubtful(answer, name) : null;
        text = wide == null ? takeInPlace(variable, answer, false) : null;
      }
    } finally {
      lock.unlock();
    }
    if (wide != null) {
      take(variable, wide, false);
    } else {
      takeText(variable, text, false);
    }
  }

  /** Sets a variable from a text. The lock is not held. */
  static void take(KRLVariable variable, TextAnswer exchanged, boolean written)
      throws CrossComValueException {
    VariableAccess access = VariableAccess.get();
    boolean taken;
    try {
      taken = access.scan(variable, new KrlScanner(exchanged.text()), written);
    } catch (IllegalArgumentException e) {
      throw notOfType(variable, exchanged.text(), written, e);
    }
    access.setReadTime(variable, exchanged.nanos());
    takeText(variable, taken ? null : exchanged.text(), written);
  }

  /**
   * Sets a variable from the answer, in place. The lock is held.
   *
   * @param written whether it is the answer to a write
   * @return nothing if the variable is set; else the text for {@link #takeText}
   */
  private @Nullable String takeInPlace(KRLVariable variable, Answer answer, boolean written)
      throws CrossComValueException {
    VariableAccess access = VariableAccess.get();
    scanner.reset(answer.frame());
    try {
      boolean taken = access.scan(variable, scanner, written);
      access.setReadTime(variable, answer.nanos());
      return taken ? null : answer.frame().toString();
    } catch (IllegalArgumentException e) {
      throw notOfType(variable, answer.frame().toString(), written, e);
    }
  }

  /** Sets a variable of a class of the program's own, whose code does not run under the lock. */
  private static void takeText(KRLVariable variable, @Nullable String text, boolean written)
      throws CrossComValueException {
    if (text != null) {
      try {
        VariableAccess.get().setFromString(variable, text);
      } catch (IllegalArgumentException e) {
        throw notOfType(variable, text, written, e);
      }
    }
  }

  private static CrossComValueException notOfType(
      KRLVariable variable, String text, boolean written, IllegalArgumentException e) {
    return new CrossComValueException(
        variable.getName(),
        text,
        (written
                ? "the write was done, but its answer is not a value for "
                : "what the controller has is not a value for ")
            + variable.getType()
            + ": "
            + e.getMessage(),
        e);
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
    if (variable instanceof KRLArray array) {
      writeVariable(array, NO_PROGRESS);
    } else {
      write(variable, variable.getStringValue());
    }
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
    write(struct, struct.getStringValueOf(fields));
  }

  private void write(KRLVariable variable, String text) throws CrossComException {
    byte[] frame = encodeWrite(variable.getName(), text);
    if (frame == null) {
      takeEcho(variable, writeUtf16(variable.getName(), text));
      return;
    }
    String echo = null;
    lock.lock();
    try {
      Answer answer = write(frame, variable.getName());
      if (!answer.frame().isEmpty()) {
        echo = takeInPlace(variable, answer, true);
      } else {
        // done, but there is no value to update the variable from
        VariableAccess.get().setReadTime(variable, answer.nanos());
      }
    } finally {
      lock.unlock();
    }
    takeText(variable, echo, true);
  }

  /** Updates a variable from what the server says that it has now. The lock is not held. */
  static void takeEcho(KRLVariable variable, TextAnswer echo) throws CrossComValueException {
    if (echo.text().isEmpty()) {
      // done, but there is no value to update the variable from
      VariableAccess.get().setReadTime(variable, echo.nanos());
    } else {
      take(variable, echo, true);
    }
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
    try {
      readWhole(array);
    } catch (CrossComAccessException e) {
      if (array.getDeclaredLength() == 0) {
        throw e;
      }
      readElements(array, progress);
    }
  }

  private void readElements(KRLArray array, ArrayProgress progress) throws CrossComException {
    int total = array.getDeclaredLength();
    long nanos = 0;
    for (int i = 1; i <= total; i++) {
      String name = array.getElementName(i);
      try {
        TextAnswer element = read(name);
        nanos += element.nanos();
        VariableAccess.get().scanElement(array, new KrlScanner(element.text()), i - 1);
      } catch (CrossComException e) {
        e.setElementsDone(i - 1, total);
        throw e;
      } catch (KrlSyntaxException e) {
        CrossComValueException wrong = notOfType(array, e.text(), false, e);
        wrong.setElementsDone(i - 1, total);
        throw wrong;
      }
      progress.elementsDone(i, total);
    }
    VariableAccess.get().acceptElements(array, total);
    VariableAccess.get().setReadTime(array, nanos);
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
    int total = array.length();
    if (total == 0) {
      throw new IllegalStateException(
          array.getName() + " has no value: it was neither set nor read");
    }
    long nanos = 0;
    for (int i = 1; i <= total; i++) {
      try {
        nanos += write(array.getElementName(i), array.getElementStringValue(i)).nanos();
      } catch (CrossComException e) {
        e.setElementsDone(i - 1, total);
        throw e;
      }
      progress.elementsDone(i, total);
    }
    VariableAccess.get().setReadTime(array, nanos);
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
   * @param variables what to read
   * @return what came of each, in the same order
   */
  public List<VariableResult> readVariables(List<? extends KRLVariable> variables) {
    return Batch.read(this, messages, variables);
  }

  /**
   * Reads several variables, as {@link #readVariables(List)}.
   *
   * @param variables what to read
   * @return what came of each, in the same order
   */
  public List<VariableResult> readVariables(KRLVariable... variables) {
    return readVariables(Arrays.asList(variables));
  }

  /**
   * Writes several variables in order: to C3 Bridge 1.3 or later in as few messages as they fit
   * into, to any other server one after the other. An array takes a message for each element.
   *
   * <p>One that the controller refuses does not keep the others from being written. If an exchange
   * fails, the outcome of all variables that it was for may be unknown, and those behind them are
   * not tried.
   *
   * @param variables what to write
   * @return what came of each, in the same order
   * @throws IllegalStateException if one has no value; nothing was written then
   */
  public List<VariableResult> writeVariables(List<? extends KRLVariable> variables) {
    variables.forEach(KRLVariable::getStringValue); // refuses what has no value
    return Batch.write(this, messages, variables);
  }

  /**
   * Writes several variables, as {@link #writeVariables(List)}.
   *
   * @param variables what to write
   * @return what came of each, in the same order
   * @throws IllegalStateException if one has no value; nothing was written then
   */
  public List<VariableResult> writeVariables(KRLVariable... variables) {
    return writeVariables(Arrays.asList(variables));
  }

  /** Forgets a watch that has ended. */
  void ended(Watch watch) {
    watches.remove(watch);
  }

  /**
   * Reads variables again and again.
   *
   * @param watchConfig what to read, and how often
   * @param listener takes the samples, in a thread of its own; more can be added
   * @return the watch, which runs already; it is to be closed
   */
  public Watch watch(WatchConfig watchConfig, Consumer<? super Sample> listener) {
    Watch watch = new Watch(this, watchConfig);
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
    return read(name).text();
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
    write(name, value);
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
    encodeWrite(name, value);
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
    return describe(name, read(name));
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
    return describe(name, write(name, val));
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
    TextAnswer exchanged = value == null ? read(name) : write(name, value);
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

  // --- the same in another thread

  /**
   * Does what {@link #readVariable(KRLVariable)} does, in another thread.
   *
   * @param variable names what to read and gets the value
   * @return the result to come; cancelling it before it is sent means that it is not sent
   */
  public CompletableFuture<Void> readVariableAsync(KRLVariable variable) {
    return doAsync(() -> readVariable(variable));
  }

  /**
   * Does what {@link #writeVariable(KRLVariable)} does, in another thread.
   *
   * @param variable names what to write and has the value
   * @return the result to come; cancelling it before it is sent means that it is not sent
   */
  public CompletableFuture<Void> writeVariableAsync(KRLVariable variable) {
    return doAsync(() -> writeVariable(variable));
  }

  /**
   * Does what {@link #writeFields} does, in another thread.
   *
   * @param struct names what to write and has the values
   * @param fields names of its fields, at least one
   * @return the result to come; cancelling it before it is sent means that it is not sent
   */
  public CompletableFuture<Void> writeFieldsAsync(KRLStruct struct, String... fields) {
    return doAsync(() -> writeFields(struct, fields));
  }

  /**
   * Does what {@link #readVariable(KRLArray, ArrayProgress)} does, in another thread.
   *
   * @param array names what to read and gets the elements
   * @param progress hears how far it has come
   * @return the result to come; cancelling it before it is sent means that it is not sent
   */
  public CompletableFuture<Void> readVariableAsync(KRLArray array, ArrayProgress progress) {
    return doAsync(() -> readVariable(array, progress));
  }

  /**
   * Does what {@link #writeVariable(KRLArray, ArrayProgress)} does, in another thread.
   *
   * @param array names what to write and has the elements
   * @param progress hears how far it has come
   * @return the result to come; cancelling it before it is sent means that it is not sent
   */
  public CompletableFuture<Void> writeVariableAsync(KRLArray array, ArrayProgress progress) {
    return doAsync(() -> writeVariable(array, progress));
  }

  /**
   * Does what {@link #readVariables(List)} does, in another thread.
   *
   * @param variables what to read
   * @return the result to come; cancelling it before it is sent means that it is not sent
   */
  public CompletableFuture<List<VariableResult>> readVariablesAsync(
      List<? extends KRLVariable> variables) {
    return callAsync(() -> readVariables(variables));
  }

  /**
   * Does what {@link #writeVariables(List)} does, in another thread.
   *
   * @param variables what to write
   * @return the result to come; cancelling it before it is sent means that it is not sent
   */
  public CompletableFuture<List<VariableResult>> writeVariablesAsync(
      List<? extends KRLVariable> variables) {
    return callAsync(() -> writeVariables(variables));
  }

  /**
   * Does what {@link #readText} does, in another thread.
   *
   * @param name the variable's name
   * @return the result to come; cancelling it before it is sent means that it is not sent
   */
  public CompletableFuture<String> readTextAsync(String name) {
    return callAsync(() -> readText(name));
  }

  /**
   * Does what {@link #writeText} does, in another thread.
   *
   * @param name the variable's name
   * @param value KRL text
   * @return the result to come; cancelling it before it is sent means that it is not sent
   */
  public CompletableFuture<Void> writeTextAsync(String name, String value) {
    return doAsync(() -> writeText(name, value));
  }

  /**
   * Does what {@link #readValue} does, in another thread.
   *
   * @param name the variable's name
   * @return the result to come; cancelling it before it is sent means that it is not sent
   */
  public CompletableFuture<KrlValue> readValueAsync(String name) {
    return callAsync(() -> readValue(name));
  }

  /**
   * Does what {@link #simpleRead} does, in another thread.
   *
   * @param name the variable's name
   * @return the result to come; cancelling it before it is sent means that it is not sent
   */
  public CompletableFuture<String> simpleReadAsync(String name) {
    return callAsync(() -> simpleRead(name));
  }

  /**
   * Does what {@link #simpleWrite} does, in another thread.
   *
   * @param name the variable's name
   * @param val the value as KRL text
   * @return the result to come; cancelling it before it is sent means that it is not sent
   */
  public CompletableFuture<String> simpleWriteAsync(String name, String val) {
    return callAsync(() -> simpleWrite(name, val));
  }

  /**
   * Does what {@link #readJointAngles} does, in another thread.
   *
   * @return the result to come; cancelling it before it is sent means that it is not sent
   */
  public CompletableFuture<double[]> readJointAnglesAsync() {
    return callAsync(() -> readJointAngles());
  }

  /**
   * Does what {@link #readJointTorques} does, in another thread.
   *
   * @return the result to come; cancelling it before it is sent means that it is not sent
   */
  public CompletableFuture<double[]> readJointTorquesAsync() {
    return callAsync(() -> readJointTorques());
  }

  /** Does something that may fail. */
  @FunctionalInterface
  private interface Action {
    void run() throws IOException;
  }

  private CompletableFuture<Void> doAsync(Action action) {
    return AsyncCall.<@Nullable Void>submit(
        async,
        callbacks,
        link,
        () -> {
          action.run();
          return null;
        });
  }

  private <T> CompletableFuture<T> callAsync(Callable<T> call) {
    return AsyncCall.submit(async, callbacks, link, call);
  }

  // --- exchanges

  private TextAnswer read(String name) throws CrossComException {
    if (!Latin1.has(checkName(name))) {
      return readUtf16(name);
    }
    byte[] frame = Codec.encode(new ReadRequest(0, name));
    lock.lock();
    try {
      Answer answer = read(frame, name);
      TextAnswer wide = readDoubtful(answer, name);
      return wide == null ? answer.toText() : wide;
    } finally {
      lock.unlock();
    }
  }

  private TextAnswer write(String name, String value) throws CrossComException {
    byte[] frame = encodeWrite(name, value);
    if (frame == null) {
      return writeUtf16(name, value);
    }
    lock.lock();
    try {
      return write(frame, name).toText();
    } finally {
      lock.unlock();
    }
  }

  /**
   * Reads a variable again if function 0 may not have given it as it is. The lock is held.
   *
   * @return nothing if the answer that there is holds; else what to take instead
   */
  private @Nullable TextAnswer readDoubtful(Answer answer, String name) throws CrossComException {
    if (!Latin1.isDoubtful(answer.frame()) || answer.frame().length() > MAX_UTF16_ANSWER) {
      return null;
    }
    TextAnswer first = answer.toText();
    try {
      String what = "read of " + name;
      return messages.find(what, ServerDetector::type) == ServerType.C3_BRIDGE
          ? readUtf16Only(name)
          : first;
    } catch (CrossComUnsupportedException e) {
      return first; // the connection was made anew meanwhile, to another server
    }
  }

  /** Reads a variable whose name function 0 cannot carry. */
  private TextAnswer readUtf16(String name) throws CrossComException {
    try {
      return readUtf16Only(name);
    } catch (CrossComUnsupportedException e) {
      throw new IllegalArgumentException("a variable's name " + Latin1.violation(name), e);
    }
  }

  private TextAnswer readUtf16Only(String name) throws CrossComException {
    MessageAnswer answered =
        messages.exchange(new ReadUtf16Request(0, name), TextResponse.class, "read of " + name);
    Tail tail = answered.response().tail();
    String text = text(answered.response());
    if (!tail.success() || text.isEmpty()) {
      throw new CrossComAccessException(name, Operation.READ, tail.success(), tail.code());
    }
    return new TextAnswer(text, answered.nanos());
  }

  private TextAnswer writeUtf16(String name, String value) throws CrossComException {
    MessageAnswer answered;
    try {
      answered =
          messages.exchange(writeUtf16Request(name, value), TextResponse.class, "write of " + name);
    } catch (CrossComUnsupportedException e) {
      if (!Latin1.has(name)) {
        throw new IllegalArgumentException("a variable's name " + Latin1.violation(name), e);
      }
      throw new CrossComValueException(
          name, value, "the value cannot be sent: it " + Latin1.violation(value), e);
    }
    Tail tail = answered.response().tail();
    if (!tail.success()) {
      throw new CrossComAccessException(name, Operation.WRITE, false, tail.code());
    }
    return new TextAnswer(text(answered.response()), answered.nanos());
  }

  private static WriteUtf16Request writeUtf16Request(String name, String value)
      throws CrossComValueException {
    try {
      return new WriteUtf16Request(0, name, value);
    } catch (IllegalArgumentException e) {
      throw new CrossComValueException(
          name, value, "the value cannot be sent: " + e.getMessage(), e);
    }
  }

  /** Gives the text of an answer, which has none if it says failure. */
  private static String text(TypedResponse response) {
    return response instanceof TextResponse text ? text.text() : "";
  }

  /**
   * Encodes a write.
   *
   * @return the frame; nothing if function 1 cannot carry the text
   */
  private byte @Nullable [] encodeWrite(String name, String value) throws CrossComValueException {
    checkName(name);
    checkAggregate(name, value);
    if (!Latin1.has(name) || !Latin1.has(value)) {
      return null;
    }
    byte[] frame;
    try {
      frame = Codec.encode(new WriteRequest(0, name, value));
    } catch (IllegalArgumentException e) {
      throw new CrossComValueException(
          name, value, "the value cannot be sent: " + e.getMessage(), e);
    }
    if (frame.length > config.maxRequestLength()) {
      throw tooLong(name, value, frame.length);
    }
    return frame;
  }

  /** Refuses an aggregate that is too long for the controller. */
  void checkAggregate(String name, String value) throws CrossComValueException {
    Objects.requireNonNull(value, () -> "the value to be written to " + name);
    int limit = config.maxAggregateLength();
    if (limit > 0 && value.length() > limit && value.stripLeading().startsWith("{")) {
      throw new CrossComValueException(
          name,
          value,
          "an aggregate to be written must have at most "
              + limit
              + " bytes, has "
              + value.length()
              + AggregateLength.describe(value)
              + ": "
              + value,
          null);
    }
  }

  private CrossComValueException tooLong(String name, String text, int length) {
    return new CrossComValueException(
        name,
        text,
        "a request must have at most " + config.maxRequestLength() + " bytes, has " + length,
        null);
  }

  private static String checkName(String name) {
    Objects.requireNonNull(name, "the variable's name");
    if (name.isBlank()) {
      throw new IllegalArgumentException("a variable's name must not be blank");
    }
    return name;
  }

  private Answer read(byte[] frame, String name) throws CrossComException {
    if (frame.length > config.maxRequestLength()) {
      throw tooLong(name, name, frame.length);
    }
    Answer answer = link.exchange(frame, frame.length, MessageType.READ, name);
    AnswerFrame result = answer.frame();
    // KUKAVARPROXY of 2019 and later says success when the controller refuses (krl.md 1.8)
    if (!result.success() || result.isEmpty()) {
      throw new CrossComAccessException(name, Operation.READ, result.success(), result.code());
    }
    return answer;
  }

  private Answer write(byte[] frame, String name) throws CrossComException {
    Answer answer = link.exchange(frame, frame.length, MessageType.WRITE, name);
    if (!answer.frame().success()) {
      throw new CrossComAccessException(name, Operation.WRITE, false, answer.frame().code());
    }
    return answer;
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
    return link.isClosed();
  }

  /**
   * Gives the address of the controller.
   *
   * @return the address connected to
   */
  public InetAddress getInetAddress() {
    return link.connection().remoteAddress();
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
    return link.connection().localPort();
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
    link.setTimeout(Duration.ofMillis(millis).toNanos());
  }

  /**
   * Gives how long an exchange may take.
   *
   * @return in ms; 0 for no limit
   * @throws SocketException never; declared for programs of the original, which may catch it
   */
  public int getSoTimeout() throws SocketException {
    return (int) Duration.ofNanos(link.timeoutNanos()).toMillis();
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
    link.close();
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
