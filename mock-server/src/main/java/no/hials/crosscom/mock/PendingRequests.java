package no.hials.crosscom.mock;

/**
 * What becomes of a request that arrives while another one is served. KUKAVARPROXY can drop it with
 * a line in its log, "reading pending", and the client waits in vain
 * (docs/reference/kukavarproxy.md#one-request-at-a-time).
 */
public enum PendingRequests {
  /** It is served when its turn comes. */
  WAIT,
  /**
   * It is dropped if it comes on the connection whose request is served, before that is answered;
   * others wait. Assumed to be what a controller does: five clients that asked at a time were all
   * answered, each five times as late (docs/reference/access-times.md#50000-accesses). Several
   * requests that came in one piece are still answered in turn.
   */
  DROP_OF_SAME_CLIENT,
  /**
   * It is dropped, whoever's request is served: the text of
   * docs/reference/kukavarproxy.md#one-request-at-a-time at its word.
   */
  DROP
}
