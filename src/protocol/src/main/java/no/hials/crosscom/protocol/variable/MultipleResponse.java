package no.hials.crosscom.protocol.variable;

import java.util.List;
import no.hials.crosscom.protocol.MessageType;
import no.hials.crosscom.protocol.Tail;
import no.hials.crosscom.protocol.TypedResponse;
import no.hials.crosscom.protocol.internal.Ranges;

/**
 * Answers {@link ReadMultipleRequest} and {@link WriteMultipleRequest} (types 6 and 7): {@code
 * count u8, results}.
 *
 * @param id u16, of the request
 * @param type u8, of the request
 * @param results u8 code and WSTRING value each; 255 at most. Empty if the request was malformed or
 *     the answer is too long
 * @param tail the end of the answer; a failure if one access failed
 */
public record MultipleResponse(int id, MessageType type, List<AccessResult> results, Tail tail)
    implements TypedResponse {
  /** Checks the ranges. */
  public MultipleResponse {
    results = List.copyOf(results);
    Ranges.u16("id", id);
    Ranges.type(type, MessageType.READ_MULTIPLE, MessageType.WRITE_MULTIPLE);
    Ranges.count("results", results, 255);
    long length = results.stream().mapToLong(r -> 1 + Ranges.wide(r.value())).sum();
    Ranges.frame("results", 1 + 1 + length + Tail.LENGTH);
  }
}
