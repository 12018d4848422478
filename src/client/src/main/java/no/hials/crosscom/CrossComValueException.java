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
  private final boolean sent;

  /** Creates an exception for an answer of the server. */
  CrossComValueException(String variable, String text, String what, @Nullable Throwable cause) {
    this(variable, text, what, cause, true);
  }

  private CrossComValueException(
      String variable, String text, String what, @Nullable Throwable cause, boolean sent) {
    super(variable + ": " + what, cause, false);
    this.variable = variable;
    this.text = text;
    this.sent = sent;
  }

  /** Returns an exception for a value that was not sent. */
  static CrossComValueException notSent(
      String variable, String text, String what, @Nullable Throwable cause) {
    return new CrossComValueException(variable, text, what, cause, false);
  }

  /** Returns the variable's name. */
  public String getVariable() {
    return variable;
  }

  /**
   * Returns whether the request was sent.
   *
   * @return true if the text is the answer of the server; false if it is a value to be written,
   *     which the controller did not receive
   */
  public boolean isSent() {
    return sent;
  }

  /** Returns the value's whole text, as the server sent it or as it would have been sent. */
  public String getText() {
    return text;
  }
}
