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
   * Makes one.
   *
   * @param to what could not be written
   */
  public OutputException(String to, IOException cause) {
    super("could not write " + to + ": " + FileException.reason(cause), cause);
    String message = String.valueOf(cause.getMessage()).toLowerCase(Locale.ROOT);
    // Java has no class for it; the word stands in the messages of Linux, macOS and Windows
    brokenPipe = message.contains("pipe");
  }

  public boolean isBrokenPipe() {
    return brokenPipe;
  }
}
