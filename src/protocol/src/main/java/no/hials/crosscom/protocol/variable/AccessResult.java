package no.hials.crosscom.protocol.variable;

import no.hials.crosscom.protocol.ErrorCode;
import no.hials.crosscom.protocol.code.Code;
import no.hials.crosscom.protocol.internal.Ranges;

/**
 * What came of one access of several.
 *
 * @param code u8; {@link ErrorCode#SUCCESS} if it succeeded, else why not
 * @param value WSTRING: u16 count of characters and UTF-16, little-endian. What was read, or read
 *     back after writing; after a failed write what was sent (c3-bridge.md, "Common to all
 *     messages")
 */
public record AccessResult(Code<ErrorCode> code, String value) {

  /** Checks the range. */
  public AccessResult {
    Ranges.u8("code", code.number());
  }

  /**
   * Says how the access ended.
   *
   * @return true for success
   */
  public boolean success() {
    return code.is(ErrorCode.SUCCESS);
  }
}
