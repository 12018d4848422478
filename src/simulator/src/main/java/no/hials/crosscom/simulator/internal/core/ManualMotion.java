package no.hials.crosscom.simulator.internal.core;

import java.util.List;
import java.util.OptionalDouble;
import java.util.Set;
import no.hials.crosscom.kinematics.Frames;
import no.hials.crosscom.kinematics.RobotModel;
import no.hials.crosscom.lang.Position;
import no.hials.crosscom.lang.Statement.MotionKind;
import no.hials.crosscom.protocol.code.ProgramState;
import no.hials.crosscom.protocol.value.Frame;
import no.hials.crosscom.protocol.value.KrlReal;
import no.hials.crosscom.protocol.value.KrlStruct;
import no.hials.crosscom.simulator.JogCoordinates;
import no.hials.crosscom.simulator.KrlExecutionException;
import no.hials.crosscom.simulator.internal.motion.ExternalAxes;
import no.hials.crosscom.simulator.internal.program.KrlInterpreter;
import no.hials.crosscom.simulator.internal.program.MotionOrder;
import org.jspecify.annotations.Nullable;

/** Moves the robot without a program, as messages 11 and 12 of C3 Bridge ask for. */
final class ManualMotion {
  private enum State {
    NONE,
    MOTION,
    JOG
  }

  /** A distance beyond the reach of the arm, mm, and an angle below half a turn, degrees. */
  private static final double FAR = 2500;

  private static final double FAR_TURN = 170;

  /** The number of X, Y and Z, which come before the angles. */
  private static final int LENGTHS = 3;

  private final KrlInterpreter robot;
  private final AdvanceRun motions;
  private final OperatorPanel panel;
  private State state = State.NONE;

  /** The part of the jogging speeds for which the motion was planned. */
  private double planned = 1;

  ManualMotion(KrlInterpreter robot, AdvanceRun motions, OperatorPanel panel) {
    this.robot = robot;
    this.motions = motions;
    this.panel = panel;
  }

  boolean active() {
    return state != State.NONE;
  }

  boolean jogging() {
    return state == State.JOG;
  }

  /**
   * Returns the part of the planned speed of a jog, 0 to 1: a lower {@code $OV_JOG} takes effect at
   * once, a higher one from the next press (assumed).
   */
  double override(double jogOverride) {
    return Math.min(1, jogOverride / planned);
  }

  void move(MotionKind kind, KrlStruct target) throws KrlExecutionException {
    requireReleased("move");
    if (jogging()) {
      throw new IllegalStateException("move: a jog key is pressed");
    }
    begin(State.MOTION, kind, target, null);
  }

  void jog(MotionKind kind, KrlStruct target) throws KrlExecutionException {
    jog(kind, target, null);
  }

  private void jog(MotionKind kind, KrlStruct target, @Nullable String coordinates)
      throws KrlExecutionException {
    requireReleased("jog");
    if (!panel.mode().manual()) {
      throw new IllegalStateException(
          "jog: the operating mode must be T1 or T2, is " + panel.mode());
    }
    end();
    begin(State.JOG, kind, target, coordinates);
  }

  void jog(JogCoordinates coordinates, int number, boolean positive) throws KrlExecutionException {
    if (coordinates == JogCoordinates.AXIS) {
      jogAxis(number, positive);
      return;
    }
    requireNumber(number, PositionValues.ROBOT_AXES);
    double far = (number <= LENGTHS ? FAR : FAR_TURN) * (positive ? 1 : -1);
    Frame increment = increment(number, far);
    if (coordinates == JogCoordinates.WORLD) {
      Frame base = motions.resolver().base();
      Frame turn = new Frame(0, 0, 0, base.a(), base.b(), base.c());
      increment = Frames.product(Frames.inverse(turn), increment, turn);
    }
    jog(
        MotionKind.LIN_REL,
        PositionValues.frame(increment),
        coordinates == JogCoordinates.TOOL ? "TOOL" : null);
  }

  private void jogAxis(int number, boolean positive) throws KrlExecutionException {
    motions.readLimits();
    List<ExternalAxes.Limits> external = motions.externalAxes().limits();
    requireNumber(number, PositionValues.ROBOT_AXES + external.size());
    String name;
    double end;
    if (number <= PositionValues.ROBOT_AXES) {
      RobotModel model = motions.model();
      name = "A" + number;
      end = positive ? model.maximum(number - 1) : model.minimum(number - 1);
    } else {
      int index = number - PositionValues.ROBOT_AXES;
      ExternalAxes.Limits limits = external.get(index - 1);
      name = "E" + index;
      end = positive ? limits.maximum() : limits.minimum();
    }
    KrlStruct.Field field = new KrlStruct.Field(name, KrlReal.of(end));
    jog(MotionKind.PTP, new KrlStruct("E6AXIS", List.of(field)));
  }

  private static void requireNumber(int number, int most) {
    if (number < 1 || number > most) {
      throw new IllegalArgumentException(
          "jog: the number of the axis must be 1 to " + most + ", is " + number);
    }
  }

  private static Frame increment(int number, double value) {
    double[] parts = new double[PositionValues.ROBOT_AXES];
    parts[number - 1] = value;
    return new Frame(parts[0], parts[1], parts[2], parts[3], parts[4], parts[5]);
  }

  private void begin(State next, MotionKind kind, KrlStruct target, @Nullable String coordinates)
      throws KrlExecutionException {
    state = next;
    planned = motions.resolver().speeds().jogShare();
    boolean done = false;
    try {
      plan(kind, target, coordinates);
      done = true;
    } finally {
      if (!done) {
        state = State.NONE;
      }
    }
  }

  private void plan(MotionKind kind, KrlStruct target, @Nullable String coordinates)
      throws KrlExecutionException {
    motions.move(
        new MotionOrder(
            kind,
            null,
            target,
            OptionalDouble.empty(),
            Set.of(),
            coordinates,
            "",
            "",
            new Position(kind.name(), 1, 1),
            List.of()));
  }

  private void requireReleased(String action) {
    ControllerCore.requireIdle(robot, action);
    panel.requireReleased(action);
    if (robot.state() == ProgramState.STOP && !active() && !motions.idle()) {
      throw new IllegalStateException(
          action + ": a program is stopped within a motion, reset or cancel it first");
    }
  }

  /** Slows the robot down and discards the motions, if it is moved manually. */
  void end() {
    if (active()) {
      motions.discardAll();
      state = State.NONE;
    }
  }

  /** Called after each cycle. */
  void cycle() {
    if (motions.finished()) {
      state = State.NONE;
    }
  }
}
