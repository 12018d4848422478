package no.hials.crosscom.simulator.internal.program;

import no.hials.crosscom.simulator.KrlExecutionException;
import no.hials.crosscom.simulator.internal.motion.PathPoint;

/**
 * A {@code TRIGGER} with its values. The controller passes it to {@link KrlInterpreter#fire} when
 * the robot passes its point.
 *
 * @param onPath whether it is {@code PATH}: the distance is in mm from the end of the motion
 * @param distance 0 for the start and 1 for the end of the motion; with {@code PATH} in mm from a
 *     point, negative before it
 * @param delayMillis negative for earlier
 * @param interruption the action
 * @param point the point of the motion from which a distance with {@code PATH} counts
 */
public record TriggerOrder(
    boolean onPath, double distance, double delayMillis, Interruption interruption, int point) {
  /** Assumed: the first priority that the system keeps for triggers. */
  private static final int AUTOMATIC = 40;

  static TriggerOrder of(
      boolean onPath, double distance, double delayMillis, Interruption interruption, int point)
      throws KrlExecutionException {
    if (!onPath && distance != 0 && distance != 1) {
      throw new KrlExecutionException(
          KrlExecutionException.OUT_OF_RANGE, "DISTANCE is 0 (start) or 1 (end), is " + distance);
    }
    return new TriggerOrder(onPath, distance, delayMillis, interruption, point);
  }

  /** Returns the place on the path. */
  public PathPoint at() {
    if (onPath) {
      return new PathPoint(point, distance);
    }
    return new PathPoint(distance == 0 ? 0 : PathPoint.LAST, 0);
  }

  /**
   * Returns the priority of the action of a trigger. An assignment and a pulse end at once and
   * precede all else; a subprogram has the priority of an interrupt, which the controller chooses
   * for PRIO=-1.
   */
  static int priority(boolean calls, int given) throws KrlExecutionException {
    if (!calls) {
      return 0;
    }
    if (given == -1) {
      return AUTOMATIC;
    }
    Interrupts.checkPriority(given);
    return given;
  }
}
