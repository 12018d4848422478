package no.hials.crosscom.simulator;

/** The directions of the jog keys. */
public enum JogCoordinates {
  /** The axes A1 to A6. */
  AXIS,

  /** X, Y and Z of {@code $BASE}; A, B and C turn the tool about Z, Y and X of it. */
  BASE,

  /** X, Y and Z of the tool; A, B and C turn it about its own Z, Y and X. */
  TOOL,

  /** X, Y and Z of {@code $WORLD}; A, B and C turn the tool about Z, Y and X of it. */
  WORLD
}
