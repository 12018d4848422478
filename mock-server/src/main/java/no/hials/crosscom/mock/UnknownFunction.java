package no.hials.crosscom.mock;

/** What a server does with a request of a function number that it has not. */
public enum UnknownFunction {
  /** Answers the id and the length 0, nothing more: KUKAVARPROXY (kukavarproxy.md). */
  EMPTY_ANSWER,
  /** Closes the connection without an answer: C3 Bridge (krl.md 1.8). */
  CLOSE
}
