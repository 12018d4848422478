package no.hials.crosscom.cell.recording;

import de.siegmar.fastcsv.reader.CsvRecord;
import java.nio.file.Path;
import java.time.DateTimeException;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import no.hials.crosscom.cell.FileException;
import no.hials.crosscom.protocol.value.PrintableText;

/**
 * The contents of a CSV file that {@code record} wrote. The columns are {@link #TIME}, {@link
 * #SECONDS}, {@link #ROBOT} if several robots were recorded, then one for each number or text, and
 * at the end {@link #ACCESS} and {@link #STATUS}; the help of {@code record} describes them.
 */
public final class RecordedData {
  /** The start of the reading, such as {@code 2026-05-04T10:15:30.123456Z}. */
  public static final String TIME = "time";

  /** The start of the reading in seconds since the first row. */
  public static final String SECONDS = "seconds";

  /** The robot of the row; the columns of the other robots are empty in it. */
  static final String ROBOT = "robot";

  /** The duration of the reading in ms. */
  static final String ACCESS = "access_ms";

  /** The problems of the reading; empty if there were none. */
  static final String STATUS = "status";

  private final Instant start;
  private final List<RecordedColumn> series;
  private final List<RecordedColumn> accessTimes;

  private RecordedData(
      Instant start, List<RecordedColumn> series, List<RecordedColumn> accessTimes) {
    this.start = start;
    this.series = List.copyOf(series);
    this.accessTimes = List.copyOf(accessTimes);
  }

  /** Returns the time of the first row, from which seconds are counted. */
  public Instant start() {
    return start;
  }

  /** Returns the recorded columns, in the order of the file. */
  public List<RecordedColumn> series() {
    return series;
  }

  /** Finds a column by its name, whatever its case. */
  public Optional<RecordedColumn> find(String name) {
    return series.stream().filter(one -> one.name().equalsIgnoreCase(name)).findFirst();
  }

  /** Returns the access times in ms: one series for each robot. */
  public List<RecordedColumn> accessTimes() {
    return accessTimes;
  }

  /**
   * Reads a file. An incomplete last row, as after a power failure, is left out.
   *
   * @throws FileException if the file cannot be read or was not written by {@code record}
   */
  public static RecordedData read(Path file) throws FileException {
    List<CsvRecord> records =
        CsvFile.read(
            file,
            true,
            csv -> {
              List<CsvRecord> rows = new ArrayList<>();
              csv.forEach(rows::add);
              return rows;
            });
    try {
      return new Rows(records).data();
    } catch (IllegalArgumentException e) {
      String reason = PrintableText.shortened(String.valueOf(e.getMessage()));
      throw new FileException(file + " is not a recording: " + reason, e);
    }
  }

  /** Turns rows into columns. */
  private static final class Rows {
    private final List<String> header;
    private final List<CsvRecord> rows;
    private final boolean severalRobots;
    private final Instant start;

    Rows(List<CsvRecord> records) {
      if (records.isEmpty()) {
        throw new IllegalArgumentException("it is empty");
      }
      header = records.get(0).getFields().stream().map(CsvText::exact).toList();
      int columns = header.size();
      if (columns < 4
          || !header.get(0).equals(TIME)
          || !header.get(1).equals(SECONDS)
          || !header.get(columns - 2).equals(ACCESS)
          || !header.get(columns - 1).equals(STATUS)) {
        throw new IllegalArgumentException(
            "the first line must be time,seconds,...,access_ms,status, is "
                + String.join(",", header));
      }
      severalRobots = header.get(2).equals(ROBOT);
      rows = records.subList(1, complete(records));
      if (rows.isEmpty()) {
        throw new IllegalArgumentException("it must have a row, has none");
      }
      start = instant(rows.get(0));
    }

    /** Returns the number of complete records. */
    private static int complete(List<CsvRecord> records) {
      int columns = records.get(0).getFieldCount();
      for (int i = 1; i < records.size(); i++) {
        CsvRecord row = records.get(i);
        if (i == records.size() - 1 && row.getFieldCount() < columns) {
          checkClosed(row);
          return i;
        }
        CsvFile.checkFields(row, columns);
      }
      return records.size();
    }

    /** Refuses a row with an open quote that includes later rows: all of them would be left out. */
    private static void checkClosed(CsvRecord row) {
      if (row.getFields().stream().anyMatch(field -> field.indexOf('\n') >= 0)) {
        throw new IllegalArgumentException(
            "line " + row.getStartingLineNumber() + " has a quote that is never closed");
      }
    }

    private static Instant instant(CsvRecord row) {
      try {
        return Instant.parse(row.getField(0));
      } catch (DateTimeException e) {
        throw new IllegalArgumentException(
            "line " + row.getStartingLineNumber() + " must begin with a time: " + e.getMessage(),
            e);
      }
    }

    RecordedData data() {
      int access = header.size() - 2;
      List<RecordedColumn> series = new ArrayList<>();
      for (int column = severalRobots ? 3 : 2; column < access; column++) {
        String name = header.get(column);
        series.add(series(name, column, robotOf(name)));
      }
      return new RecordedData(start, series, accessTimes(access));
    }

    private List<RecordedColumn> accessTimes(int column) {
      if (!severalRobots) {
        return List.of(series(ACCESS, column, ""));
      }
      return rows.stream()
          .map(row -> row.getField(2))
          .distinct()
          .map(robot -> series(robot + ":" + ACCESS, column, robot))
          .toList();
    }

    private String robotOf(String column) {
      return severalRobots ? column.substring(0, Math.max(0, column.indexOf(':'))) : "";
    }

    private RecordedColumn series(String name, int column, String robot) {
      List<CsvRecord> own =
          severalRobots
              ? rows.stream().filter(row -> row.getField(2).equals(robot)).toList()
              : rows;
      double[] seconds = new double[own.size()];
      double[] values = new double[own.size()];
      List<String> texts = new ArrayList<>(own.size());
      boolean numeric = true;
      for (int i = 0; i < seconds.length; i++) {
        CsvRecord row = own.get(i);
        seconds[i] = seconds(row);
        String text = CsvText.exact(row.getField(column));
        texts.add(text);
        values[i] = number(text);
        numeric &= text.isEmpty() || !Double.isNaN(values[i]);
      }
      return new RecordedColumn(name, numeric, seconds, values, texts);
    }

    private static double seconds(CsvRecord row) {
      double seconds = number(row.getField(1));
      if (Double.isNaN(seconds)) {
        throw new IllegalArgumentException(
            "line "
                + row.getStartingLineNumber()
                + " must have the seconds second, has "
                + row.getField(1));
      }
      return seconds;
    }

    private static double number(String text) {
      if (text.isEmpty()) {
        return Double.NaN;
      }
      try {
        return Double.parseDouble(text);
      } catch (NumberFormatException e) {
        return Double.NaN;
      }
    }
  }

  /** A column over time. */
  public static final class RecordedColumn {
    private final String name;
    private final boolean numeric;
    private final double[] seconds;
    private final double[] values;
    private final List<String> texts;

    private RecordedColumn(
        String name, boolean numeric, double[] seconds, double[] values, List<String> texts) {
      this.name = name;
      this.numeric = numeric;
      this.seconds = seconds;
      this.values = values;
      this.texts = texts;
    }

    /** Returns the column's name, such as {@code $POS_ACT.X} or {@code cell1:$POS_ACT.X}. */
    public String name() {
      return name;
    }

    /** Returns whether all samples are numbers. */
    boolean isNumeric() {
      return numeric;
    }

    public int size() {
      return seconds.length;
    }

    /** Returns the times of the samples, since {@link RecordedData#start}. */
    public double[] seconds() {
      return seconds.clone();
    }

    /** Returns the numbers; NaN in a gap, after a failed reading, and for a text. */
    public double[] values() {
      return values.clone();
    }

    /** Returns the texts of the cells, such as {@code #T1} and {@code TRUE}; empty in a gap. */
    public List<String> texts() {
      return List.copyOf(texts);
    }
  }
}
