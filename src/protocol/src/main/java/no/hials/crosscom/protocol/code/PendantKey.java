package no.hials.crosscom.protocol.code;

/** The keys of the teach pendant that a client can press (type 12). */
public enum PendantKey implements WireCode {
  /** Starts the program, forward or backward. */
  START(1),
  /** Stops the program. */
  STOP(2),
  /** Moves one axis. */
  JOG(3),
  /** The 6D mouse. */
  MOUSE(4);

  private final int code;

  PendantKey(int code) {
    this.code = code;
  }

  @Override
  public int code() {
    return code;
  }
}
