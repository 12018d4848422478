package no.hials.crosscom.control;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;

import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicInteger;
import no.hials.crosscom.control.StopReason.StopKind;
import no.hials.crosscom.protocol.variable.VariableRequest.ReadRequest;
import no.hials.crosscom.protocol.variable.VariableRequest.WriteRequest;
import org.junit.jupiter.api.Test;

/** A second client that already moves the robot. */
class OtherDriverTest extends ControlTest {
  private static final int STANDING = -1;

  private final AtomicInteger otherBeat = new AtomicInteger(100);

  /** Sends the heartbeat of another loop, after this one has looked at it several times. */
  private void drive(int reads, boolean stopsIfReplaced) {
    AtomicInteger left = new AtomicInteger(reads);
    server.variables().set("JOV_HEARTBEAT", "100");
    server.variables().set("JOV_SEEN", "100");
    server.faults(
        request -> {
          if (request.request() instanceof ReadRequest
              && request.name().equals("JOV_HEARTBEAT")
              && left.decrementAndGet() < 0
              && otherBeat.get() != STANDING) {
            int seen = Integer.parseInt(server.variables().get("JOV_SEEN"));
            if (stopsIfReplaced && Math.abs(seen - otherBeat.get()) > 4) {
              otherBeat.set(STANDING);
            } else {
              server.variables().set("JOV_HEARTBEAT", "" + otherBeat.incrementAndGet());
            }
          }
          return Optional.empty();
        });
  }

  private void assertRefused(LoopConfig config) {
    assertThatExceptionOfType(ControlRefusedException.class)
        .isThrownBy(() -> start(config, Law.jointVelocity(s -> TURNING)))
        .withMessage(
            "JOV_HEARTBEAT must not change before the start, changed from 100 to 101;"
                + " another client drives the robot")
        .satisfies(e -> assertThat(e.reason().kind()).isEqualTo(StopKind.OTHER_DRIVER));
    assertThat(server.requests()).noneMatch(r -> r.request() instanceof WriteRequest);
  }

  @Test
  void aLoopIsNotStartedWhileAnotherSendsAHeartbeat() throws Exception {
    run("ext_move_axis.src");
    drive(1, true);

    assertRefused(config(cfg -> {}));
  }

  @Test
  void withTheWatchdogOnALoopWaitsForASlowHeartbeat() throws Exception {
    run("ext_move_axis.src");
    server.variables().set("JOV_LIMIT", "400");
    drive(4, true);

    assertRefused(config(cfg -> {}));
  }

  @Test
  void aLoopWithoutAWatchdogIsNotStartedEither() throws Exception {
    run("ext_move_axis.src");
    drive(1, true);

    assertRefused(config(cfg -> cfg.safety(s -> inAutomatic(s).noWatchdog())));
  }

  @Test
  void aPathIsNotPlayedEither() throws Exception {
    run("play_path.src");
    drive(1, true);
    PathPlayer player = new PathPlayer(client, Safety.create(ControlTest::inAutomatic), time);

    assertThatExceptionOfType(ControlRefusedException.class)
        .isThrownBy(() -> player.playAxes(List.of(START), LIMIT))
        .satisfies(e -> assertThat(e.reason().kind()).isEqualTo(StopKind.OTHER_DRIVER));
  }

  @Test
  void aTakeoverStopsTheOtherDriverFirst() throws Exception {
    run("ext_move_axis.src");
    server.variables().set("JOV_LIMIT", "500");
    drive(1, true);

    StopReason reason =
        runLoop(
            config(cfg -> cfg.takeover().duration(Duration.ofSeconds(1))),
            Law.jointVelocity(
                s -> {
                  assertThat(otherBeat).hasValue(STANDING);
                  return TURNING;
                }));

    assertThat(reason.kind()).isEqualTo(StopKind.TIME_OVER);
  }

  @Test
  void aTakeoverFromADriverThatDoesNotStopIsRefused() throws Exception {
    run("ext_move_axis.src");
    drive(1, false);

    assertThatExceptionOfType(ControlRefusedException.class)
        .isThrownBy(
            () -> start(config(LoopConfig.Builder::takeover), Law.jointVelocity(s -> TURNING)))
        .withMessage(
            "the other driver must stop within 5 s of the takeover, still changes JOV_HEARTBEAT");
    assertThat(writesTo("MYAXIS")).isEmpty();
  }

  @Test
  void aLoopWhoseHeartbeatIsReplacedStops() throws Exception {
    StopReason reason =
        runToStop(
            "ext_move_axis.src",
            afterOneSecond(() -> server.variables().set("JOV_HEARTBEAT", "7")));

    assertThat(reason.kind()).isEqualTo(StopKind.WATCHDOG);
    assertThat(reason.message()).contains("another client sends a heartbeat");
  }

  @Test
  void twoLoopsThatStartTogetherNoticeEachOther() throws Exception {
    run("ext_move_axis.src");
    for (int i = 0; i < 2; i++) {
      server.clearRequests();
      server.variables().set("JOV_HEARTBEAT", "0");
      runLoop(config(cfg -> cfg.duration(Duration.ofMillis(24))), Law.jointVelocity(s -> TURNING));
      // a number of its own, not the next after the one it found
      assertThat(writesTo("JOV_HEARTBEAT").get(0)).isNotIn("0", "1", "2");
    }
  }
}
