package no.hials.crosscom.mock;

import no.hials.crosscom.protocol.Tail;

/**
 * The answer to a read that the controller refuses. The value is always empty; servers differ in
 * the tail (docs/reference/kukavarproxy.md#refused-accesses).
 */
public enum FailedRead {
  /** {@code 00 01 01}, the tail of success: KUKAVARPROXY since 2019. */
  EMPTY_SUCCESS,
  /** {@code 00 01 00}: most descriptions of KUKAVARPROXY. */
  FAILURE,
  /** {@code 00 00 00}: C3 Bridge. */
  FAILURE_ZERO;

  /** Returns the tail of the answer. */
  public Tail tail() {
    return switch (this) {
      case EMPTY_SUCCESS -> Tail.SUCCESS;
      case FAILURE -> Tail.FAILURE;
      case FAILURE_ZERO -> Tail.FAILURE_ZERO;
    };
  }
}
