package no.hials.crosscom.cell.recording;

import java.io.IOException;
import java.nio.file.NoSuchFileException;
import java.util.Locale;
import no.hials.crosscom.cell.FileException;
import org.jspecify.annotations.Nullable;

/** Thrown when data cannot be written to stdout or a file. */
public final class OutputException extends RuntimeException {
  private static final long serialVersionUID = 1L;

  private final boolean brokenPipe;

  /** Creates the exception for stdout. */
  public OutputException(IOException cause) {
    this("the output", cause);
  }

  /**
   * Creates the exception for a file.
   *
   * @param to the name of the output
   */
  public OutputException(String to, IOException cause) {
    super("could not write " + to + ": " + reason(cause), cause);
    String message = String.valueOf(cause.getMessage()).toLowerCase(Locale.ROOT);
    // Java has no exception class for a broken pipe; the messages of Linux, macOS and Windows
    // contain the word
    brokenPipe = message.contains("pipe");
  }

  private static String reason(IOException cause) {
    // the file to be created does not exist in any case
    return cause instanceof NoSuchFileException
        ? "no such folder, or it does not take this file"
        : FileException.reason(cause);
  }

  private OutputException(String message, boolean brokenPipe, @Nullable Throwable cause) {
    super(message, cause);
    this.brokenPipe = brokenPipe;
  }

  /**
   * Returns this failure of an output that reports a change of the controller. It is not a broken
   * pipe: the user must know of the change.
   *
   * @param change the change as it would have been printed
   */
  public OutputException after(String change) {
    return new OutputException("done: " + change + "; " + getMessage(), false, getCause());
  }

  /**
   * Returns this failure with the place of the command.
   *
   * @param place the text before the message, such as {@code FILE:3: }
   */
  public OutputException at(String place) {
    return new OutputException(place + getMessage(), brokenPipe, getCause());
  }

  /** Returns whether the reader of the output has closed it, which is not an error to report. */
  public boolean isBrokenPipe() {
    return brokenPipe;
  }
}
