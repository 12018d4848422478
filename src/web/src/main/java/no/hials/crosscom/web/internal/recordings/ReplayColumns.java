package no.hials.crosscom.web.internal.recordings;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.BufferedReader;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.DateTimeException;
import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import no.hials.crosscom.cell.Units;
import no.hials.crosscom.cell.recording.RecordedData;
import no.hials.crosscom.cell.recording.RecordedData.RecordedColumn;
import no.hials.crosscom.web.internal.socket.CommandException;
import no.hials.crosscom.web.internal.socket.Json;

/**
 * The numbers of a recording, as a page draws them: BOOL becomes 1 or 0, and a gap NaN. Texts and
 * constants are left out.
 */
final class ReplayColumns {
  /** The maximum memory of the numbers: some copies of it exist at a time. */
  static final long MAX_BYTES = 32L * 1024 * 1024;

  /** The maximum number of columns: a page lists all of them. */
  static final int MAX_COLUMNS = 10_000;

  private static final Instant EARLIEST = Instant.parse("0000-01-01T00:00:00Z");
  private static final Instant LATEST = Instant.parse("9999-12-31T23:59:59Z");

  private final Instant start;
  private final double[] seconds;
  private final Map<String, double[]> columns;
  private final List<String> texts;

  private ReplayColumns(
      Instant start, double[] seconds, Map<String, double[]> columns, List<String> texts) {
    this.start = start;
    this.seconds = seconds;
    this.columns = columns;
    this.texts = texts;
  }

  /**
   * Reads a file in CSV or JSON Lines.
   *
   * @throws IOException if it cannot be read, or is not the recording of one robot
   */
  static ReplayColumns read(Path file) throws IOException {
    return file.toString().endsWith(RecordingFiles.JSON_LINES) ? readLines(file) : readCsv(file);
  }

  private static ReplayColumns readCsv(Path file) throws IOException {
    RecordedData data = RecordedData.read(file);
    if (data.accessTimes().size() != 1) {
      throw new CommandException("a recording of several robots cannot be opened on the page");
    }
    if (data.series().isEmpty()) {
      throw new CommandException("the recording has no variable");
    }
    checkSize(data.series().get(0).seconds().length, data.series().size());
    Map<String, double[]> columns = new LinkedHashMap<>();
    List<String> texts = new ArrayList<>();
    for (RecordedColumn column : data.series()) {
      double[] values = column.values();
      List<String> cells = column.texts();
      boolean numeric = true;
      for (int i = 0; i < values.length; i++) {
        String cell = cells.get(i);
        if (cell.equals("TRUE") || cell.equals("FALSE")) {
          values[i] = cell.equals("TRUE") ? 1 : 0;
        } else {
          numeric &= cell.isEmpty() || !Double.isNaN(values[i]);
        }
      }
      if (numeric) {
        columns.put(column.name(), values);
      } else {
        texts.add(column.name());
      }
    }
    double[] seconds = data.series().get(0).seconds();
    double before = Double.NEGATIVE_INFINITY;
    for (int i = 0; i < seconds.length; i++) {
      checkTime("row " + (i + 1), seconds[i], before);
      before = seconds[i];
    }
    return new ReplayColumns(checkedStart(data.start()), seconds, columns, texts);
  }

  /** Checks that a time can follow another one: a replay finds its rows by their times. */
  private static void checkTime(String place, double seconds, double before)
      throws CommandException {
    if (!Double.isFinite(seconds) || seconds < before) {
      throw new CommandException(
          place
              + (" must have the seconds of a later time, has " + seconds)
              + (Double.isFinite(before) ? " after " + before : "")
              + "; download the recording instead");
    }
  }

  /** Checks a start: its milliseconds must fit into a number of the page. */
  private static Instant checkedStart(Instant start) throws CommandException {
    if (start.isBefore(EARLIEST) || start.isAfter(LATEST)) {
      throw new CommandException(
          "a recording that is opened must begin in one of the years 0 to 9999, begins at "
              + start
              + "; download it instead");
    }
    return start;
  }

  private static void checkSize(long rows, long columns) throws CommandException {
    if (columns > MAX_COLUMNS) {
      throw new CommandException(
          "a recording that is opened may have at most "
              + MAX_COLUMNS
              + " columns, this one has more; download it instead");
    }
    if (rows * (columns + 1) * Double.BYTES > MAX_BYTES) {
      throw new CommandException(
          "a recording that is opened may have at most "
              + MAX_BYTES / Double.BYTES
              + " numbers, this one has more; download it instead");
    }
  }

  private static ReplayColumns readLines(Path file) throws IOException {
    Rows rows = new Rows();
    try (BufferedReader lines = Files.newBufferedReader(file)) {
      for (String line = lines.readLine(); line != null; line = lines.readLine()) {
        JsonNode row;
        try {
          row = Json.parse(line);
        } catch (IOException e) {
          if (rows.lines > 0 && lines.readLine() == null) {
            break; // the last line is incomplete, as after a power failure
          }
          throw new CommandException(
              "line " + (rows.lines + 1) + " of " + file.getFileName() + " is not JSON");
        }
        rows.add(row);
      }
    }
    return rows.columns(file);
  }

  /** Collects lines of JSON. */
  private static final class Rows {
    private final Map<String, double[]> columns = new LinkedHashMap<>();
    private final Map<String, Boolean> texts = new LinkedHashMap<>();
    private double[] seconds = new double[256];
    private Instant start = Instant.EPOCH;
    private int lines;
    private int count;

    void add(JsonNode row) throws CommandException {
      lines++;
      JsonNode time = row.path("seconds");
      if (!time.isNumber() || !row.path("values").isObject()) {
        throw new CommandException("line " + lines + " is not of a recording");
      }
      double now = time.doubleValue();
      checkTime("line " + lines, now, count == 0 ? Double.NEGATIVE_INFINITY : seconds[count - 1]);
      if (count == 0) {
        try {
          long nanos = Math.round(now * 1e9);
          start =
              checkedStart(Instant.parse(row.path("time").asText()).minus(Duration.ofNanos(nanos)));
        } catch (DateTimeException | ArithmeticException e) {
          throw new CommandException("line 1 has no time");
        }
      } else if (row.path("failed").asInt() > 0) {
        put(seconds[count - 1]); // a gap
      }
      put(now);
      for (Map.Entry<String, JsonNode> value : row.path("values").properties()) {
        addLeaves(value.getKey(), value.getValue());
      }
    }

    private void put(double time) throws CommandException {
      if (count == seconds.length) {
        checkSize(2L * count, columns.size());
        seconds = Arrays.copyOf(seconds, 2 * count);
        columns.replaceAll((name, values) -> grown(values, seconds.length));
      }
      seconds[count++] = time;
    }

    private static double[] grown(double[] values, int length) {
      double[] result = Arrays.copyOf(values, length);
      Arrays.fill(result, values.length, length, Double.NaN);
      return result;
    }

    /** Adds the numbers of a value, by the names of the columns in CSV. */
    private void addLeaves(String name, JsonNode value) throws CommandException {
      if (value.isObject()) {
        for (Map.Entry<String, JsonNode> field : value.properties()) {
          addLeaves(name + "." + field.getKey(), field.getValue());
        }
      } else if (value.isArray()) {
        String open = name.substring(0, name.length() - (name.endsWith("]") ? 1 : 0));
        for (int i = 0; i < value.size(); i++) {
          addLeaves(open + (i + 1) + "]", value.get(i));
        }
      } else if (value.isNumber() || value.isBoolean()) {
        if (!columns.containsKey(name)) {
          checkSize(seconds.length, columns.size() + 1L);
        }
        columns.computeIfAbsent(name, it -> grown(new double[0], seconds.length))[count - 1] =
            value.isNumber() ? value.doubleValue() : value.booleanValue() ? 1 : 0;
      } else {
        texts.put(name, true);
      }
    }

    ReplayColumns columns(Path file) throws CommandException {
      if (count == 0) {
        throw new CommandException(file.getFileName() + " has no row");
      }
      columns.keySet().removeAll(texts.keySet());
      columns.replaceAll((name, values) -> Arrays.copyOf(values, count));
      return new ReplayColumns(
          start, Arrays.copyOf(seconds, count), columns, List.copyOf(texts.keySet()));
    }
  }

  /**
   * Returns an INT with the length of a text, the text in JSON with blanks at its end, and then, at
   * a multiple of 8 bytes, the seconds and each column as numbers of 8 bytes, the least significant
   * one first.
   */
  ByteBuffer bytes() {
    ObjectNode head = Json.object().put("start", start.toEpochMilli()).put("rows", seconds.length);
    Units units = new Units();
    ArrayNode list = head.putArray("columns");
    columns
        .keySet()
        .forEach(name -> list.addObject().put("name", name).put("unit", units.of(name)));
    texts.forEach(head.putArray("texts")::add);
    byte[] text = head.toString().getBytes(StandardCharsets.UTF_8);
    int length = (text.length + 4 + 7) / 8 * 8 - 4;
    ByteBuffer result =
        ByteBuffer.allocate(4 + length + 8 * seconds.length * (columns.size() + 1))
            .order(ByteOrder.LITTLE_ENDIAN)
            .putInt(length)
            .put(Arrays.copyOf((head + " ".repeat(8)).getBytes(StandardCharsets.UTF_8), length));
    put(result, seconds);
    columns.values().forEach(values -> put(result, values));
    return result.flip().order(ByteOrder.BIG_ENDIAN);
  }

  private static void put(ByteBuffer buffer, double[] values) {
    for (double value : values) {
      buffer.putDouble(value);
    }
  }
}
