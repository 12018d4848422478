package no.hials.crosscom.mock;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStream;
import java.io.InputStreamReader;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.Locale;

/**
 * Reads the variables of the simulated controller from {@code types.tsv} and {@code variables.tsv},
 * whose first lines say what their columns are.
 */
final class BuiltInTable {
  /** Never changed, only copied. */
  static final VariableTable KRC4 = load();

  private static final int TYPE_COLUMNS = 4;
  private static final int VARIABLE_COLUMNS = 7;

  private BuiltInTable() {}

  private static VariableTable load() {
    VariableTable table = VariableTable.empty();
    read("types.tsv", TYPE_COLUMNS, row -> declareType(table, row));
    read("variables.tsv", VARIABLE_COLUMNS, row -> declareVariable(table, row));
    return table;
  }

  /** Takes one row. */
  @FunctionalInterface
  interface Row {
    void take(String[] columns);
  }

  static void read(String file, int columnCount, Row row) {
    try (InputStream in = BuiltInTable.class.getResourceAsStream(file)) {
      if (in == null) {
        throw new IllegalStateException("resource " + file + " is missing from the jar");
      }
      BufferedReader lines = new BufferedReader(new InputStreamReader(in, StandardCharsets.UTF_8));
      int number = 0;
      for (String line = lines.readLine(); line != null; line = lines.readLine()) {
        number++;
        if (line.isBlank() || line.startsWith("#")) {
          continue;
        }
        String[] columns = line.split("\t", -1);
        if (columns.length != columnCount) {
          throw new IllegalStateException(
              file
                  + ":"
                  + number
                  + " must have "
                  + columnCount
                  + " columns, has "
                  + columns.length);
        }
        try {
          row.take(columns);
        } catch (IllegalArgumentException e) {
          throw new IllegalStateException(file + ":" + number + ": " + e.getMessage(), e);
        }
      }
    } catch (IOException e) {
      throw new UncheckedIOException("resource " + file + " cannot be read", e);
    }
  }

  private static void declareType(VariableTable table, String[] columns) {
    String name = columns[1];
    String definition = columns[2];
    switch (columns[0].toUpperCase(Locale.ROOT)) {
      case "STRUC" -> table.declareStruc(name, definition);
      case "ENUM" -> table.declareEnum(name, definition.split(",", -1));
      default -> throw new IllegalArgumentException("kind is STRUC or ENUM, is " + columns[0]);
    }
  }

  private static void declareVariable(VariableTable table, String[] columns) {
    String name = columns[0];
    String value = columns[4];
    int bracket = name.indexOf('[');
    if (bracket >= 0 && table.contains(name.substring(0, bracket))) {
      // NAME[i] behind NAME[n] is the value of one element
      table.set(name, value);
      return;
    }
    Access access =
        switch (columns[2]) {
          case "RO" -> Access.READ_ONLY;
          case "RW" -> Access.READ_WRITE;
          default -> throw new IllegalArgumentException("access is RO or RW, is " + columns[2]);
        };
    table.declare(name, columns[1], access, value.equals("-") ? null : value);
  }
}
