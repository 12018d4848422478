package no.hials.crosscom.protocol.variable;

import no.hials.crosscom.protocol.internal.Ranges;

/**
 * Sets a variable from text (type 5): {@code name, value}.
 *
 * @param id u16, echoed in the answer
 * @param name WSTRING
 * @param value WSTRING; name and value have 32,765 characters together at most
 */
public record WriteUtf16Request(int id, String name, String value) implements VariableRequest {
  /** Checks the ranges. */
  public WriteUtf16Request {
    Ranges.u16("id", id);
    Ranges.frame("name and value", 1 + Ranges.wide(name) + Ranges.wide(value));
  }
}
