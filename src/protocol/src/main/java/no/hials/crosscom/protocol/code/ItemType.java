package no.hials.crosscom.protocol.code;

/**
 * The kinds of items in the file tree: a code for one item, flags for a request that asks for
 * several kinds.
 */
public enum ItemType implements WireCode {
  /** Unknown, or not asked for. */
  UNKNOWN(0),
  /** A directory. */
  DIRECTORY(1),
  /** A virtual directory. */
  VIRTUAL_DIRECTORY(2),
  /** An archive. */
  ARCHIVE(4),
  /** A binary file. */
  BINARY(8),
  /** A text file. */
  TEXT(16),
  /** A module. */
  MODULE(32),
  /** A raw file. */
  RAW(64),
  /** A motion file. */
  MOTION_FILE(128),
  /** A protected container. */
  PROTECTED_CONTAINER(256);

  private final int code;

  ItemType(int code) {
    this.code = code;
  }

  @Override
  public int code() {
    return code;
  }
}
