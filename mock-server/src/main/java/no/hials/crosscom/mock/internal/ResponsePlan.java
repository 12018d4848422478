package no.hials.crosscom.mock.internal;

import java.nio.ByteBuffer;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.HexFormat;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import java.util.concurrent.CountDownLatch;
import java.util.function.Function;
import no.hials.crosscom.lang.TypeSwitch;
import no.hials.crosscom.mock.Fault;
import no.hials.crosscom.protocol.Codec;
import no.hials.crosscom.protocol.EmptyResponse;
import no.hials.crosscom.protocol.Request;
import no.hials.crosscom.protocol.Response;
import org.jspecify.annotations.Nullable;

/**
 * The plan for the response to one request: its bytes, time and pieces, and the state of the
 * connection after it.
 *
 * @param segments the pieces; each is sent by one write
 * @param pause the time between two segments
 * @param delay the time before the first segment
 * @param gate must be open before the first segment is sent, if there is one
 * @param holdBack whether the segments are sent together with the next answer
 * @param ending the state of the connection after the response
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

  /** The state of the connection after the response. */
  enum Ending {
    OPEN,
    CLOSE,
    RESET
  }

  private static ResponsePlan of(List<byte[]> segments) {
    return new ResponsePlan(segments, Duration.ZERO, Duration.ZERO, null, false, Ending.OPEN);
  }

  /** Sends an answer without a fault. */
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

  /** A request, null if the bytes are none, and its answer. */
  private record Exchange(@Nullable Request request, Optional<byte[]> answer) {

    /** Sends nothing if the request was not executed or has no answer. */
    ResponsePlan changed(Function<byte[], ResponsePlan> change) {
      return answer.map(change).orElse(NOTHING);
    }

    /** Sends the proper answer, if there is one, to bytes that are not a request. */
    ResponsePlan instead(Function<Request, Response> scripted) {
      return request == null
          ? changed(ResponsePlan::of)
          : of(Codec.encode(scripted.apply(request)));
    }
  }

  private static final TypeSwitch<Exchange, Fault, ResponsePlan, RuntimeException> FAULTS =
      TypeSwitch.create(
          Fault.class,
          cases ->
              cases
                  .on(Fault.Simple.class, ResponsePlan::simple)
                  .on(
                      Fault.Raw.class,
                      (it, raw) ->
                          of(
                              raw.segments().stream()
                                  .map(HexFormat.ofDelimiter(" ")::parseHex)
                                  .toList()))
                  .on(Fault.Garbage.class, (it, garbage) -> of(random(garbage)))
                  .on(
                      Fault.Answer.class,
                      (it, scripted) ->
                          it.instead(
                              request ->
                                  KukavarproxyHandler.answer(
                                      request, scripted.value(), scripted.tail())))
                  .on(
                      Fault.CloseDuring.class,
                      (it, close) ->
                          it.changed(answer -> of(first(answer, close.bytes())).then(Ending.CLOSE)))
                  .on(
                      Fault.Truncate.class,
                      (it, cut) -> it.changed(answer -> of(first(answer, cut.bytes()))))
                  .on(
                      Fault.Delay.class,
                      (it, late) -> it.changed(answer -> of(answer).after(late.time(), null)))
                  .on(
                      Fault.Hold.class,
                      (it, hold) ->
                          it.changed(answer -> of(answer).after(Duration.ZERO, hold.released())))
                  .on(
                      Fault.Split.class,
                      (it, split) ->
                          it.changed(
                              answer -> of(pieces(answer, split.sizes())).spacedBy(split.pause())))
                  .on(
                      Fault.OneByteAtATime.class,
                      (it, bytes) ->
                          it.changed(
                              answer ->
                                  of(pieces(answer, Collections.nCopies(answer.length, 1)))
                                      .spacedBy(bytes.pause())))
                  .on(
                      Fault.WrongId.class,
                      (it, wrong) -> it.changed(answer -> of(withId(answer, wrong))))
                  .on(
                      Fault.WrongLength.class,
                      (it, wrong) -> it.changed(answer -> of(withLength(answer, wrong))))
                  .on(
                      Fault.WrongFunction.class,
                      (it, wrong) -> it.changed(answer -> of(withFunction(answer, wrong)))));

  /**
   * Applies a fault.
   *
   * @param request the message, null if the bytes were no message
   * @param answer the answer without the fault, null without an answer or if the request was not
   *     executed
   */
  public static ResponsePlan of(Fault fault, @Nullable Request request, byte @Nullable [] answer) {
    return FAULTS.apply(new Exchange(request, Optional.ofNullable(answer)), fault);
  }

  private static ResponsePlan simple(Exchange exchange, Fault.Simple fault) {
    return switch (fault) {
      case NONE -> exchange.changed(ResponsePlan::of);
      case EMPTY_ANSWER -> exchange.instead(request -> new EmptyResponse(request.id()));
      case DROP, DROP_ANSWER -> NOTHING;
      case CLOSE_BEFORE -> NOTHING.then(Ending.CLOSE);
      case RESET_BEFORE -> NOTHING.then(Ending.RESET);
      case CLOSE_AFTER -> exchange.changed(ResponsePlan::of).then(Ending.CLOSE);
      case ANSWER_TWICE ->
          exchange.changed(
              answer -> of(ByteBuffer.allocate(2 * answer.length).put(answer).put(answer).array()));
      case GLUE_TO_NEXT -> exchange.changed(answer -> of(answer).heldBack());
    };
  }

  private static byte[] random(Fault.Garbage garbage) {
    byte[] bytes = new byte[garbage.length()];
    new Random(garbage.seed()).nextBytes(bytes);
    return bytes;
  }

  private static byte[] withId(byte[] answer, Fault.WrongId wrong) {
    Codec.setId(answer, (Short.toUnsignedInt(u16(answer, 0)) + wrong.difference()) & U16);
    return answer;
  }

  private static byte[] withLength(byte[] answer, Fault.WrongLength wrong) {
    ByteBuffer.wrap(answer)
        .putShort(LENGTH_FIELD, (short) (u16(answer, LENGTH_FIELD) + wrong.difference()));
    return answer;
  }

  private static byte[] withFunction(byte[] answer, Fault.WrongFunction wrong) {
    if (answer.length > FUNCTION_FIELD) {
      answer[FUNCTION_FIELD] = (byte) wrong.function();
    }
    return answer;
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
