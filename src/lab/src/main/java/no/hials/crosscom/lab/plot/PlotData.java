package no.hials.crosscom.lab.plot;

import de.siegmar.fastcsv.reader.CsvRecord;
import java.nio.file.Path;
import java.time.Instant;
import java.time.ZoneOffset;
import java.time.format.DateTimeFormatter;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import no.hials.crosscom.cell.FileException;
import no.hials.crosscom.cell.Units;
import no.hials.crosscom.cell.recording.CsvFile;
import no.hials.crosscom.cell.recording.CsvText;
import no.hials.crosscom.cell.recording.RecordedData;

/**
 * The columns of a CSV file for plotting: a file from {@code record}, or any other file whose first
 * line names its columns and whose first column has numbers.
 */
public final class PlotData {
  /** A column's name with its unit, as {@code force [N]}. */
  private static final Pattern NAME_AND_UNIT = Pattern.compile("(.+?) ?\\[([^\\]\\d][^\\]]*)\\]");

  /** The texts that mean that there is no finite number. */
  private static final Pattern NOT_FINITE =
      Pattern.compile("[+-]?(nan|inf|infinity)", Pattern.CASE_INSENSITIVE);

  private static final DateTimeFormatter TIME =
      DateTimeFormatter.ofPattern("yyyy-MM-dd HH:mm:ss 'UTC'", Locale.ROOT)
          .withZone(ZoneOffset.UTC);

  private final String title;
  private final Quantity x;
  private final List<Column> columns;

  private PlotData(String title, Quantity x, List<Column> columns) {
    this.title = title;
    this.x = x;
    this.columns = columns;
  }

  /** A column of the file. */
  public static final class Column {
    private final String name;
    private final String unit;
    private final double[] x;
    private final double[] y;
    private final String text;
    private final boolean onlyIfNamed;

    private Column(
        String name, String unit, double[] x, double[] y, String text, boolean onlyIfNamed) {
      this.name = name;
      this.unit = unit;
      this.x = x;
      this.y = y;
      this.text = text;
      this.onlyIfNamed = onlyIfNamed;
    }

    public String name() {
      return name;
    }

    /** Returns the unit; empty if it has no unit or the unit is unknown. */
    public String unit() {
      return unit;
    }

    public Quantity axis() {
      return new Quantity(name, unit);
    }

    /** Returns the numbers of the first column, for {@link #y}. */
    public double[] x() {
      return x.clone();
    }

    /** Returns the numbers; NaN in a gap, infinite for NaN. TRUE is 1, FALSE 0. */
    public double[] y() {
      return y.clone();
    }

    /** Returns whether the column has numbers, or TRUE and FALSE, and no other text. */
    public boolean isDrawable() {
      return text.isEmpty() && hasNumbers();
    }

    public boolean hasNumbers() {
      return Arrays.stream(y).anyMatch(Double::isFinite);
    }

    /** Returns the first text that is not a number, TRUE or FALSE; empty without one. */
    public String text() {
      return text;
    }

    /**
     * Returns whether the column is about the recording, such as access times, and so drawn only by
     * name.
     */
    public boolean isOnlyIfNamed() {
      return onlyIfNamed;
    }
  }

  /** Returns the title of the chart. */
  public String title() {
    return title;
  }

  /** Returns the axis of the first column. */
  public Quantity x() {
    return x;
  }

  public List<Column> columns() {
    return columns;
  }

  public Optional<Column> find(String name) {
    return columns.stream().filter(column -> column.name.equalsIgnoreCase(name)).findFirst();
  }

  /**
   * Reads a file.
   *
   * @throws FileException if the file cannot be read or has another format
   */
  public static PlotData read(Path file) throws FileException {
    try {
      return CsvFile.read(file, false, csv -> recordedOrOther(file, csv));
    } catch (IllegalArgumentException e) {
      throw new FileException("cannot draw " + file + ": " + e.getMessage(), e);
    }
  }

  private static PlotData recordedOrOther(Path file, Iterable<CsvRecord> csv) throws FileException {
    List<CsvRecord> rows = new ArrayList<>();
    for (CsvRecord row : csv) {
      if (rows.isEmpty() && isHeaderOfRecord(row)) {
        return of(file, RecordedData.read(file));
      }
      rows.add(row);
    }
    return of(file, rows);
  }

  // files from record

  private static boolean isHeaderOfRecord(CsvRecord row) {
    return row.getFieldCount() > 1
        && row.getField(0).equals(RecordedData.TIME)
        && row.getField(1).equals(RecordedData.SECONDS);
  }

  private static PlotData of(Path file, RecordedData data) {
    List<Column> columns = new ArrayList<>();
    Units units = new Units();
    for (RecordedData.RecordedColumn series : data.series()) {
      columns.add(column(series.name(), units.of(series.name()), series.seconds(), series.texts()));
    }
    for (RecordedData.RecordedColumn series : data.accessTimes()) {
      columns.add(new Column(series.name(), "ms", series.seconds(), series.values(), "", true));
    }
    return new PlotData(title(file, data.start()), new Quantity("time", "s"), columns);
  }

  private static String title(Path file, Instant start) {
    return file.getFileName() + ", " + TIME.format(start);
  }

  // other files

  private static PlotData of(Path file, List<CsvRecord> rows) {
    if (rows.size() < 2) {
      throw new IllegalArgumentException("it must have a line of names and lines of numbers");
    }
    List<String> header = rows.get(0).getFields().stream().map(CsvText::exact).toList();
    if (!Double.isNaN(number(header.get(0)))) {
      throw new IllegalArgumentException(
          "the first line must name the columns, begins with " + header.get(0));
    }
    checkSeparator(header);
    List<CsvRecord> body = rows.subList(1, rows.size());
    body.forEach(row -> CsvFile.checkFields(row, header.size()));
    double[] x = numbers(texts(body, 0));
    for (int i = 0; i < x.length; i++) {
      if (!Double.isFinite(x[i])) {
        throw new IllegalArgumentException(
            "line "
                + body.get(i).getStartingLineNumber()
                + " must begin with a number, begins with "
                + body.get(i).getField(0));
      }
    }
    List<Column> columns = new ArrayList<>();
    Units units = new Units();
    for (int i = 1; i < header.size(); i++) {
      Quantity axis = axis(header.get(i));
      String unit = axis.unit().isEmpty() ? units.of(axis.name()) : axis.unit();
      columns.add(column(axis.name(), unit, x, texts(body, i)));
    }
    Quantity first = axis(header.get(0));
    boolean seconds = first.name().equals(RecordedData.SECONDS) && first.unit().isEmpty();
    String name = String.valueOf(file.getFileName());
    return new PlotData(name, seconds ? new Quantity("time", "s") : first, columns);
  }

  /**
   * Refuses semicolons and tabs as separators, which spreadsheets write where numbers have a
   * decimal comma.
   */
  private static void checkSeparator(List<String> header) {
    String only = header.get(0);
    if (header.size() == 1 && (only.indexOf(';') >= 0 || only.indexOf('\t') >= 0)) {
      throw new IllegalArgumentException(
          "line 1 must have commas between the names, has "
              + (only.indexOf(';') >= 0 ? "semicolons" : "tabs")
              + "; numbers need a decimal point");
    }
  }

  private static Quantity axis(String header) {
    Matcher matcher = NAME_AND_UNIT.matcher(header);
    return matcher.matches()
        ? new Quantity(matcher.group(1), matcher.group(2))
        : new Quantity(header, header.endsWith("_ms") ? "ms" : "");
  }

  private static List<String> texts(List<CsvRecord> rows, int column) {
    return rows.stream().map(row -> CsvText.exact(row.getField(column))).toList();
  }

  private static Column column(String name, String unit, double[] x, List<String> texts) {
    double[] y = numbers(texts);
    boolean truth = texts.stream().anyMatch(text -> text.matches("(?i)TRUE|FALSE"));
    String other =
        texts.stream()
            .filter(text -> Double.isNaN(number(text)) && !text.isBlank())
            .findFirst()
            .orElse("");
    return new Column(name, truth ? "TRUE is 1" : unit, x, y, other, false);
  }

  private static double[] numbers(List<String> texts) {
    return texts.stream().mapToDouble(PlotData::number).toArray();
  }

  private static double number(String text) {
    if (text.equalsIgnoreCase("TRUE")) {
      return 1;
    } else if (text.equalsIgnoreCase("FALSE")) {
      return 0;
    }
    try {
      return text.isBlank()
          ? Double.NaN
          : NOT_FINITE.matcher(text).matches()
              ? Double.POSITIVE_INFINITY
              : Double.parseDouble(text);
    } catch (NumberFormatException e) {
      return Double.NaN;
    }
  }
}
