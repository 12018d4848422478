package no.hials.crosscom.protocol.code;

/** The kinds of build of a server. */
public enum BuildType implements WireCode {
  /** Open source. */
  OPEN_SOURCE(0),
  /** Proprietary. */
  PROPRIETARY(1),
  /** Freeware. */
  FREEWARE(2),
  /** Internal. */
  INTERNAL(3);

  private final int code;

  BuildType(int code) {
    this.code = code;
  }

  @Override
  public int code() {
    return code;
  }
}
