package no.hials.crosscom.simulator.internal.motion;

/**
 * The part of a motion in which it can leave its path for the next one ({@code $APO}).
 *
 * <p>A blend is the sum of the end of one motion, slowing down, and of the start of the next,
 * speeding up. It lasts no longer than either ramp, so at most half of the shorter motion.
 */
public sealed interface ApproximationZone {
  /** Stops exactly at the target. */
  record Exact() implements ApproximationZone {}

  /**
   * Starts when no axis has further to go than a part of {@code $APO_DIS_PTP} (KRL's C_PTP).
   *
   * @param percent the part, {@code $APO.CPTP}, 0 to 100 %
   */
  record AxisDistance(double percent) implements ApproximationZone {
    public AxisDistance {
      requirePercentage("C_PTP", percent);
    }
  }

  /**
   * Starts within a distance of the target (KRL's C_DIS).
   *
   * @param mm the distance, {@code $APO.CDIS}
   */
  record Distance(double mm) implements ApproximationZone {
    public Distance {
      requireNotNegative("C_DIS", mm);
    }
  }

  /**
   * Starts when the speed has fallen to a part of the programmed speed (KRL's C_VEL).
   *
   * @param percent the part, {@code $APO.CVEL}, 0 to 100 %
   */
  record Speed(double percent) implements ApproximationZone {
    public Speed {
      requirePercentage("C_VEL", percent);
    }
  }

  /**
   * Starts when the orientation is within an angle of the target's (KRL's C_ORI).
   *
   * @param degrees the angle, {@code $APO.CORI}
   */
  record Orientation(double degrees) implements ApproximationZone {
    public Orientation {
      requireNotNegative("C_ORI", degrees);
    }
  }

  private static void requirePercentage(String what, double value) {
    if (!(value >= 0 && value <= 100)) {
      throw new IllegalArgumentException(what + " must be 0 to 100 %, is " + value);
    }
  }

  private static void requireNotNegative(String what, double value) {
    if (!(value >= 0)) {
      throw new IllegalArgumentException(what + " must be 0 or more, is " + value);
    }
  }
}
