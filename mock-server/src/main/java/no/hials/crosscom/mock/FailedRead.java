package no.hials.crosscom.mock;

import no.hials.crosscom.protocol.Tail;

/**
 * How a read that the controller refuses is answered. The value is empty in each; servers differ in
 * the tail (docs/reference/kukavarproxy.md#refused-accesses).
 */
public enum FailedRead {
  /** {@code 00 01 01}, the tail of success: KUKAVARPROXY since 2019. */
  EMPTY_SUCCESS,
  /** {@code 00 01 00}: what most descriptions of KUKAVARPROXY say. */
  FAILURE,
  /** {@code 00 00 00}: what C3 Bridge answers. */
  FAILURE_ZERO;

  /**
   * Gives the end of such an answer.
   *
   * @return the tail
   */
  public Tail tail() {
    return switch (this) {
      case EMPTY_SUCCESS -> Tail.SUCCESS;
      case FAILURE -> Tail.FAILURE;
      case FAILURE_ZERO -> Tail.FAILURE_ZERO;
    };
  }
}
