package no.hials.crosscom.cell.feed;

/** The reliability of a value. */
public enum Quality {
  /** The controller sent the value at the time of the update. */
  GOOD,
  /**
   * The controller does not answer now. The value, if there is one, is the last one that it sent,
   * at the time of the update.
   */
  STALE,
  /** The controller refused to read the variable: there is no value. */
  BAD
}
