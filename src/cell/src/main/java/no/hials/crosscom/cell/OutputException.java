package no.hials.crosscom.cell;

import java.io.IOException;
import java.util.Locale;

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
    super("could not write " + to + ": " + FileException.reason(cause), cause);
    String message = String.valueOf(cause.getMessage()).toLowerCase(Locale.ROOT);
    // Java has no exception class for a broken pipe; the messages of Linux, macOS and Windows
    // contain the word
    brokenPipe = message.contains("pipe");
  }

  public boolean isBrokenPipe() {
    return brokenPipe;
  }
}
