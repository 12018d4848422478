package no.hials.crosscom.mock;

/** The answer to a request with a function number that the server does not support. */
public enum UnknownFunction {
  /**
   * Answers only the id and the length 0: KUKAVARPROXY
   * (docs/reference/kukavarproxy.md#unknown-functions).
   */
  EMPTY_ANSWER,
  /** Closes the connection without an answer: C3 Bridge (docs/reference/c3-messages.md#framing). */
  CLOSE
}
