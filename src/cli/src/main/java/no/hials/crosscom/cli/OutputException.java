package no.hials.crosscom.cli;

import java.io.IOException;
import java.util.Locale;

/** Says that the data could not be written to stdout. */
final class OutputException extends RuntimeException {
  private static final long serialVersionUID = 1L;

  private final boolean brokenPipe;

  OutputException(IOException cause) {
    super("could not write the output: " + cause.getMessage(), cause);
    String message = String.valueOf(cause.getMessage()).toLowerCase(Locale.ROOT);
    // Java has no class for it; the word stands in the messages of Linux, macOS and Windows
    brokenPipe = message.contains("pipe");
  }

  boolean isBrokenPipe() {
    return brokenPipe;
  }
}
