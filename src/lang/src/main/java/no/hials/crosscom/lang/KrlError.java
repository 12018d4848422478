package no.hials.crosscom.lang;

/**
 * An error in a file.
 *
 * @param position where the error is
 * @param message the rule that broke, or what was expected and found
 * @param common whether files that run on real controllers have it, and nothing of the file is lost
 *     (docs/reference/krl-language.md#files)
 */
public record KrlError(Position position, String message, boolean common) {
  /** Creates an error that no controller is known to accept. */
  public KrlError(Position position, String message) {
    this(position, message, false);
  }

  @Override
  public String toString() {
    return position + ": " + message;
  }
}
