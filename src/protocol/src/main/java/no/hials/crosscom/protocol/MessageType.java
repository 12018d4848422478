package no.hials.crosscom.protocol;

import java.util.Optional;
import org.jspecify.annotations.Nullable;

/**
 * The types of message, by the function byte of a frame (docs/reference/wire-format.md,
 * docs/reference/c3-messages.md).
 */
public enum MessageType {
  /** Reads a variable as text. */
  READ(0, new Version(1, 0, 0)),
  /** Writes a variable as text. */
  WRITE(1, new Version(1, 0, 0)),
  /** Reads an array of 16-bit numbers. */
  READ_ARRAY(2, null),
  /** Writes an array of 16-bit numbers. */
  WRITE_ARRAY(3, null),
  /** Reads a variable as text in UTF-16. */
  READ_UTF16(4, new Version(1, 0, 0)),
  /** Writes a variable as text in UTF-16. */
  WRITE_UTF16(5, new Version(1, 0, 0)),
  /** Reads several variables. Has errors in servers before 1.2. */
  READ_MULTIPLE(6, new Version(1, 2, 0)),
  /** Writes several variables. Has errors in servers before 1.3. */
  WRITE_MULTIPLE(7, new Version(1, 3, 0)),
  /** Selects, starts and stops programs. Has two layouts, by the command. */
  PROGRAM_CONTROL(10, new Version(1, 0, 0)),
  /** Moves the robot. */
  MOTION(11, new Version(1, 0, 0)),
  /** Presses and releases keys of the pendant. */
  PENDANT_KEY(12, new Version(1, 0, 0)),
  /** Asks for the server's version, clock and host. */
  INFORMATION(13, new Version(1, 0, 0)),
  /** Asks which types of message the server supports. */
  FEATURES(14, new Version(1, 0, 0)),
  /** Measures the time of accesses to variables. Has two layouts, for reading and writing. */
  BENCHMARK(17, new Version(1, 2, 0)),
  /** Sets a file's attributes. */
  SET_ATTRIBUTES(20, new Version(1, 1, 2)),
  /** Lists a directory. */
  LIST_DIRECTORY(21, new Version(1, 1, 2)),
  /** Creates a file or a directory. */
  CREATE_FILE(22, new Version(1, 1, 2)),
  /** Deletes a file. */
  DELETE_FILE(23, new Version(1, 1, 2)),
  /** Copies a file. */
  COPY_FILE(24, new Version(1, 1, 2)),
  /** Moves a file. */
  MOVE_FILE(25, new Version(1, 1, 2)),
  /** Asks for a file's properties. */
  FILE_PROPERTIES(26, new Version(1, 1, 2)),
  /** Asks for the full name of a file, such as {@code KRC:\R1\PROGRAM\TEST.SRC}. */
  FULL_NAME(27, new Version(1, 1, 2)),
  /** Asks for the KRC name of a file, such as {@code /R1/TEST.SRC}. */
  KRC_NAME(28, new Version(1, 1, 2)),
  /** Writes a file's content. Has a layout for each operation; correct for large files from 1.4. */
  WRITE_CONTENT(29, new Version(1, 1, 2)),
  /** Reads a file's content. Has a layout for each operation; correct for large files from 1.4. */
  READ_CONTENT(30, new Version(1, 1, 2)),
  /** Confirms all messages of the controller. */
  CONFIRM_ALL(63, new Version(1, 0, 0));

  /** KUKAVARPROXY supports the types from 0 to this one. */
  private static final int LAST_OF_KUKAVARPROXY = 3;

  private static final @Nullable MessageType[] BY_CODE = byCode();

  private final int code;

  @SuppressWarnings("ImmutableEnumChecker") // a record of numbers
  private final @Nullable Version since;

  MessageType(int code, @Nullable Version since) {
    this.code = code;
    this.since = since;
  }

  private static @Nullable MessageType[] byCode() {
    @Nullable MessageType[] types = new @Nullable MessageType[0x100];
    for (MessageType type : values()) {
      types[type.code] = type;
    }
    return types;
  }

  /**
   * Returns the function byte.
   *
   * @return 0 to 255
   */
  public int code() {
    return code;
  }

  /**
   * Returns whether the newest version of a server supports the type.
   *
   * @param server any
   * @return true if so
   */
  public boolean isKnownTo(ServerType server) {
    return server == ServerType.KUKAVARPROXY ? code <= LAST_OF_KUKAVARPROXY : since != null;
  }

  /**
   * Returns the first version of C3 Bridge that supports the type without known errors
   * (docs/reference/c3-messages.md#server-versions).
   *
   * @return the version, or empty if no version supports the type
   */
  public Optional<Version> since() {
    return Optional.ofNullable(since);
  }

  /**
   * Returns the type with a function byte.
   *
   * @param code any number
   * @return the type, or empty if the number is unknown
   */
  public static Optional<MessageType> from(int code) {
    return Optional.ofNullable(find(code));
  }

  /** Works like {@link #from}, without creating an object. */
  static @Nullable MessageType find(int code) {
    return code < 0 || code >= BY_CODE.length ? null : BY_CODE[code];
  }
}
