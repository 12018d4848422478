package no.hials.crosscom.web.internal.programs;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import no.hials.crosscom.cell.Leaf;
import no.hials.crosscom.protocol.value.KrlValue;
import no.hials.crosscom.web.internal.robot.Readings.ReadOutcome;
import org.jspecify.annotations.Nullable;

/** Holds the values of variables that were read, and why the others could not be. */
final class ReadValues {
  private final Map<String, ReadOutcome> outcomes;
  private final @Nullable String lost;

  ReadValues(Map<String, ReadOutcome> outcomes) {
    this.outcomes = outcomes;
    lost =
        outcomes.values().stream()
            .filter(ReadOutcome::missed)
            .map(ReadOutcome::error)
            .findFirst()
            .orElse(null);
  }

  /** Returns why nothing can be read; null if it can. */
  @Nullable String lost() {
    return lost;
  }

  boolean isEmpty() {
    return outcomes.isEmpty();
  }

  /** Returns a value; null if it is unknown. */
  @Nullable KrlValue get(String name) {
    ReadOutcome outcome = outcomes.get(name);
    return outcome == null || lost != null ? null : outcome.value();
  }

  /** Returns a value without quotes and blanks around it; empty if it is unknown. */
  String text(String name) {
    KrlValue value = get(name);
    return value == null ? "" : new Leaf(name, value).text().strip();
  }

  /** Returns variables with their values, or why there are none. */
  String print(String... names) {
    List<String> parts = new ArrayList<>();
    for (String name : names) {
      KrlValue value = get(name);
      parts.add(value == null ? name + ": " + error(name) : name + " = " + value.print());
    }
    return String.join(", ", parts);
  }

  private String error(String name) {
    ReadOutcome outcome = outcomes.get(name);
    return outcome == null || lost != null ? "not read" : outcome.error();
  }

  /** Returns a value as a number; NaN for another type. */
  static double number(KrlValue value) {
    try {
      return value.asDouble();
    } catch (RuntimeException e) { // a controller may answer with another type
      return Double.NaN;
    }
  }
}
