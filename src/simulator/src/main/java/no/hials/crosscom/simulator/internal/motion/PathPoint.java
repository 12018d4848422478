package no.hials.crosscom.simulator.internal.motion;

/**
 * A place on the path of a motion.
 *
 * @param point the point from which it counts: 0 is the start of the motion, 1 the end of its first
 *     segment; {@link #LAST} is the end of the last one
 * @param mm the distance along the path, negative before the point
 */
public record PathPoint(int point, double mm) {
  /** The last point of a motion. */
  public static final int LAST = Integer.MAX_VALUE;
}
