package no.hials.crosscom.cell.feed;

/** How far a value can be relied on. */
public enum Quality {
  /** The controller sent the value at the time of the update. */
  GOOD,
  /**
   * The controller does not answer now: the value, if there is one, is the last that it sent, at
   * the time of the update.
   */
  STALE,
  /** The controller refused to read the variable: there is no value. */
  BAD
}
