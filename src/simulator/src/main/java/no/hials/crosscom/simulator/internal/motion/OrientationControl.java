package no.hials.crosscom.simulator.internal.motion;

/** The orientation on the path of a LIN or CIRC ({@code $ORI_TYPE}). */
public enum OrientationControl {
  /** Turns about one axis to the orientation of the target, at a rate that matches the path. */
  VAR,
  /** Keeps the orientation of the start. */
  CONSTANT,
  /**
   * Turns A4 to A6 evenly, each from its angle at the start to that at the target; the others keep
   * the TCP on the path. There is no wrist singularity.
   */
  JOINT,
  /** The orientation of the point does not count. Only in a spline block. */
  IGNORE
}
