package no.hials.crosscom.simulator;

import java.io.IOException;
import java.util.List;
import java.util.Locale;
import no.hials.crosscom.protocol.value.KrlArray;
import no.hials.crosscom.protocol.value.KrlInt;
import no.hials.crosscom.protocol.value.KrlReal;
import no.hials.crosscom.protocol.value.KrlValue;
import no.hials.crosscom.simulator.internal.data.BuiltInDataLists;

/** The variables of the simulated controller, from the data lists in the jar, and their ranges. */
final class BuiltInTable {
  /** The range of a variable, for writes of clients and programs. */
  private record Range(String name, int minimum, int maximum) {}

  private static final List<Range> RANGES =
      List.of(
          // docs/reference/system-variables.md#override-and-speed
          new Range("$OV_PRO", 0, 100),
          new Range("$ADVANCE", 0, 5),
          // docs/reference/system-variables.md#inputs-outputs-and-timers
          new Range("$ANOUT", -1, 1),
          // in %; assumed that 0 and more than 100 are refused
          // (docs/reference/system-variables.md#override-and-speed)
          new Range("$OV_JOG", 0, 100),
          new Range("$VEL_AXIS", 1, 100),
          new Range("$ACC_AXIS", 1, 100),
          new Range("$VEL_EXTAX", 1, 100),
          new Range("$ACC_EXTAX", 1, 100));

  /** Never changed, only copied. */
  static final VariableTable KRC4 = krc4();

  private BuiltInTable() {}

  private static VariableTable krc4() {
    VariableTable table = load(BuiltInDataLists.NAMES);
    for (Range range : RANGES) {
      table.scope().guard(range.name(), (path, value) -> check(range, value));
    }
    return table;
  }

  /** Returns a table of some data lists in the jar. */
  static VariableTable load(List<String> files) {
    VariableTable table = VariableTable.empty();
    for (String file : files) {
      try {
        table.load(file, BuiltInDataLists.text(file));
      } catch (IOException | KrlFileException e) {
        throw new IllegalStateException("a data list in the jar is wrong: " + e.getMessage(), e);
      }
    }
    return table;
  }

  private static void check(Range range, KrlValue value) throws RefusedException {
    if (value instanceof KrlArray array) {
      for (KrlValue element : array.elements()) {
        check(range, element);
      }
      return;
    }
    double number;
    if (value instanceof KrlInt integer) {
      number = integer.value();
    } else if (value instanceof KrlReal real) {
      number = real.value();
    } else {
      return; // the type of the variable refuses it
    }
    if (!(number >= range.minimum() && number <= range.maximum())) {
      throw new RefusedException(
          Refusal.OUT_OF_RANGE,
          String.format(
              Locale.ROOT,
              "must be %d to %d, was given %s",
              range.minimum(),
              range.maximum(),
              value.print()));
    }
  }
}
