package no.hials.crosscom.simulator.internal.core;

import java.util.Locale;
import java.util.Objects;
import java.util.OptionalDouble;
import java.util.Set;
import no.hials.crosscom.kinematics.Frames;
import no.hials.crosscom.kinematics.RobotModel;
import no.hials.crosscom.kinematics.UnreachableException;
import no.hials.crosscom.lang.Statement;
import no.hials.crosscom.protocol.value.Axis;
import no.hials.crosscom.protocol.value.Frame;
import no.hials.crosscom.protocol.value.KrlStruct;
import no.hials.crosscom.simulator.KrlExecutionException;
import no.hials.crosscom.simulator.internal.motion.ApproximationZone;
import no.hials.crosscom.simulator.internal.motion.ExternalTarget;
import no.hials.crosscom.simulator.internal.motion.Joints;
import no.hials.crosscom.simulator.internal.motion.MotionCommand;
import no.hials.crosscom.simulator.internal.motion.MotionCommand.Circular;
import no.hials.crosscom.simulator.internal.motion.MotionCommand.Linear;
import no.hials.crosscom.simulator.internal.motion.MotionCommand.PointToPoint;
import no.hials.crosscom.simulator.internal.motion.MotionProblem;
import no.hials.crosscom.simulator.internal.motion.OrientationControl;
import no.hials.crosscom.simulator.internal.program.MotionOrder;

/**
 * Resolves motion statements when the advance run reaches them: the target by {@code $BASE}, {@code
 * $TOOL} and the end of the motion before, the speed by {@code $VEL}, {@code $ACC} and the like.
 */
final class MotionResolver {
  /** Positions of doubles are exact to 0.001 mm up to here, mm. */
  private static final double FARTHEST = 1e9;

  /** The number of values of the six bits of the Turn. */
  private static final int TURNS = 64;

  private final SystemVariableAccess access;
  private final ExternalAxesData externalAxes;
  private final MotionSpeeds speeds;
  private final BlockResolver blocks;
  private RobotModel robot;

  /** The end of the last planned motion. */
  private Joints last;

  private long planned;

  MotionResolver(SystemVariableAccess access, RobotModel robot, Joints start) {
    this.access = access;
    this.externalAxes = new ExternalAxesData(access);
    this.speeds = new MotionSpeeds(access);
    this.robot = robot;
    this.last = start;
    this.blocks = new BlockResolver(access, this);
  }

  MotionSpeeds speeds() {
    return speeds;
  }

  /** Replaces the robot by the same with other software limits. */
  void robot(RobotModel limited) {
    robot = limited;
  }

  /** Sets the start position of the next motion. */
  void startAt(Joints axes) {
    last = axes;
  }

  /** Returns the base in the world. */
  Frame base() {
    return access.frame("$BASE");
  }

  /** Returns the base in the robot's root. */
  Frame baseInRoot(Axis external) {
    return Frames.product(Frames.inverse(externalAxes.root(external)), base());
  }

  Frame tool() {
    return access.frame("$TOOL");
  }

  /** Returns the end of the external axes; those that are not there stay at 0. */
  ExternalTarget externalTarget(MotionOrder order) {
    return externalTarget(order, last.external());
  }

  /**
   * Returns the end of the external axes.
   *
   * @param from their positions at the start of the motion
   */
  ExternalTarget externalTarget(MotionOrder order, Axis from) {
    int count = externalAxes.read().limits().size();
    Axis to =
        order.kind().relative()
            ? from.plus(PositionValues.toExternal(order.target(), Axis.ZERO))
            : PositionValues.toExternal(order.target(), from);
    for (int i = count; i < Axis.COUNT; i++) {
      to = to.with(i, from.get(i));
    }
    return new ExternalTarget(to, speeds.externalAxes());
  }

  MotionCommand plan(MotionOrder order) throws KrlExecutionException {
    planned++;
    if (order.block() != null || !PositionValues.isAxes(order.target())) {
      requireComputable("$BASE", base());
      requireComputable("$TOOL", tool());
    }
    if (order.block() != null) {
      return blocks.plan(planned, order, order.block(), last);
    }
    return switch (order.kind()) {
      case PTP, PTP_REL -> pointToPoint(order);
      case LIN, LIN_REL ->
          new Linear(
              planned,
              frame(order, order.target()),
              tool(),
              speeds.path(),
              orientation(),
              pathApproximation(order.approximations()));
      case CIRC, CIRC_REL -> circular(order);
    };
  }

  /** Refuses a frame so far away that positions in it would lose their digits (assumed). */
  private static void requireComputable(String name, Frame frame) throws KrlExecutionException {
    double[] lengths = {frame.x(), frame.y(), frame.z()};
    for (int i = 0; i < lengths.length; i++) {
      if (!(Math.abs(lengths[i]) <= FARTHEST)) {
        throw new KrlExecutionException(
            MotionProblem.BAD_MOTION,
            String.format(
                Locale.ROOT,
                "%s.%s must be within %.0e mm, is %.1e",
                name,
                "XYZ".charAt(i),
                FARTHEST,
                lengths[i]));
      }
    }
  }

  private MotionCommand pointToPoint(MotionOrder order) throws KrlExecutionException {
    return new PointToPoint(
        planned, axesOf(order), speeds.axes(), tool(), axisApproximation(order));
  }

  /** Returns the axes at the end of a PTP motion. */
  private Axis axesOf(MotionOrder order) throws KrlExecutionException {
    KrlStruct target = order.target();
    // with external axes only, the robot keeps its axes in PTP, and its TCP in LIN (assumed)
    if (!PositionValues.isAxes(target) && !PositionValues.isExternal(target)) {
      return inverse(order);
    }
    return order.kind().relative()
        ? last.robot().plus(PositionValues.toAxes(target, Axis.ZERO))
        : PositionValues.toAxes(target, last.robot());
  }

  /** Returns the axes at the end of a PTP motion that starts elsewhere. */
  Axis axesOf(MotionOrder order, Joints start) throws KrlExecutionException {
    Joints before = last;
    last = start;
    try {
      return axesOf(order);
    } finally {
      last = before;
    }
  }

  /** Returns the TCP in the robot's root at given axes. */
  Frame tcp(Axis axes) {
    return Frames.product(robot.forward(axes), tool());
  }

  /**
   * Returns the axes of a PTP motion's Cartesian target. Without Status and Turn, and for an
   * increment, the arm keeps its configuration (docs/reference/kinematics.md#status-and-turn; for
   * PTP_REL assumed).
   */
  private Axis inverse(MotionOrder order) throws KrlExecutionException {
    KrlStruct target = order.target();
    Axis external = externalTarget(order).axes();
    try {
      if (order.kind().relative()) {
        Frame tcp = Frames.product(baseInRoot(external), inBase(order, target));
        return robot.inverse(Frames.product(tcp, Frames.inverse(tool())), last.robot());
      }
      return inverse(target, last, external);
    } catch (UnreachableException e) {
      throw new KrlExecutionException(
          MotionProblem.WORK_ENVELOPE, Objects.requireNonNull(e.getMessage()));
    }
  }

  private MotionCommand circular(MotionOrder order) throws KrlExecutionException {
    KrlStruct auxiliary = order.auxiliary();
    if (auxiliary == null) {
      throw new IllegalArgumentException("a circle needs an auxiliary point");
    }
    return new Circular(
        planned,
        frame(order, auxiliary),
        frame(order, order.target()),
        order.circularAngle(),
        tool(),
        speeds.path(),
        orientation(),
        pathApproximation(order.approximations()));
  }

  /**
   * Returns the TCP's frame in the robot's root at the start of the motion. An increment is along
   * the axes of {@code $BASE}, and its angles turn the TCP about these axes. With {@code #TOOL} it
   * is along those of the tool (both assumed).
   */
  private Frame frame(MotionOrder order, KrlStruct target) throws KrlExecutionException {
    if (!PositionValues.isAxes(target)) {
      return Frames.product(baseInRoot(last.external()), inBase(order, target));
    }
    if (order.kind().relative()) {
      throw new KrlExecutionException(
          KrlExecutionException.WRONG_TYPE,
          order.kind() + " needs a Cartesian increment, was given axes");
    }
    Axis external = externalTarget(order).axes();
    Frame tcp = Frames.product(robot.forward(PositionValues.toAxes(target, last.robot())), tool());
    return external.equals(last.external())
        ? tcp
        : Frames.product(
            Frames.inverse(externalAxes.root(last.external())), externalAxes.root(external), tcp);
  }

  /** Returns a Cartesian target in the base. */
  private Frame inBase(MotionOrder order, KrlStruct target) {
    return inBase(order, target, tcpInBase(last));
  }

  /**
   * Returns a Cartesian target in the base.
   *
   * @param from the TCP in the base at the start of the motion
   */
  static Frame inBase(MotionOrder order, KrlStruct target, Frame from) {
    if (!order.kind().relative()) {
      return PositionValues.toFrame(target, from);
    }
    Frame increment = PositionValues.toFrame(target, Frame.IDENTITY);
    if ("TOOL".equals(order.coordinates())) {
      return Frames.product(from, increment);
    }
    Frame turn = new Frame(0, 0, 0, increment.a(), increment.b(), increment.c());
    Frame turned = Frames.product(turn, new Frame(0, 0, 0, from.a(), from.b(), from.c()));
    return new Frame(
        from.x() + increment.x(),
        from.y() + increment.y(),
        from.z() + increment.z(),
        turned.a(),
        turned.b(),
        turned.c());
  }

  /** Returns the TCP in the base. */
  Frame tcpInBase(Joints joints) {
    return Frames.product(
        Frames.inverse(baseInRoot(joints.external())), robot.forward(joints.robot()), tool());
  }

  /**
   * Returns the axes that bring the tool to a position: with its Status and Turn, or else, of what
   * it has, near other axes.
   *
   * @param near the axes from which missing components come
   * @param external the external axes at the position
   */
  Axis inverse(KrlStruct position, Joints near, Axis external) throws UnreachableException {
    Frame flange =
        Frames.product(
            baseInRoot(external),
            PositionValues.toFrame(position, tcpInBase(near)),
            Frames.inverse(tool()));
    OptionalDouble status = PositionValues.number(position, "S");
    OptionalDouble turn = PositionValues.number(position, "T");
    if (status.isEmpty()) {
      return robot.inverse(flange, near.robot());
    }
    int wanted = (int) status.getAsDouble();
    return turn.isPresent()
        ? robot.inverse(flange, wanted, (int) turn.getAsDouble())
        : nearest(flange, wanted, near.robot());
  }

  /** Returns the axes of a Status that are nearest to others, of all Turns. */
  private Axis nearest(Frame flange, int status, Axis near) throws UnreachableException {
    Axis nearest = null;
    UnreachableException reason = null;
    for (int turn = 0; turn < TURNS; turn++) {
      try {
        Axis axes = robot.inverse(flange, status, turn);
        if (nearest == null || axes.largestDifference(near) < nearest.largestDifference(near)) {
          nearest = axes;
        }
      } catch (UnreachableException e) {
        reason = e;
      }
    }
    if (nearest == null) {
      throw Objects.requireNonNull(reason);
    }
    return nearest;
  }

  OrientationControl orientation() {
    return switch (access.constant("$ORI_TYPE", "VAR")) {
      case "CONSTANT" -> OrientationControl.CONSTANT;
      case "JOINT" -> OrientationControl.JOINT;
      case "IGNORE" -> OrientationControl.IGNORE;
      default -> OrientationControl.VAR;
    };
  }

  private ApproximationZone axisApproximation(MotionOrder order) {
    if (order.spline()) {
      return pathApproximation(order.approximations());
    }
    return order.approximations().isEmpty()
        ? new ApproximationZone.Exact()
        : new ApproximationZone.AxisDistance(within(access.number("$APO.CPTP", 0), 100));
  }

  ApproximationZone pathApproximation(Set<Statement.Approximation> asked) {
    if (asked.contains(Statement.Approximation.C_VEL)) {
      return new ApproximationZone.Speed(within(access.number("$APO.CVEL", 100), 100));
    }
    if (asked.contains(Statement.Approximation.C_ORI)) {
      return new ApproximationZone.Orientation(
          within(access.number("$APO.CORI", 0), Double.MAX_VALUE));
    }
    return asked.isEmpty()
        ? new ApproximationZone.Exact()
        : new ApproximationZone.Distance(within(access.number("$APO.CDIS", 0), Double.MAX_VALUE));
  }

  private static double within(double value, double most) {
    return Math.max(0, Math.min(most, value));
  }
}
