package no.hials.crosscom.simulator.internal.core;

import static no.hials.crosscom.kinematics.Frames.inverse;
import static no.hials.crosscom.kinematics.Frames.product;

import java.util.ArrayList;
import java.util.List;
import no.hials.crosscom.protocol.value.Axis;
import no.hials.crosscom.protocol.value.Frame;
import no.hials.crosscom.simulator.internal.motion.ExternalAxes;
import no.hials.crosscom.simulator.internal.motion.ExternalAxes.Limits;

/**
 * The external axes of the machine data, and where E1 carries the robot. All of it is assumed
 * (docs/reference/robots.md#external-axes).
 */
final class ExternalAxesData {
  private static final int LINEAR = 1;
  private static final int ENDLESS = 5;

  /** The time to the highest speed, s, of an axis that does not state it. */
  private static final double RAISE_TIME = 0.3;

  /** The highest speed, per s, of an axis that does not state it. */
  private static final double SPEED = 100;

  /** Further than any axis moves. */
  private static final double FAR = 1e9;

  private final SystemVariableAccess access;

  ExternalAxesData(SystemVariableAccess access) {
    this.access = access;
  }

  /** Returns the axes and their limits, which clients and data lists can change. */
  ExternalAxes read() {
    int count = (int) Math.max(0, Math.min(Axis.COUNT, access.number("$EX_AX_NUM", 0)));
    if (count == 0) {
      return ExternalAxes.NONE;
    }
    List<Limits> limits = new ArrayList<>();
    for (int i = 0; i < count; i++) {
      limits.add(limits("[" + (PositionValues.ROBOT_AXES + i + 1) + "]"));
    }
    Frame way = product(inverse(root(Axis.ZERO)), root(Axis.ZERO.with(0, 1)));
    return new ExternalAxes(limits, new Frame(way.x(), way.y(), way.z(), 0, 0, 0));
  }

  private Limits limits(String index) {
    double minimum = access.number("$SOFTN_END" + index, 0);
    double maximum = access.number("$SOFTP_END" + index, 0);
    boolean endless = access.number("$AXIS_TYPE" + index, 0) == ENDLESS;
    double turns =
        access.number("$RAT_MOT_AX" + index + ".N", 0)
            / access.number("$RAT_MOT_AX" + index + ".D", 0);
    double speed = Math.abs(access.number("$VEL_AXIS_MA" + index, 0) * 6 / turns);
    speed = speed > 0 && speed < FAR ? speed : SPEED;
    double raise = access.number("$RAISE_TIME" + index, 0) / 1000;
    return new Limits(
        endless ? -FAR : minimum,
        endless ? FAR : maximum,
        speed,
        speed / (raise > 0 ? raise : RAISE_TIME));
  }

  /** Returns the root of the robot in the world ({@code $ROBROOT_C}). */
  Frame root(Axis external) {
    return isUnit()
        ? product(
            access.frame("$ERSYSROOT"),
            access.frame("$ET1_TA1KR"),
            new Frame(0, 0, external.a1(), 0, 0, 0),
            access.frame("$ET1_TFLA3"))
        : access.frame("$ROBROOT");
  }

  /** Returns whether E1 is a linear unit that carries the robot. */
  private boolean isUnit() {
    return access.number("$EX_AX_NUM", 0) > 0
        && access.number("$AXIS_TYPE[7]", 0) == LINEAR
        && access.constant("$EX_KIN.ET1", "NONE").equalsIgnoreCase("ERSYS")
        && access.constant("$ET1_AX.TR_A1", "E1").equalsIgnoreCase("E1")
        && access.constant("$ET1_AX.TR_A2", "NONE").equalsIgnoreCase("NONE");
  }
}
