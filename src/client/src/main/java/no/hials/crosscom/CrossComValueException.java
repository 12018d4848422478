package no.hials.crosscom;

import org.jspecify.annotations.Nullable;

/**
 * Thrown if a text is not a value of the variable's type, or cannot be sent. The connection can be
 * used, and the variable keeps the value it had.
 */
public final class CrossComValueException extends CrossComException {
  private static final long serialVersionUID = 1L;

  private final String variable;
  private final String text;

  CrossComValueException(String variable, String text, String what, @Nullable Throwable cause) {
    super(variable + ": " + what, cause, false);
    this.variable = variable;
    this.text = text;
  }

  /** Returns the variable's name. */
  public String getVariable() {
    return variable;
  }

  /** Returns the value's whole text, as the server sent it or as it would have been sent. */
  public String getText() {
    return text;
  }
}
