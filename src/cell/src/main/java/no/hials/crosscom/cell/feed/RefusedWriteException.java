package no.hials.crosscom.cell.feed;

import java.io.IOException;

/** Thrown when a write is not allowed, or not any more. Nothing was sent. */
public class RefusedWriteException extends IOException {
  private static final long serialVersionUID = 1L;

  RefusedWriteException(String message) {
    super(message);
  }
}
