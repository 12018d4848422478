package no.hials.crosscom.protocol.variable;

import no.hials.crosscom.protocol.ErrorCode;
import no.hials.crosscom.protocol.code.Code;
import no.hials.crosscom.protocol.internal.Ranges;

/**
 * The result of one access of several.
 *
 * @param code u8; {@link ErrorCode#SUCCESS}, or the reason of the failure
 * @param value WSTRING: u16 count of characters and UTF-16, little-endian. The value read, or read
 *     back after a write; after a failed write the value sent
 *     (docs/reference/c3-messages.md#several-variables-6-and-7)
 */
public record AccessResult(Code<ErrorCode> code, String value) {

  /** Checks the range. */
  public AccessResult {
    Ranges.u8("code", code.number());
  }

  /**
   * Returns whether the access succeeded.
   *
   * @return true for success
   */
  public boolean success() {
    return code.is(ErrorCode.SUCCESS);
  }
}
