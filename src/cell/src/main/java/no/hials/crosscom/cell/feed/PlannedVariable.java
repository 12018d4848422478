package no.hials.crosscom.cell.feed;

import java.time.Duration;
import java.util.Locale;
import java.util.Optional;
import no.hials.crosscom.cell.Units;
import no.hials.crosscom.protocol.value.KrlStruct;
import no.hials.crosscom.protocol.value.KrlValue;
import org.jspecify.annotations.Nullable;

/**
 * A variable of a plan.
 *
 * @param name the variable as the configuration writes it
 * @param read the variable or the structure that is read for it
 * @param period the time from one reading to the next
 * @param onChange whether only changed values are passed on
 * @param deadBand the difference up to which a REAL counts as unchanged
 * @param settings its settings; null if it has none
 */
public record PlannedVariable(
    String name,
    String read,
    Duration period,
    boolean onChange,
    double deadBand,
    @Nullable VariableSettings settings) {

  /** Returns the name in upper case, since KRL ignores case. */
  public String key() {
    return name.toUpperCase(Locale.ROOT);
  }

  /**
   * Returns the unit of the variable or of a number in it, from its settings or else from the
   * catalogue.
   *
   * @param leaf the name of the number, such as {@code $POS_ACT.X}
   * @return the unit; empty if it has no unit or the unit is unknown
   */
  public String unit(Units units, String leaf) {
    return settings == null || settings.unit() == null ? units.of(leaf) : settings.unit();
  }

  /** Returns this variable's part of what was read; empty if the structure has no such field. */
  public Optional<KrlValue> in(KrlValue whole) {
    Optional<KrlValue> part = Optional.of(whole);
    if (name.length() > read.length()) {
      for (String field : name.substring(read.length() + 1).split("\\.", -1)) {
        part =
            part.flatMap(
                value -> value instanceof KrlStruct struct ? struct.get(field) : Optional.empty());
      }
    }
    return part;
  }
}
