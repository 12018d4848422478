package no.hials.crosscom.cell;

import java.io.IOException;

/** Thrown when the answer to a write has another value than the one sent. */
public final class OtherValueException extends IOException {
  private static final long serialVersionUID = 1L;

  OtherValueException(String message) {
    super(message);
  }
}
