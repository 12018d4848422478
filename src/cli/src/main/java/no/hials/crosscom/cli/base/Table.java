package no.hials.crosscom.cli.base;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import no.hials.crosscom.protocol.value.PrintableText;
import picocli.CommandLine.Help;
import picocli.CommandLine.Help.Ansi;
import picocli.CommandLine.Help.Column;
import picocli.CommandLine.Help.TextTable;

/** A table for people: columns as wide as their widest text, two blanks apart. */
public final class Table {
  private static final int GAP = 2;
  private static final String NUMBER = "-?[0-9.]+";

  /** The text of an empty cell. */
  public static final String NOTHING = "-";

  private final int columns;
  private final List<List<String>> rows = new ArrayList<>();

  private Table(int columns) {
    this.columns = columns;
  }

  /** Creates a table that begins with a line of titles. */
  public static Table withTitles(String... titles) {
    return new Table(titles.length).add(titles);
  }

  /** Creates a table of two columns without titles: names and values. */
  public static Table ofValues() {
    return new Table(2);
  }

  /**
   * Adds a row.
   *
   * @param cells one per column; an empty cell is shown as {@link #NOTHING}
   */
  public Table add(String... cells) {
    rows.add(
        Arrays.stream(cells)
            .map(cell -> cell.isEmpty() ? NOTHING : PrintableText.of(cell))
            .toList());
    return this;
  }

  /** Prints the lines as data. */
  public void print(Console console) {
    int[] widths = new int[columns];
    for (List<String> row : rows) {
      for (int i = 0; i < columns; i++) {
        widths[i] = Math.max(widths[i], row.get(i).length());
      }
    }
    TextTable table =
        TextTable.forColumns(
            Help.defaultColorScheme(Ansi.OFF),
            Arrays.stream(widths)
                .mapToObj(width -> new Column(width + GAP, 0, Column.Overflow.TRUNCATE))
                .toArray(Column[]::new));
    for (List<String> row : rows) {
      String[] cells = new String[columns];
      for (int i = 0; i < columns; i++) {
        String cell = row.get(i);
        // numbers are right-aligned, and so is their title; the last column has no right edge
        boolean right = i < columns - 1 && rows.size() > 1 && isNumeric(i);
        cells[i] = right ? " ".repeat(widths[i] - cell.length()) + cell : cell;
      }
      table.addRowValues(cells);
    }
    table.toString().lines().map(String::stripTrailing).forEach(console::print);
  }

  private boolean isNumeric(int column) {
    List<String> cells =
        rows.stream()
            .skip(1)
            .map(row -> row.get(column))
            .filter(cell -> !cell.equals(NOTHING))
            .toList();
    return !cells.isEmpty() && cells.stream().allMatch(cell -> cell.matches(NUMBER));
  }
}
