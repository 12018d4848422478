package no.hials.crosscom.protocol.variable;

import no.hials.crosscom.protocol.internal.Ranges;

/**
 * Asks for an INT array as 16-bit numbers: {@code id, length, 02, name length, name}.
 *
 * @param id u16, echoed in the answer
 * @param name u16 byte count and ISO 8859-1 bytes; 65,532 at most
 */
public record ReadArrayRequest(int id, String name) implements VariableRequest {
  /** Checks the ranges. */
  public ReadArrayRequest {
    Ranges.u16("id", id);
    Ranges.latin1("name", name);
    Ranges.frame("name", 1 + 2 + name.length());
  }
}
