package no.hials.crosscom.simulator;

/** How strictly files are loaded. */
public enum LoadingMode {
  /**
   * A line that is not understood is a warning, and the rest of the file is loaded: for files as
   * they come from a controller.
   */
  LENIENT,
  /** A file with an error is refused, and nothing changes. */
  STRICT
}
