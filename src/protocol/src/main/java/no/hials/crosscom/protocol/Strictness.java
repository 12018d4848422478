package no.hials.crosscom.protocol;

/**
 * Whether a decoder of requests accepts bytes that a server accepts although no client sends them.
 */
public enum Strictness {
  /** Rejects missing and extra bytes, and truth values other than 0 and 1. */
  STRICT,
  /**
   * Reads a request as C3 Bridge does (docs/reference/c3-messages.md#framing): ignores bytes after
   * the last field, and reads the complete assignments of a write of several variables that ends
   * early, and needs only the first ten variables of a benchmark. Assumed: a truth value other than
   * 0 is true, as in the tail of an answer.
   */
  LENIENT
}
