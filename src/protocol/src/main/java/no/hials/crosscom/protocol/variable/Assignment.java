package no.hials.crosscom.protocol.variable;

import java.util.List;
import no.hials.crosscom.protocol.internal.Ranges;

/**
 * A variable and the text to write to it.
 *
 * @param name WSTRING: u16 count of characters and UTF-16, little-endian
 * @param value WSTRING
 */
public record Assignment(String name, String value) {
  static long length(List<Assignment> assignments) {
    return assignments.stream().mapToLong(a -> Ranges.wide(a.name) + Ranges.wide(a.value)).sum();
  }
}
