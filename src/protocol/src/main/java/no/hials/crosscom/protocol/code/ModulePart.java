package no.hials.crosscom.protocol.code;

/**
 * Flags for the parts of a KRL module. C3 Bridge calls {@link #SRC} and {@link #DAT} together
 * SRCDAT.
 */
public enum ModulePart implements WireCode {
  /** The SUB file. */
  SUB(1),
  /** The SRC file. */
  SRC(2),
  /** The DAT file. */
  DAT(4),
  /** A template. */
  TEMPLATE(8),
  /** A motion. */
  MOTION(16);

  private final int code;

  ModulePart(int code) {
    this.code = code;
  }

  @Override
  public int code() {
    return code;
  }
}
