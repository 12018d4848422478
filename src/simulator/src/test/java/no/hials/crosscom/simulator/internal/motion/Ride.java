package no.hials.crosscom.simulator.internal.motion;

import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;
import no.hials.crosscom.kinematics.RobotModel;
import no.hials.crosscom.protocol.value.Axis;
import no.hials.crosscom.protocol.value.Frame;
import no.hials.crosscom.simulator.internal.motion.MotionCommand.Circular;
import no.hials.crosscom.simulator.internal.motion.MotionCommand.Linear;
import no.hials.crosscom.simulator.internal.motion.MotionCommand.PointToPoint;

/** An interpolator with what the core around it would see: every position and every event. */
final class Ride {
  static final RobotModel ROBOT = RobotModel.kr6r900sixx();
  static final AxisRates FULL = AxisRates.of(100, 100);

  /** Those of BAS(#INITMOV,0) (docs/reference/system-variables.md#what-initmov-sets). */
  static final PathRates PATH = new PathRates(2, 2.3, 200, 100);

  /** More cycles than any test needs. */
  private static final int MANY = 20_000;

  final Interpolator system;
  final List<Axis> positions = new ArrayList<>();
  final List<MotionEvent> events = new ArrayList<>();
  double override = 1;
  boolean released = true;
  private long lastId;

  Ride(Axis start) {
    this(ROBOT, start);
  }

  Ride(RobotModel robot, Axis start) {
    system = new Interpolator(robot, start);
    positions.add(start);
  }

  static Ride fromHome() {
    return new Ride(ROBOT.home());
  }

  MotionCommand ptp(Axis target) throws MotionRefusedException {
    return ptp(target, FULL, new ApproximationZone.Exact());
  }

  MotionCommand ptp(Axis target, AxisRates rates, ApproximationZone approximation)
      throws MotionRefusedException {
    return add(new PointToPoint(++lastId, target, rates, Frame.IDENTITY, approximation));
  }

  MotionCommand lin(Frame target) throws MotionRefusedException {
    return lin(target, Frame.IDENTITY, PATH, OrientationControl.VAR, new ApproximationZone.Exact());
  }

  MotionCommand lin(Frame target, ApproximationZone approximation) throws MotionRefusedException {
    return lin(target, Frame.IDENTITY, PATH, OrientationControl.VAR, approximation);
  }

  MotionCommand lin(
      Frame target,
      Frame tool,
      PathRates rates,
      OrientationControl orientation,
      ApproximationZone approximation)
      throws MotionRefusedException {
    return add(new Linear(++lastId, target, tool, rates, orientation, approximation));
  }

  MotionCommand circ(
      Frame auxiliary, Frame target, OptionalDouble angle, OrientationControl orientation)
      throws MotionRefusedException {
    return add(
        new Circular(
            ++lastId,
            auxiliary,
            target,
            angle,
            Frame.IDENTITY,
            PATH,
            orientation,
            new ApproximationZone.Exact()));
  }

  /** Adds a block that starts where the planned motions end. */
  MotionCommand spline(List<SplineSegment> segments, ApproximationZone approximation)
      throws MotionRefusedException {
    return add(
        new MotionCommand.Spline(
            ++lastId, segments, MotionCommand.Sections.NONE, Frame.IDENTITY, approximation));
  }

  long nextId() {
    return ++lastId;
  }

  MotionCommand add(MotionCommand motion) throws MotionRefusedException {
    system.add(motion);
    return motion;
  }

  /** Runs to the end of what is planned, and returns the cycles that it took. */
  int toTheEnd() {
    int cycles = 0;
    while (!system.finished()) {
      cycle();
      cycles++;
      if (cycles > MANY) {
        throw new AssertionError("no end in sight after " + MANY + " cycles");
      }
    }
    return cycles;
  }

  /** Runs until the robot stands, and returns the cycles that it took. */
  int toStanding() {
    int cycles = 0;
    do {
      cycle();
      cycles++;
      if (cycles > MANY) {
        throw new AssertionError("still moving after " + MANY + " cycles");
      }
    } while (!system.standing());
    return cycles;
  }

  void cycles(int count) {
    for (int i = 0; i < count; i++) {
      cycle();
    }
  }

  void cycle() {
    events.addAll(system.cycle(override, released));
    positions.add(system.axes());
  }

  /** Returns the flange at every cycle. */
  List<Frame> flanges() {
    return positions.stream().map(ROBOT::forward).toList();
  }

  /** Returns the highest speed of an axis from one cycle to the next, degrees/s. */
  double peakSpeed(int axis) {
    double peak = 0;
    for (int i = 1; i < positions.size(); i++) {
      peak = Math.max(peak, Math.abs(step(i, axis)));
    }
    return peak / Interpolator.CYCLE;
  }

  /** Returns the highest change of an axis' speed from one cycle to the next, degrees/s². */
  double peakAcceleration(int axis) {
    double peak = 0;
    for (int i = 2; i < positions.size(); i++) {
      peak = Math.max(peak, Math.abs(step(i, axis) - step(i - 1, axis)));
    }
    return peak / Interpolator.CYCLE / Interpolator.CYCLE;
  }

  /** Returns the speed of the flange in every cycle, m/s. */
  List<Double> flangeSpeeds() {
    List<Double> speeds = new ArrayList<>();
    List<Frame> flanges = flanges();
    for (int i = 1; i < flanges.size(); i++) {
      speeds.add(flanges.get(i).distance(flanges.get(i - 1)) / Interpolator.CYCLE / 1000);
    }
    return speeds;
  }

  /** Returns the highest change of the flange's speed from one cycle to the next, m/s². */
  double peakPathAcceleration() {
    double peak = 0;
    double before = 0;
    for (double speed : flangeSpeeds()) {
      peak = Math.max(peak, Math.abs(speed - before) / Interpolator.CYCLE);
      before = speed;
    }
    return peak;
  }

  private double step(int index, int axis) {
    return positions.get(index).get(axis) - positions.get(index - 1).get(axis);
  }
}
