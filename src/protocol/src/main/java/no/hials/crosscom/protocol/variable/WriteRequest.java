package no.hials.crosscom.protocol.variable;

import no.hials.crosscom.protocol.internal.Ranges;

/**
 * Sets a variable from text: {@code id, length, 01, name length, name, value length, value}.
 *
 * @param id u16, echoed in the answer
 * @param name u16 byte count and ISO 8859-1 bytes
 * @param value u16 byte count and ISO 8859-1 bytes; name and value have 65,530 together at most
 */
public record WriteRequest(int id, String name, String value) implements VariableRequest {
  /** Checks the ranges. */
  public WriteRequest {
    Ranges.u16("id", id);
    Ranges.assignment(name, value);
  }
}
