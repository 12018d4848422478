package no.hials.crosscom.web.internal.jog;

/**
 * A button that a person holds.
 *
 * @param id the number of the hold, larger than those before it
 * @param direction the direction, 0 to 5: X, Y, Z, A, B, C or A1 to A6
 * @param positive whether the robot moves in the positive direction
 * @param speed the part of the full speed, more than 0 and at most 1
 * @param step the distance after which the robot stops, mm or degrees; 0 for no limit
 */
record Press(long id, int direction, boolean positive, double speed, double step) {
  /** Returns a deflection in the direction of this press. */
  double signed(double deflection) {
    return positive ? deflection : -deflection;
  }
}
