package no.hials.crosscom.simulator;

/** Why the simulated controller refused an access. On the wire a client sees none of this. */
public enum Refusal {
  /** There is no variable of that name, or the text is not a name. */
  UNKNOWN_VARIABLE,
  /** The structure has no component of that name, or the variable is no structure. */
  UNKNOWN_COMPONENT,
  /** The index is out of range, missing, or there is one too many. */
  BAD_INDEX,
  /** The variable has no value yet. */
  NOT_INITIALISED,
  /** Clients may not write the variable. */
  READ_ONLY,
  /** The text to be written is no KRL value at all. */
  NO_VALUE,
  /** The value is of another type than the variable. */
  WRONG_TYPE,
  /**
   * The value is of the right type but does not fit: an ENUM constant that the type has not, a text
   * longer than its CHAR array, a number with more bits than the signal.
   */
  OUT_OF_RANGE,
  /** The array can only be accessed element by element. */
  WHOLE_ARRAY,
  /** The text of the aggregate to be written, or of the answer, is too long. */
  TOO_LONG
}
