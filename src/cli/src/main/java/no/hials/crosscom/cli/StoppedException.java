package no.hials.crosscom.cli;

/** Says that the user stopped a command before its end. */
final class StoppedException extends RuntimeException {
  private static final long serialVersionUID = 1L;

  StoppedException() {
    super("stopped");
  }
}
