package no.hials.crosscom.protocol.code;

/** Flags for the properties of a file that a request can ask for. */
public enum FileProperty implements WireCode {
  /** The type. */
  TYPE(1),
  /** The name. */
  NAME(2),
  /** The size. */
  SIZE(4),
  /** The attributes. */
  ATTRIBUTES(8),
  /** The time of creation. */
  CREATION(16),
  /** The time of the last access. */
  ACCESS(32),
  /** The time of the last change. */
  MODIFICATION(64),
  /** The edit mode. */
  EDIT_MODE(128);

  private final int code;

  FileProperty(int code) {
    this.code = code;
  }

  @Override
  public int code() {
    return code;
  }
}
