package no.hials.crosscom.simulator.internal.core;

import no.hials.crosscom.protocol.code.OperatingMode;
import no.hials.crosscom.protocol.value.Axis;
import no.hials.crosscom.simulator.internal.core.MotionSpeeds.Purpose;
import no.hials.crosscom.simulator.internal.motion.MotionCommand.AxisSpline;
import no.hials.crosscom.simulator.internal.motion.MotionCommand.PointToPoint;
import no.hials.crosscom.simulator.internal.motion.SpeedLimit;

/**
 * Reduces the programmed speed: by the override, and in T1 by its limits
 * (docs/reference/simulated-controller.md#reduced-speeds).
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
    motions.resolver().speeds().purpose(this::purpose);
  }

  private Purpose purpose() {
    if (manual.jogging()) {
      return Purpose.JOG;
    }
    return slow() ? Purpose.REDUCED : Purpose.PROGRAM;
  }

  /** Returns the part of the planned speed, 0 to 1. */
  double override() {
    return manual.jogging() ? manual.override(part("$OV_JOG")) : part("$OV_PRO");
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

  /**
   * Returns the limits of T1, also in T2 while a jog key is pressed: of TCP and flange, and of the
   * axes for motions that were planned in another mode and for bends of a path.
   */
  SpeedLimit limit() {
    boolean jogging = manual.jogging();
    if (!jogging && !slow()) {
      return SpeedLimit.NONE;
    }
    MotionSpeeds speeds = motions.resolver().speeds();
    if (isPointToPoint()) {
      double share = jogging ? PERCENT : speeds.teachShare() * PERCENT;
      return new SpeedLimit(teachLimit(), new Axis(share, share, share, share, share, share));
    }
    return new SpeedLimit(speeds.teachSpeed(), access.axes("$VEL_CPT1_MA", PERCENT));
  }

  private double teachLimit() {
    return access.number("$SPEED_LIMIT_TEACH_MODE", Double.POSITIVE_INFINITY);
  }
}
