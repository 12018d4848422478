package no.hials.crosscom.protocol;

import no.hials.crosscom.protocol.internal.Ranges;

/**
 * The three bytes that end an answer.
 *
 * @param code u16; on KUKAVARPROXY the length of the flag, always 1; elsewhere an error code
 * @param flag u8; not 0 for success. Only this byte tells success from failure
 *     (docs/reference/wire-format.md#answers)
 */
public record Tail(int code, int flag) {
  /** {@code 00 01 01}: success. */
  public static final Tail SUCCESS = new Tail(1, 1);

  /** {@code 00 01 00}: a failure, as KUKAVARPROXY sends it. */
  public static final Tail FAILURE = new Tail(1, 0);

  /** {@code 00 00 00}: a failure, as other servers send it. */
  public static final Tail FAILURE_ZERO = new Tail(0, 0);

  /** The length of a tail in bytes. */
  public static final int LENGTH = 3;

  /** Checks the ranges. */
  public Tail {
    Ranges.u16("tail code", code);
    Ranges.u8("tail flag", flag);
  }

  /**
   * Returns whether the access succeeded.
   *
   * @return true for success
   */
  public boolean success() {
    return flag != 0;
  }
}
