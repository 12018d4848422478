package no.hials.crosscom.control;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.assertThatNullPointerException;

import java.io.IOException;
import java.nio.file.Files;
import java.time.Duration;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicReference;
import no.hials.crosscom.control.StopReason.StopKind;
import no.hials.crosscom.control.input.Input;
import no.hials.crosscom.control.input.InputDevice;
import no.hials.crosscom.mock.Fault;
import no.hials.crosscom.protocol.code.OperatingMode;
import no.hials.crosscom.protocol.code.ProgramState;
import no.hials.crosscom.protocol.value.Axis;
import no.hials.crosscom.protocol.variable.VariableRequest.WriteRequest;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Stops a loop by its input, the controller, the law, the connection and the watchdog. */
class StoppingTest extends ControlTest {
  // the input

  private Input held(boolean deadMan) {
    return new Input(List.of(1.0), List.of(), deadMan, time.nanoTime());
  }

  @ParameterizedTest
  @CsvSource({"ext_move_axis.src, MYAXIS, true", "follow_axis.src, JOV_AXIS, false"})
  void withoutFreshInputTheRobotStandsUntilItIsBack(String file, String name, boolean increment)
      throws Exception {
    run(file);
    InputDevice silent =
        () -> {
          double seconds = time.nanoTime() / 1e9;
          boolean heard = seconds < 2 || seconds > 4;
          return new Input(List.of(1.0), List.of(), true, heard ? time.nanoTime() : 2_000_000_000L);
        };
    Law law = Law.jointVelocity(s -> Axis.ZERO.with(0, 5 * s.input().axis(0)));
    LoopConfig config =
        config(
            cfg ->
                cfg.target(new Target(name, increment))
                    .input(silent)
                    .duration(Duration.ofSeconds(6)));
    try (ControlLoop loop = start(config, law)) {
      assertThat(loop.await().kind()).isEqualTo(StopKind.TIME_OVER);
      List<Trace.Cycle> held =
          loop.trace().cycles().stream().filter(cycle -> !cycle.moving()).toList();
      assertThat(held.size()).isBetween(140, 152); // 1.8 s: 200 ms after the last input
      assertThat(loop.statistics().holding()).isEqualTo(held.size());
      double stoodAt = held.get(held.size() - 1).actual().get(0);
      assertThat(held.get(held.size() / 2).actual().get(0)).isEqualTo(stoodAt);
      assertThat(Math.abs(controller.axes().a1())).isGreaterThan(Math.abs(stoodAt) + 1);
    }
  }

  @Test
  @SuppressWarnings("NullAway") // on purpose
  void aLoopWithoutClientConfigurationOrLawIsNotStarted() {
    LoopConfig config = LoopConfig.create(LoopConfig.Builder::noInput);
    Law law = Law.jointVelocity(s -> Axis.ZERO);

    assertThatNullPointerException()
        .isThrownBy(() -> ControlLoop.start(null, config, law))
        .withMessage("client");
    assertThatNullPointerException()
        .isThrownBy(() -> ControlLoop.start(client, null, law))
        .withMessage("config");
    assertThatNullPointerException()
        .isThrownBy(() -> ControlLoop.start(client, config, null))
        .withMessage("law");
  }

  @Test
  void withoutTheDeadManTheLawIsNotAskedAndTimeDoesNotCount() throws Exception {
    run("ext_move_axis.src");
    InputDevice device = () -> held(time.nanoTime() > 1_500_000_000L);
    AtomicReference<Double> first = new AtomicReference<>();
    LoopConfig config = config(cfg -> cfg.input(device).duration(Duration.ofSeconds(2)));

    StopReason reason =
        runLoop(
            config,
            Law.jointVelocity(
                s -> {
                  assertThat(time.nanoTime()).isGreaterThan(1_500_000_000L);
                  first.compareAndSet(null, s.time());
                  return TURNING;
                }));

    assertThat(reason.kind()).isEqualTo(StopKind.TIME_OVER);
    assertThat(first.get()).isZero();
    assertStandsForGood();
  }

  @Test
  void anInputDeviceThatFailsStopsTheRobot() throws Exception {
    InputDevice failing =
        () -> {
          if (time.nanoTime() > 1_000_000_000L) {
            throw new IOException("unplugged");
          }
          return held(true);
        };

    StopReason reason =
        runToStop(
            "ext_move_axis.src",
            config(cfg -> cfg.input(failing)),
            Law.jointVelocity(s -> TURNING));

    assertThat(reason.kind()).isEqualTo(StopKind.INPUT);
    assertThat(reason.message()).contains("unplugged");
  }

  @Test
  void aDeadManWithTheTimeOfAnotherClockStopsTheRobot() throws Exception {
    InputDevice ahead =
        () -> new Input(List.of(), List.of(), true, time.nanoTime() + 5_000_000_000L);

    StopReason reason =
        runToStop(
            "ext_move_axis.src", config(cfg -> cfg.input(ahead)), Law.jointVelocity(s -> TURNING));

    assertReason(
        reason,
        StopKind.INPUT,
        "the time of the input must be from System.nanoTime, is 5000 ms ahead of it");
  }

  @Test
  void aLoopWithoutADeadManHasToBeAskedFor() {
    assertThatIllegalArgumentException()
        .isThrownBy(() -> LoopConfig.create(cfg -> {}))
        .withMessageContaining("noInput()");
  }

  @Test
  void aLoopThatMayNotWriteIsRefusedBeforeAnythingIsWritten() throws Exception {
    run("ext_move_axis.src");

    assertThatExceptionOfType(ControlRefusedException.class)
        .isThrownBy(
            () -> start(config(cfg -> cfg.writeIf(() -> false)), Law.jointVelocity(s -> TURNING)))
        .withMessage("the loop was not allowed to write")
        .satisfies(e -> assertThat(e.reason().kind()).isEqualTo(StopKind.ASKED));

    assertThat(server.requests()).noneMatch(r -> r.request() instanceof WriteRequest);
  }

  @Test
  void aLoopThatMayNoLongerWriteOnlyTellsTheRobotToStand() throws Exception {
    run("ext_move_axis.src");
    AtomicBoolean allowed = new AtomicBoolean(true);
    AtomicInteger before = new AtomicInteger();
    LoopConfig config = config(cfg -> cfg.writeIf(allowed::get));

    StopReason reason =
        runLoop(
            config,
            afterOneSecond(
                () -> {
                  before.set(writesTo("MYAXIS").size());
                  allowed.set(false);
                }));

    assertReason(reason, StopKind.ASKED, "the loop was not allowed to write");
    List<String> writes = writesTo("MYAXIS");
    assertThat(writes.subList(before.get(), writes.size()))
        .singleElement()
        .asString()
        .startsWith("{A1 0.0");
    assertThat(server.variables().get("JOV_LIMIT")).isEqualTo("0");
    assertStandsForGood();
  }

  // the controller

  @Test
  void aModeThatIsNotAllowedIsRefusedBeforeAnythingIsWritten() throws Exception {
    run("ext_move_axis.src");
    LoopConfig onlyInT1 = LoopConfig.create(cfg -> cfg.period(PERIOD).noInput());

    assertThatExceptionOfType(ControlRefusedException.class)
        .isThrownBy(() -> start(onlyInT1, Law.jointVelocity(s -> TURNING)))
        .withMessage("$MODE_OP must be one of [T1], is #AUT")
        .satisfies(e -> assertThat(e.reason().kind()).isEqualTo(StopKind.MODE));

    assertThat(server.requests()).noneMatch(r -> r.request() instanceof WriteRequest);
  }

  @Test
  void aProgramThatDoesNotRunIsRefusedBeforeAnythingIsWritten() {
    assertThatExceptionOfType(ControlRefusedException.class)
        .isThrownBy(() -> start(config(cfg -> {}), Law.jointVelocity(s -> TURNING)))
        .withMessage("$PRO_STATE1 must be #P_ACTIVE, is #P_FREE");

    assertThat(server.requests()).noneMatch(r -> r.request() instanceof WriteRequest);
  }

  @Test
  void anotherModeStopsTheLoop() throws Exception {
    StopReason reason =
        runToStop("ext_move_axis.src", afterOneSecond(() -> controller.setMode(OperatingMode.T2)));

    assertReason(reason, StopKind.MODE, "$MODE_OP must be one of [AUT], is #T2");
  }

  @Test
  void aProgramThatIsStoppedStopsTheLoop() throws Exception {
    StopReason reason =
        runToStop("ext_move_axis.src", afterOneSecond(() -> controller.robot().stop()));

    assertThat(reason.message()).isEqualTo("$PRO_STATE1 must be #P_ACTIVE, is #P_STOP");
    controller.robot().start();
    assertStandsForGood();
  }

  @Test
  void aVariableThatTheControllerDoesNotKnowIsTheReason() throws Exception {
    run("ext_move_axis.src");
    LoopConfig config = config(cfg -> cfg.target(Target.increment("NOSUCH")));
    try (ControlLoop loop = start(config, Law.jointVelocity(s -> TURNING))) {
      assertThat(loop.await().kind()).isEqualTo(StopKind.ACCESS);
      assertThat(loop.await().message()).contains("NOSUCH");
      assertThat(loop.toldToStand()).isFalse();
    }
  }

  // the law

  @Test
  void anExceptionInTheLawStopsTheRobot() throws Exception {
    IllegalStateException thrown = new IllegalStateException("no plan");

    StopReason reason =
        runToStop(
            "ext_move_axis.src",
            afterOneSecond(
                () -> {
                  throw thrown;
                }));

    assertThat(reason.kind()).isEqualTo(StopKind.LAW);
    assertThat(reason.message()).contains("no plan");
    assertThat(reason.cause()).isSameAs(thrown);
    assertThat(controller.axes().a1()).isGreaterThan(5);
  }

  @Test
  void aLawThatLeavesItsThreadInterruptedStopsTheRobot() throws Exception {
    StopReason reason =
        runToStop(
            "ext_move_axis.src",
            afterOneSecond(
                () -> {
                  Thread.currentThread().interrupt();
                  throw new InterruptedException("no plan");
                }));

    assertThat(reason.kind()).isEqualTo(StopKind.LAW);
    assertThat(reason.message()).contains("no plan");
  }

  @Test
  void whateverTheLawThrowsStopsTheRobot() throws Exception {
    Throwable thrown = new Throwable("neither exception nor error");

    StopReason reason =
        runToStop("ext_move_axis.src", Law.jointVelocity(s -> throwUndeclared(thrown)));

    assertThat(reason.kind()).isEqualTo(StopKind.LAW);
    assertThat(reason.cause()).isSameAs(thrown);
  }

  @SuppressWarnings("unchecked") // on purpose: T is not the type of the exception
  private static <T extends Throwable> Axis throwUndeclared(Throwable thrown) throws T {
    throw (T) thrown;
  }

  @Test
  void aNumberThatIsNoneStopsTheRobot() throws Exception {
    StopReason reason =
        runToStop(
            "actuator.src",
            Law.cartesianVelocity(s -> Twist.linear(s.time() < 0.5 ? 10 : 0 / 0.0, 0, 0)));

    assertThat(reason.kind()).isEqualTo(StopKind.LAW);
    assertThat(reason.message()).contains("X must be finite, is NaN");
  }

  @Test
  void aLawThatGivesNothingStopsTheRobot() throws Exception {
    StopReason reason = runToStop("follow_axis.src", Law.jointPosition(s -> null));

    assertReason(reason, StopKind.LAW, "the law must return a command, returned null");
  }

  // the connection and the watchdog

  @Test
  void aLostWriteStopsTheRobotAndIsNotRepeated() throws Exception {
    StopReason reason =
        runToStop(
            "ext_move_axis.src",
            afterOneSecond(
                () -> {
                  server.fault(
                      r -> r.request() instanceof WriteRequest w && w.value().startsWith("{A1 0.1"),
                      Fault.resetBefore());
                }));

    assertThat(reason.kind()).isEqualTo(StopKind.ACCESS);
    List<String> writes = writesTo("MYAXIS");
    assertThat(writes.get(writes.size() - 2)).startsWith("{A1 0.12");
    assertThat(writes.get(writes.size() - 1)).startsWith("{A1 0.0");
  }

  @Test
  void theWatchdogStopsTheRobotWhenTheConnectionIsLost() throws Exception {
    run("ext_move_axis.src");
    try (ControlLoop loop =
        start(
            config(cfg -> {}),
            afterOneSecond(
                () -> {
                  server.refuseConnections();
                  server.disconnectClients();
                }))) {
      assertThat(loop.await().kind()).isEqualTo(StopKind.ACCESS);
      assertThat(loop.toldToStand()).isFalse();
    }
    controller.step(Duration.ofMillis(240));
    assertThat(controller.standing()).isFalse(); // the increment is still there

    assertStandsForGood();

    assertThat(controller.robot().state()).isEqualTo(ProgramState.STOP);
    assertThat(server.variables().get("JOV_TIMEOUT")).isEqualTo("TRUE");
  }

  @Test
  void aWatchdogThatDoesNotLookIsRefused() throws Exception {
    run("ext_move_axis.src");
    controller.submit().stop();
    client.writeText("JOV_SEEN", "1"); // as if the first heartbeat had been seen

    assertThatExceptionOfType(ControlRefusedException.class)
        .isThrownBy(() -> start(config(cfg -> {}), Law.jointVelocity(s -> TURNING)))
        .withMessageContaining("JOV_SPS does not run")
        .satisfies(e -> assertThat(e.reason().kind()).isEqualTo(StopKind.WATCHDOG));

    assertThat(server.variables().get("JOV_LIMIT")).isEqualTo("0");
    assertThat(writesTo("MYAXIS")).isEmpty();
  }

  @Test
  void aWatchdogThatSeesTheHeartbeatWithoutALimitIsRefused() throws Exception {
    run("ext_move_axis.src");
    controller.submit().stop();
    controller
        .submit()
        .select(
            controller.load(
                "off.sub",
                """
                DEF OFF ( )
                  LOOP
                    JOV_LIMIT=0
                    JOV_SEEN=JOV_HEARTBEAT
                  ENDLOOP
                END
                """));
    controller.submit().start();

    assertThatExceptionOfType(ControlRefusedException.class)
        .isThrownBy(() -> start(config(cfg -> {}), Law.jointVelocity(s -> TURNING)))
        .withMessage(
            "JOV_LIMIT must be 500 as set by this loop, is 0; another client uses the watchdog");

    assertThat(writesTo("MYAXIS")).isEmpty();
  }

  @Test
  void aWatchdogThatAnotherClientSwitchesOffStopsTheRobot() throws Exception {
    StopReason reason =
        runToStop(
            "ext_move_axis.src", afterOneSecond(() -> server.variables().set("JOV_LIMIT", "0")));

    assertReason(
        reason,
        StopKind.WATCHDOG,
        "JOV_LIMIT must be 500 as set by this loop, is 0; another client uses the watchdog");
  }

  @Test
  void aWatchdogThatStopsLookingStopsTheRobot() throws Exception {
    StopReason reason =
        runToStop("ext_move_axis.src", afterOneSecond(() -> controller.submit().stop()));

    assertThat(reason.kind()).isEqualTo(StopKind.WATCHDOG);
    assertThat(reason.message()).contains("JOV_SEEN must be at most 4 behind");
  }

  @Test
  void aHeartbeatThatIsTooLateForTheWatchdogStopsTheRobot() throws Exception {
    StopReason reason =
        runToStop(
            "ext_move_axis.src",
            safe(s -> s.maxFeedbackAge(Duration.ofSeconds(1))),
            afterOneSecond(() -> time.awaitUntil(time.nanoTime() + 600_000_000)));

    assertThat(reason.kind()).isEqualTo(StopKind.LATE_HEARTBEAT);
    assertThat(reason.message())
        .startsWith("the time between two heartbeats must be at most 500 ms, is ")
        .endsWith("; the watchdog stops the program");
    assertThat(controller.robot().state()).isEqualTo(ProgramState.STOP);
  }

  @Test
  void aComputerThatWasAsleepIsTheReasonAndNotTheProgramThatHasStopped() throws Exception {
    run("ext_move_axis.src");
    AtomicBoolean sleeps = new AtomicBoolean();
    LoopTime clock =
        new LoopTime() {
          @Override
          public long nanoTime() {
            return time.nanoTime();
          }

          @Override
          public void awaitUntil(long nanoTime) {
            time.awaitUntil(sleeps.get() ? nanoTime + 1_000_000_000 : nanoTime);
          }
        };
    LoopConfig config = safe(s -> s.checkInterval(Duration.ofMillis(1)));
    Law law = afterOneSecond(() -> sleeps.set(true));
    try (ControlLoop loop = ControlLoop.start(client, config, law, clock)) {
      assertThat(loop.await().kind()).isEqualTo(StopKind.LATE_HEARTBEAT);
    }
    assertThat(controller.robot().state()).isEqualTo(ProgramState.STOP);
  }

  @Test
  void aProgramGoesOnWhenTheWatchdogIsSwitchedOffWhileItLooks() throws Exception {
    run("ext_move_axis.src");
    CompletableFuture<Void> cycles =
        CompletableFuture.runAsync(() -> controller.step(Duration.ofMinutes(1)));
    while (!cycles.isDone()) {
      server.variables().set("JOV_LIMIT", "3600000");
      server.variables().set("JOV_LIMIT", "0");
    }
    cycles.join();

    assertThat(controller.robot().state()).isEqualTo(ProgramState.ACTIVE);
  }

  @Test
  void aHeartbeatRightAfterATimeoutDoesNotKeepTheProgramRunning() throws Exception {
    controller.submit().stop();
    String beats = "    IF JOV_TIMEOUT THEN\n JOV_HEARTBEAT=JOV_HEARTBEAT+1\n ENDIF\n  ENDLOOP";
    String watchdog = Files.readString(KRL.resolve("jov_sps.sub")).replace("  ENDLOOP", beats);
    controller.submit().select(controller.load("jov_sps.sub", watchdog));
    controller.submit().start();
    run("ext_move_axis.src");
    for (int i = 0; i < 50; i++) { // the cycles end at different statements of JOV_SPS
      client.writeText("JOV_LIMIT", "50");
      controller.step(Duration.ofMillis(120));
      assertThat(controller.robot().state()).isEqualTo(ProgramState.STOP);

      client.writeText("JOV_LIMIT", "0");
      controller.step(Duration.ofMillis(240));
      controller.robot().start();
      controller.step(Duration.ofMillis(24));
      assertThat(controller.robot().state()).isEqualTo(ProgramState.ACTIVE);
    }
  }

  @Test
  void aWatchdogThatWasOnBeforeStopsTheProgramAfterAPlannedEnd() throws Exception {
    client.writeText("JOV_LIMIT", "400");
    run("ext_move_axis.src");

    runLoop(config(cfg -> cfg.duration(Duration.ofSeconds(2))), Law.jointVelocity(s -> TURNING));
    assertThat(server.variables().get("JOV_LIMIT")).isEqualTo("400");
    assertThat(controller.robot().state()).isEqualTo(ProgramState.ACTIVE);
    controller.step(Duration.ofMillis(500));

    assertThat(controller.robot().state()).isEqualTo(ProgramState.STOP);
    assertThat(server.variables().get("JOV_TIMEOUT")).isEqualTo("TRUE");
  }

  @Test
  void afterAPlannedEndTheWatchdogIsAsItWasAndTheProgramGoesOn() throws Exception {
    run("ext_move_axis.src");

    runLoop(config(cfg -> cfg.duration(Duration.ofSeconds(2))), Law.jointVelocity(s -> TURNING));
    assertStandsForGood();

    assertThat(server.variables().get("JOV_LIMIT")).isEqualTo("0");
    assertThat(controller.robot().state()).isEqualTo(ProgramState.ACTIVE);
    assertThat(writesTo("JOV_HEARTBEAT")).hasSizeGreaterThan(12);
  }

  @Test
  void withoutAWatchdogNoHeartbeatIsSent() throws Exception {
    run("ext_move_axis.src");

    runLoop(
        config(cfg -> cfg.duration(Duration.ofSeconds(1)).safety(s -> inAutomatic(s).noWatchdog())),
        Law.jointVelocity(s -> TURNING));

    assertThat(writesTo("JOV_HEARTBEAT")).isEmpty();
    assertThat(writesTo("JOV_LIMIT")).isEmpty();
    assertStandsForGood();
  }
}
