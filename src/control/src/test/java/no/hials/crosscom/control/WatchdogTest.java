package no.hials.crosscom.control;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;

import java.nio.file.Files;
import java.time.Duration;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.atomic.AtomicBoolean;
import no.hials.crosscom.control.StopReason.StopKind;
import no.hials.crosscom.protocol.code.ProgramState;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Stops a loop by the watchdog, and the program by a heartbeat that is missing. */
class WatchdogTest extends ControlTest {
  /** Runs another submit program in place of the watchdog. */
  private void replaceSubmit(String name, String text) throws Exception {
    controller.submit().stop();
    controller.submit().select(controller.load(name, text));
    controller.submit().start();
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
    replaceSubmit(
        "off.sub",
        """
        DEF OFF ( )
          LOOP
            JOV_LIMIT=0
            JOV_SEEN=JOV_HEARTBEAT
          ENDLOOP
        END
        """);

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

  /** Returns the clock of a computer that sleeps for a second each time it waits. */
  private LoopTime clockWhile(AtomicBoolean sleeps) {
    return new LoopTime() {
      @Override
      public long nanoTime() {
        return time.nanoTime();
      }

      @Override
      public void awaitUntil(long nanoTime) {
        time.awaitUntil(sleeps.get() ? nanoTime + 1_000_000_000 : nanoTime);
      }
    };
  }

  @ParameterizedTest
  @ValueSource(booleans = {false, true})
  void aComputerThatWasAsleepIsTheReasonAndNotTheProgramThatHasStopped(boolean atTheStart)
      throws Exception {
    run("ext_move_axis.src");
    AtomicBoolean sleeps = new AtomicBoolean(atTheStart);
    LoopConfig config = safe(s -> s.checkInterval(Duration.ofMillis(1)));
    Law law =
        Law.jointVelocity(
            s -> {
              sleeps.set(!atTheStart && s.time() > 1);
              return TURNING;
            });
    try (ControlLoop loop = ControlLoop.start(client, config, law, clockWhile(sleeps))) {
      assertThat(loop.await().kind()).isEqualTo(StopKind.LATE_HEARTBEAT);
    }
    assertThat(controller.robot().state()).isEqualTo(ProgramState.STOP);
  }

  @Test
  void cyclesThatWereMissedAtTheEndAreCounted() throws Exception {
    run("ext_move_axis.src");
    AtomicBoolean sleeps = new AtomicBoolean();
    LoopConfig config = config(cfg -> cfg.duration(Duration.ofMillis(1499)));
    Law law = afterOneSecond(() -> sleeps.set(true));
    try (ControlLoop loop = ControlLoop.start(client, config, law, clockWhile(sleeps))) {
      assertThat(loop.await().kind()).isEqualTo(StopKind.TIME_OVER);
      assertThat(loop.statistics().cycles() + loop.statistics().missed()).isEqualTo(125);
    }
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
    String beats = "    IF JOV_TIMEOUT THEN\n JOV_HEARTBEAT=JOV_HEARTBEAT+1\n ENDIF\n  ENDLOOP";
    String watchdog = Files.readString(KRL.resolve("jov_sps.sub")).replace("  ENDLOOP", beats);
    replaceSubmit("jov_sps.sub", watchdog);
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
