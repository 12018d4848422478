package no.hials.crosscom.protocol.code;

import java.util.Optional;

/**
 * How a directory is listed (c3-bridge.md, "list flags", which has names and numbers only). Flags.
 */
public enum ListFlag implements WireCode {
  /** Recursive. */
  RECURSIVE(1),
  /** Expand. */
  EXPAND(2),
  /** Long: items have an info. */
  LONG(4),
  /** Long, in the old form. */
  OLD_LONG(8),
  /** No PFC, protected containers. */
  NO_PFC(16),
  /** PFC as file. */
  PFC_AS_FILE(32),
  /** ZIP as file. */
  ZIP_AS_FILE(64);

  private final int code;

  ListFlag(int code) {
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
  public static Optional<ListFlag> from(int code) {
    return WireCode.find(ListFlag.class, code);
  }
}
