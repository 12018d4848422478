package no.hials.crosscom;

import java.util.List;
import java.util.Objects;
import no.hials.crosscom.CrossComAccessException.Operation;
import no.hials.crosscom.KRL.KRLAny;
import no.hials.crosscom.KRL.KRLArray;
import no.hials.crosscom.KRL.KRLChar;
import no.hials.crosscom.KRL.KRLRecord;
import no.hials.crosscom.KRL.KRLString;
import no.hials.crosscom.KRL.KRLVariable;
import no.hials.crosscom.internal.VariableAccess;
import no.hials.crosscom.internal.VariableName;
import no.hials.crosscom.internal.exchange.AggregateLength;
import no.hials.crosscom.internal.exchange.ExchangeAnswer;
import no.hials.crosscom.internal.exchange.MessageAnswer;
import no.hials.crosscom.internal.exchange.Repeatability;
import no.hials.crosscom.internal.exchange.TextAnswer;
import no.hials.crosscom.internal.exchange.TextCharset;
import no.hials.crosscom.protocol.AnswerFrame;
import no.hials.crosscom.protocol.Codec;
import no.hials.crosscom.protocol.ErrorCode;
import no.hials.crosscom.protocol.FrameWriter;
import no.hials.crosscom.protocol.MessageType;
import no.hials.crosscom.protocol.ServerType;
import no.hials.crosscom.protocol.Tail;
import no.hials.crosscom.protocol.TextResponse;
import no.hials.crosscom.protocol.TypedResponse;
import no.hials.crosscom.protocol.value.KrlScanner;
import no.hials.crosscom.protocol.value.KrlSyntaxException;
import no.hials.crosscom.protocol.value.KrlText;
import no.hials.crosscom.protocol.variable.AccessResult;
import no.hials.crosscom.protocol.variable.VariableRequest.ReadMultipleRequest;
import no.hials.crosscom.protocol.variable.VariableRequest.ReadRequest;
import no.hials.crosscom.protocol.variable.VariableRequest.ReadUtf16Request;
import no.hials.crosscom.protocol.variable.VariableRequest.WriteUtf16Request;
import no.hials.crosscom.protocol.variable.VariableResponse.MultipleResponse;
import org.jspecify.annotations.Nullable;

/**
 * Reads and writes variables: numbers with functions 0 and 1; texts in UTF-16 if the server is C3
 * Bridge, otherwise in the configured charset; arrays element by element if necessary; and several
 * variables at once. The class is long because numbers, texts and arrays share the checks and
 * errors of an access.
 *
 * <p>Reading or writing a number, or a structure of numbers, creates no objects: a request is
 * encoded into a buffer that is used again, and the variable is set from the answer in place. The
 * turn of the connection guards the buffers.
 */
final class VariableExchange {
  static final ArrayProgress NO_PROGRESS = (done, total) -> {};

  /** The longest text of an answer in UTF-16: 65,535 bytes less type, length and tail, halved. */
  private static final int MAX_UTF16_ANSWER = 32_764;

  private final ClientConfig config;
  private final ReconnectingConnection connection;
  private final C3Channel channel;
  private final TextCharset charset;

  // guarded by the turn
  private final KrlScanner scanner = new KrlScanner();
  private final FrameWriter writer = new FrameWriter();

  VariableExchange(ClientConfig config, ReconnectingConnection connection, C3Channel channel) {
    this.config = config;
    this.connection = connection;
    this.channel = channel;
    this.charset = new TextCharset(config.charset());
  }

  // --- by name

  TextAnswer read(String name) throws CrossComException {
    return readAny(VariableName.check(name), null);
  }

  TextAnswer write(String name, String value) throws CrossComException {
    check(name, value);
    if (!isPlain(name, value)) {
      return writeText(name, value);
    }
    connection.acquire(MessageType.WRITE, name);
    try {
      return sendWrite(name, value).toText();
    } finally {
      connection.release();
    }
  }

  /**
   * Reads like {@link #read(String)}, with an empty value for a refusal, for the original's API
   * only.
   */
  TextAnswer readOrEmpty(String name) throws CrossComException {
    long start = System.nanoTime();
    try {
      return read(name);
    } catch (CrossComAccessException e) {
      return new TextAnswer("", System.nanoTime() - start);
    }
  }

  /** Writes like {@link #write(String, String)}, with an empty value for a refusal. */
  TextAnswer writeOrEmpty(String name, String value) throws CrossComException {
    long start = System.nanoTime();
    try {
      return write(name, value);
    } catch (CrossComAccessException e) {
      return new TextAnswer("", System.nanoTime() - start);
    }
  }

  /** Refuses what {@link #write(String, String)} refuses before it knows the server. */
  void checkWrite(String name, String value) throws CrossComValueException {
    check(name, value);
    if (isPlain(name, value)) {
      encode(new FrameWriter(), name, value);
    }
  }

  // --- variables

  /** Reads a variable; an array element by element if the server cannot read it whole. */
  void read(KRLVariable variable) throws CrossComException {
    if (variable instanceof KRLArray array && array.getDeclaredLength() > 0) {
      read(array, NO_PROGRESS);
    } else {
      readWhole(variable);
    }
  }

  private void readWhole(KRLVariable variable) throws CrossComException {
    VariableAccess access = VariableAccess.get();
    byte[] frame = access.readFrame(variable);
    String name = variable.getName();
    if (isText(variable)) {
      take(variable, readText(name), false);
      return;
    }
    if (frame == null || access.holdsText(variable) || VariableName.isWhole(name)) {
      take(variable, readAny(name, frame), false);
      return;
    }
    String text;
    connection.acquire(MessageType.READ, name);
    try {
      text = takeInPlace(variable, sendRead(frame, name), false);
    } finally {
      connection.release();
    }
    takeText(variable, text, false);
  }

  /** Returns whether the value of a variable always has a text. */
  static boolean isText(KRLVariable variable) {
    return variable instanceof KRLString
        || variable instanceof KRLChar
        || (variable instanceof KRLRecord && VariableAccess.get().holdsText(variable));
  }

  /** Writes a variable, an array element by element, and updates it from the answer. */
  void write(KRLVariable variable) throws CrossComException {
    if (variable instanceof KRLArray array) {
      write(array, NO_PROGRESS);
    } else {
      write(variable, VariableAccess.get().writeText(variable));
    }
  }

  /** Writes a text to a variable, and updates it from the answer. */
  void write(KRLVariable variable, CharSequence value) throws CrossComException {
    String name = variable.getName();
    checkValue(name, value);
    if (!isPlain(name, value)) {
      takeEcho(variable, writeText(name, value.toString()));
      return;
    }
    String echo = null;
    connection.acquire(MessageType.WRITE, name);
    try {
      ExchangeAnswer answer = sendWrite(name, value);
      if (answer.frame().isEmpty()) {
        // done, but there is no value to update the variable from
        VariableAccess.get().setReadTime(variable, answer.nanos());
      } else {
        echo = takeInPlace(variable, answer, true);
      }
    } finally {
      connection.release();
    }
    takeText(variable, echo, true);
  }

  // --- arrays

  void read(KRLArray array, ArrayProgress progress) throws CrossComException {
    Objects.requireNonNull(progress, "progress");
    try {
      readWhole(Objects.requireNonNull(array, "array"));
    } catch (CrossComAccessException | CrossComValueException e) {
      boolean unreadable = !(e instanceof CrossComValueException value) || value.isTooLong();
      if (array.getDeclaredLength() == 0 || !unreadable) {
        throw e;
      }
      readElements(array, progress);
    }
  }

  void readElements(KRLArray array, ArrayProgress progress) throws CrossComException {
    int total = array.getDeclaredLength();
    long nanos = 0;
    for (int i = 1; i <= total; i++) {
      try {
        TextAnswer element = read(array.getElementName(i));
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

  void write(KRLArray array, ArrayProgress progress) throws CrossComException {
    Objects.requireNonNull(progress, "progress");
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

  // --- several variables

  List<VariableResult> readAll(List<? extends KRLVariable> variables) {
    return new Batch.Reading(this, channel, variables).run();
  }

  List<VariableResult> writeAll(List<? extends KRLVariable> variables) {
    variables.forEach(KRLVariable::getStringValue); // refuses a variable without a value
    return new Batch.Writing(this, channel, variables).run();
  }

  // --- setting a variable from an answer

  /** Sets a variable from a text. The turn is not needed. */
  static void take(KRLVariable variable, TextAnswer answer, boolean written)
      throws CrossComValueException {
    VariableAccess access = VariableAccess.get();
    boolean taken;
    try {
      taken = access.scan(variable, new KrlScanner(answer.text()), written);
    } catch (IllegalArgumentException e) {
      throw notOfType(variable, answer.text(), written, e);
    }
    access.setReadTime(variable, answer.nanos());
    takeText(variable, taken ? null : answer.text(), written);
  }

  /** Updates a variable from the answer to a write. The turn is not needed. */
  static void takeEcho(KRLVariable variable, TextAnswer echo) throws CrossComValueException {
    if (echo.text().isEmpty()) {
      // done, but there is no value to update the variable from
      VariableAccess.get().setReadTime(variable, echo.nanos());
    } else {
      take(variable, echo, true);
    }
  }

  /**
   * Sets a variable from an answer in place. This thread has the turn.
   *
   * @param written whether the answer is that to a write
   * @return null if the variable is set; otherwise the text for {@link #takeText}
   */
  private @Nullable String takeInPlace(KRLVariable variable, ExchangeAnswer answer, boolean written)
      throws CrossComValueException {
    VariableAccess access = VariableAccess.get();
    answer.frame().scan(scanner);
    try {
      boolean taken = access.scan(variable, scanner, written);
      access.setReadTime(variable, answer.nanos());
      return taken ? null : answer.frame().toString();
    } catch (IllegalArgumentException e) {
      throw notOfType(variable, answer.frame().toString(), written, e);
    }
  }

  /** Sets a variable of a class of the program, whose code does not run in the turn. */
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
    String type =
        variable instanceof KRLAny
            ? "a KRL value"
            : "a value for " + VariableAccess.get().type(variable);
    return new CrossComValueException(
        variable.getName(),
        text,
        (written ? "the write was done, but its answer" : "the answer of the controller")
            + " is not "
            + type
            + ": "
            + e.getMessage(),
        VariableAccess.get().cause(e));
  }

  // --- functions 0 and 1; this thread has the turn

  private ExchangeAnswer sendRead(byte[] frame, String name) throws CrossComException {
    checkLength(frame, name);
    return checkRead(connection.exchange(frame, frame.length, MessageType.READ, name), name);
  }

  /** Does the same on the current connection, without a repetition. */
  private ExchangeAnswer sendReadHere(byte[] frame, String name) throws CrossComException {
    checkLength(frame, name);
    return checkRead(
        connection.send(frame, frame.length, MessageType.READ, Repeatability.READ, name), name);
  }

  void checkLength(byte[] frame, String name) throws CrossComValueException {
    if (frame.length > config.maxRequestLength()) {
      throw tooLong(name, name, frame.length);
    }
  }

  static ExchangeAnswer checkRead(ExchangeAnswer answer, String name)
      throws CrossComAccessException {
    AnswerFrame result = answer.frame();
    // KUKAVARPROXY of 2019 and later says success when the controller refuses
    // (docs/reference/kukavarproxy.md#refused-accesses)
    if (!result.success() || result.isEmpty()) {
      throw new CrossComAccessException(name, Operation.READ, result.success(), result.code());
    }
    return answer;
  }

  private ExchangeAnswer sendWrite(String name, CharSequence value) throws CrossComException {
    encode(writer, name, value);
    return checkWritten(
        connection.exchange(writer.buffer(), writer.length(), MessageType.WRITE, name), name);
  }

  /** Does the same on the current connection, whose server is known. */
  private ExchangeAnswer sendWriteHere(String name, String nameBytes, String valueBytes)
      throws CrossComException {
    encode(writer, nameBytes, valueBytes);
    return checkWritten(
        connection.send(
            writer.buffer(), writer.length(), MessageType.WRITE, Repeatability.CHANGE, name),
        name);
  }

  private static ExchangeAnswer checkWritten(ExchangeAnswer answer, String name)
      throws CrossComAccessException {
    AnswerFrame result = answer.frame();
    if (!result.success()) {
      throw new CrossComAccessException(name, Operation.WRITE, false, result.code());
    }
    return answer;
  }

  private void encode(FrameWriter out, String name, CharSequence value)
      throws CrossComValueException {
    try {
      out.write(name, value);
    } catch (IllegalArgumentException e) {
      throw cannotBeSent(name, value.toString(), e.getMessage(), e);
    }
    if (out.length() > config.maxRequestLength()) {
      throw tooLong(name, value.toString(), out.length());
    }
  }

  // --- texts: in UTF-16 if the server is C3 Bridge, else in the charset of KUKAVARPROXY

  /**
   * Reads a variable whose type is not known with function 0, and again if it has a text. Each text
   * of KRL is in double quotes, which no code page changes; only the server's own variables have
   * texts without.
   *
   * @param encoded the request, if it has been encoded before
   */
  private TextAnswer readAny(String name, byte @Nullable [] encoded) throws CrossComException {
    if (isReadAsText(name)) {
      return readText(name);
    }
    byte[] frame = encoded == null ? Codec.encode(new ReadRequest(0, name)) : encoded;
    C3Channel.Question<TextAnswer> read = server -> exact(server, sendReadHere(frame, name), name);
    return channel.find(
        "read of " + name,
        read,
        VariableName.isWhole(name) ? server -> readWhole(server, name) : read);
  }

  /** Returns the text of an answer to function 0; reads it again if that is not exact. */
  private TextAnswer exact(ServerDetector server, ExchangeAnswer answer, String name)
      throws CrossComException {
    TextAnswer bytes = answer.toText();
    if (TextCharset.isPlain(answer.frame())) {
      return bytes;
    }
    if (server.type() == ServerType.KUKAVARPROXY) {
      return decode(bytes, name, false);
    }
    checkUtf16(bytes, name);
    return readUtf16(name);
  }

  /** Returns whether function 0 cannot read a variable, or its value can have any character. */
  static boolean isReadAsText(String name) {
    return !TextCharset.isPlain(name) || name.startsWith("@");
  }

  /** Refuses to read a value again in UTF-16 if it is too long. */
  static void checkUtf16(TextAnswer bytes, String name) throws CrossComValueException {
    if (bytes.text().length() > MAX_UTF16_ANSWER) {
      throw new CrossComValueException(
          name, bytes.text(), "the value is too long for an answer in UTF-16", null);
    }
  }

  /** Reads a variable that has a text. */
  private TextAnswer readText(String name) throws CrossComException {
    return channel.find(
        "read of " + name, server -> readText(server, name), server -> readWhole(server, name));
  }

  private TextAnswer readText(ServerDetector server, String name) throws CrossComException {
    return server.type() == ServerType.KUKAVARPROXY
        ? decode(
            sendReadHere(Codec.encode(new ReadRequest(0, encodeName(name))), name).toText(),
            name,
            false)
        : readUtf16(name);
  }

  /**
   * Reads an array or a text when the first read has lost the connection. C3 Bridge closes the
   * connection if a value is too long for messages 0 and 4, but answers message 6
   * (docs/reference/c3-messages.md#framing).
   */
  private TextAnswer readWhole(ServerDetector server, String name) throws CrossComException {
    if (!VariableName.isWhole(name) || !server.supportsCorrectly(MessageType.READ_MULTIPLE)) {
      return readText(server, name);
    }
    MessageAnswer answer =
        connection.send(
            Codec.encode(new ReadMultipleRequest(0, List.of(name))),
            MessageType.READ_MULTIPLE,
            Repeatability.READ,
            "read of " + name,
            MultipleResponse.class);
    TextAnswer whole = whole(answer, name);
    return whole == null ? readText(server, name) : whole;
  }

  /** Returns the value of an answer to message 6 for one variable; null if it has no result. */
  static @Nullable TextAnswer whole(MessageAnswer answer, String name) throws CrossComException {
    Tail tail = answer.response().tail();
    if (tail.code() == ErrorCode.LONG_ANSWER.code()) {
      throw CrossComValueException.tooLong(name);
    }
    if (!(answer.response() instanceof MultipleResponse one) || one.results().size() != 1) {
      return null;
    }
    AccessResult result = one.results().get(0);
    if (!result.success() || result.value().isEmpty()) {
      throw new CrossComAccessException(
          name, Operation.READ, result.success(), result.code().number());
    }
    return new TextAnswer(result.value(), answer.nanos());
  }

  private TextAnswer readUtf16(String name) throws CrossComException {
    MessageAnswer answer =
        connection.send(
            Codec.encode(new ReadUtf16Request(0, name)),
            MessageType.READ_UTF16,
            Repeatability.READ,
            "read of " + name,
            TextResponse.class);
    return utf16(answer, name);
  }

  /** Returns the value of an answer to a read in UTF-16. */
  static TextAnswer utf16(MessageAnswer answer, String name) throws CrossComAccessException {
    Tail tail = answer.response().tail();
    String text = text(answer.response());
    if (!tail.success() || text.isEmpty()) {
      throw new CrossComAccessException(name, Operation.READ, tail.success(), tail.code());
    }
    return new TextAnswer(text, answer.nanos());
  }

  /** Writes a value that can hold text. */
  private TextAnswer writeText(String name, String value) throws CrossComException {
    return channel.change(
        "write of " + name,
        ServerDetector::type,
        server ->
            server.type() == ServerType.KUKAVARPROXY
                ? decode(
                    sendWriteHere(name, encodeName(name), encodeValue(name, value)).toText(),
                    name,
                    true)
                : writeUtf16(name, value));
  }

  private TextAnswer writeUtf16(String name, String value) throws CrossComException {
    byte[] frame;
    try {
      frame = Codec.encode(new WriteUtf16Request(0, name, value));
    } catch (IllegalArgumentException e) {
      throw cannotBeSent(name, value, e.getMessage(), e);
    }
    MessageAnswer answer =
        connection.send(
            frame,
            MessageType.WRITE_UTF16,
            Repeatability.CHANGE,
            "write of " + name,
            TextResponse.class);
    Tail tail = answer.response().tail();
    if (!tail.success()) {
      throw new CrossComAccessException(name, Operation.WRITE, false, tail.code());
    }
    return new TextAnswer(text(answer.response()), answer.nanos());
  }

  String encodeName(String name) {
    String violation = charset.violation(name);
    if (violation != null) {
      throw new IllegalArgumentException(
          "a variable's name cannot be sent: " + violation,
          new CrossComUnsupportedException(
              "access to " + name, MessageType.READ_UTF16, ServerType.KUKAVARPROXY, null));
    }
    return charset.encode(name);
  }

  private String encodeValue(String name, String value) throws CrossComValueException {
    String violation = charset.violation(value);
    if (violation != null) {
      throw cannotBeSent(name, value, violation, null);
    }
    return charset.encode(value);
  }

  TextAnswer decode(TextAnswer bytes, String name, boolean written) throws CrossComValueException {
    try {
      return new TextAnswer(charset.decode(bytes.text()), bytes.nanos());
    } catch (IllegalArgumentException e) {
      throw new CrossComValueException(
          name,
          bytes.text(),
          (written ? "the write was done, but its answer" : "the answer of the controller")
              + " cannot be read: "
              + e.getMessage(),
          e);
    }
  }

  /** Returns the text of an answer; an answer that says failure has none. */
  private static String text(TypedResponse response) {
    return response instanceof TextResponse text ? text.text() : "";
  }

  // --- what a request may hold

  private static boolean isPlain(String name, CharSequence value) {
    return TextCharset.isPlain(name) && TextCharset.isPlain(value);
  }

  private void check(String name, CharSequence value) throws CrossComValueException {
    VariableName.check(name);
    checkValue(name, value);
  }

  /** Refuses more than one line, and an aggregate that is too long for the controller. */
  void checkValue(String name, CharSequence value) throws CrossComValueException {
    if (value == null) { // not by requireNonNull, as its supplier would be an object
      throw new NullPointerException("the value to be written to " + name);
    }
    // a KrlText has no texts: it is a number, BOOL or structure of numbers
    int bad = value instanceof KrlText ? -1 : VariableName.indexOfLineEnd(value, true);
    if (bad >= 0) {
      String why = "must be one line, has U+%04X at index %d";
      throw cannotBeSent(name, value.toString(), why.formatted((int) value.charAt(bad), bad), null);
    }
    int limit = config.maxAggregateLength();
    if (limit > 0 && value.length() > limit && value.toString().stripLeading().startsWith("{")) {
      throw CrossComValueException.notSent(
          name,
          value.toString(),
          "an aggregate to be written must have at most "
              + limit
              + " bytes, has "
              + value.length()
              + AggregateLength.describe(value.toString())
              + ": "
              + value,
          null);
    }
  }

  private static CrossComValueException cannotBeSent(
      String name, String value, @Nullable String why, @Nullable Exception cause) {
    return CrossComValueException.notSent(name, value, "the value cannot be sent: " + why, cause);
  }

  private CrossComValueException tooLong(String name, String text, int length) {
    return CrossComValueException.notSent(
        name,
        text,
        "a request must have at most " + config.maxRequestLength() + " bytes, has " + length,
        null);
  }
}
