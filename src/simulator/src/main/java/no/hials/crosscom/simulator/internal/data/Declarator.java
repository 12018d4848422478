package no.hials.crosscom.simulator.internal.data;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * A declared variable or component: its type, name and, for an array, the dimensions.
 *
 * @param type the type of an element
 * @param name as declared, without the dimensions
 * @param dimensions the length of each, none for what is no array; the last one of a CHAR array is
 *     the length of its texts
 */
record Declarator(Type type, String name, List<Integer> dimensions) {
  private static final Pattern FORM =
      Pattern.compile("([^\\[\\]]+)(?:\\[(\\d{1,7}(?:,\\d{1,7}){0,2})])?");

  /** Keeps a typing error from filling the memory. */
  private static final long MAX_ELEMENTS = 1_000_000;

  /** Takes a declared name apart, such as {@code TOOL_NAME[16,24]}. */
  static Declarator parse(Type type, String text) {
    Matcher matcher = FORM.matcher(text.strip().replaceAll("\\s*([\\[\\],])\\s*", "$1"));
    if (!matcher.matches() || !VariablePath.isName(matcher.group(1))) {
      throw new IllegalArgumentException(
          "a declaration is a name with or without [dimensions], is '" + text + "'");
    }
    List<Integer> dimensions = new ArrayList<>();
    if (matcher.group(2) != null) {
      for (String number : matcher.group(2).split(",", -1)) {
        dimensions.add(Integer.valueOf(number));
      }
    }
    return of(type, matcher.group(1), dimensions);
  }

  /** Checks the number of elements. */
  static Declarator of(Type type, String name, List<Integer> dimensions) {
    // three dimensions of an INT each would not fit a long
    double elements = 1;
    for (int dimension : dimensions) {
      elements *= dimension;
    }
    if (elements < 1 || elements > MAX_ELEMENTS) {
      throw new IllegalArgumentException(
          String.format(
              Locale.ROOT,
              "%s must have 1 to %d elements, has %.0f",
              name,
              MAX_ELEMENTS,
              elements));
    }
    return new Declarator(type, name, List.copyOf(dimensions));
  }

  Storage uninitialised() {
    int depth = dimensions.size();
    Storage element = type.uninitialised();
    if (type == Type.Base.CHAR && depth > 0) {
      depth--;
      element = new Storage.Text(dimensions.get(depth), null);
    }
    if (depth == 0) {
      return element;
    }
    int[] lengths = new int[depth];
    int count = 1;
    for (int i = 0; i < depth; i++) {
      lengths[i] = dimensions.get(i);
      count *= lengths[i];
    }
    Storage[] elements = new Storage[count];
    Arrays.fill(elements, element);
    return new Storage.Array(lengths, elements);
  }
}
