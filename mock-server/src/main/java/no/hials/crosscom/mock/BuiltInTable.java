package no.hials.crosscom.mock;

import java.io.FileNotFoundException;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.util.List;

/** Reads the variables of the simulated controller from the data lists in the jar. */
final class BuiltInTable {
  /** In the order in which they need each other: types, what signals are wired to, the rest. */
  static final List<String> DATA_LISTS =
      List.of("$TYPES.DAT", "$OPERATE.DAT", "$MACHINE.DAT", "$CONFIG.DAT");

  /** Never changed, only copied. */
  static final VariableTable KRC4 = krc4();

  private BuiltInTable() {}

  private static VariableTable krc4() {
    VariableTable table = load(DATA_LISTS);
    Ranges.guard(table.scope());
    return table;
  }

  /** Makes a table of some data lists in the jar. */
  static VariableTable load(List<String> files) {
    VariableTable table = VariableTable.empty();
    for (String file : files) {
      try {
        table.load(file, text(file));
      } catch (IOException | KrlFileException e) {
        throw new IllegalStateException("a data list in the jar is wrong: " + e.getMessage(), e);
      }
    }
    return table;
  }

  /** Gives the text of a data list in the jar. */
  static String text(String file) throws IOException {
    try (InputStream in = BuiltInTable.class.getResourceAsStream(file)) {
      if (in == null) {
        throw new FileNotFoundException("resource " + file + " is missing");
      }
      return new String(in.readAllBytes(), StandardCharsets.ISO_8859_1);
    }
  }
}
