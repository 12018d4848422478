package no.hials.crosscom.simulator.internal.core;

import java.util.function.Supplier;
import no.hials.crosscom.protocol.value.Axis;
import no.hials.crosscom.simulator.internal.motion.AxisRates;
import no.hials.crosscom.simulator.internal.motion.PathRates;

/**
 * The speeds and accelerations of a motion when it is planned: those of the program, reduced in T1
 * and in a BCO run, or those of jogging (docs/reference/simulated-controller.md#reduced-speeds).
 */
final class MotionSpeeds {
  /** The reason why a motion is planned. */
  enum Purpose {
    PROGRAM,
    REDUCED,
    JOG
  }

  /**
   * The values that INITMOV sets, for a controller without these variables
   * (docs/reference/system-variables.md#what-initmov-sets).
   */
  private static final double DEFAULT_VELOCITY = 2;

  private static final double DEFAULT_TURN_VELOCITY = 200;
  private static final double DEFAULT_ACCELERATION = 2.3;
  private static final double DEFAULT_TURN_ACCELERATION = 100;

  // assumed; with 0 a motion would never end, and axes have at least 0.1 %

  private static final double MIN_PERCENT = 0.1;

  private static final double IN_PLACE_OF_ZERO = 0.001;
  private static final double ALL = 100;

  private final SystemVariableAccess access;
  private Supplier<Purpose> purpose = () -> Purpose.PROGRAM;

  MotionSpeeds(SystemVariableAccess access) {
    this.access = access;
  }

  /** Sets how the purpose of the next motion is found. */
  void purpose(Supplier<Purpose> ofNext) {
    purpose = ofNext;
  }

  /** Returns the rates of the robot's axes. */
  AxisRates axes() {
    return rates("$VEL_AXIS", "$ACC_AXIS", 0);
  }

  /** Returns the rates of the external axes. */
  AxisRates externalAxes() {
    return rates("$VEL_EXTAX", "$ACC_EXTAX", PositionValues.ROBOT_AXES);
  }

  private AxisRates rates(String velocity, String acceleration, int first) {
    return switch (purpose.get()) {
      case PROGRAM -> programmed(velocity, acceleration, 1);
      case REDUCED -> programmed(velocity, acceleration, teachShare());
      case JOG ->
          new AxisRates(
              jogged("$RED_VEL_AXC", first, jogShare()), jogged("$RED_ACC_AXC", first, 1));
    };
  }

  private AxisRates programmed(String velocity, String acceleration, double share) {
    return new AxisRates(
        percent(access.axes(velocity, ALL), share), percent(access.axes(acceleration, ALL), 1));
  }

  /** Returns the share of each axis in jogging; that of T1 if an axis has none. */
  private Axis jogged(String array, int first, double share) {
    Axis axes = Axis.ZERO;
    for (int i = 0; i < PositionValues.ROBOT_AXES; i++) {
      double own = access.number(array + "[" + (first + i + 1) + "]", 0);
      axes = axes.with(i, own > 0 ? own : teachShare() * ALL);
    }
    return percent(axes, share);
  }

  private static Axis percent(Axis axes, double share) {
    Axis result = axes;
    for (int i = 0; i < PositionValues.ROBOT_AXES; i++) {
      double part = Math.max(0, Math.min(ALL, axes.get(i))) * share;
      result = result.with(i, Math.max(MIN_PERCENT, part));
    }
    return result;
  }

  /** Returns the rates of the tool centre point. */
  PathRates path() {
    return switch (purpose.get()) {
      case PROGRAM -> path(Double.POSITIVE_INFINITY);
      case REDUCED -> path(teachSpeed());
      case JOG -> jogPath();
    };
  }

  private PathRates path(double most) {
    return new PathRates(
        positive(Math.min(most, rate("$VEL.CP", DEFAULT_VELOCITY, "$VEL_MA.CP"))),
        rate("$ACC.CP", DEFAULT_ACCELERATION, "$ACC_MA.CP"),
        rate("$VEL.ORI1", DEFAULT_TURN_VELOCITY, "$VEL_MA.ORI1"),
        rate("$ACC.ORI1", DEFAULT_TURN_ACCELERATION, "$ACC_MA.ORI1"));
  }

  private PathRates jogPath() {
    double velocity = part("$RED_VEL_CPC", teachShare());
    double acceleration = part("$RED_ACC_CPC", teachShare());
    double speed = Math.min(teachSpeed(), velocity * access.number("$VEL_MA.CP", DEFAULT_VELOCITY));
    return new PathRates(
        positive(speed * jogShare()),
        positive(acceleration * access.number("$ACC_MA.CP", DEFAULT_ACCELERATION)),
        positive(velocity * access.number("$VEL_MA.ORI1", DEFAULT_TURN_VELOCITY) * jogShare()),
        positive(acceleration * access.number("$ACC_MA.ORI1", DEFAULT_TURN_ACCELERATION)));
  }

  private double rate(String name, double otherwise, String limit) {
    return positive(Math.min(access.number(name, otherwise), access.number(limit, otherwise)));
  }

  private static double positive(double rate) {
    return rate > 0 ? rate : IN_PLACE_OF_ZERO;
  }

  /** Returns the part of the axes' speeds in T1, above 0 to 1. */
  double teachShare() {
    return part("$RED_T1", 1);
  }

  /** Returns the highest speed of the tool centre point on a path in T1, m/s. */
  double teachSpeed() {
    double limit = access.number("$SPEED_LIMIT_TEACH_MODE", Double.POSITIVE_INFINITY);
    return Math.min(limit, access.number("$VEL_CP_T1", limit));
  }

  private double part(String percentage, double otherwise) {
    double part = access.number(percentage, otherwise * ALL) / ALL;
    return Math.max(MIN_PERCENT / ALL, Math.min(1, part));
  }

  /** Returns the part of the jogging speeds that {@code $OV_JOG} asks for, above 0 to 1. */
  double jogShare() {
    return part("$OV_JOG", 1);
  }
}
