package no.hials.crosscom.protocol.code;

/**
 * Flags for copying, moving and writing files; only their names and numbers are known. {@link
 * #MODIFY} includes the bit of {@link #ARCHIVE}, and {@link #UPDATE} the bit of {@link #REFRESH}.
 */
public enum CopyFlag implements WireCode {
  /** Archive. */
  ARCHIVE(1),
  /** Modify. */
  MODIFY(3),
  /** Continue. */
  CONTINUE(4),
  /** Recursive. */
  RECURSIVE(8),
  /** Refresh. */
  REFRESH(16),
  /** Update. */
  UPDATE(48),
  /** Overwrites existing files. */
  OVERWRITE(64),
  /** No directory entries. */
  NO_DIRECTORY_ENTRIES(128),
  /** Junk directory. */
  JUNK_DIRECTORY(256),
  /** Forces binary. */
  FORCE_BINARY(512),
  /** Forces text. */
  FORCE_TEXT(1024),
  /** No version check. */
  NO_VERSION_CHECK(2048),
  /** Overwrites read-only files. */
  OVERWRITE_READ_ONLY(4096),
  /** No KRL analysis. */
  NO_KRL_ANALYSIS(8192);

  private final int code;

  CopyFlag(int code) {
    this.code = code;
  }

  @Override
  public int code() {
    return code;
  }
}
