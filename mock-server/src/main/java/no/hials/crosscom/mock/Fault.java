package no.hials.crosscom.mock;

import java.time.Duration;
import java.util.Arrays;
import java.util.HexFormat;
import java.util.List;
import java.util.Objects;
import java.util.concurrent.CountDownLatch;
import no.hials.crosscom.mock.internal.Checks;
import no.hials.crosscom.mock.internal.KukavarproxyHandler;
import no.hials.crosscom.protocol.Tail;

/**
 * Something that goes wrong with one request: how it is answered instead of properly.
 *
 * <p>A fault is set with {@link MockServer#enqueue}, {@link MockServer#fault} or {@link
 * MockServer#faults}; a {@link FaultRule} chooses the requests by number, name or chance, and can
 * be read from text. It says by {@link #executes} whether the controller still does what the
 * request asks, which decides what a client finds when it looks again after a lost write. Delays
 * and pauses hold up the one connection, not the server; {@link MockServer#close} ends them.
 */
public sealed interface Fault {

  /**
   * Says whether the request is executed on the variables before the fault.
   *
   * @return true if a write takes effect
   */
  boolean executes();

  // the factories, in the order of the records below

  /**
   * Makes a fault that is none: the request is executed and answered.
   *
   * @return the fault
   */
  static Fault none() {
    return new None();
  }

  /**
   * Answers with these bytes instead. Not executed.
   *
   * @param segments hexadecimal digits, blanks between them or not; each text is sent in a write of
   *     its own
   * @return the fault
   */
  static Fault raw(String... segments) {
    return new Raw(List.of(segments));
  }

  /**
   * Answers id and function of the request with this value and tail. Not executed.
   *
   * <p>In an answer that only C3 Bridge gives, the value is its text; the value of every item, each
   * with the tail's code, of a batch; the names of a directory, one a line; the computer name of
   * type 13; the features of type 14 as {@code @PROXY_FEATURES} has them. In UTF-16 it is cut to
   * what the answer holds. Other answers leave it out, and have nothing but what they repeat of the
   * request, and the tail.
   *
   * @param value the value; for an array of 16-bit numbers their decimal text
   * @param tail the tail
   * @return the fault
   */
  static Fault answer(String value, Tail tail) {
    return new Answer(value, tail);
  }

  /**
   * Answers with the id and nothing else, as an unknown function is answered. Not executed.
   *
   * @return the fault
   */
  static Fault emptyAnswer() {
    return new EmptyAnswer();
  }

  /**
   * Drops the request without an answer, as KUKAVARPROXY does while it serves another. Not
   * executed.
   *
   * @return the fault
   */
  static Fault drop() {
    return new Drop(false);
  }

  /**
   * Executes the request, and never answers.
   *
   * @return the fault
   */
  static Fault dropAnswer() {
    return new Drop(true);
  }

  /**
   * Closes the connection instead of an answer. Not executed.
   *
   * @return the fault
   */
  static Fault closeBefore() {
    return new CloseBefore(false);
  }

  /**
   * Resets the connection (TCP RST) instead of an answer. Not executed.
   *
   * @return the fault
   */
  static Fault resetBefore() {
    return new CloseBefore(true);
  }

  /**
   * Executes the request, and closes the connection within its answer.
   *
   * @param bytes how many bytes of the answer are sent; 0 for none
   * @return the fault
   */
  static Fault closeDuring(int bytes) {
    return new CloseDuring(bytes);
  }

  /**
   * Executes and answers the request, and then closes the connection.
   *
   * @return the fault
   */
  static Fault closeAfter() {
    return new CloseAfter();
  }

  /**
   * Executes the request at once, and answers later.
   *
   * @param time how much later
   * @return the fault
   */
  static Fault delay(Duration time) {
    return new Delay(time);
  }

  /**
   * Executes the request at once, and answers when a test says so: a stall without a clock.
   *
   * @param released the answer is sent when it is counted down
   * @return the fault
   */
  static Fault hold(CountDownLatch released) {
    return new Hold(released);
  }

  /**
   * Executes the request, and cuts its answer into pieces, each sent by a write of its own. What is
   * left behind the last piece is one more.
   *
   * @param sizes the lengths of the pieces
   * @return the fault
   */
  static Fault split(int... sizes) {
    return new Split(Arrays.stream(sizes).boxed().toList(), Duration.ZERO);
  }

  /**
   * Executes the request, and sends its answer one byte at a time, without a pause.
   *
   * @return the fault
   */
  static Fault oneByteAtATime() {
    return new OneByteAtATime(Duration.ZERO);
  }

  /**
   * Executes the request, and sends its answer one byte at a time.
   *
   * @param pause how long to wait between two bytes, so that they do not arrive together
   * @return the fault
   */
  static Fault oneByteAtATime(Duration pause) {
    return new OneByteAtATime(pause);
  }

  /**
   * Executes the request once, and sends its answer twice in one piece.
   *
   * @return the fault
   */
  static Fault answerTwice() {
    return new AnswerTwice();
  }

  /**
   * Executes the request, holds its answer back, and sends it in one piece with the next answer on
   * the same connection.
   *
   * @return the fault
   */
  static Fault glueToNext() {
    return new GlueToNext();
  }

  /**
   * Executes the request, and answers with the id that follows its own.
   *
   * @return the fault
   */
  static Fault wrongId() {
    return new WrongId(1);
  }

  /**
   * Executes the request, and answers with another function byte.
   *
   * @param function 0 to 255
   * @return the fault
   */
  static Fault wrongFunction(int function) {
    return new WrongFunction(function);
  }

  /**
   * Executes the request, and answers with a wrong length field.
   *
   * @param difference what is added to the true length
   * @return the fault
   */
  static Fault wrongLength(int difference) {
    return new WrongLength(difference);
  }

  /**
   * Executes the request, sends the beginning of its answer only, and leaves the connection open.
   *
   * @param bytes how many bytes are sent
   * @return the fault
   */
  static Fault truncate(int bytes) {
    return new Truncate(bytes);
  }

  /**
   * Executes the request, and answers with random bytes.
   *
   * @param seed the same seed gives the same bytes
   * @param length how many
   * @return the fault
   */
  static Fault garbage(long seed, int length) {
    return new Garbage(seed, length);
  }

  /** A proper answer. Executed. */
  record None() implements Fault {
    @Override
    public boolean executes() {
      return true;
    }
  }

  /**
   * Other bytes instead of an answer. Not executed.
   *
   * @param segments hexadecimal digits; each text is sent by a write of its own
   */
  record Raw(List<String> segments) implements Fault {
    /** Checks the digits. */
    public Raw {
      segments =
          segments.stream()
              .map(hex -> HexFormat.of().parseHex(hex.replaceAll("\\s", "")))
              .map(bytes -> HexFormat.ofDelimiter(" ").withUpperCase().formatHex(bytes))
              .toList();
    }

    @Override
    public boolean executes() {
      return false;
    }
  }

  /**
   * An answer of the right form with another value and tail. Not executed.
   *
   * @param value the value
   * @param tail the tail
   */
  record Answer(String value, Tail tail) implements Fault {
    /** Checks that the value fits into an answer. */
    public Answer {
      Objects.requireNonNull(tail, "tail");
      if (value.length() > KukavarproxyHandler.MAX_VALUE || value.chars().anyMatch(c -> c > 0xFF)) {
        throw new IllegalArgumentException(
            "value must be ISO 8859-1 and have at most "
                + KukavarproxyHandler.MAX_VALUE
                + " characters, has "
                + value.length());
      }
    }

    @Override
    public boolean executes() {
      return false;
    }
  }

  /** The answer to an unknown function. Not executed. */
  record EmptyAnswer() implements Fault {
    @Override
    public boolean executes() {
      return false;
    }
  }

  /**
   * No answer.
   *
   * @param executes whether the request is executed
   */
  record Drop(boolean executes) implements Fault {}

  /**
   * No answer, and the end of the connection. Not executed.
   *
   * @param reset whether the connection is reset instead of closed
   */
  record CloseBefore(boolean reset) implements Fault {
    @Override
    public boolean executes() {
      return false;
    }
  }

  /**
   * The beginning of the answer, and the end of the connection. Executed.
   *
   * @param bytes how many bytes are sent
   */
  record CloseDuring(int bytes) implements Fault {
    /** Checks the range. */
    public CloseDuring {
      Checks.notNegative("bytes", bytes);
    }

    @Override
    public boolean executes() {
      return true;
    }
  }

  /** The answer, and the end of the connection. Executed. */
  record CloseAfter() implements Fault {
    @Override
    public boolean executes() {
      return true;
    }
  }

  /**
   * A late answer. Executed when the request comes.
   *
   * @param time how late
   */
  record Delay(Duration time) implements Fault {
    /** Checks the range. */
    public Delay {
      Checks.notNegative("time", time);
    }

    @Override
    public boolean executes() {
      return true;
    }
  }

  /**
   * An answer that waits. Executed when the request comes.
   *
   * @param released what it waits for
   */
  record Hold(CountDownLatch released) implements Fault {
    @Override
    public boolean executes() {
      return true;
    }
  }

  /**
   * An answer in pieces. Executed.
   *
   * @param sizes the lengths of the pieces
   * @param pause how long to wait between two, so that they do not arrive together
   */
  record Split(List<Integer> sizes, Duration pause) implements Fault {
    /** Checks the ranges. */
    public Split {
      sizes = List.copyOf(sizes);
      for (int size : sizes) {
        if (size < 1) {
          throw new IllegalArgumentException("a piece must have at least 1 byte, has " + size);
        }
      }
      Checks.notNegative("pause", pause);
    }

    @Override
    public boolean executes() {
      return true;
    }
  }

  /**
   * An answer in pieces of one byte. Executed.
   *
   * @param pause how long to wait between two, so that they do not arrive together
   */
  record OneByteAtATime(Duration pause) implements Fault {
    /** Checks the range. */
    public OneByteAtATime {
      Checks.notNegative("pause", pause);
    }

    @Override
    public boolean executes() {
      return true;
    }
  }

  /** The answer twice in one piece. Executed once. */
  record AnswerTwice() implements Fault {
    @Override
    public boolean executes() {
      return true;
    }
  }

  /** The answer in one piece with the next one of the connection. Executed. */
  record GlueToNext() implements Fault {
    @Override
    public boolean executes() {
      return true;
    }
  }

  /**
   * An answer with another id. Executed.
   *
   * @param difference what is added to the id, modulo 65536
   */
  record WrongId(int difference) implements Fault {
    @Override
    public boolean executes() {
      return true;
    }
  }

  /**
   * An answer with another function byte. Executed.
   *
   * @param function the byte, 0 to 255
   */
  record WrongFunction(int function) implements Fault {
    /** Checks the range. */
    public WrongFunction {
      if (function < 0 || function > 0xFF) {
        throw new IllegalArgumentException("function must be 0 to 255, is " + function);
      }
    }

    @Override
    public boolean executes() {
      return true;
    }
  }

  /**
   * An answer with another length field. Executed.
   *
   * @param difference what is added to the length, modulo 65536
   */
  record WrongLength(int difference) implements Fault {
    @Override
    public boolean executes() {
      return true;
    }
  }

  /**
   * The beginning of the answer. Executed; the connection stays open, its framing is lost.
   *
   * @param bytes how many bytes are sent
   */
  record Truncate(int bytes) implements Fault {
    /** Checks the range. */
    public Truncate {
      Checks.notNegative("bytes", bytes);
    }

    @Override
    public boolean executes() {
      return true;
    }
  }

  /**
   * Random bytes instead of an answer. Executed.
   *
   * @param seed the same seed gives the same bytes
   * @param length how many
   */
  record Garbage(long seed, int length) implements Fault {
    /** Checks the range. */
    public Garbage {
      Checks.notNegative("length", length);
    }

    @Override
    public boolean executes() {
      return true;
    }
  }
}
