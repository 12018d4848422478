package no.hials.crosscom.mock;

/** What a server does with a request of a function number that it has not. */
public enum UnknownFunction {
  /**
   * Answers the id and the length 0, nothing more: KUKAVARPROXY
   * (docs/reference/kukavarproxy.md#unknown-functions).
   */
  EMPTY_ANSWER,
  /** Closes the connection without an answer: C3 Bridge (docs/reference/c3-messages.md#framing). */
  CLOSE
}
