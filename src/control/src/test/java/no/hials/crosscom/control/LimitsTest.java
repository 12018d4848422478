package no.hials.crosscom.control;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.time.Duration;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicInteger;
import no.hials.crosscom.control.StopReason.StopKind;
import no.hials.crosscom.mock.Fault;
import no.hials.crosscom.protocol.Tail;
import no.hials.crosscom.protocol.code.ProgramState;
import no.hials.crosscom.protocol.value.Axis;
import no.hials.crosscom.protocol.value.Frame;
import no.hials.crosscom.protocol.variable.VariableRequest.ReadRequest;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Violates each limit of a loop, and checks that the simulated robot stops. */
class LimitsTest extends ControlTest {
  // too fast, too far

  @Test
  void anAxisThatIsToTurnTooFastStopsTheRobotAndItsProgram() throws Exception {
    StopReason reason =
        runToStop(
            "ext_move_axis.src",
            Law.jointVelocity(s -> Axis.ZERO.with(2, s.time() < 1 ? 10 : 30.1)));

    assertReason(reason, StopKind.SPEED, "the speed of A3 must be at most 30 degrees/s, is 30.1");
    assertThat(controller.axes().a3()).isGreaterThan(95);
    assertThat(writesTo("MYAXIS")).last().asString().contains("A3 0");
    assertThat(controller.robot().state()).isEqualTo(ProgramState.STOP); // by the watchdog
  }

  @Test
  void aToolThatIsToMoveTooFastStopsTheRobot() throws Exception {
    StopReason reason =
        runToStop(
            "actuator.src",
            Law.cartesianVelocity(s -> Twist.linear(0, s.time() < 1 ? 50 : 100.1, 0)));

    assertReason(reason, StopKind.SPEED, "the speed of path must be at most 100 mm/s, is 100.1");
  }

  @Test
  void aToolThatIsToRotateTooFastStopsTheRobot() throws Exception {
    StopReason reason =
        runToStop(
            "actuator.src",
            Law.cartesianVelocity(s -> new Twist(0, 0, 0, 18, 0, s.time() < 0.5 ? 0 : 25)));

    assertReason(
        reason, StopKind.SPEED, "the speed of rotation must be at most 30 degrees/s, is 30.806");
  }

  @Test
  void aPositionThatJumpsStopsTheRobot() throws Exception {
    Frame start = position();

    StopReason reason =
        runToStop(
            "follow_pos.src",
            Law.cartesianPosition(s -> Twist.linear(0, 0, s.time() < 0.5 ? 0 : 40).move(start, 1)));

    assertReason(
        reason, StopKind.STEP, "the step of path in one cycle must be at most 5 mm, is 40");
    assertThat(position().distance(start)).isCloseTo(0, within(0.01));
  }

  @Test
  void aFirstTargetFarFromWhereTheRobotStandsIsNotSent() throws Exception {
    StopReason reason = runToStop("follow_axis.src", Law.jointPosition(s -> START.with(0, 3)));

    assertReason(
        reason, StopKind.STEP, "the step of A1 in one cycle must be at most 2 degrees, is 3");
    assertThat(controller.axes()).isEqualTo(START);
  }

  @Test
  void anAxisStopsBeforeItsLimit() throws Exception {
    controller.place(START.with(2, 145)); // the limit is 156
    StopReason reason =
        runToStop("ext_move_axis.src", Law.jointVelocity(s -> Axis.ZERO.with(2, 10)));

    assertThat(reason.kind()).isEqualTo(StopKind.AXIS_LIMIT);
    assertThat(reason.message())
        .startsWith("A3 must be -115 to 151 degrees (limits minus a margin of 5), would be 151.");
    assertThat(controller.axes().a3()).isBetween(150.0, 152.0);
  }

  @Test
  void anAxisStopsBeforeItsLimitInACartesianLawToo() throws Exception {
    StopReason reason =
        runToStop(
            "actuator.src",
            safe(s -> s.axisLimits(new AxisLimits(START.plus(five(-10)), START.plus(five(10))))),
            Law.cartesianVelocity(s -> Twist.linear(-20, 0, 0)));

    assertThat(reason.kind()).isEqualTo(StopKind.AXIS_LIMIT);
    assertThat(reason.message()).contains("(limits minus a margin of 5), would be");
    for (int i = 0; i < 6; i++) {
      assertThat(controller.axes().get(i)).isBetween(START.get(i) - 10, START.get(i) + 10);
    }
  }

  @Test
  void theAxesAreCheckedInALoopTooThatSendsAHeartbeatInEachCycle() throws Exception {
    StopReason reason =
        runToStop(
            "actuator.src",
            safe(
                s ->
                    s.maxFeedbackAge(Duration.ofMillis(200))
                        .axisLimits(new AxisLimits(START.plus(five(-10)), START.plus(five(10))))),
            Law.cartesianVelocity(
                s -> {
                  time.pass(Duration.ofMillis(130)); // a beat goes out every 125 ms
                  return Twist.linear(-20, 0, 0);
                }));

    assertThat(reason.kind()).isEqualTo(StopKind.AXIS_LIMIT);
  }

  private static Axis five(double angle) {
    return new Axis(angle, angle, angle, angle, angle, angle);
  }

  @Test
  void theToolStopsBeforeTheSideOfTheWorkspace() throws Exception {
    Frame start = position();

    StopReason reason =
        runToStop(
            "actuator.src",
            safe(s -> s.workspace(Workspace.around(start, 60))),
            Law.cartesianVelocity(s -> Twist.linear(0, 40, 0)));

    assertThat(reason.kind()).isEqualTo(StopKind.WORKSPACE);
    assertThat(reason.message())
        .startsWith(
            "Y of the workspace must be -50 to 50 mm (limits minus a margin of 10), would be 50.");
    assertThat(position().y()).isBetween(49.0, 53.0);
  }

  @ParameterizedTest
  @ValueSource(ints = {0, 90})
  void theToolStopsBeforeTheWristIsSingular(int millisOfLaw) throws Exception {
    controller.place(START.with(4, 24));
    StopReason reason =
        runToStop(
            "actuator.src",
            safe(s -> s.maxFeedbackAge(Duration.ofMillis(200))),
            Law.cartesianVelocity(
                s -> {
                  time.pass(Duration.ofMillis(millisOfLaw));
                  return new Twist(0, 0, 0, 0, -29, 0);
                }));

    assertThat(reason.kind()).isEqualTo(StopKind.SINGULARITY);
    assertThat(reason.message())
        .startsWith("A5 must be at least 10 degrees from 0, where small motions of the tool turn")
        .endsWith(": move the axes first");
    assertThat(controller.axes().a5()).isBetween(7.0, 15.0);
  }

  @Test
  void aCartesianLawDoesNotStartWhereTheWristIsSingular() throws Exception {
    controller.place(START.with(4, -9));
    run("actuator.src");

    assertThatThrownBy(
            () -> start(config(cfg -> {}), Law.cartesianVelocity(s -> Twist.linear(1, 0, 0))))
        .isInstanceOfSatisfying(
            ControlRefusedException.class,
            e -> assertThat(e.reason().kind()).isEqualTo(StopKind.SINGULARITY));
    assertThat(writesTo("MYPOS")).isEmpty();
  }

  @Test
  void aJointLawMovesThroughTheSingularityOfTheWrist() throws Exception {
    controller.place(START.with(4, 12));
    run("ext_move_axis.src");

    StopReason reason =
        runLoop(
            config(cfg -> cfg.duration(Duration.ofSeconds(3))),
            Law.jointVelocity(s -> Axis.ZERO.with(4, -10)));

    assertThat(reason.kind()).isEqualTo(StopKind.TIME_OVER);
    assertThat(controller.axes().a5()).isLessThan(-10);
  }

  @Test
  void withoutAWorkspaceTheToolStaysNearWhereItStarted() throws Exception {
    Frame start = position();

    StopReason reason =
        runToStop(
            "follow_pos.src",
            safe(s -> s.path(100, 5, 60).wristMargin(0)),
            Law.cartesianPosition(s -> Twist.linear(0, 0, -90 * s.time()).move(start, 1)));

    assertThat(reason.kind()).isEqualTo(StopKind.WORKSPACE);
    assertThat(reason.message()).startsWith("Z of the workspace must be ");
    assertThat(start.z() - position().z()).isBetween(250.0, 295.0);
  }

  @Test
  void aJointLawKeepsAWorkspaceThatIsGiven() throws Exception {
    Frame start = position();

    StopReason reason =
        runToStop(
            "ext_move_axis.src",
            safe(s -> s.workspace(Workspace.around(start, 60))),
            Law.jointVelocity(s -> TURNING));

    assertThat(reason.kind()).isEqualTo(StopKind.WORKSPACE);
    assertThat(position().y()).isBetween(-60.0, -50.0);
  }

  @Test
  void aRobotThatIsFasterThanItWasToldStops() throws Exception {
    run("follow_axis.src");
    client.writeText("JOV_SPEED", "100");

    StopReason reason =
        runToStop(
            safe(s -> s.axes(5, 2, 90)), // the target runs ahead while the override is low
            Law.jointPosition(
                s -> {
                  if (s.time() == 0) {
                    write("$OV_PRO", "1");
                  } else if (s.time() > 5) {
                    write("$OV_PRO", "100");
                  }
                  return START.with(0, 4.9 * s.time());
                }));

    assertThat(reason.kind()).isEqualTo(StopKind.SPEED);
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

    assertThat(reason.kind()).isEqualTo(StopKind.TRACKING_ERROR);
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
                s -> START.plus(new Axis(12 * s.time(), 0, 0, 0, 0, 6 * s.time()))))) {
      assertThat(loop.await().kind()).isEqualTo(StopKind.TIME_OVER);
      assertThat(loop.statistics().saturated()).isPositive();
      assertThat(loop.trace().cycles())
          .allSatisfy(
              cycle -> {
                assertThat(cycle.sent().get(0)).isBetween(-0.2, 0.2);
                assertThat(cycle.sent().get(5)).isCloseTo(cycle.sent().get(0) / 2, within(0.02));
              });
    }
  }

  // the feedback

  @Test
  void aValueThatDoesNotChangeStopsTheRobot() throws Exception {
    StopReason reason =
        runToStop(
            "ext_move_axis.src",
            Law.jointVelocity(
                s -> {
                  if (s.time() > 1 && s.time() < 1.02) {
                    String stuck = client.readText("$AXIS_ACT");
                    server.fault(
                        r -> r.name().equals("$AXIS_ACT"), Fault.answer(stuck, Tail.SUCCESS));
                  }
                  return TURNING;
                }));

    assertReason(
        reason,
        StopKind.STALLED_FEEDBACK,
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

    assertThat(reason.kind()).as(reason.message()).isEqualTo(StopKind.TIME_OVER);
  }

  @Test
  void whereTheRobotIsNotKnownNoPositionIsWrittenToHoldIt() throws Exception {
    run("follow_axis.src");
    String stuck = client.readText("$AXIS_ACT");
    server.fault(r -> r.name().equals("$AXIS_ACT"), Fault.answer(stuck, Tail.SUCCESS));
    try (ControlLoop loop =
        start(config(cfg -> {}), Law.jointPosition(s -> START.with(0, 10 * s.time())))) {
      assertThat(loop.await().kind()).isEqualTo(StopKind.STALLED_FEEDBACK);
      assertThat(loop.toldToStand()).isFalse();
    }
    assertStandsForGood();
    assertThat(controller.axes().a1()).isBetween(4.5, 5.5); // at the last target
  }

  @Test
  void anAbsoluteTargetHoldsTheRobotWhereItWasWhenItHadToStop() throws Exception {
    StopReason reason =
        runToStop(
            "follow_axis.src",
            Law.jointPosition(
                s -> {
                  if (s.time() > 1) {
                    throw new IllegalStateException("no plan");
                  }
                  return START.with(0, 10 * s.time());
                }));

    assertThat(reason.kind()).isEqualTo(StopKind.LAW);
    assertThat(controller.axes().a1()).isBetween(9.0, 10.1);
    assertThat(server.variables().get("JOV_TIMEOUT")).isEqualTo("TRUE");
  }

  @Test
  void aValueThatIsTooOldWhenItComesStopsTheRobot() throws Exception {
    server.faults(
        request -> {
          if (request.request() instanceof ReadRequest read
              && read.name().equals("$AXIS_ACT")
              && time.nanoTime() > 1_000_000_000L) {
            time.pass(Duration.ofMillis(101));
          }
          return Optional.empty();
        });

    StopReason reason = runToStop("ext_move_axis.src", Law.jointVelocity(s -> TURNING));

    assertReason(
        reason,
        StopKind.STALE_FEEDBACK,
        "the time of reading $AXIS_ACT must be at most 100 ms, is 101");
  }

  @Test
  void aLawThatTakesTooLongStopsTheRobot() throws Exception {
    StopReason reason =
        runToStop("ext_move_axis.src", afterOneSecond(() -> time.pass(Duration.ofMillis(101))));

    assertReason(
        reason,
        StopKind.STALE_FEEDBACK,
        "the age of $AXIS_ACT after the law must be at most 100 ms, is 101");
  }
}
