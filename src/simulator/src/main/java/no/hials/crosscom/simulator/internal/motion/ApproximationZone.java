package no.hials.crosscom.simulator.internal.motion;

/**
 * Says where a motion may leave its path for the next one ({@code $APO},
 * docs/reference/system-variables.md#override-and-speed).
 *
 * <p>A blend is the sum of the end of one motion, slowing down, and of the beginning of the next,
 * speeding up; it needs no longer than either takes for that, so at most half of the shorter one.
 */
public sealed interface ApproximationZone {
  /** Ends exactly on the target, standing. */
  record Exact() implements ApproximationZone {}

  /**
   * Leaves when no axis has further to go than a part of {@code $APO_DIS_PTP} (KRL's C_PTP).
   *
   * @param percent the part, {@code $APO.CPTP}, 0 to 100 %
   */
  record AxisDistance(double percent) implements ApproximationZone {
    /** Refuses a percentage outside of its range. */
    public AxisDistance {
      requirePercentage("C_PTP", percent);
    }
  }

  /**
   * Leaves within a distance of the target (KRL's C_DIS).
   *
   * @param mm the distance, {@code $APO.CDIS}
   */
  record Distance(double mm) implements ApproximationZone {
    /** Refuses a negative distance. */
    public Distance {
      requireNotNegative("C_DIS", mm);
    }
  }

  /**
   * Leaves when the speed has fallen to a part of the programmed one (KRL's C_VEL).
   *
   * @param percent the part, {@code $APO.CVEL}, 0 to 100 %
   */
  record Speed(double percent) implements ApproximationZone {
    /** Refuses a percentage outside of its range. */
    public Speed {
      requirePercentage("C_VEL", percent);
    }
  }

  /**
   * Leaves when the orientation is within an angle of the target's (KRL's C_ORI).
   *
   * @param degrees the angle, {@code $APO.CORI}
   */
  record Orientation(double degrees) implements ApproximationZone {
    /** Refuses a negative angle. */
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
