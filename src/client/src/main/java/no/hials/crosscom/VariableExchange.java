package no.hials.crosscom;

import java.util.List;
import java.util.Objects;
import java.util.concurrent.locks.ReentrantLock;
import no.hials.crosscom.CrossComAccessException.Operation;
import no.hials.crosscom.KRL.KRLAny;
import no.hials.crosscom.KRL.KRLArray;
import no.hials.crosscom.KRL.KRLVariable;
import no.hials.crosscom.internal.Latin1;
import no.hials.crosscom.internal.VariableAccess;
import no.hials.crosscom.internal.VariableName;
import no.hials.crosscom.protocol.AnswerFrame;
import no.hials.crosscom.protocol.Codec;
import no.hials.crosscom.protocol.FrameWriter;
import no.hials.crosscom.protocol.MessageType;
import no.hials.crosscom.protocol.ServerType;
import no.hials.crosscom.protocol.Tail;
import no.hials.crosscom.protocol.TextResponse;
import no.hials.crosscom.protocol.TypedResponse;
import no.hials.crosscom.protocol.value.KrlScanner;
import no.hials.crosscom.protocol.value.KrlSyntaxException;
import no.hials.crosscom.protocol.variable.VariableRequest.ReadRequest;
import no.hials.crosscom.protocol.variable.VariableRequest.ReadUtf16Request;
import no.hials.crosscom.protocol.variable.VariableRequest.WriteUtf16Request;
import org.jspecify.annotations.Nullable;

/**
 * Reads and writes variables: with functions 0 and 1, which carry ISO 8859-1; in UTF-16 where that
 * is not enough and the server is C3 Bridge; arrays element by element if necessary; and several
 * variables at once.
 *
 * <p>Reading or writing a number, or a structure of numbers, creates no objects: a request is
 * encoded into a buffer that is used again, and the variable is set from the answer in place. The
 * lock of the connection guards the buffers.
 */
final class VariableExchange {
  static final ArrayProgress NO_PROGRESS = (done, total) -> {};

  /** The longest text of an answer in UTF-16: 65,535 bytes less type, length and tail, halved. */
  private static final int MAX_UTF16_ANSWER = 32_764;

  private final ClientConfig config;
  private final ReconnectingConnection connection;
  private final C3Channel channel;
  private final ReentrantLock lock;

  // guarded by the lock
  private final KrlScanner scanner = new KrlScanner();
  private final FrameWriter writer = new FrameWriter();

  VariableExchange(ClientConfig config, ReconnectingConnection connection, C3Channel channel) {
    this.config = config;
    this.connection = connection;
    this.channel = channel;
    this.lock = connection.lock();
  }

  // --- by name

  TextAnswer read(String name) throws CrossComException {
    if (!Latin1.has(VariableName.check(name))) {
      return readUtf16(name);
    }
    byte[] frame = Codec.encode(new ReadRequest(0, name));
    lock.lock();
    try {
      Answer answer = sendRead(frame, name);
      TextAnswer wide = readDoubtful(answer, name);
      return wide == null ? answer.toText() : wide;
    } finally {
      lock.unlock();
    }
  }

  TextAnswer write(String name, String value) throws CrossComException {
    check(name, value);
    if (!isLatin1(name, value)) {
      return writeUtf16(name, value);
    }
    lock.lock();
    try {
      return sendWrite(name, value).toText();
    } finally {
      lock.unlock();
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

  /** Writes likewise. */
  TextAnswer writeOrEmpty(String name, String value) throws CrossComException {
    long start = System.nanoTime();
    try {
      return write(name, value);
    } catch (CrossComAccessException e) {
      return new TextAnswer("", System.nanoTime() - start);
    }
  }

  /** Refuses what {@link #write(String, String)} would refuse before it sends anything. */
  void checkWrite(String name, String value) throws CrossComValueException {
    check(name, value);
    if (isLatin1(name, value)) {
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
    if (frame == null) {
      take(variable, readUtf16(name), false);
      return;
    }
    TextAnswer wide;
    String text = null;
    lock.lock();
    try {
      Answer answer = sendRead(frame, name);
      wide = access.holdsText(variable) ? readDoubtful(answer, name) : null;
      if (wide == null) {
        text = takeInPlace(variable, answer, false);
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
    check(name, value);
    if (!isLatin1(name, value)) {
      takeEcho(variable, writeUtf16(name, value.toString()));
      return;
    }
    String echo = null;
    lock.lock();
    try {
      Answer answer = sendWrite(name, value);
      if (answer.frame().isEmpty()) {
        // done, but there is no value to update the variable from
        VariableAccess.get().setReadTime(variable, answer.nanos());
      } else {
        echo = takeInPlace(variable, answer, true);
      }
    } finally {
      lock.unlock();
    }
    takeText(variable, echo, true);
  }

  // --- arrays

  void read(KRLArray array, ArrayProgress progress) throws CrossComException {
    Objects.requireNonNull(progress, "progress");
    try {
      readWhole(Objects.requireNonNull(array, "array"));
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

  /** Sets a variable from a text. The lock is not held. */
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

  /** Updates a variable from the answer to a write. The lock is not held. */
  static void takeEcho(KRLVariable variable, TextAnswer echo) throws CrossComValueException {
    if (echo.text().isEmpty()) {
      // done, but there is no value to update the variable from
      VariableAccess.get().setReadTime(variable, echo.nanos());
    } else {
      take(variable, echo, true);
    }
  }

  /**
   * Sets a variable from an answer in place. The lock is held.
   *
   * @param written whether the answer is that to a write
   * @return null if the variable is set; otherwise the text for {@link #takeText}
   */
  private @Nullable String takeInPlace(KRLVariable variable, Answer answer, boolean written)
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

  /** Sets a variable of a class of the program, whose code does not run under the lock. */
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
    String type = variable instanceof KRLAny ? "a KRL value" : "a value for " + variable.getType();
    return new CrossComValueException(
        variable.getName(),
        text,
        (written ? "the write was done, but its answer" : "the answer of the controller")
            + " is not "
            + type
            + ": "
            + e.getMessage(),
        e);
  }

  // --- ISO 8859-1: functions 0 and 1; the lock is held

  private Answer sendRead(byte[] frame, String name) throws CrossComException {
    if (frame.length > config.maxRequestLength()) {
      throw tooLong(name, name, frame.length);
    }
    Answer answer = connection.exchange(frame, frame.length, MessageType.READ, name);
    AnswerFrame result = answer.frame();
    // KUKAVARPROXY of 2019 and later says success when the controller refuses
    // (docs/reference/kukavarproxy.md#refused-accesses)
    if (!result.success() || result.isEmpty()) {
      throw new CrossComAccessException(name, Operation.READ, result.success(), result.code());
    }
    return answer;
  }

  private Answer sendWrite(String name, CharSequence value) throws CrossComException {
    encode(writer, name, value);
    Answer answer = connection.exchange(writer.buffer(), writer.length(), MessageType.WRITE, name);
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

  // --- UTF-16

  /**
   * Reads a variable again if function 0 may have returned another text. The lock is held.
   *
   * @return null if the first answer is right; otherwise the text to take instead
   */
  private @Nullable TextAnswer readDoubtful(Answer answer, String name) throws CrossComException {
    if (!Latin1.isDoubtful(answer.frame()) || answer.frame().length() > MAX_UTF16_ANSWER) {
      return null;
    }
    TextAnswer first = answer.toText();
    try {
      return channel.find("read of " + name, ServerDetector::type) == ServerType.C3_BRIDGE
          ? readUtf16Only(name)
          : first;
    } catch (CrossComUnsupportedException e) {
      return first; // reconnected meanwhile, to another server
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
    MessageAnswer answer =
        channel.exchange(new ReadUtf16Request(0, name), TextResponse.class, "read of " + name);
    Tail tail = answer.response().tail();
    String text = text(answer.response());
    if (!tail.success() || text.isEmpty()) {
      throw new CrossComAccessException(name, Operation.READ, tail.success(), tail.code());
    }
    return new TextAnswer(text, answer.nanos());
  }

  private TextAnswer writeUtf16(String name, String value) throws CrossComException {
    WriteUtf16Request request;
    try {
      request = new WriteUtf16Request(0, name, value);
    } catch (IllegalArgumentException e) {
      throw cannotBeSent(name, value, e.getMessage(), e);
    }
    MessageAnswer answer;
    try {
      answer = channel.exchange(request, TextResponse.class, "write of " + name);
    } catch (CrossComUnsupportedException e) {
      if (!Latin1.has(name)) {
        throw new IllegalArgumentException("a variable's name " + Latin1.violation(name), e);
      }
      throw cannotBeSent(name, value, "it " + Latin1.violation(value), e);
    }
    Tail tail = answer.response().tail();
    if (!tail.success()) {
      throw new CrossComAccessException(name, Operation.WRITE, false, tail.code());
    }
    return new TextAnswer(text(answer.response()), answer.nanos());
  }

  /** Returns the text of an answer; an answer that says failure has none. */
  private static String text(TypedResponse response) {
    return response instanceof TextResponse text ? text.text() : "";
  }

  // --- what a request may hold

  private static boolean isLatin1(String name, CharSequence value) {
    return Latin1.has(name) && Latin1.has(value);
  }

  private void check(String name, CharSequence value) throws CrossComValueException {
    VariableName.check(name);
    checkAggregate(name, value);
  }

  /** Refuses an aggregate that is too long for the controller. */
  void checkAggregate(String name, CharSequence value) throws CrossComValueException {
    if (value == null) { // not by requireNonNull, as its supplier would be an object
      throw new NullPointerException("the value to be written to " + name);
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
      String name, String value, @Nullable String why, Exception cause) {
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
