package no.hials.crosscom.protocol.code;

/** Flags for the attributes of a file or directory. */
public enum FileAttribute implements WireCode {
  /** Read only. */
  READ_ONLY(1),
  /** Hidden. */
  HIDDEN(2),
  /** System. */
  SYSTEM(4),
  /** Directory. */
  DIRECTORY(16),
  /** Archive. */
  ARCHIVE(32),
  /** Encrypted. */
  ENCRYPTED(16384),
  /** Signed. */
  SIGNED(268435456);

  private final int code;

  FileAttribute(int code) {
    this.code = code;
  }

  @Override
  public int code() {
    return code;
  }
}
