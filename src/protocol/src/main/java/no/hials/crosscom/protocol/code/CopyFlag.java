package no.hials.crosscom.protocol.code;

import java.util.Optional;

/**
 * How files are copied, moved and written (c3-bridge.md, "copy flags", which has names and numbers
 * only). Flags; {@link #MODIFY} has the bit of {@link #ARCHIVE} in it, {@link #UPDATE} that of
 * {@link #REFRESH}.
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

  /**
   * Finds a constant by its number.
   *
   * @param code any number
   * @return the constant, or nothing if the number is unknown
   */
  public static Optional<CopyFlag> from(int code) {
    return WireCode.find(CopyFlag.class, code);
  }
}
