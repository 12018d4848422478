package no.hials.crosscom.protocol.code;

/** The commands for a program (type 10). */
public enum ProgramCommand implements WireCode {
  /** Resets the selected program. */
  RESET(1),
  /** Runs the selected program. */
  START(2),
  /** Stops the running program. */
  STOP(3),
  /** Cancels the selection of the program. */
  CANCEL(4),
  /** Selects a program. */
  SELECT(5),
  /** Selects a program and runs it. */
  RUN(6);

  private final int code;

  ProgramCommand(int code) {
    this.code = code;
  }

  @Override
  public int code() {
    return code;
  }
}
