package no.hials.crosscom.control.input;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.Reader;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.function.LongSupplier;
import java.util.stream.Stream;

/**
 * Replays recorded input from CSV text.
 *
 * <p>The first line names the columns, separated by commas: {@code time} in s, increasing; {@code
 * axis1}, {@code axis2} and so on, -1 to 1; {@code button1} and so on, 0 or 1; {@code dead_man}, 0
 * or 1. Axes, buttons and the dead-man are optional, but nothing moves without the dead-man. Empty
 * lines and lines that start with {@code #} are skipped. A cell may have an apostrophe before it,
 * as cells have that a spreadsheet would take for a formula.
 *
 * <p>The time starts with the first {@link #read}. Each line is valid until the next line, and its
 * age is the time since it, so the robot stands still in a gap and after the last line. The time
 * between lines should be at most half the maximum age of the input.
 */
public final class CsvReplay implements InputDevice {
  private static final String BYTE_ORDER_MARK = "\uFEFF";

  private final List<Row> rows;
  private final LongSupplier clock;
  private boolean begun;
  private long start;
  private int next;

  /** A line, with its time in ns. */
  private record Row(long time, List<Double> axes, List<Boolean> buttons, boolean deadMan) {}

  private CsvReplay(List<Row> rows, LongSupplier clock) {
    this.rows = rows;
    this.clock = clock;
  }

  /**
   * Reads a file.
   *
   * @param file CSV text in UTF-8
   * @throws IOException if the file cannot be read or a line is invalid; the message then has the
   *     file, the line, and the expected and actual text
   */
  public static CsvReplay load(Path file) throws IOException {
    try (Reader reader = Files.newBufferedReader(file)) {
      return load(reader, file.toString(), System::nanoTime);
    }
  }

  /**
   * Reads a text.
   *
   * @param csv CSV text; not closed
   * @param nameForErrors the name of the text in messages
   * @throws IOException if the text cannot be read or a line is invalid
   */
  public static CsvReplay load(Reader csv, String nameForErrors) throws IOException {
    return load(csv, nameForErrors, System::nanoTime);
  }

  static CsvReplay load(Reader csv, String name, LongSupplier clock) throws IOException {
    BufferedReader lines = new BufferedReader(csv);
    List<String> columns = null;
    List<Row> rows = new ArrayList<>();
    int number = 0;
    for (String line = lines.readLine(); line != null; line = lines.readLine()) {
      number++;
      if (number == 1 && line.startsWith(BYTE_ORDER_MARK)) {
        line = line.substring(1); // as spreadsheets write it
      }
      if (line.isBlank() || line.startsWith("#")) {
        continue;
      }
      List<String> cells =
          Stream.of(line.strip().split("\\s*,\\s*", -1)).map(CsvReplay::withoutGuard).toList();
      try {
        if (columns == null) {
          columns = columns(cells);
        } else {
          rows.add(row(columns, cells, rows.isEmpty() ? -1 : rows.get(rows.size() - 1).time()));
        }
      } catch (IllegalArgumentException e) {
        throw new IOException(name + ", line " + number + ": " + e.getMessage(), e);
      }
    }
    if (rows.isEmpty()) {
      throw new IOException(name + ": expected a line of names and a line of values, found none");
    }
    return new CsvReplay(List.copyOf(rows), clock);
  }

  /** Removes the apostrophe that programs write before a cell, so that it is not a formula. */
  private static String withoutGuard(String cell) {
    return cell.startsWith("'") ? cell.substring(1) : cell;
  }

  private static List<String> columns(List<String> cells) {
    List<String> columns = cells.stream().map(cell -> cell.toLowerCase(Locale.ROOT)).toList();
    for (String column : columns) {
      if (!column.matches("time|dead_man|(axis|button)[1-9][0-9]?")) {
        throw new IllegalArgumentException(
            "a column must be time, axis1 to axis99, button1 to button99 or dead_man, is '"
                + column
                + "'");
      }
    }
    if (columns.stream().distinct().count() < columns.size() || !columns.contains("time")) {
      throw new IllegalArgumentException(
          "there must be a column time and no column twice, are " + columns);
    }
    return columns;
  }

  private static Row row(List<String> columns, List<String> cells, long before) {
    if (cells.size() != columns.size()) {
      throw new IllegalArgumentException(
          "expected " + columns.size() + " values, found " + cells.size());
    }
    double seconds = number(cells.get(columns.indexOf("time")));
    if (!(seconds * 1e9 > before && seconds < 1e6)) {
      throw new IllegalArgumentException(
          "time must be more than before, 0 or more and less than 1000000 s, is " + seconds);
    }
    List<Double> axes = new ArrayList<>();
    List<Boolean> buttons = new ArrayList<>();
    boolean deadMan = false;
    for (int i = 0; i < cells.size(); i++) {
      String column = columns.get(i);
      String cell = cells.get(i);
      if (column.startsWith("axis")) {
        put(axes, Integer.parseInt(column.substring(4)) - 1, number(cell), 0.0);
      } else if (column.startsWith("button")) {
        put(buttons, Integer.parseInt(column.substring(6)) - 1, bool(column, cell), false);
      } else if (column.equals("dead_man")) {
        deadMan = bool(column, cell);
      }
    }
    Input checked = new Input(axes, buttons, deadMan, 0);
    return new Row((long) (seconds * 1e9), checked.axes(), checked.buttons(), deadMan);
  }

  private static <T> void put(List<T> list, int index, T value, T filler) {
    while (list.size() <= index) {
      list.add(filler);
    }
    list.set(index, value);
  }

  private static double number(String cell) {
    try {
      return Double.parseDouble(cell);
    } catch (NumberFormatException e) {
      throw new IllegalArgumentException("a value must be a number, is '" + cell + "'", e);
    }
  }

  private static boolean bool(String column, String cell) {
    if (!cell.equals("0") && !cell.equals("1")) {
      throw new IllegalArgumentException(column + " must be 0 or 1, is '" + cell + "'");
    }
    return cell.equals("1");
  }

  @Override
  public synchronized Input read() {
    long now = clock.getAsLong();
    if (!begun) {
      begun = true;
      start = now;
    }
    while (next < rows.size() && start + rows.get(next).time() <= now) {
      next++;
    }
    if (next == 0) {
      return Input.NONE;
    }
    Row row = rows.get(next - 1);
    return new Input(row.axes(), row.buttons(), row.deadMan(), start + row.time());
  }

  /** Returns whether the time of the last line is over. */
  public synchronized boolean isOver() {
    return next == rows.size();
  }
}
