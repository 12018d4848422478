package no.hials.crosscom.mock.internal;

import java.nio.ByteBuffer;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.HexFormat;
import java.util.List;
import java.util.Random;
import java.util.concurrent.CountDownLatch;
import no.hials.crosscom.mock.Fault;
import no.hials.crosscom.protocol.Codec;
import no.hials.crosscom.protocol.EmptyResponse;
import no.hials.crosscom.protocol.Request;
import org.jspecify.annotations.Nullable;

/**
 * How the answer to one request goes out: which bytes, when, in which pieces, and what becomes of
 * the connection.
 *
 * @param segments each is sent by one write
 * @param pause how long to wait between two segments
 * @param delay how long to wait before the first
 * @param gate what to wait for before the first, if anything
 * @param holdBack whether to send the segments in front of the next answer only
 * @param ending what becomes of the connection
 */
public record ResponsePlan(
    List<byte[]> segments,
    Duration pause,
    Duration delay,
    @Nullable CountDownLatch gate,
    boolean holdBack,
    Ending ending) {

  static final ResponsePlan NOTHING = of(List.of());

  private static final int LENGTH_FIELD = 2;
  private static final int FUNCTION_FIELD = 4;
  private static final int U16 = 0xFFFF;

  /** What becomes of the connection. */
  enum Ending {
    OPEN,
    CLOSE,
    RESET
  }

  private static ResponsePlan of(List<byte[]> segments) {
    return new ResponsePlan(segments, Duration.ZERO, Duration.ZERO, null, false, Ending.OPEN);
  }

  /** Sends an answer properly. */
  public static ResponsePlan of(byte[] answer) {
    return of(List.of(answer));
  }

  private ResponsePlan spacedBy(Duration newPause) {
    return new ResponsePlan(segments, newPause, delay, gate, holdBack, ending);
  }

  private ResponsePlan after(Duration newDelay, @Nullable CountDownLatch newGate) {
    return new ResponsePlan(segments, pause, newDelay, newGate, holdBack, ending);
  }

  private ResponsePlan heldBack() {
    return new ResponsePlan(segments, pause, delay, gate, true, ending);
  }

  private ResponsePlan then(Ending newEnding) {
    return new ResponsePlan(segments, pause, delay, gate, holdBack, newEnding);
  }

  /**
   * Applies a fault.
   *
   * @param fault what goes wrong
   * @param request the message, null if the bytes were none
   * @param answer the proper answer; null if the request was not executed, or has none
   */
  public static ResponsePlan of(Fault fault, @Nullable Request request, byte @Nullable [] answer) {
    if (fault instanceof Fault.Raw raw) {
      return of(raw.segments().stream().map(HexFormat.ofDelimiter(" ")::parseHex).toList());
    }
    if (fault instanceof Fault.Garbage garbage) {
      byte[] bytes = new byte[garbage.length()];
      new Random(garbage.seed()).nextBytes(bytes);
      return of(bytes);
    }
    if (fault instanceof Fault.CloseBefore close) {
      return NOTHING.then(close.reset() ? Ending.RESET : Ending.CLOSE);
    }
    if (fault instanceof Fault.Answer scripted && request != null) {
      return of(
          Codec.encode(KukavarproxyHandler.answer(request, scripted.value(), scripted.tail())));
    }
    if (fault instanceof Fault.EmptyAnswer && request != null) {
      return of(Codec.encode(new EmptyResponse(request.id())));
    }
    if (fault instanceof Fault.CloseAfter && answer == null) {
      return NOTHING.then(Ending.CLOSE);
    }
    if (answer == null || fault instanceof Fault.Drop) {
      return NOTHING;
    }
    return cut(fault, answer);
  }

  /** Applies a fault that needs the proper answer. */
  private static ResponsePlan cut(Fault fault, byte[] answer) {
    if (fault instanceof Fault.Delay late) {
      return of(answer).after(late.time(), null);
    }
    if (fault instanceof Fault.Hold hold) {
      return of(answer).after(Duration.ZERO, hold.released());
    }
    if (fault instanceof Fault.CloseDuring close) {
      return of(first(answer, close.bytes())).then(Ending.CLOSE);
    }
    if (fault instanceof Fault.CloseAfter) {
      return of(answer).then(Ending.CLOSE);
    }
    if (fault instanceof Fault.Split split) {
      return of(pieces(answer, split.sizes())).spacedBy(split.pause());
    }
    if (fault instanceof Fault.OneByteAtATime bytes) {
      List<Integer> ones = new ArrayList<>(Collections.nCopies(answer.length, 1));
      return of(pieces(answer, ones)).spacedBy(bytes.pause());
    }
    if (fault instanceof Fault.AnswerTwice) {
      return of(ByteBuffer.allocate(2 * answer.length).put(answer).put(answer).array());
    }
    if (fault instanceof Fault.GlueToNext) {
      return of(answer).heldBack();
    }
    if (fault instanceof Fault.Truncate truncate) {
      return of(first(answer, truncate.bytes()));
    }
    if (fault instanceof Fault.WrongId wrong) {
      Codec.setId(answer, (Short.toUnsignedInt(u16(answer, 0)) + wrong.difference()) & U16);
    } else if (fault instanceof Fault.WrongLength wrong) {
      ByteBuffer.wrap(answer)
          .putShort(LENGTH_FIELD, (short) (u16(answer, LENGTH_FIELD) + wrong.difference()));
    } else if (fault instanceof Fault.WrongFunction wrong && answer.length > FUNCTION_FIELD) {
      answer[FUNCTION_FIELD] = (byte) wrong.function();
    }
    return of(answer);
  }

  private static short u16(byte[] bytes, int offset) {
    return ByteBuffer.wrap(bytes).getShort(offset);
  }

  private static byte[] first(byte[] answer, int bytes) {
    return Arrays.copyOf(answer, Math.min(bytes, answer.length));
  }

  private static List<byte[]> pieces(byte[] answer, List<Integer> sizes) {
    List<byte[]> pieces = new ArrayList<>();
    int start = 0;
    for (int size : sizes) {
      int end = Math.min(answer.length, start + size);
      if (end > start) {
        pieces.add(Arrays.copyOfRange(answer, start, end));
      }
      start = end;
    }
    if (start < answer.length) {
      pieces.add(Arrays.copyOfRange(answer, start, answer.length));
    }
    return pieces;
  }
}
