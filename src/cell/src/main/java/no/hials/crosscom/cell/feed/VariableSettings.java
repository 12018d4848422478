package no.hials.crosscom.cell.feed;

import java.util.List;
import no.hials.crosscom.protocol.value.KrlString;
import no.hials.crosscom.protocol.value.KrlValue;
import org.jspecify.annotations.Nullable;

/**
 * The settings of one variable or field.
 *
 * @param name the variable, in upper case
 * @param unit its unit; null for the unit of the catalogue
 * @param deadBand the difference up to which a REAL counts as unchanged; null for the group's
 * @param range the range of its numbers, also of those to write; null if unknown
 * @param values the values that may be written if it is not a number, texts without quotes
 * @param writable whether it may be written
 */
public record VariableSettings(
    String name,
    @Nullable String unit,
    @Nullable Double deadBand,
    @Nullable Range range,
    List<String> values,
    boolean writable) {

  /** Copies the list. */
  public VariableSettings {
    values = List.copyOf(values);
  }

  /**
   * Returns whether a value is in the list of values. A text must be the same; for another value,
   * case is ignored as KRL does.
   */
  boolean lists(KrlValue value, String print) {
    return value instanceof KrlString text
        ? values.contains(text.text())
        : values.stream().anyMatch(print::equalsIgnoreCase);
  }
}
