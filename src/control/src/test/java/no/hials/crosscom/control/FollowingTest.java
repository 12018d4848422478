package no.hials.crosscom.control;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.time.Duration;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import no.hials.crosscom.control.StopReason.StopKind;
import no.hials.crosscom.control.input.Input;
import no.hials.crosscom.protocol.code.OperatingMode;
import no.hials.crosscom.protocol.value.Axis;
import no.hials.crosscom.protocol.value.Frame;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;

/** The four kinds of laws follow a sinusoid with the programs of krl on the simulated robot. */
class FollowingTest extends ControlTest {
  private static final Duration ONE_TURN = Duration.ofSeconds(4);
  private static final double OMEGA = Math.PI / 2;
  private static final double DEGREES = 5;
  private static final double MM = 30;

  private static LoopConfig oneTurn() {
    return config(cfg -> cfg.duration(ONE_TURN));
  }

  private static LoopConfig oneTurn(Target target) {
    return config(cfg -> cfg.duration(ONE_TURN).target(target));
  }

  /** Runs a loop for one period of the sinusoid, and returns its cycles. */
  private List<Trace.Cycle> follow(LoopConfig config, Law law) throws Exception {
    try (ControlLoop loop = start(config, law)) {
      assertThat(loop.await().kind()).isEqualTo(StopKind.TIME_OVER);
      assertThat(loop.toldToStand()).isTrue();
      LoopStatistics statistics = loop.statistics();
      assertThat(statistics.cycles()).isEqualTo(334);
      assertThat(statistics.missed()).isZero();
      assertThat(statistics.period().maximum()).isEqualTo(12);
      return loop.trace().cycles();
    }
  }

  private static double amplitude(List<Trace.Cycle> cycles, int coordinate) {
    double least = Double.MAX_VALUE;
    double most = -Double.MAX_VALUE;
    for (Trace.Cycle cycle : cycles) {
      least = Math.min(least, cycle.actual().get(coordinate));
      most = Math.max(most, cycle.actual().get(coordinate));
    }
    return (most - least) / 2;
  }

  private static double largestError(List<Trace.Cycle> cycles, int coordinate) {
    return cycles.stream()
        .mapToDouble(c -> Math.abs(c.desired().get(coordinate) - c.actual().get(coordinate)))
        .max()
        .orElseThrow();
  }

  private void assertStands() {
    assertThat(controller.stepUntil(controller::standing, LIMIT)).isTrue();
    Axis stoodAt = controller.axes();
    controller.step(Duration.ofSeconds(2));
    assertThat(controller.axes().largestDifference(stoodAt)).isLessThan(1e-9);
    assertThat(controller.messages()).isEmpty();
  }

  private static Law sinusoidOfA1() {
    return Law.jointPosition(state -> START.with(0, DEGREES * Math.sin(OMEGA * state.time())));
  }

  private static Law sinusoidAlongX(Frame centre) {
    return Law.cartesianPosition(
        state -> Twist.linear(MM * Math.sin(OMEGA * state.time()), 0, 0).move(centre, 1));
  }

  @Test
  void aJointPositionLawIsFollowedByAbsoluteTargets() throws Exception {
    run("follow_axis.src");

    List<Trace.Cycle> cycles = follow(oneTurn(), sinusoidOfA1());

    assertThat(amplitude(cycles, 0)).isCloseTo(DEGREES, within(0.01));
    assertThat(largestError(cycles, 0)).isLessThan(0.5);
    assertThat(largestError(cycles, 3)).isZero();
    assertStands();
  }

  @Test
  void aJointPositionLawIsFollowedByIncrements() throws Exception {
    run("ext_move_axis.src");

    List<Trace.Cycle> cycles = follow(oneTurn(Target.increment("MYAXIS")), sinusoidOfA1());

    assertThat(amplitude(cycles, 0)).isCloseTo(DEGREES, within(0.1));
    assertThat(largestError(cycles, 0)).isLessThan(0.5);
    assertStands();
  }

  @Test
  void aJointVelocityLawTurnsTheAxesByIncrements() throws Exception {
    run("ext_move_axis.src");

    List<Trace.Cycle> cycles =
        follow(
            oneTurn(),
            Law.jointVelocity(
                s -> Axis.ZERO.with(0, DEGREES * OMEGA * Math.cos(OMEGA * s.time()))));

    // the program takes a cycle of 12 ms or slightly longer for an increment of v * dt
    assertThat(amplitude(cycles, 0)).isBetween(0.7 * DEGREES, 1.05 * DEGREES);
    assertStands();
  }

  @ParameterizedTest
  @ValueSource(ints = {24, 48, 120})
  void aLongerPeriodDoesNotMakeTheIncrementsOfAVelocityFaster(int millis) throws Exception {
    run("ext_move_axis.src");
    LoopConfig config =
        config(
            cfg ->
                cfg.duration(ONE_TURN)
                    .period(Duration.ofMillis(millis))
                    .safety(s -> inAutomatic(s).axes(30, 5, 15)));
    try (ControlLoop loop =
        start(
            config,
            Law.jointVelocity(
                s -> Axis.ZERO.with(0, DEGREES * OMEGA * Math.cos(OMEGA * s.time()))))) {
      assertThat(loop.await().kind()).isEqualTo(StopKind.TIME_OVER);
      assertThat(amplitude(loop.trace().cycles(), 0)).isBetween(0.7 * DEGREES, 1.05 * DEGREES);
    }
  }

  @ParameterizedTest
  @ValueSource(ints = {24, 48, 120})
  void aLongerPeriodDoesNotMakeTheIncrementsOfAPositionOvershoot(int millis) throws Exception {
    run("ext_move_axis.src");
    LoopConfig config =
        config(
            cfg ->
                cfg.duration(ONE_TURN)
                    .period(Duration.ofMillis(millis))
                    .gain(1)
                    .target(Target.increment("MYAXIS"))
                    .safety(s -> inAutomatic(s).axes(30, 5, 15)));
    try (ControlLoop loop = start(config, sinusoidOfA1())) {
      assertThat(loop.await().kind()).isEqualTo(StopKind.TIME_OVER);
      assertThat(amplitude(loop.trace().cycles(), 0)).isCloseTo(DEGREES, within(0.1));
      assertThat(largestError(loop.trace().cycles(), 0)).isLessThan(1.5);
    }
  }

  @Test
  void aCartesianPositionLawIsFollowedByAbsoluteTargets() throws Exception {
    run("follow_pos.src");

    List<Trace.Cycle> cycles = follow(oneTurn(), sinusoidAlongX(position()));

    assertThat(amplitude(cycles, 0)).isCloseTo(MM, within(0.1));
    assertThat(largestError(cycles, 0)).isLessThan(4);
    assertThat(largestError(cycles, 2)).isLessThan(0.01);
    assertStands();
  }

  @ParameterizedTest
  @ValueSource(doubles = {10, 20, 40, 60})
  void aSlowPointIsFollowedWithoutAStopBetweenTargets(double speed) throws Exception {
    run("follow_pos.src");
    Frame start = position();

    List<Trace.Cycle> cycles =
        follow(
            oneTurn(),
            Law.cartesianPosition(s -> Twist.linear(0, 0, -speed * s.time()).move(start, 1)));

    double period = 0.012;
    for (int i = 50; i < cycles.size(); i++) {
      double step = cycles.get(i - 1).actual().get(2) - cycles.get(i).actual().get(2);
      assertThat(step / period).isCloseTo(speed, within(0.02 * speed));
    }
    assertStands();
  }

  @Test
  void aCartesianPositionLawIsFollowedByIncrements() throws Exception {
    run("actuator.src");

    List<Trace.Cycle> cycles =
        follow(oneTurn(Target.increment("MYPOS")), sinusoidAlongX(position()));

    assertThat(amplitude(cycles, 0)).isCloseTo(MM, within(0.5));
    assertThat(largestError(cycles, 0)).isLessThan(4);
    assertStands();
  }

  @Test
  void aCartesianVelocityLawMovesTheToolByIncrements() throws Exception {
    run("actuator.src");

    List<Trace.Cycle> cycles =
        follow(
            oneTurn(),
            Law.cartesianVelocity(
                s -> Twist.linear(MM * OMEGA * Math.cos(OMEGA * s.time()), 0, 0)));

    assertThat(amplitude(cycles, 0)).isBetween(0.7 * MM, 1.05 * MM);
    assertThat(cycles)
        .as("rounding errors of the other coordinates are not sent")
        .allSatisfy(cycle -> assertThat(cycle.sent().subList(1, 6)).containsOnly(0.0));
    assertStands();
  }

  @Test
  void velocitiesWorkWithAbsoluteTargetsToo() throws Exception {
    run("follow_axis.src");

    List<Trace.Cycle> cycles =
        follow(
            oneTurn(Target.absolute("JOV_AXIS")),
            Law.jointVelocity(
                s -> Axis.ZERO.with(0, DEGREES * OMEGA * Math.cos(OMEGA * s.time()))));

    // slower than commanded: the robot brakes for each of the near targets
    assertThat(amplitude(cycles, 0)).isBetween(0.2 * DEGREES, 1.05 * DEGREES);
    assertStands();
  }

  @ParameterizedTest
  @CsvSource({"follow_pos.src, JOV_POS, false", "actuator.src, MYPOS, true"})
  void aRotationIsFollowedAcrossTheWrapOfTheAngles(String file, String name, boolean increment)
      throws Exception {
    controller.place(Axis.of(0, -90, 90, 0, 90, 0)); // A and C of the tool are at 180
    run(file);
    Frame start = position();

    List<Trace.Cycle> cycles =
        follow(
            oneTurn(new Target(name, increment)),
            Law.cartesianPosition(
                s -> new Twist(0, 0, 0, 0, 0, 4 * Math.sin(OMEGA * s.time())).move(start, 1)));

    assertThat(cycles.stream().map(c -> Math.signum(c.actual().get(3)))).contains(1.0, -1.0);
    assertThat(cycles.stream().mapToDouble(c -> 180 - Math.abs(c.actual().get(3))).max())
        .hasValueCloseTo(4.0, within(0.5));
    assertStands();
  }

  @Test
  void aRotationIsFollowedThroughGimbalLock() throws Exception {
    controller.place(Axis.of(0, -90, 90, 0, 2, 0)); // B of the tool is near 90
    run("actuator.src");
    Frame start = position();

    List<Trace.Cycle> cycles =
        follow(
            config(
                cfg ->
                    cfg.duration(ONE_TURN)
                        .target(Target.increment("MYPOS"))
                        .safety(s -> inAutomatic(s).wristMargin(0))),
            Law.cartesianPosition(
                s -> new Twist(0, 0, 0, 0, -4 * Math.sin(OMEGA * s.time()), 0).move(start, 1)));

    assertThat(cycles.stream().mapToDouble(c -> c.actual().get(4)).max())
        .hasValueCloseTo(90.0, within(0.3));
    assertStands();
  }

  @ParameterizedTest
  @EnumSource(DriveSpace.class)
  void withALowOverrideTheRobotStandsSoonToo(DriveSpace space) throws Exception {
    controller.setMode(OperatingMode.T1);
    run(space.program() + ".src");
    controller.variables().set("$OV_PRO", "10");
    Input full =
        new Input(List.of(0.0, 0.0, 0.0, 0.0, 0.0, 1.0), List.of(), true, System.nanoTime());
    Set<Double> factors = new HashSet<>();

    StopReason end =
        runLoop(
            LoopConfig.create(cfg -> cfg.period(PERIOD).noInput().duration(Duration.ofSeconds(1))),
            space.law(
                state -> {
                  factors.add(state.incrementFactor());
                  return full;
                },
                30,
                30));

    assertThat(end.kind()).isEqualTo(StopKind.TIME_OVER);
    assertThat(factors).containsOnly(Math.sqrt(0.1));
    controller.step(Duration.ofMillis(700));
    Axis soon = controller.axes();
    assertThat(soon.largestDifference(START)).isGreaterThan(0.1);
    controller.step(Duration.ofSeconds(5));
    assertThat(controller.axes().largestDifference(soon)).isLessThan(1e-9);
  }
}
