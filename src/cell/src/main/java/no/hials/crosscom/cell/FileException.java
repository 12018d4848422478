package no.hials.crosscom.cell;

import java.io.IOException;
import java.nio.file.FileSystemException;
import java.nio.file.Path;
import java.util.List;

/** Thrown when a file named in the arguments or the environment cannot be used. */
public final class FileException extends IOException {
  private static final long serialVersionUID = 1L;

  private final transient List<String> details;

  public FileException(String message) {
    super(message);
    details = List.of();
  }

  public FileException(String message, Throwable cause) {
    this(message, List.of(), cause);
  }

  /**
   * Creates an exception with a list of errors.
   *
   * @param details the errors in the file
   */
  public FileException(String message, List<String> details, Throwable cause) {
    super(message, cause);
    this.details = List.copyOf(details);
  }

  /** Returns the errors in the file, each for a line of its own after the message. */
  public List<String> details() {
    return details;
  }

  /**
   * Creates an exception about an operation on a file.
   *
   * @param verb the operation, such as {@code read} in {@code cannot read}
   */
  public static FileException cannot(String verb, Path file, IOException cause) {
    return new FileException("cannot " + verb + " " + file + ": " + reason(cause), cause);
  }

  /** Returns the reason; the message of most such exceptions is only the file name. */
  public static String reason(IOException e) {
    return switch (e.getClass().getSimpleName()) {
      case "NoSuchFileException" -> "file not found";
      case "FileAlreadyExistsException" -> "the file already exists";
      case "AccessDeniedException" -> "access is denied";
      case "MalformedInputException" -> "it is not in UTF-8";
      default ->
          e instanceof FileSystemException file && file.getReason() != null
              ? file.getReason()
              : String.valueOf(e.getMessage());
    };
  }
}
