package no.hials.crosscom.lang;

/**
 * An error in a file.
 *
 * @param position where the error is
 * @param message the rule that broke, or what was expected and found
 */
public record KrlError(Position position, String message) {
  @Override
  public String toString() {
    return position + ": " + message;
  }
}
