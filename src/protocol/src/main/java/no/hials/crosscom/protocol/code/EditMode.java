package no.hials.crosscom.protocol.code;

/** The ways in which a file may be edited on the controller. */
public enum EditMode implements WireCode {
  /** Unknown, as that of a directory. */
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
}
