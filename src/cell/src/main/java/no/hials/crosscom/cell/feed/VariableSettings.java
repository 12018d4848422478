package no.hials.crosscom.cell.feed;

import java.util.List;
import org.jspecify.annotations.Nullable;

/**
 * The settings of one variable or field.
 *
 * @param name the variable, in upper case
 * @param unit its unit; null for the unit of the catalogue
 * @param deadBand the difference up to which a REAL counts as unchanged; null for the group's
 * @param range the range of its numbers, also of those to write; null if unknown
 * @param values the values that may be written if it is not a number, in upper case; empty for any
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
}
