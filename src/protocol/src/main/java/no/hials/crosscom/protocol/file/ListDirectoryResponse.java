package no.hials.crosscom.protocol.file;

import java.util.List;
import no.hials.crosscom.protocol.Tail;
import no.hials.crosscom.protocol.TypedResponse;
import no.hials.crosscom.protocol.internal.Ranges;

/**
 * Answers {@link ListDirectoryRequest} (type 21): {@code count u16, items, count u16, infos}.
 *
 * @param id u16, of the request
 * @param items WSTRING each; the names
 * @param infos WSTRING each, type, attributes and size, such as {@code 32,32,21}; one an item, or
 *     none if {@link no.hials.crosscom.protocol.code.ListFlag#LONG} was not set
 * @param tail the end of the answer
 */
public record ListDirectoryResponse(int id, List<String> items, List<String> infos, Tail tail)
    implements TypedResponse {
  /** Checks the ranges. */
  public ListDirectoryResponse {
    items = List.copyOf(items);
    infos = List.copyOf(infos);
    Ranges.u16("id", id);
    Ranges.frame(
        "items and infos", 1 + 2 + Ranges.wide(items) + 2 + Ranges.wide(infos) + Tail.LENGTH);
  }
}
