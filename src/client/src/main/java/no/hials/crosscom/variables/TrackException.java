package no.hials.crosscom.variables;

/**
 * Thrown by programs of version 0.1 of the original.
 *
 * @deprecated kept for these programs; nothing here throws it
 */
@Deprecated
public class TrackException extends RuntimeException {
  private static final long serialVersionUID = 1L;

  /**
   * Creates an exception.
   *
   * @param message the message
   */
  public TrackException(String message) {
    super(message);
  }
}
