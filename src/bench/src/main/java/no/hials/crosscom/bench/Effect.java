package no.hials.crosscom.bench;

/** The results of a call that are right, whatever has happened on its way. */
enum Effect {
  /** An exception. */
  FAILS,
  /** An exception; or the right value, if a read is repeated on a new connection. */
  LOST,
  /** The right value or an exception. */
  RIGHT_OR_FAILS,
  /** The right value or an exception; a write that was done can be reported as refused. */
  MAY_REFUSE,
  /** Any value or an exception. */
  ANY_VALUE;

  /** Returns whether the bytes are a valid answer with a wrong value. */
  boolean lies() {
    return this == MAY_REFUSE || this == ANY_VALUE;
  }

  boolean allowsSuccess(boolean write) {
    return this != FAILS && (this != LOST || !write);
  }
}
