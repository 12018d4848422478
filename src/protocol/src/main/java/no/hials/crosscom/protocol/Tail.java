package no.hials.crosscom.protocol;

import no.hials.crosscom.protocol.internal.Ranges;

/**
 * The three bytes that end an answer.
 *
 * @param code u16; on KUKAVARPROXY the length of the flag, always 1; elsewhere an error code
 * @param flag u8; not 0 for success. Only this byte says how the access ended (krl.md 1.8)
 */
public record Tail(int code, int flag) {
  /** {@code 00 01 01}: done. */
  public static final Tail SUCCESS = new Tail(1, 1);

  /** {@code 00 01 00}: refused, as KUKAVARPROXY says it. */
  public static final Tail FAILURE = new Tail(1, 0);

  /** {@code 00 00 00}: refused, as other servers say it. */
  public static final Tail FAILURE_ZERO = new Tail(0, 0);

  /** How many bytes a tail has. */
  public static final int LENGTH = 3;

  /** Checks the ranges. */
  public Tail {
    Ranges.u16("tail code", code);
    Ranges.u8("tail flag", flag);
  }

  /**
   * Says how the access ended.
   *
   * @return true for success
   */
  public boolean success() {
    return flag != 0;
  }
}
