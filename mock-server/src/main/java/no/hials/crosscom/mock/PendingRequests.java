package no.hials.crosscom.mock;

/**
 * The treatment of a request that arrives while another one is served. KUKAVARPROXY can drop it and
 * log "reading pending"; the client then gets no answer
 * (docs/reference/kukavarproxy.md#one-request-at-a-time).
 */
public enum PendingRequests {
  /** The request waits for its turn. */
  WAIT,
  /**
   * The request is dropped if it arrives on the connection whose request is served; requests of
   * other connections wait. Assumed to be the behaviour of a controller: five clients at the same
   * time all got answers, each after five times the time
   * (docs/reference/access-times.md#50000-accesses). Several requests in one piece are all
   * answered.
   */
  DROP_OF_SAME_CLIENT,
  /**
   * The request is dropped on every connection, the literal meaning of
   * docs/reference/kukavarproxy.md#one-request-at-a-time.
   */
  DROP
}
