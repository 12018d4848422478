package no.hials.crosscom.protocol.variable;

import no.hials.crosscom.protocol.internal.Ranges;

/**
 * Asks for the text of a variable (type 4): {@code name}.
 *
 * @param id u16, echoed in the answer
 * @param name WSTRING: u16 count of characters and UTF-16, little-endian; 32,766 at most
 */
public record ReadUtf16Request(int id, String name) implements VariableRequest {
  /** Checks the ranges. */
  public ReadUtf16Request {
    Ranges.u16("id", id);
    Ranges.frame("name", 1 + Ranges.wide(name));
  }
}
