package no.hials.crosscom.cli.shell;

import java.io.IOException;

/** Thrown when a line is not in the shell language. */
final class ShellSyntaxException extends IOException {
  private static final long serialVersionUID = 1L;

  ShellSyntaxException(String message) {
    super(message);
  }
}
