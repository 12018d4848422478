package no.hials.crosscom.protocol.code;

import java.util.Optional;

/**
 * The parts of a KRL module (c3-bridge.md, "module parts"). Flags: {@link #SRC} and {@link #DAT}
 * together are what the reference calls SRCDAT.
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

  /**
   * Finds a constant by its number.
   *
   * @param code any number
   * @return the constant, or nothing if the number is unknown
   */
  public static Optional<ModulePart> from(int code) {
    return WireCode.find(ModulePart.class, code);
  }
}
