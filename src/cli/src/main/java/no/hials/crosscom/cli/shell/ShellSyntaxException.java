package no.hials.crosscom.cli.shell;

import java.io.IOException;

/** Says that a line is none of the shell language. */
final class ShellSyntaxException extends IOException {
  private static final long serialVersionUID = 1L;

  ShellSyntaxException(String message) {
    super(message);
  }
}
