package no.hials.crosscom.control;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;

import java.time.Duration;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.HexFormat;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import no.hials.crosscom.control.StopReason.StopKind;
import no.hials.crosscom.mock.Fault;
import no.hials.crosscom.mock.RecordedRequest;
import no.hials.crosscom.protocol.Codec;
import no.hials.crosscom.protocol.ErrorCode;
import no.hials.crosscom.protocol.MessageType;
import no.hials.crosscom.protocol.Tail;
import no.hials.crosscom.protocol.code.Code;
import no.hials.crosscom.protocol.value.Axis;
import no.hials.crosscom.protocol.variable.AccessResult;
import no.hials.crosscom.protocol.variable.VariableRequest.ReadMultipleRequest;
import no.hials.crosscom.protocol.variable.VariableRequest.ReadRequest;
import no.hials.crosscom.protocol.variable.VariableResponse.MultipleResponse;
import org.junit.jupiter.api.Test;

/** A server between the client and the controller answers with old values. */
class FeedbackAgeTest extends ControlTest {
  private static final int LATE = 40;
  private static final List<String> OLD = List.of("$AXIS_ACT", "$ROB_TIMER");

  private final Deque<Map<String, String>> readings = new ArrayDeque<>();

  /** Answers with the values of 40 cycles before; until then with the first. */
  private void answerLate() {
    server.faults(
        request -> {
          if (request.names().contains("$AXIS_ACT")) {
            readings.add(
                Map.of(
                    "$AXIS_ACT", server.variables().get("$AXIS_ACT"),
                    "$ROB_TIMER", server.variables().get("$ROB_TIMER")));
            if (readings.size() > LATE) {
              readings.remove();
            }
          }
          return old(request);
        });
  }

  private Optional<Fault> old(RecordedRequest request) {
    if (readings.isEmpty() || request.names().stream().noneMatch(OLD::contains)) {
      return Optional.empty();
    }
    Map<String, String> values = readings.getFirst();
    if (request.request() instanceof ReadRequest read) {
      return Optional.of(Fault.answer(values.get(read.name()), Tail.SUCCESS));
    } else if (request.request() instanceof ReadMultipleRequest read) {
      List<AccessResult> results =
          read.names().stream()
              .map(name -> values.getOrDefault(name, "" + server.variables().get(name)))
              .map(value -> new AccessResult(Code.of(ErrorCode.SUCCESS), value))
              .toList();
      byte[] answer =
          Codec.encode(
              new MultipleResponse(read.id(), MessageType.READ_MULTIPLE, results, Tail.SUCCESS));
      return Optional.of(Fault.raw(HexFormat.of().formatHex(answer)));
    }
    return Optional.empty();
  }

  /** A slow motion, whose tracking error stays within its limit. */
  static final Law SLOW = Law.jointVelocity(s -> Axis.ZERO.with(0, 2));

  void assertStopsAtOldPositions(int mostCycles) throws Exception {
    run("ext_move_axis.src");
    answerLate();
    LoopConfig config =
        config(
            cfg ->
                cfg.duration(Duration.ofSeconds(4))
                    .safety(s -> inAutomatic(s).maxStall(Duration.ofSeconds(5))));
    try (ControlLoop loop = start(config, SLOW)) {
      StopReason reason = loop.await();
      assertThat(reason.message())
          .matches("the age of \\$AXIS_ACT by \\$ROB_TIMER must be at most 112 ms, is \\d{3}.*");
      assertThat(reason.kind()).isEqualTo(StopKind.STALE_FEEDBACK);
      assertThat(loop.toldToStand()).isTrue();
      assertThat(loop.statistics().cycles()).isLessThan(mostCycles);
    }
  }

  @Test
  void oldPositionsStopTheRobotAtTheNextCheckOfTheClock() throws Exception {
    assertStopsAtOldPositions(50); // twice the interval of the checks
  }

  @Test
  void withoutAClockTheyAreNotNoticed() throws Exception {
    run("ext_move_axis.src");
    answerLate();
    StopReason reason =
        runLoop(
            config(
                cfg ->
                    cfg.duration(Duration.ofSeconds(4))
                        .safety(s -> inAutomatic(s).maxStall(Duration.ofSeconds(5)).noClock())),
            SLOW);

    assertThat(reason.kind()).isEqualTo(StopKind.TIME_OVER);
  }

  @Test
  void aControllerWithoutTheClockIsRefusedUnlessItIsNotAskedFor() throws Exception {
    run("ext_move_axis.src");
    server.fault(r -> r.names().contains("$ROB_TIMER"), Fault.answer("", Tail.FAILURE));

    assertThatExceptionOfType(ControlRefusedException.class)
        .isThrownBy(() -> start(config(cfg -> {}), SLOW))
        .withMessageContaining("$ROB_TIMER")
        .withMessageContaining("noClock()")
        .satisfies(e -> assertThat(e.reason().kind()).isEqualTo(StopKind.STALE_FEEDBACK));
    assertThat(writesTo("MYAXIS")).isEmpty();
    try (ControlLoop loop =
        start(
            config(
                cfg -> cfg.duration(Duration.ofSeconds(1)).safety(s -> inAutomatic(s).noClock())),
            SLOW)) {
      assertThat(loop.await().kind()).isEqualTo(StopKind.TIME_OVER);
    }
  }

  @Test
  void aCounterThatStartsAgainIsNotOld() throws Exception {
    FeedbackAge age = new FeedbackAge(new Channel(client), time, Safety.create(cfg -> {}));
    age.start();
    age.clock.setValue(Integer.MAX_VALUE);
    age.check("$AXIS_ACT");
    time.pass(Duration.ofMillis(500));
    age.clock.setValue(Integer.MIN_VALUE + 499);

    age.check("$AXIS_ACT");
  }

  @Test
  void theClockCostsAFewAccessesASecond() throws Exception {
    run("ext_move_axis.src");
    server.clearRequests();
    runLoop(config(cfg -> cfg.duration(Duration.ofSeconds(3))), SLOW);

    // one in each interval of the checks, and one before the start
    assertThat(server.requests())
        .filteredOn(r -> r.names().contains("$ROB_TIMER"))
        .hasSizeBetween(10, 11);
  }
}
