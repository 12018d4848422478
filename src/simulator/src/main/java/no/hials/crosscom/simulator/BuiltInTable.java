package no.hials.crosscom.simulator;

import java.io.IOException;
import java.util.List;
import no.hials.crosscom.simulator.internal.data.BuiltInDataLists;

/** Reads the variables of the simulated controller from the data lists in the jar. */
final class BuiltInTable {
  /** Never changed, only copied. */
  static final VariableTable KRC4 = krc4();

  private BuiltInTable() {}

  private static VariableTable krc4() {
    VariableTable table = load(BuiltInDataLists.NAMES);
    SystemVariableRanges.guard(table.scope());
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
}
