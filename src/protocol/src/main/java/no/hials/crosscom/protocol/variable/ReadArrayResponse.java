package no.hials.crosscom.protocol.variable;

import java.util.List;
import no.hials.crosscom.protocol.Tail;
import no.hials.crosscom.protocol.TypedResponse;
import no.hials.crosscom.protocol.internal.Ranges;

/**
 * Answers {@link ReadArrayRequest}: {@code id, length, 02, value length, numbers, tail}.
 *
 * @param id u16, of the request
 * @param elements u16 each; empty if the access failed
 * @param tail the end of the answer
 */
public record ReadArrayResponse(int id, List<Integer> elements, Tail tail)
    implements TypedResponse {
  /** Checks the ranges. */
  public ReadArrayResponse {
    elements = List.copyOf(elements);
    Ranges.u16("id", id);
    Ranges.words("element", elements);
    Ranges.frame("elements", 1 + 2 + 2 * elements.size() + Tail.LENGTH);
  }
}
