package no.hials.crosscom.protocol.code;

/** Flags for listing a directory; only their names and numbers are known. */
public enum ListFlag implements WireCode {
  /** Recursive. */
  RECURSIVE(1),
  /** Expand. */
  EXPAND(2),
  /** Long: adds an info to each item. */
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
}
