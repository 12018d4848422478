package no.hials.crosscom.protocol.code;

/**
 * The motions to a position. The numbers are those of the server's header, by which it runs, and
 * not of its description (docs/reference/c3-messages.md#motion-11).
 */
public enum MotionType implements WireCode {
  /** Point to point, to an absolute position. */
  PTP(1),
  /** In a straight line, to an absolute position. */
  LIN(2),
  /** Point to point, relative to the actual position. */
  PTP_REL(3),
  /** In a straight line, relative to the actual position. */
  LIN_REL(4);

  private final int code;

  MotionType(int code) {
    this.code = code;
  }

  @Override
  public int code() {
    return code;
  }
}
