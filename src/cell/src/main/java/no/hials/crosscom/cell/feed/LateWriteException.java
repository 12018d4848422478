package no.hials.crosscom.cell.feed;

/** Thrown when a write waited too long for the connection to the robot. Nothing was sent. */
public final class LateWriteException extends RefusedWriteException {
  private static final long serialVersionUID = 1L;

  LateWriteException(String message) {
    super(message);
  }
}
