package no.hials.crosscom.control;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.Consumer;
import no.hials.crosscom.control.StopReason.Kind;
import no.hials.crosscom.control.input.Input;
import no.hials.crosscom.control.input.InputDevice;
import no.hials.crosscom.kinematics.Axes;
import no.hials.crosscom.kinematics.Frame;
import no.hials.crosscom.mock.Fault;
import no.hials.crosscom.mock.RecordedRequest;
import no.hials.crosscom.protocol.Tail;
import no.hials.crosscom.protocol.variable.ReadRequest;
import no.hials.crosscom.protocol.variable.WriteRequest;
import no.hials.crosscom.simulator.ProgramState;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Tries to break each limit, and sees the simulated robot stop. */
class StoppingTest extends ControlTest {
  private static final Axes TURNING = Axes.ZERO.with(0, 10); // degrees/s

  private static LoopConfig safe(Consumer<Safety.Builder> changes) {
    return config(cfg -> cfg.safety(s -> changes.accept(inAutomatic(s))));
  }

  /** Sees that the robot comes to stand, stays there, and that nobody writes any more. */
  private void assertStandsForGood() {
    long requests = server.requestCount();
    assertThat(controller.stepUntil(controller::standing, LIMIT)).isTrue();
    Axes stoodAt = controller.axes();
    controller.step(Duration.ofSeconds(2));
    assertThat(controller.axes().largestDifference(stoodAt)).isLessThan(1e-9);
    assertThat(server.requestCount()).isEqualTo(requests);
  }

  /** Runs a loop that ends by a limit, and gives why. */
  private StopReason runToStop(LoopConfig config, Law law) throws Exception {
    StopReason reason;
    try (ControlLoop loop = start(config, law)) {
      reason = loop.await();
      assertThat(loop.toldToStand()).isTrue();
      assertThat(loop.status()).isEqualTo(ControlLoop.Status.STOPPED);
      assertThat(loop.stopReason()).contains(reason);
    }
    assertThat(reason.isPlanned()).isFalse();
    assertStandsForGood();
    return reason;
  }

  private List<String> writesTo(String name) {
    return server.requests().stream()
        .map(RecordedRequest::request)
        .filter(r -> r instanceof WriteRequest write && write.name().equals(name))
        .map(r -> ((WriteRequest) r).value())
        .toList();
  }

  // too fast, too far

  @Test
  void anAxisThatIsToTurnTooFastStopsTheRobot() throws Exception {
    run("ext_move_axis.src");

    StopReason reason =
        runToStop(
            config(cfg -> {}), Law.jointVelocity(s -> Axes.ZERO.with(2, s.time() < 1 ? 10 : 30.1)));

    assertThat(reason.kind()).isEqualTo(Kind.SPEED);
    assertThat(reason.message()).isEqualTo("the speed of A3 must be at most 30 degrees/s, is 30.1");
    assertThat(controller.axes().a3()).isGreaterThan(95);
    assertThat(writesTo("MYAXIS")).last().asString().contains("A3 0");
  }

  @Test
  void aToolThatIsToMoveTooFastStopsTheRobot() throws Exception {
    run("actuator.src");

    StopReason reason =
        runToStop(
            config(cfg -> {}),
            Law.cartesianVelocity(s -> Twist.linear(0, s.time() < 1 ? 50 : 100.1, 0)));

    assertThat(reason.kind()).isEqualTo(Kind.SPEED);
    assertThat(reason.message()).isEqualTo("the speed of path must be at most 100 mm/s, is 100.1");
  }

  @Test
  void aToolThatIsToRotateTooFastStopsTheRobot() throws Exception {
    run("actuator.src");

    StopReason reason =
        runToStop(
            config(cfg -> {}),
            Law.cartesianVelocity(s -> new Twist(0, 0, 0, 18, 0, s.time() < 0.5 ? 0 : 25)));

    assertThat(reason.kind()).isEqualTo(Kind.SPEED);
    assertThat(reason.message())
        .isEqualTo("the speed of rotation must be at most 30 degrees/s, is 30.806");
  }

  @Test
  void aPositionThatJumpsStopsTheRobot() throws Exception {
    run("follow_pos.src");
    Frame start = position();

    StopReason reason =
        runToStop(
            config(cfg -> {}),
            Law.cartesianPosition(s -> Twist.linear(0, 0, s.time() < 0.5 ? 0 : 40).move(start, 1)));

    assertThat(reason.kind()).isEqualTo(Kind.STEP);
    assertThat(reason.message())
        .isEqualTo("the step of path in one cycle must be at most 5 mm, is 40");
    assertThat(position().distance(start)).isCloseTo(0, within(0.01));
  }

  @Test
  void aFirstTargetFarFromWhereTheRobotStandsIsNotSent() throws Exception {
    run("follow_axis.src");

    StopReason reason = runToStop(config(cfg -> {}), Law.jointPosition(s -> START.with(0, 3)));

    assertThat(reason.kind()).isEqualTo(Kind.STEP);
    assertThat(reason.message())
        .isEqualTo("the step of A1 in one cycle must be at most 2 degrees, is 3");
    assertThat(controller.axes()).isEqualTo(START);
  }

  @Test
  void anAxisStopsBeforeItsLimit() throws Exception {
    controller.place(START.with(2, 145)); // the limit is 156
    run("ext_move_axis.src");

    StopReason reason = runToStop(config(cfg -> {}), Law.jointVelocity(s -> Axes.ZERO.with(2, 10)));

    assertThat(reason.kind()).isEqualTo(Kind.AXIS_LIMIT);
    assertThat(reason.message())
        .startsWith("A3 must be -115 to 151 degrees (limits minus a margin of 5), would be 151.");
    assertThat(controller.axes().a3()).isBetween(150.0, 152.0);
  }

  @Test
  void anAxisStopsBeforeItsLimitInACartesianLawToo() throws Exception {
    run("actuator.src");

    StopReason reason =
        runToStop(
            safe(s -> s.axisLimits(new AxisLimits(START.plus(five(-10)), START.plus(five(10))))),
            Law.cartesianVelocity(s -> Twist.linear(-20, 0, 0)));

    assertThat(reason.kind()).isEqualTo(Kind.AXIS_LIMIT);
    assertThat(reason.message()).contains("(limits minus a margin of 5), would be");
    for (int i = 0; i < 6; i++) {
      assertThat(controller.axes().get(i)).isBetween(START.get(i) - 10, START.get(i) + 10);
    }
  }

  @Test
  void theAxesAreCheckedInALoopTooThatSendsAHeartbeatInEachCycle() throws Exception {
    run("actuator.src");

    StopReason reason =
        runToStop(
            safe(
                s ->
                    s.maxFeedbackAge(Duration.ofMillis(200))
                        .axisLimits(new AxisLimits(START.plus(five(-10)), START.plus(five(10))))),
            Law.cartesianVelocity(
                s -> {
                  time.pass(Duration.ofMillis(130)); // a beat goes out every 125 ms
                  return Twist.linear(-20, 0, 0);
                }));

    assertThat(reason.kind()).isEqualTo(Kind.AXIS_LIMIT);
  }

  private static Axes five(double angle) {
    return new Axes(angle, angle, angle, angle, angle, angle);
  }

  @Test
  void theToolStopsBeforeTheSideOfTheWorkspace() throws Exception {
    run("actuator.src");
    Frame start = position();

    StopReason reason =
        runToStop(
            safe(s -> s.workspace(Workspace.around(start, 60))),
            Law.cartesianVelocity(s -> Twist.linear(0, 40, 0)));

    assertThat(reason.kind()).isEqualTo(Kind.WORKSPACE);
    assertThat(reason.message())
        .startsWith(
            "Y of the workspace must be -50 to 50 mm (limits minus a margin of 10), would be 50.");
    assertThat(position().y()).isBetween(49.0, 53.0);
  }

  @Test
  void withoutAWorkspaceTheToolStaysNearWhereItStarted() throws Exception {
    run("follow_pos.src");
    Frame start = position();

    StopReason reason =
        runToStop(
            safe(s -> s.path(100, 5, 60)),
            Law.cartesianPosition(s -> Twist.linear(0, 0, -90 * s.time()).move(start, 1)));

    assertThat(reason.kind()).isEqualTo(Kind.WORKSPACE);
    assertThat(reason.message()).startsWith("Z of the workspace must be ");
    assertThat(start.z() - position().z()).isBetween(250.0, 295.0);
  }

  @Test
  void aJointLawKeepsAWorkspaceThatIsGiven() throws Exception {
    run("ext_move_axis.src");
    Frame start = position();

    StopReason reason =
        runToStop(
            safe(s -> s.workspace(Workspace.around(start, 60))), Law.jointVelocity(s -> TURNING));

    assertThat(reason.kind()).isEqualTo(Kind.WORKSPACE);
    assertThat(position().y()).isBetween(-60.0, -50.0);
  }

  @Test
  void aRobotThatIsFasterThanItWasToldStops() throws Exception {
    run("follow_axis.src");
    client.writeText("JOV_SPEED", "100");

    StopReason reason =
        runToStop(
            safe(s -> s.axes(5, 2, 90)), // the target runs ahead unseen while the override is low
            Law.jointPosition(
                s -> {
                  if (s.time() == 0) {
                    write("$OV_PRO", "1");
                  } else if (s.time() > 5) {
                    write("$OV_PRO", "100");
                  }
                  return START.with(0, 4.9 * s.time());
                }));

    assertThat(reason.kind()).isEqualTo(Kind.SPEED);
    assertThat(reason.message())
        .startsWith("the measured speed of A1 must be at most 7.5 degrees/s, is ");
  }

  private void write(String name, String value) throws IOException {
    client.writeText(name, value);
  }

  @Test
  void aRobotThatDoesNotFollowStops() throws Exception {
    run("follow_axis.src");
    client.writeText("$OV_PRO", "1");

    StopReason reason =
        runToStop(config(cfg -> {}), Law.jointPosition(s -> START.with(0, 29 * s.time())));

    assertThat(reason.kind()).isEqualTo(Kind.TRACKING_ERROR);
    assertThat(reason.message())
        .startsWith("the tracking error of A1 must be at most 15 degrees, is 15.");
  }

  @Test
  void aLargeIncrementOfAPositionLawIsCutToTheStep() throws Exception {
    run("ext_move_axis.src");
    LoopConfig config =
        config(
            cfg ->
                cfg.target(Target.increment("MYAXIS"))
                    .duration(Duration.ofSeconds(2))
                    .gain(1)
                    .safety(s -> inAutomatic(s).axes(30, 0.2, 15)));
    try (ControlLoop loop =
        start(
            config,
            Law.jointPosition(
                s -> START.plus(new Axes(12 * s.time(), 0, 0, 0, 0, 6 * s.time()))))) {
      assertThat(loop.await().kind()).isEqualTo(Kind.TIME_OVER);
      assertThat(loop.statistics().saturated()).isPositive();
      assertThat(loop.trace().cycles())
          .allSatisfy(
              cycle -> {
                assertThat(cycle.sent().get(0)).isBetween(-0.2, 0.2);
                assertThat(cycle.sent().get(5)).isCloseTo(cycle.sent().get(0) / 2, within(0.02));
              });
    }
  }

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
    Law law = Law.jointVelocity(s -> Axes.ZERO.with(0, 5 * s.input().axis(0)));
    LoopConfig config =
        config(
            cfg ->
                cfg.target(new Target(name, increment))
                    .input(silent)
                    .duration(Duration.ofSeconds(6)));
    try (ControlLoop loop = start(config, law)) {
      assertThat(loop.await().kind()).isEqualTo(Kind.TIME_OVER);
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

    assertThat(reason.kind()).isEqualTo(Kind.TIME_OVER);
    assertThat(first.get()).isZero();
    assertStandsForGood();
  }

  @Test
  void anInputDeviceThatFailsStopsTheRobot() throws Exception {
    run("ext_move_axis.src");
    InputDevice failing =
        () -> {
          if (time.nanoTime() > 1_000_000_000L) {
            throw new IOException("unplugged");
          }
          return held(true);
        };

    StopReason reason =
        runToStop(config(cfg -> cfg.input(failing)), Law.jointVelocity(s -> TURNING));

    assertThat(reason.kind()).isEqualTo(Kind.INPUT);
    assertThat(reason.message()).contains("unplugged");
  }

  @Test
  void aDeadManWithTheTimeOfAnotherClockStopsTheRobot() throws Exception {
    run("ext_move_axis.src");
    InputDevice ahead =
        () -> new Input(List.of(), List.of(), true, time.nanoTime() + 5_000_000_000L);

    StopReason reason = runToStop(config(cfg -> cfg.input(ahead)), Law.jointVelocity(s -> TURNING));

    assertThat(reason.kind()).isEqualTo(Kind.INPUT);
    assertThat(reason.message())
        .isEqualTo("the time of the input must be from System.nanoTime, is 5000 ms ahead of it");
  }

  @Test
  void aLoopWithoutADeadManHasToBeAskedFor() {
    assertThatIllegalArgumentException()
        .isThrownBy(() -> LoopConfig.create(cfg -> {}))
        .withMessageContaining("noInput()");
  }

  // the feedback

  @Test
  void aValueThatDoesNotChangeStopsTheRobot() throws Exception {
    run("ext_move_axis.src");

    StopReason reason =
        runToStop(
            config(cfg -> {}),
            Law.jointVelocity(
                s -> {
                  if (s.time() > 1 && s.time() < 1.02) {
                    String stuck = client.readText("$AXIS_ACT");
                    server.fault(
                        r -> r.name().equals("$AXIS_ACT"), Fault.answer(stuck, Tail.SUCCESS));
                  }
                  return TURNING;
                }));

    assertThat(reason.kind()).isEqualTo(Kind.STALLED_FEEDBACK);
    assertThat(reason.message())
        .isEqualTo(
            "$AXIS_ACT must change within 500 ms when the robot is told to move,"
                + " was the same for 504 ms");
    assertThat(writesTo("MYAXIS")).last().asString().startsWith("{A1 0");
  }

  @Test
  void aSlowReadingIsNotTakenForAStall() throws Exception {
    run("ext_move_axis.src");
    String before = client.readText("$AXIS_ACT");
    AtomicInteger writes = new AtomicInteger();
    server.fault(
        r -> {
          if (r.name().equals("MYAXIS")) {
            writes.incrementAndGet();
            return false;
          }
          boolean slow = r.name().equals("$AXIS_ACT") && writes.get() == 1;
          if (slow) {
            time.pass(Duration.ofMillis(600));
          }
          return slow;
        },
        Fault.answer(before, Tail.SUCCESS)); // from before the robot could move

    StopReason reason =
        runLoop(
            config(
                cfg ->
                    cfg.duration(Duration.ofSeconds(3))
                        .safety(
                            s ->
                                inAutomatic(s).noWatchdog().maxFeedbackAge(Duration.ofSeconds(1)))),
            Law.jointVelocity(s -> TURNING));

    assertThat(reason.kind()).as(reason.message()).isEqualTo(Kind.TIME_OVER);
  }

  @Test
  void whereTheRobotIsNotKnownNoPositionIsWrittenToHoldIt() throws Exception {
    run("follow_axis.src");
    String stuck = client.readText("$AXIS_ACT");
    server.fault(r -> r.name().equals("$AXIS_ACT"), Fault.answer(stuck, Tail.SUCCESS));
    try (ControlLoop loop =
        start(config(cfg -> {}), Law.jointPosition(s -> START.with(0, 10 * s.time())))) {
      assertThat(loop.await().kind()).isEqualTo(Kind.STALLED_FEEDBACK);
      assertThat(loop.toldToStand()).isFalse();
    }
    assertStandsForGood();
    assertThat(controller.axes().a1()).isBetween(4.5, 5.5); // at the last target
  }

  @Test
  void anAbsoluteTargetHoldsTheRobotWhereItWasWhenItHadToStop() throws Exception {
    run("follow_axis.src");

    StopReason reason =
        runToStop(
            config(cfg -> {}),
            Law.jointPosition(
                s -> {
                  if (s.time() > 1) {
                    throw new IllegalStateException("no plan");
                  }
                  return START.with(0, 10 * s.time());
                }));

    assertThat(reason.kind()).isEqualTo(Kind.LAW);
    assertThat(controller.axes().a1()).isBetween(9.0, 10.1);
    assertThat(server.variables().get("JOV_TIMEOUT")).isEqualTo("TRUE");
  }

  @Test
  void aValueThatIsTooOldWhenItComesStopsTheRobot() throws Exception {
    run("ext_move_axis.src");
    server.faults(
        request -> {
          if (request.request() instanceof ReadRequest read
              && read.name().equals("$AXIS_ACT")
              && time.nanoTime() > 1_000_000_000L) {
            time.pass(Duration.ofMillis(101));
          }
          return Optional.empty();
        });

    StopReason reason = runToStop(config(cfg -> {}), Law.jointVelocity(s -> TURNING));

    assertThat(reason.kind()).isEqualTo(Kind.STALE_FEEDBACK);
    assertThat(reason.message())
        .isEqualTo("the time of reading $AXIS_ACT must be at most 100 ms, is 101");
  }

  @Test
  void aLawThatTakesTooLongStopsTheRobot() throws Exception {
    run("ext_move_axis.src");

    StopReason reason =
        runToStop(
            config(cfg -> {}),
            Law.jointVelocity(
                s -> {
                  if (s.time() > 1) {
                    time.pass(Duration.ofMillis(101));
                  }
                  return TURNING;
                }));

    assertThat(reason.kind()).isEqualTo(Kind.STALE_FEEDBACK);
    assertThat(reason.message())
        .isEqualTo("the age of $AXIS_ACT after the law must be at most 100 ms, is 101");
  }

  // the controller

  @Test
  void aModeThatIsNotAllowedIsRefusedBeforeAnythingIsWritten() throws Exception {
    run("ext_move_axis.src");
    LoopConfig onlyInT1 = LoopConfig.create(cfg -> cfg.period(PERIOD).noInput());

    assertThatExceptionOfType(ControlRefusedException.class)
        .isThrownBy(() -> start(onlyInT1, Law.jointVelocity(s -> TURNING)))
        .withMessage("$MODE_OP must be one of [T1], is #AUT")
        .satisfies(e -> assertThat(e.reason().kind()).isEqualTo(Kind.MODE));

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
    run("ext_move_axis.src");

    StopReason reason =
        runToStop(
            config(cfg -> {}),
            Law.jointVelocity(
                s -> {
                  if (s.time() > 1) {
                    controller.setMode(no.hials.crosscom.simulator.OperatingMode.T2);
                  }
                  return TURNING;
                }));

    assertThat(reason.kind()).isEqualTo(Kind.MODE);
    assertThat(reason.message()).isEqualTo("$MODE_OP must be one of [AUT], is #T2");
  }

  @Test
  void aProgramThatIsStoppedStopsTheLoop() throws Exception {
    run("ext_move_axis.src");

    StopReason reason =
        runToStop(
            config(cfg -> {}),
            Law.jointVelocity(
                s -> {
                  if (s.time() > 1) {
                    controller.robot().stop();
                  }
                  return TURNING;
                }));

    assertThat(reason.message()).isEqualTo("$PRO_STATE1 must be #P_ACTIVE, is #P_STOP");
    controller.robot().start();
    assertStandsForGood();
  }

  @Test
  void aVariableThatTheControllerDoesNotKnowIsTheReason() throws Exception {
    run("ext_move_axis.src");
    LoopConfig config = config(cfg -> cfg.target(Target.increment("NOSUCH")));
    try (ControlLoop loop = start(config, Law.jointVelocity(s -> TURNING))) {
      assertThat(loop.await().kind()).isEqualTo(Kind.ACCESS);
      assertThat(loop.await().message()).contains("NOSUCH");
      assertThat(loop.toldToStand()).isFalse();
    }
  }

  // the law

  @Test
  void anExceptionInTheLawStopsTheRobot() throws Exception {
    run("ext_move_axis.src");
    IllegalStateException thrown = new IllegalStateException("no plan");

    StopReason reason =
        runToStop(
            config(cfg -> {}),
            Law.jointVelocity(
                s -> {
                  if (s.time() > 1) {
                    throw thrown;
                  }
                  return TURNING;
                }));

    assertThat(reason.kind()).isEqualTo(Kind.LAW);
    assertThat(reason.message()).contains("no plan");
    assertThat(reason.cause()).isSameAs(thrown);
    assertThat(controller.axes().a1()).isGreaterThan(5);
  }

  @Test
  void aLawThatLeavesItsThreadInterruptedStopsTheRobot() throws Exception {
    run("ext_move_axis.src");

    StopReason reason =
        runToStop(
            config(cfg -> {}),
            Law.jointVelocity(
                s -> {
                  if (s.time() > 1) {
                    Thread.currentThread().interrupt();
                    throw new InterruptedException("no plan");
                  }
                  return TURNING;
                }));

    assertThat(reason.kind()).isEqualTo(Kind.LAW);
    assertThat(reason.message()).contains("no plan");
  }

  @Test
  void whateverTheLawThrowsStopsTheRobot() throws Exception {
    run("ext_move_axis.src");
    Throwable thrown = new Throwable("neither exception nor error");

    StopReason reason =
        runToStop(config(cfg -> {}), Law.jointVelocity(s -> throwUndeclared(thrown)));

    assertThat(reason.kind()).isEqualTo(Kind.LAW);
    assertThat(reason.cause()).isSameAs(thrown);
  }

  @SuppressWarnings("unchecked") // the point: E is not what is thrown
  private static <T extends Throwable> Axes throwUndeclared(Throwable thrown) throws T {
    throw (T) thrown;
  }

  @Test
  void aNumberThatIsNoneStopsTheRobot() throws Exception {
    run("actuator.src");

    StopReason reason =
        runToStop(
            config(cfg -> {}),
            Law.cartesianVelocity(s -> Twist.linear(s.time() < 0.5 ? 10 : 0 / 0.0, 0, 0)));

    assertThat(reason.kind()).isEqualTo(Kind.LAW);
    assertThat(reason.message()).contains("X must be finite, is NaN");
  }

  @Test
  void aLawThatGivesNothingStopsTheRobot() throws Exception {
    run("follow_axis.src");

    StopReason reason = runToStop(config(cfg -> {}), Law.jointPosition(s -> null));

    assertThat(reason.kind()).isEqualTo(Kind.LAW);
    assertThat(reason.message()).isEqualTo("the law must return a command, returned null");
  }

  // the connection and the watchdog

  @Test
  void aLostWriteStopsTheRobotAndIsNotRepeated() throws Exception {
    run("ext_move_axis.src");

    StopReason reason =
        runToStop(
            config(cfg -> {}),
            Law.jointVelocity(
                s -> {
                  if (s.time() > 1) {
                    server.fault(
                        r ->
                            r.request() instanceof WriteRequest w
                                && w.value().startsWith("{A1 0.1"),
                        Fault.resetBefore());
                  }
                  return TURNING;
                }));

    assertThat(reason.kind()).isEqualTo(Kind.ACCESS);
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
            Law.jointVelocity(
                s -> {
                  if (s.time() > 1) {
                    server.refuseConnections();
                    server.disconnectClients();
                  }
                  return TURNING;
                }))) {
      assertThat(loop.await().kind()).isEqualTo(Kind.ACCESS);
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
        .satisfies(e -> assertThat(e.reason().kind()).isEqualTo(Kind.WATCHDOG));

    assertThat(server.variables().get("JOV_LIMIT")).isEqualTo("0");
    assertThat(writesTo("MYAXIS")).isEmpty();
  }

  @Test
  void aWatchdogThatAnotherClientSwitchesOffStopsTheRobot() throws Exception {
    run("ext_move_axis.src");

    StopReason reason =
        runToStop(
            config(cfg -> {}),
            Law.jointVelocity(
                s -> {
                  if (s.time() > 1) {
                    server.variables().set("JOV_LIMIT", "0");
                  }
                  return TURNING;
                }));

    assertThat(reason.kind()).isEqualTo(Kind.WATCHDOG);
    assertThat(reason.message())
        .isEqualTo(
            "JOV_LIMIT must be 500 as set by this loop, is 0; another client uses the watchdog");
  }

  @Test
  void aWatchdogThatStopsLookingStopsTheRobot() throws Exception {
    run("ext_move_axis.src");

    StopReason reason =
        runToStop(
            config(cfg -> {}),
            Law.jointVelocity(
                s -> {
                  if (s.time() > 1) {
                    controller.submit().stop();
                  }
                  return TURNING;
                }));

    assertThat(reason.kind()).isEqualTo(Kind.WATCHDOG);
    assertThat(reason.message()).contains("JOV_SEEN must be at most 4 behind");
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
  void afterAnyOtherEndTheWatchdogStopsTheProgramToo() throws Exception {
    run("ext_move_axis.src");

    runToStop(
        config(cfg -> {}), Law.jointVelocity(s -> s.time() < 1 ? TURNING : Axes.ZERO.with(0, 99)));

    assertThat(controller.robot().state()).isEqualTo(ProgramState.STOP);
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
