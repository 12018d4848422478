package no.hials.crosscom.control;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;

import java.time.Duration;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicInteger;
import no.hials.crosscom.control.StopReason.StopKind;
import no.hials.crosscom.mock.MockServerConfig;
import no.hials.crosscom.mock.RecordedRequest;
import no.hials.crosscom.protocol.ServerType;
import no.hials.crosscom.protocol.value.Axis;
import no.hials.crosscom.protocol.value.Frame;
import no.hials.crosscom.protocol.variable.VariableRequest.ReadMultipleRequest;
import no.hials.crosscom.protocol.variable.VariableRequest.WriteMultipleRequest;
import org.junit.jupiter.api.Nested;
import org.junit.jupiter.api.Test;

/** The measurements of a loop, and its costs. */
class MeasuringTest extends ControlTest {
  private static final Law TURNING = Law.jointVelocity(s -> Axis.ZERO.with(0, 10));

  private static LoopConfig forASecond() {
    return config(cfg -> cfg.duration(Duration.ofSeconds(1)));
  }

  @Test
  void cyclesThatTheLawTakesTooLongForAreLeftOutAndCounted() throws Exception {
    run("ext_move_axis.src");
    try (ControlLoop loop =
        start(
            forASecond(),
            Law.jointVelocity(
                s -> {
                  if (s.time() == 0.24) {
                    time.pass(Duration.ofMillis(30));
                  }
                  return Axis.ZERO;
                }))) {
      assertThat(loop.await().kind()).isEqualTo(StopKind.TIME_OVER);
      LoopStatistics statistics = loop.statistics();
      assertThat(statistics.missed()).isEqualTo(2);
      assertThat(statistics.missedByAccess()).isZero();
      assertThat(statistics.cycles()).isEqualTo(84 - 2);
      assertThat(statistics.period().maximum()).isEqualTo(36);
      assertThat(statistics.period().median()).isCloseTo(12, within(0.01));
      assertThat(statistics.own().maximum()).isEqualTo(30);
    }
  }

  @Test
  void cyclesThatTheControllerTakesTooLongForAreCountedApart() throws Exception {
    run("ext_move_axis.src");
    AtomicInteger reads = new AtomicInteger();
    server.faults(
        request -> {
          if (request.name().equals("$AXIS_ACT") && reads.incrementAndGet() % 20 == 0) {
            time.pass(Duration.ofMillis(13));
          }
          return Optional.empty();
        });
    try (ControlLoop loop = start(forASecond(), TURNING)) {
      assertThat(loop.await().kind()).isEqualTo(StopKind.TIME_OVER);
      LoopStatistics statistics = loop.statistics();
      assertThat(statistics.missed()).isEqualTo(4);
      assertThat(statistics.missedByAccess()).isEqualTo(4);
      assertThat(statistics.read().maximum()).isEqualTo(13);
      assertThat(statistics.write().maximum()).isZero();
    }
  }

  @Test
  void aPositionLawMayGoOnFurtherAfterACycleThatWasLeftOut() throws Exception {
    run("follow_axis.src");
    StopReason reason =
        runLoop(
            config(cfg -> cfg.duration(Duration.ofSeconds(2))),
            Law.jointPosition(
                s -> {
                  if (Math.floorMod(Math.round(s.time() * 1000), 240) == 120) {
                    time.pass(Duration.ofMillis(13));
                  }
                  return START.with(0, 29 * s.time());
                }));

    assertThat(reason.kind()).isEqualTo(StopKind.TIME_OVER);
  }

  @Test
  void numbersAndCyclesGoToCsv() throws Exception {
    run("ext_move_axis.src");
    StringBuilder numbers = new StringBuilder();
    StringBuilder cycles = new StringBuilder();
    try (ControlLoop loop = start(forASecond(), TURNING)) {
      loop.await();
      loop.statistics().writeCsv(numbers);
      loop.trace().writeCsv(cycles);
    }
    assertThat(numbers.toString())
        .startsWith("name,value\ncycles,84\nholding,0\nmissed,0\n")
        .contains("\nperiod_mean_ms,12.0000\n", "\nerror_a1_max,0.0");
    assertThat(cycles.toString().lines()).hasSize(85);
    assertThat(cycles.toString().lines().findFirst().orElseThrow())
        .startsWith("time_s,period_ms,read_ms,write_ms,moving,desired_A1,desired_A2")
        .endsWith("actual_A5,actual_A6")
        .contains(",sent_A1,");
    assertThat(cycles.toString().lines().skip(1).findFirst().orElseThrow())
        .isEqualTo(
            "0.0000,0.000,0.000,0.000,1"
                + ",0.12000,-90.00000,90.00000,0.00000,45.00000,0.00000"
                + ",0.12000,0.00000,0.00000,0.00000,0.00000,0.00000"
                + ",0.00000,-90.00000,90.00000,0.00000,45.00000,0.00000");
  }

  @Test
  void aShortTraceKeepsTheLastCycles() throws Exception {
    run("ext_move_axis.src");
    LoopConfig config = config(cfg -> cfg.duration(Duration.ofSeconds(1)).traceLength(10));
    try (ControlLoop loop = start(config, TURNING)) {
      loop.await();
      assertThat(loop.trace().cycles()).hasSize(10);
      assertThat(loop.trace().cycles().get(9).time()).isEqualTo(83 * 0.012);
      assertThat(loop.trace().cycles().get(0).time()).isEqualTo(74 * 0.012);
    }
  }

  @Test
  void aCycleHasThreeAccessesAtMost() throws Exception {
    run("ext_move_axis.src");
    runLoop(
        forASecond(),
        Law.jointVelocity(
            s -> {
              if (s.time() == 0) {
                server.clearRequests();
              }
              return Axis.ZERO.with(0, 10);
            }));

    int inCycle = 0;
    int most = 0;
    for (RecordedRequest request : server.requests()) {
      if (request.name().equals("$AXIS_ACT")) {
        most = Math.max(most, inCycle);
        inCycle = 0;
      }
      inCycle++;
    }
    assertThat(most).isEqualTo(3);
  }

  @Test
  void aLoopRunsByTheComputersTimeToo() throws Exception {
    run("ext_move_axis.src");
    LoopConfig config =
        config(
            cfg ->
                cfg.duration(Duration.ofMillis(150))
                    .safety(
                        s -> inAutomatic(s).noWatchdog().maxFeedbackAge(Duration.ofSeconds(10))));
    try (ControlLoop loop = ControlLoop.start(client, config, Law.jointVelocity(s -> Axis.ZERO))) {
      assertThat(loop.ended().get().kind()).isEqualTo(StopKind.TIME_OVER);
      assertThat(loop.statistics().cycles()).isPositive();
    }
  }

  @Test
  void aLoopEndsWhenItIsClosed() throws Exception {
    run("ext_move_axis.src");
    ControlLoop loop =
        ControlLoop.start(
            client,
            config(cfg -> cfg.safety(s -> inAutomatic(s).noWatchdog())),
            Law.jointVelocity(s -> Axis.ZERO));
    loop.close();

    assertThat(loop.stopReason()).map(StopReason::kind).contains(StopKind.ASKED);
    assertThat(loop.toldToStand()).isTrue();
  }

  @Test
  void aLawOfTwoKindsIsRefused() {
    class Both implements Law.CartesianPosition, Law.JointVelocity {
      @Override
      public Frame position(State state) {
        return Frame.IDENTITY;
      }

      @Override
      public Axis velocity(State state) {
        return Axis.ZERO;
      }
    }

    assertThatIllegalArgumentException()
        .isThrownBy(() -> start(config(cfg -> {}), new Both()))
        .withMessageStartingWith("a law must implement one kind of law, ")
        .withMessageEndingWith("$1Both implements several");
  }

  @Test
  void wrongSettingsAreNamed() {
    assertThatIllegalArgumentException()
        .isThrownBy(() -> config(cfg -> cfg.period(Duration.ofMillis(3))))
        .withMessage("period must be PT0.004S to PT1S, is PT0.003S");
    assertThatIllegalArgumentException()
        .isThrownBy(() -> config(cfg -> cfg.gain(1.1)))
        .withMessage("gain must be more than 0 and at most 1, is 1.1");
    assertThatIllegalArgumentException()
        .isThrownBy(() -> config(cfg -> cfg.period(Duration.ofMillis(200))))
        .withMessage("time of the watchdog must be at least 4 periods, is PT0.5S");
    assertThatIllegalArgumentException()
        .isThrownBy(() -> Safety.create(s -> s.path(0, 5, 50)))
        .withMessage("speed limit must be more than 0, is 0.0");
    assertThatIllegalArgumentException()
        .isThrownBy(() -> new Workspace(0, 0, 0, 1, 0, 1))
        .withMessage("the workspace must have a minimum of X below the maximum, has 0.0 and 0.0");
    assertThatIllegalArgumentException()
        .isThrownBy(() -> new AxisLimits(START, START))
        .withMessage("the minimum of A1 must be less than its maximum, are 0.0 and 0.0");
  }

  /** With C3 Bridge. */
  @Nested
  class OnC3Bridge extends ControlTest {
    @Override
    void configure(MockServerConfig.Builder cfg) {
      super.configure(cfg);
      cfg.server(ServerType.C3_BRIDGE);
    }

    @Test
    void heartbeatAndChecksGoInOneMessageWithTheRest() throws Exception {
      run("follow_pos.src");
      Frame start = position();
      server.clearRequests();

      StopReason reason =
          runLoop(
              config(cfg -> cfg.duration(Duration.ofSeconds(1))),
              Law.cartesianPosition(s -> Twist.linear(0, 20, 0).move(start, s.time())));

      assertThat(reason.kind()).isEqualTo(StopKind.TIME_OVER);
      assertThat(server.requests())
          .filteredOn(r -> r.request() instanceof WriteMultipleRequest)
          .hasSize(8)
          .allSatisfy(r -> assertThat(r.names()).containsExactly("JOV_POS", "JOV_HEARTBEAT"));
      assertThat(server.requests())
          .filteredOn(r -> r.request() instanceof ReadMultipleRequest)
          .hasSizeGreaterThan(8);
      assertThat(position().y()).isBetween(15.0, 20.1);
    }
  }
}
