package no.hials.crosscom.simulator.internal.core;

import no.hials.crosscom.protocol.code.OperatingMode;
import no.hials.crosscom.simulator.internal.motion.MotionCommand.AxisSpline;
import no.hials.crosscom.simulator.internal.motion.MotionCommand.PointToPoint;
import no.hials.crosscom.simulator.internal.motion.SpeedLimit;

/**
 * Reduces the programmed speed: by the override, and in T1 by its limits
 * (docs/reference/system-variables.md#override-and-speed).
 */
final class SpeedReduction {
  private static final double PERCENT = 100;

  private final SystemVariableAccess access;
  private final AdvanceRun motions;
  private final OperatorPanel panel;
  private final ManualMotion manual;
  private final BlockCoincidence coincidence;

  SpeedReduction(
      SystemVariableAccess access,
      AdvanceRun motions,
      OperatorPanel panel,
      ManualMotion manual,
      BlockCoincidence coincidence) {
    this.access = access;
    this.motions = motions;
    this.panel = panel;
    this.manual = manual;
    this.coincidence = coincidence;
  }

  /** Returns the part of the programmed speed, 0 to 1. */
  double override() {
    double override = part(manual.jogging() ? "$OV_JOG" : "$OV_PRO");
    boolean reduced = slow() && isPointToPoint();
    return reduced ? override * Math.min(1, access.number("$RED_T1", PERCENT) / PERCENT) : override;
  }

  /** A BCO run is as slow as a motion in T1 (assumed). */
  private boolean slow() {
    return panel.mode() == OperatingMode.T1 || coincidence.running();
  }

  private double part(String percentage) {
    return Math.max(0, Math.min(1, access.number(percentage, PERCENT) / PERCENT));
  }

  private boolean isPointToPoint() {
    return motions
        .interpolator()
        .current()
        .map(motion -> motion instanceof PointToPoint || motion instanceof AxisSpline)
        .orElse(true);
  }

  /** Returns the limits of T1 for TCP and flange, and on a path for the axes. */
  SpeedLimit limit() {
    if (!slow()) {
      return SpeedLimit.NONE;
    }
    double limit = access.number("$SPEED_LIMIT_TEACH_MODE", Double.POSITIVE_INFINITY);
    if (isPointToPoint()) {
      return new SpeedLimit(limit, SpeedLimit.NONE.axes());
    }
    return new SpeedLimit(
        Math.min(limit, access.number("$VEL_CP_T1", limit)), access.axes("$VEL_CPT1_MA", PERCENT));
  }
}
