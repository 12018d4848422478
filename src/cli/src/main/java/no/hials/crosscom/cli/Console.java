package no.hials.crosscom.cli;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.Writer;

/**
 * Where a command prints: data to one stream, messages to another. Both are flushed line by line,
 * so that their lines come in order where both end up on one terminal.
 */
final class Console {
  private static final String PROGRAM = "jopenshowvar";

  private final Writer data;
  private final PrintWriter out;
  private final PrintWriter err;

  Console(Writer out, Writer err) {
    this.data = out;
    this.out = new PrintWriter(out, true);
    this.err = new PrintWriter(err, true);
  }

  /** Gives stdout for texts of picocli. It swallows errors, so data goes through {@link #print}. */
  PrintWriter out() {
    return out;
  }

  PrintWriter err() {
    return err;
  }

  /**
   * Prints a line of data.
   *
   * @throws OutputException if it cannot be written, as into a pipe that nobody reads any more
   */
  void print(String line) {
    try {
      data.write(line + System.lineSeparator());
      data.flush();
    } catch (IOException e) {
      throw new OutputException(e);
    }
  }

  /** Prints a message behind the program's name. */
  void error(String message) {
    err.println(PROGRAM + ": " + message);
  }

  /** Prints what an exception says, and where it comes from if that is asked for. */
  void failure(Throwable e, boolean verbose) {
    error(String.valueOf(e.getMessage()));
    if (verbose) {
      e.printStackTrace(err);
    }
  }

  /** Prints a line that helps with the message before it. */
  void hint(String line) {
    err.println(line);
  }
}
