package no.hials.crosscom.cell;

import java.util.List;

/**
 * An input or output, or several that form a number, with the signals that name it.
 *
 * @param array the array in upper case, such as {@code $OUT}
 * @param first the number of the first element, which is the lowest bit
 * @param last the number of the last element; that of the first for a single one
 * @param names the names of the signals as declared, sorted; at least one
 */
public record SignalWires(String array, int first, int last, List<String> names) {
  public SignalWires {
    names = List.copyOf(names);
  }
}
