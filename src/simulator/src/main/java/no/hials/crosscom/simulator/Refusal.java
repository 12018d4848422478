package no.hials.crosscom.simulator;

/** The reasons why the simulated controller refuses an access. They are not sent to clients. */
public enum Refusal {
  /** The variable does not exist, or the text is not a name. */
  UNKNOWN_VARIABLE,
  /** The structure does not have the component, or the variable is not a structure. */
  UNKNOWN_COMPONENT,
  /** The index is out of range or missing, or has too many dimensions. */
  BAD_INDEX,
  /** The variable has no value yet. */
  NOT_INITIALISED,
  /** Clients may not write the variable. */
  READ_ONLY,
  /** The written text is not a KRL value. */
  NO_VALUE,
  /** The value does not have the type of the variable. */
  WRONG_TYPE,
  /**
   * The value has the right type but does not fit: an unknown constant of an ENUM, a text longer
   * than its CHAR array, a number with more bits than the signal.
   */
  OUT_OF_RANGE,
  /** The array can only be accessed element by element. */
  WHOLE_ARRAY,
  /** The text of the written aggregate, or of the answer, is too long. */
  TOO_LONG
}
