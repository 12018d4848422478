package no.hials.crosscom.cell.feed;

import java.io.IOException;

/** Thrown when a write is not allowed. Nothing was sent. */
public final class RefusedWriteException extends IOException {
  private static final long serialVersionUID = 1L;

  RefusedWriteException(String message) {
    super(message);
  }
}
