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
  private final Kind kind;

  private enum Kind {
    ANSWER,
    TOO_LONG,
    NOT_SENT
  }

  /** Creates an exception for an answer of the server. */
  CrossComValueException(String variable, String text, String what, @Nullable Throwable cause) {
    this(variable, text, what, cause, Kind.ANSWER);
  }

  private CrossComValueException(
      String variable, String text, String what, @Nullable Throwable cause, Kind kind) {
    super(variable + ": " + what, cause, false);
    this.variable = variable;
    this.text = text;
    this.kind = kind;
  }

  /** Returns an exception for a value that was not sent. */
  static CrossComValueException notSent(
      String variable, String text, String what, @Nullable Throwable cause) {
    return new CrossComValueException(variable, text, what, cause, Kind.NOT_SENT);
  }

  /** Returns an exception for a value that does not fit into an answer. */
  static CrossComValueException tooLong(String variable) {
    return new CrossComValueException(
        variable, "", "the value is too long for an answer (code 10)", null, Kind.TOO_LONG);
  }

  /** Returns whether the value does not fit into an answer. */
  boolean isTooLong() {
    return kind == Kind.TOO_LONG;
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
    return kind != Kind.NOT_SENT;
  }

  /** Returns the value's whole text, as the server sent it or as it would have been sent. */
  public String getText() {
    return text;
  }
}
