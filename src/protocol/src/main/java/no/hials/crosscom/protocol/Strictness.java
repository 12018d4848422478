package no.hials.crosscom.protocol;

/** What a decoder of requests makes of bytes that a server takes although no client sends them. */
public enum Strictness {
  /** A message has all of its fields and no byte more, and a truth value is 0 or 1. */
  STRICT,
  /**
   * Reads a request as C3 Bridge does (c3-bridge.md, "Common to all messages"): bytes after the
   * last field are ignored, and a write of several variables that ends early has the variables that
   * are whole. Assumed: a truth value other than 0 is true, as it is in the tail of an answer.
   */
  LENIENT
}
