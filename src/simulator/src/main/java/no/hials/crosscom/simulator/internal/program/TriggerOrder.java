package no.hials.crosscom.simulator.internal.program;

import no.hials.crosscom.simulator.KrlExecutionException;

/**
 * A {@code TRIGGER} with its values. The controller gives it back to {@link KrlInterpreter#fire}
 * when the robot comes by.
 */
public final class TriggerOrder {
  /** Assumed: the first of those that the system keeps for triggers. */
  private static final int AUTOMATIC = 40;

  private final boolean onPath;
  private final double distance;
  private final double delayMillis;
  private final Interruption interruption;

  TriggerOrder(boolean onPath, double distance, double delayMillis, Interruption interruption)
      throws KrlExecutionException {
    if (!onPath && distance != 0 && distance != 1) {
      throw new KrlExecutionException(
          KrlExecutionException.OUT_OF_RANGE, "DISTANCE is 0 (start) or 1 (end), is " + distance);
    }
    this.interruption = interruption;
    this.onPath = onPath;
    this.distance = distance;
    this.delayMillis = delayMillis;
  }

  /**
   * Gives the priority of a trigger's action. An assignment and a pulse end at once and come before
   * all else; a subprogram has that of an interrupt, which PRIO=-1 leaves to the controller.
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

  Interruption interruption() {
    return interruption;
  }

  /**
   * Says what the distance means.
   *
   * @return true for {@code PATH}: mm from the end of the motion; false for {@code DISTANCE}
   */
  public boolean onPath() {
    return onPath;
  }

  /**
   * Gives the place.
   *
   * @return 0 for the start and 1 for the end of the motion; with {@code PATH} mm from the end,
   *     negative for a place ahead of it
   */
  public double distance() {
    return distance;
  }

  /**
   * Gives the shift in time.
   *
   * @return ms, negative for earlier
   */
  public double delayMillis() {
    return delayMillis;
  }
}
