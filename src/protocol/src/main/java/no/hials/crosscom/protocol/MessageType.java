package no.hials.crosscom.protocol;

import java.util.Collections;
import java.util.EnumSet;
import java.util.Optional;
import java.util.Set;
import java.util.function.Function;
import org.jspecify.annotations.Nullable;

/**
 * The types of message, by the function byte of a frame (kukavarproxy.md, "Frames"; c3-bridge.md,
 * "Messages").
 */
public enum MessageType {
  /** Reads a variable as text. */
  READ(0, new Version(1, 0, 0), ReadRequest.LAYOUT, ReadResponse.LAYOUT),
  /** Writes a variable as text. */
  WRITE(1, new Version(1, 0, 0), WriteRequest.LAYOUT, WriteResponse.LAYOUT),
  /** Reads an array of 16-bit numbers. */
  READ_ARRAY(2, null, ReadArrayRequest.LAYOUT, ReadArrayResponse.LAYOUT),
  /** Writes an array of 16-bit numbers. */
  WRITE_ARRAY(3, null, WriteArrayRequest.LAYOUT, WriteArrayResponse.LAYOUT),
  /** Reads a variable as text in UTF-16. */
  READ_UTF16(4, new Version(1, 0, 0), t -> ReadUtf16Request.LAYOUT, TextResponse::layout),
  /** Writes a variable as text in UTF-16. */
  WRITE_UTF16(5, new Version(1, 0, 0), t -> WriteUtf16Request.LAYOUT, TextResponse::layout),
  /** Reads several variables. Servers before 1.2 have it with mistakes. */
  READ_MULTIPLE(6, new Version(1, 2, 0), t -> ReadMultipleRequest.LAYOUT, MultipleResponse::layout),
  /** Writes several variables. Servers before 1.3 have it with mistakes. */
  WRITE_MULTIPLE(
      7, new Version(1, 3, 0), t -> WriteMultipleRequest.LAYOUT, MultipleResponse::layout),
  /** Selects, starts and stops programs. Has two layouts, by the command. */
  PROGRAM_CONTROL(
      10, new Version(1, 0, 0), t -> ProgramLayout.REQUEST, t -> ProgramControlResponse.LAYOUT),
  /** Moves the robot. */
  MOTION(11, new Version(1, 0, 0), t -> MotionRequest.LAYOUT, t -> MotionResponse.LAYOUT),
  /** Presses and releases keys of the pendant. */
  PENDANT_KEY(
      12, new Version(1, 0, 0), t -> PendantKeyRequest.LAYOUT, t -> PendantKeyResponse.LAYOUT),
  /** Asks for the server's version, clock and host. */
  INFORMATION(13, new Version(1, 0, 0), PlainRequest::layout, t -> InformationResponse.LAYOUT),
  /** Asks for the types of message that the server knows. */
  FEATURES(14, new Version(1, 0, 0), PlainRequest::layout, t -> FeaturesResponse.LAYOUT),
  /** Measures the time of accesses to variables. Has two layouts, for reading and writing. */
  BENCHMARK(17, new Version(1, 2, 0), t -> BenchmarkLayout.REQUEST, t -> BenchmarkResponse.LAYOUT),
  /** Sets a file's attributes. */
  SET_ATTRIBUTES(20, new Version(1, 1, 2), t -> SetAttributesRequest.LAYOUT, PlainResponse::layout),
  /** Lists a directory. */
  LIST_DIRECTORY(
      21,
      new Version(1, 1, 2),
      t -> ListDirectoryRequest.LAYOUT,
      t -> ListDirectoryResponse.LAYOUT),
  /** Creates a file or a directory. */
  CREATE_FILE(22, new Version(1, 1, 2), t -> CreateFileRequest.LAYOUT, PlainResponse::layout),
  /** Deletes a file. */
  DELETE_FILE(23, new Version(1, 1, 2), t -> DeleteFileRequest.LAYOUT, PlainResponse::layout),
  /** Copies a file. */
  COPY_FILE(24, new Version(1, 1, 2), CopyFileRequest::layout, PlainResponse::layout),
  /** Moves a file. */
  MOVE_FILE(25, new Version(1, 1, 2), CopyFileRequest::layout, PlainResponse::layout),
  /** Asks for a file's properties. */
  FILE_PROPERTIES(
      26,
      new Version(1, 1, 2),
      t -> FilePropertiesRequest.LAYOUT,
      t -> FilePropertiesResponse.LAYOUT),
  /** Asks for the full name of a file, such as {@code KRC:\R1\PROGRAM\TEST.SRC}. */
  FULL_NAME(27, new Version(1, 1, 2), FileNameRequest::layout, TextResponse::layout),
  /** Asks for the KRC name of a file, such as {@code /R1/TEST.SRC}. */
  KRC_NAME(28, new Version(1, 1, 2), FileNameRequest::layout, TextResponse::layout),
  /** Writes a file's content. Has a layout for each operation; correct for large files from 1.4. */
  WRITE_CONTENT(29, new Version(1, 1, 2), ContentLayout::request, ContentLayout::response),
  /** Reads a file's content. Has a layout for each operation; correct for large files from 1.4. */
  READ_CONTENT(30, new Version(1, 1, 2), ContentLayout::request, ContentLayout::response),
  /** Confirms all messages of the controller. */
  CONFIRM_ALL(63, new Version(1, 0, 0), PlainRequest::layout, PlainResponse::layout);

  private static final @Nullable MessageType[] BY_CODE = byCode();

  private final int code;
  private final boolean legacy;

  @SuppressWarnings("ImmutableEnumChecker") // a record of numbers
  private final @Nullable Version since;

  @SuppressWarnings("ImmutableEnumChecker") // a record of two lambdas that hold nothing
  private final Layout<? extends Request> request;

  @SuppressWarnings("ImmutableEnumChecker") // likewise
  private final Layout<? extends TypedResponse> response;

  /** Makes a type that KUKAVARPROXY knows. */
  MessageType(
      int code,
      @Nullable Version since,
      Layout<? extends Request> request,
      Layout<? extends TypedResponse> response) {
    this.code = code;
    this.legacy = true;
    this.since = since;
    this.request = request;
    this.response = response;
  }

  /** Makes a type that only C3 Bridge knows; one layout may be that of several types. */
  MessageType(
      int code,
      Version since,
      Function<MessageType, Layout<? extends Request>> request,
      Function<MessageType, Layout<? extends TypedResponse>> response) {
    this.code = code;
    this.legacy = false;
    this.since = since;
    this.request = request.apply(this);
    this.response = Layout.orNothing(this, response.apply(this));
  }

  private static @Nullable MessageType[] byCode() {
    @Nullable MessageType[] types = new @Nullable MessageType[0x100];
    for (MessageType type : values()) {
      types[type.code] = type;
    }
    return types;
  }

  /**
   * Gives the function byte.
   *
   * @return 0 to 255
   */
  public int code() {
    return code;
  }

  /**
   * Says which servers know the type, in their newest version.
   *
   * @return the servers, unmodifiable
   */
  public Set<ServerType> servers() {
    EnumSet<ServerType> servers = EnumSet.allOf(ServerType.class);
    servers.removeIf(server -> !isKnownTo(server));
    return Collections.unmodifiableSet(servers);
  }

  /**
   * Says whether a server knows the type, in its newest version.
   *
   * @param server any
   * @return true if so
   */
  public boolean isKnownTo(ServerType server) {
    return server == ServerType.KUKAVARPROXY ? legacy : since != null;
  }

  /**
   * Gives the first version of C3 Bridge that has the type and has it right (c3-bridge.md, "Minimum
   * server versions").
   *
   * @return the version, or nothing if no version knows the type
   */
  public Optional<Version> since() {
    return Optional.ofNullable(since);
  }

  /**
   * Finds a type by its function byte.
   *
   * @param code any number
   * @return the type, or nothing if this codec has none of that number
   */
  public static Optional<MessageType> from(int code) {
    return Optional.ofNullable(find(code));
  }

  /** As {@link #from}, without an object. */
  static @Nullable MessageType find(int code) {
    return code < 0 || code >= BY_CODE.length ? null : BY_CODE[code];
  }

  Layout<? extends Request> request() {
    return request;
  }

  Layout<? extends TypedResponse> response() {
    return response;
  }
}
