package no.hials.crosscom.protocol.code;

import java.util.Optional;

/**
 * The motions that a position can be the target of. The numbers are those of the server's header,
 * by which it runs (c3-bridge.md, note a).
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

  /**
   * Finds a constant by its number.
   *
   * @param code any number
   * @return the constant, or nothing if the number is unknown
   */
  public static Optional<MotionType> from(int code) {
    return WireCode.find(MotionType.class, code);
  }
}
