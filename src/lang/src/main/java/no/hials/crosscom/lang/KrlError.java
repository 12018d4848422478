package no.hials.crosscom.lang;

/**
 * One thing that is wrong in a file.
 *
 * @param position where
 * @param message what: the rule, what was expected and what was found
 */
public record KrlError(Position position, String message) {
  @Override
  public String toString() {
    return position + ": " + message;
  }
}
