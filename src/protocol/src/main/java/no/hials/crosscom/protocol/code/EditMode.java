package no.hials.crosscom.protocol.code;

import java.util.Optional;

/** How a file may be edited on the controller (c3-bridge.md, "edit modes"). */
public enum EditMode implements WireCode {
  /** Unknown, such as that of a directory in c3-vectors.tsv. */
  UNKNOWN(-1),
  /** Full. */
  FULL(0),
  /** DatKor. */
  DAT_KOR(1),
  /** ProKor. */
  PRO_KOR(2),
  /** Read only. */
  READ_ONLY(3);

  private final int code;

  EditMode(int code) {
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
  public static Optional<EditMode> from(int code) {
    return WireCode.find(EditMode.class, code);
  }
}
