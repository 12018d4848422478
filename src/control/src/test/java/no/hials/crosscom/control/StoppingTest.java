package no.hials.crosscom.control;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.assertThatNullPointerException;

import java.io.IOException;
import java.time.Duration;
import java.util.List;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicReference;
import no.hials.crosscom.control.StopReason.StopKind;
import no.hials.crosscom.control.input.Input;
import no.hials.crosscom.control.input.InputDevice;
import no.hials.crosscom.mock.Fault;
import no.hials.crosscom.protocol.code.OperatingMode;
import no.hials.crosscom.protocol.value.Axis;
import no.hials.crosscom.protocol.variable.VariableRequest.WriteRequest;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Stops a loop by its input, the controller, the law and the connection. */
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

  // the connection

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
}
