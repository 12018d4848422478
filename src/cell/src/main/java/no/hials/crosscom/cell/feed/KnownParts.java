package no.hials.crosscom.cell.feed;

import java.util.HashMap;
import java.util.Map;
import no.hials.crosscom.protocol.value.KrlArray;
import no.hials.crosscom.protocol.value.KrlStruct;
import no.hials.crosscom.protocol.value.KrlValue;

/**
 * The fields and elements that a variable has had so far. Outputs keep something for each of them,
 * so their number is bounded. Not thread-safe.
 */
final class KnownParts {
  private static final int MAX_FIELDS = 1000;

  /** Enough for {@code $IN[]} (docs/reference/system-variables.md). */
  private static final int MAX_ELEMENTS = 10_000;

  /** A name of KRL has at most 24 characters (docs/reference/krl-values.md). */
  private static final int LONGEST_NAME = 250;

  /** The fields, and the number of elements of those that are arrays. */
  private final Map<String, Integer> known = new HashMap<>();

  /**
   * Adds the fields and elements of a value.
   *
   * @return empty, or a text about the variable if they are too many; then they are not added
   */
  String add(KrlValue value) {
    Map<String, Integer> parts = new HashMap<>();
    collect("", value, parts);
    known.forEach((name, size) -> parts.merge(name, size, Math::max));
    if (parts.equals(known)) {
      return "";
    }
    if (parts.size() > MAX_FIELDS) {
      return "has more than %d fields, with those of earlier readings".formatted(MAX_FIELDS);
    }
    if (parts.values().stream().mapToInt(size -> size).sum() > MAX_ELEMENTS) {
      return "has arrays with more than %d elements".formatted(MAX_ELEMENTS);
    }
    if (parts.keySet().stream().anyMatch(name -> name.length() > LONGEST_NAME)) {
      return "has a field whose name has more than %d characters".formatted(LONGEST_NAME);
    }
    known.putAll(parts);
    return "";
  }

  private static void collect(String name, KrlValue value, Map<String, Integer> parts) {
    if (value instanceof KrlStruct struct) {
      for (KrlStruct.Field field : struct.fields()) {
        String own = name + "." + field.name();
        parts.put(own, 0);
        collect(own, field.value(), parts);
      }
    } else if (value instanceof KrlArray array) {
      parts.put(name, array.elements().size());
    }
  }
}
