package no.hials.crosscom.cli;

import java.io.IOException;

/** Says that a file that was named in the arguments cannot be used. */
final class FileException extends IOException {
  private static final long serialVersionUID = 1L;

  FileException(String message, Throwable cause) {
    super(message, cause);
  }
}
