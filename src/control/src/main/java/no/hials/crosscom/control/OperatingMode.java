package no.hials.crosscom.control;

/** The operating modes of a controller, the values of {@code $MODE_OP}. */
public enum OperatingMode {
  /** Manual, slow; a person holds the enabling switch. */
  T1,
  /** Manual, at programmed speed; a person holds the enabling switch. */
  T2,
  /** Automatic: nobody holds a switch. */
  AUT,
  /** Automatic, started by a higher-level controller ({@code #EX}): nobody holds a switch. */
  EX
}
