package no.hials.crosscom.protocol.variable;

import java.util.List;
import no.hials.crosscom.protocol.internal.Ranges;

/**
 * Sets the elements of an array from 16-bit numbers: {@code id, length, 03, name length, name,
 * value length, numbers}. Assumed: the value length counts bytes, as in every other message, and
 * not numbers (docs/reference/wire-format.md#integer-arrays).
 *
 * @param id u16, echoed in the answer
 * @param name u16 byte count and ISO 8859-1 bytes
 * @param elements u16 each, for {@code NAME[1]}, {@code NAME[2]}, ...
 */
public record WriteArrayRequest(int id, String name, List<Integer> elements)
    implements VariableRequest {
  /** Checks the ranges. */
  public WriteArrayRequest {
    elements = List.copyOf(elements);
    Ranges.u16("id", id);
    Ranges.latin1("name", name);
    Ranges.words("element", elements);
    Ranges.frame("name and elements", 1 + 2 + name.length() + 2 + 2 * elements.size());
  }
}
