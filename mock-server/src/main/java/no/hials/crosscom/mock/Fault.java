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
 * A fault of the server or the network in the answer to one request.
 *
 * <p>A fault is set with {@link MockServer#enqueue}, {@link MockServer#fault} or {@link
 * MockServer#faults}; a {@link FaultRule} chooses the requests by number, name or probability, and
 * can be parsed from text. {@link #executes} decides the value that a client finds when it reads
 * again after a lost write. Delays and pauses affect one connection, not the server; {@link
 * MockServer#close} ends them.
 */
public sealed interface Fault {

  /** Returns whether the controller executes the request in spite of the fault. */
  default boolean executes() {
    return true;
  }

  /** Returns a fault that changes nothing: the request is executed and answered. */
  static Fault none() {
    return Simple.NONE;
  }

  /**
   * Returns a fault that sends these bytes instead of the answer. Does not execute the request.
   *
   * @param segments hexadecimal digits, with or without blanks; each text is sent by its own write
   */
  static Fault raw(String... segments) {
    return new Raw(List.of(segments));
  }

  /**
   * Returns a fault that answers the id and function of the request with this value and tail. Does
   * not execute the request.
   *
   * <p>In an answer that only C3 Bridge sends, the value stands for the text; for the value of each
   * item of a batch, with the tail's code; for the names of a directory, one in a line; for the
   * computer name in type 13; for the features in type 14, as {@code @PROXY_FEATURES} shows them.
   * In UTF-16 it is cut to the longest text that fits. Other answers only repeat the request and
   * end with the tail.
   *
   * @param value the value; for an array of 16-bit numbers their decimal text
   * @param tail the tail
   */
  static Fault answer(String value, Tail tail) {
    return new Answer(value, tail);
  }

  /**
   * Returns a fault that answers only the id, as KUKAVARPROXY answers an unknown function. Does not
   * execute the request.
   */
  static Fault emptyAnswer() {
    return Simple.EMPTY_ANSWER;
  }

  /**
   * Returns a fault that drops the request without an answer, as KUKAVARPROXY does while it serves
   * another one. Does not execute the request.
   */
  static Fault drop() {
    return Simple.DROP;
  }

  /** Returns a fault that executes the request and never answers. */
  static Fault dropAnswer() {
    return Simple.DROP_ANSWER;
  }

  /**
   * Returns a fault that closes the connection instead of answering. Does not execute the request.
   */
  static Fault closeBefore() {
    return Simple.CLOSE_BEFORE;
  }

  /**
   * Returns a fault that resets the connection (TCP RST) instead of answering. Does not execute the
   * request.
   */
  static Fault resetBefore() {
    return Simple.RESET_BEFORE;
  }

  /**
   * Returns a fault that closes the connection within the answer.
   *
   * @param bytes the number of bytes of the answer that are sent, from 0
   */
  static Fault closeDuring(int bytes) {
    return new CloseDuring(bytes);
  }

  /** Returns a fault that closes the connection after the answer. */
  static Fault closeAfter() {
    return Simple.CLOSE_AFTER;
  }

  /**
   * Returns a fault that executes the request at once and delays the answer.
   *
   * @param time the delay
   */
  static Fault delay(Duration time) {
    return new Delay(time);
  }

  /**
   * Returns a fault that executes the request at once and holds the answer back until a test
   * releases it.
   *
   * @param released the answer is sent when this is counted down
   */
  static Fault hold(CountDownLatch released) {
    return new Hold(released);
  }

  /**
   * Returns a fault that cuts the answer into pieces, each sent by its own write.
   *
   * @param sizes the lengths of the pieces; the rest of the answer is one more
   */
  static Fault split(int... sizes) {
    return new Split(Arrays.stream(sizes).boxed().toList(), Duration.ZERO);
  }

  /** Returns a fault that sends the answer one byte at a time, without a pause. */
  static Fault oneByteAtATime() {
    return oneByteAtATime(Duration.ZERO);
  }

  /**
   * Returns a fault that sends the answer one byte at a time.
   *
   * @param pause the time between two bytes, so that they do not arrive together
   */
  static Fault oneByteAtATime(Duration pause) {
    return new OneByteAtATime(pause);
  }

  /** Returns a fault that executes the request once and sends the answer twice, in one piece. */
  static Fault answerTwice() {
    return Simple.ANSWER_TWICE;
  }

  /**
   * Returns a fault that holds the answer back and sends it in one piece with the next answer of
   * the connection.
   */
  static Fault glueToNext() {
    return Simple.GLUE_TO_NEXT;
  }

  /** Returns a fault that answers with the next id. */
  static Fault wrongId() {
    return new WrongId(1);
  }

  /**
   * Returns a fault that answers with another function byte.
   *
   * @param function 0 to 255
   */
  static Fault wrongFunction(int function) {
    return new WrongFunction(function);
  }

  /**
   * Returns a fault that answers with a wrong length field.
   *
   * @param difference the number that is added to the true length
   */
  static Fault wrongLength(int difference) {
    return new WrongLength(difference);
  }

  /**
   * Returns a fault that sends only the start of the answer and leaves the connection open.
   *
   * @param bytes the number of bytes that are sent, from 0
   */
  static Fault truncate(int bytes) {
    return new Truncate(bytes);
  }

  /**
   * Returns a fault that answers with random bytes.
   *
   * @param seed the same seed gives the same bytes
   * @param length the number of bytes, from 0
   */
  static Fault garbage(long seed, int length) {
    return new Garbage(seed, length);
  }

  /** The faults without an argument. The factory method of the same name describes each. */
  enum Simple implements Fault {
    /** See {@link Fault#none}. */
    NONE(true),
    /** See {@link Fault#emptyAnswer}. */
    EMPTY_ANSWER(false),
    /** See {@link Fault#drop}. */
    DROP(false),
    /** See {@link Fault#dropAnswer}. */
    DROP_ANSWER(true),
    /** See {@link Fault#closeBefore}. */
    CLOSE_BEFORE(false),
    /** See {@link Fault#resetBefore}. */
    RESET_BEFORE(false),
    /** See {@link Fault#closeAfter}. */
    CLOSE_AFTER(true),
    /** See {@link Fault#answerTwice}. */
    ANSWER_TWICE(true),
    /** See {@link Fault#glueToNext}. */
    GLUE_TO_NEXT(true);

    private final boolean executes;

    Simple(boolean executes) {
      this.executes = executes;
    }

    @Override
    public boolean executes() {
      return executes;
    }
  }

  /**
   * See {@link Fault#raw}.
   *
   * @param segments pairs of hexadecimal digits with a blank between them
   */
  record Raw(List<String> segments) implements Fault {
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
   * See {@link Fault#answer}.
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

  /**
   * See {@link Fault#closeDuring}.
   *
   * @param bytes the number of bytes that are sent
   */
  record CloseDuring(int bytes) implements Fault {
    public CloseDuring {
      Checks.notNegative("bytes", bytes);
    }
  }

  /**
   * See {@link Fault#delay}.
   *
   * @param time the delay
   */
  record Delay(Duration time) implements Fault {
    public Delay {
      Checks.notNegative("time", time);
    }
  }

  /**
   * See {@link Fault#hold}.
   *
   * @param released releases the answer
   */
  record Hold(CountDownLatch released) implements Fault {}

  /**
   * See {@link Fault#split}.
   *
   * @param sizes the lengths of the pieces, at least 1
   * @param pause the time between two pieces, so that they do not arrive together
   */
  record Split(List<Integer> sizes, Duration pause) implements Fault {
    public Split {
      sizes = List.copyOf(sizes);
      for (int size : sizes) {
        if (size < 1) {
          throw new IllegalArgumentException("a piece must have at least 1 byte, has " + size);
        }
      }
      Checks.notNegative("pause", pause);
    }
  }

  /**
   * See {@link Fault#oneByteAtATime(Duration)}.
   *
   * @param pause the time between two bytes
   */
  record OneByteAtATime(Duration pause) implements Fault {
    public OneByteAtATime {
      Checks.notNegative("pause", pause);
    }
  }

  /**
   * See {@link Fault#wrongId}.
   *
   * @param difference the number that is added to the id, modulo 65536
   */
  record WrongId(int difference) implements Fault {}

  /**
   * See {@link Fault#wrongFunction}.
   *
   * @param function the byte, 0 to 255
   */
  record WrongFunction(int function) implements Fault {
    public WrongFunction {
      if (function < 0 || function > 0xFF) {
        throw new IllegalArgumentException("function must be 0 to 255, is " + function);
      }
    }
  }

  /**
   * See {@link Fault#wrongLength}.
   *
   * @param difference the number that is added to the length, modulo 65536
   */
  record WrongLength(int difference) implements Fault {}

  /**
   * See {@link Fault#truncate}.
   *
   * @param bytes the number of bytes that are sent
   */
  record Truncate(int bytes) implements Fault {
    public Truncate {
      Checks.notNegative("bytes", bytes);
    }
  }

  /**
   * See {@link Fault#garbage}.
   *
   * @param seed the seed of the random bytes
   * @param length their number
   */
  record Garbage(long seed, int length) implements Fault {
    public Garbage {
      Checks.notNegative("length", length);
    }
  }
}
