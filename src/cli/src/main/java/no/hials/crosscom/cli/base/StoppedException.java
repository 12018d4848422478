package no.hials.crosscom.cli.base;

/** Thrown when the user stops a command before its end. */
public final class StoppedException extends RuntimeException {
  private static final long serialVersionUID = 1L;

  public StoppedException() {
    super("stopped");
  }
}
