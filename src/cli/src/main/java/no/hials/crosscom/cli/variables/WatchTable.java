package no.hials.crosscom.cli.variables;

import java.math.BigDecimal;
import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import no.hials.crosscom.ConnectionEvent;
import no.hials.crosscom.CrossComException;
import no.hials.crosscom.Sample;
import no.hials.crosscom.Sample.Reading;
import no.hials.crosscom.cell.Leaf;
import no.hials.crosscom.cell.SampledRobot;
import no.hials.crosscom.cell.TimeText;
import no.hials.crosscom.protocol.value.KrlInt;
import no.hials.crosscom.protocol.value.KrlReal;
import no.hials.crosscom.protocol.value.KrlValue;
import no.hials.crosscom.protocol.value.PrintableText;
import org.jline.utils.AttributedString;
import org.jline.utils.AttributedStringBuilder;
import org.jline.utils.AttributedStyle;
import org.jspecify.annotations.Nullable;

/**
 * The table of {@code watch} on a terminal: a row for each number or text, and a summary. Rows of a
 * robot without a connection are dim and have no age, and the first line has the reason.
 */
final class WatchTable {
  private static final String GAP = "  ";

  private static final int AGE_WIDTH = "9999.9 s".length();

  /** How long a change is marked. */
  private static final Duration FRESH = Duration.ofSeconds(1);

  private static final AttributedStyle PLAIN = AttributedStyle.DEFAULT;
  private static final AttributedStyle TITLE = PLAIN.bold();
  private static final AttributedStyle CHANGED = PLAIN.foreground(AttributedStyle.GREEN).bold();
  private static final AttributedStyle OLD = PLAIN.faint();
  private static final AttributedStyle BAD = PLAIN.foreground(AttributedStyle.RED);

  private final List<SampledRobot> robots;
  private final Map<SampledRobot, ConnectionEvent> losses = new HashMap<>();

  /** The rows of each variable of each robot, in the order of the command line. */
  private final Map<String, Map<String, Row>> variables = new LinkedHashMap<>();

  private final Map<String, SampledRobot> owners = new HashMap<>();

  // columns that became narrower would jump
  private int nameWidth = "NAME".length();
  private int valueWidth = "VALUE".length();
  private int changeWidth = "CHANGE".length();

  /** One number or text, and how it changed last. */
  private static final class Row {
    final String name;
    final boolean failed;
    @Nullable KrlValue value;
    String text;
    String change = "";
    Instant since;

    Row(String name, @Nullable KrlValue value, String text, Instant since) {
      this.name = PrintableText.of(name);
      this.failed = value == null;
      this.value = value;
      this.text = text;
      this.since = since;
    }

    void set(Leaf leaf, Instant time) {
      KrlValue now = leaf.value();
      if (now.equals(value)) {
        return;
      }
      change = change(value, text, now);
      value = now;
      text = PrintableText.of(leaf.text());
      since = time;
    }

    private static String change(@Nullable KrlValue before, String textBefore, KrlValue now) {
      if (before != null && isNumber(before) && isNumber(now)) {
        // from the controller's digits, since the digits of a float would show its rounding
        BigDecimal change = new BigDecimal(now.print()).subtract(new BigDecimal(before.print()));
        return (change.signum() > 0 ? "+" : "") + change.toPlainString();
      }
      return "from " + textBefore;
    }

    boolean isFresh(Instant now) {
      return !change.isEmpty() && Duration.between(since, now).compareTo(FRESH) < 0;
    }
  }

  /**
   * Creates a table without rows.
   *
   * @param robots were read once
   */
  WatchTable(List<SampledRobot> robots) {
    this.robots = robots;
    for (SampledRobot robot : robots) {
      for (String name : robot.first().keySet()) {
        variables.put(robot.qualified(name), new LinkedHashMap<>());
        owners.put(robot.qualified(name), robot);
      }
    }
  }

  private static boolean isNumber(KrlValue value) {
    return value instanceof KrlInt || value instanceof KrlReal;
  }

  /** Called when a sample arrives. */
  void add(SampledRobot robot, Sample sample) {
    for (Map.Entry<String, Reading> entry : sample.readings().entrySet()) {
      String name = robot.qualified(entry.getKey());
      variables.compute(
          name,
          (key, before) ->
              rows(name, entry.getValue(), before == null ? Map.of() : before, sample.time()));
    }
  }

  private Map<String, Row> rows(
      String name, Reading reading, Map<String, Row> before, Instant time) {
    Map<String, Row> rows = new LinkedHashMap<>();
    CrossComException failure = reading.failure();
    KrlValue value = reading.value();
    if (failure != null) {
      String text = PrintableText.of(String.valueOf(failure.getMessage()));
      Row row = before.get(name);
      rows.put(
          name,
          row != null && row.failed && row.text.equals(text)
              ? row
              : new Row(name, null, text, time));
    }
    if (value != null) {
      for (Leaf leaf : Leaf.of(name, value)) {
        Row row = before.get(leaf.name());
        if (row == null || row.failed) {
          row = new Row(leaf.name(), leaf.value(), PrintableText.of(leaf.text()), time);
        } else {
          row.set(leaf, time);
        }
        rows.put(leaf.name(), row);
      }
    }
    return rows;
  }

  /** Called when a connection is lost or restored. */
  void connectionChanged(SampledRobot robot, ConnectionEvent event) {
    losses.put(robot, event);
  }

  /** Returns all lines as they are now, however wide, without colours. */
  List<String> text() {
    return lines(Integer.MAX_VALUE, Integer.MAX_VALUE, false).stream()
        .map(AttributedString::toString)
        .toList();
  }

  /** Returns the lines that fit, cut off at the width. */
  List<AttributedString> lines(int columns, int rows, boolean colours) {
    Instant now = Instant.now();
    List<AttributedString> footer = footer();
    List<AttributedString> table = table(now);
    int room = Math.max(1, rows - footer.size());
    Stream<AttributedString> shown = table.stream();
    if (table.size() > room) {
      String rest = "... " + (table.size() - room + 1) + " more";
      shown = Stream.concat(table.stream().limit(room - 1L), Stream.of(new AttributedString(rest)));
    }
    return Stream.concat(shown, footer.stream())
        .limit(rows)
        .map(line -> fit(line, columns, colours))
        .toList();
  }

  private static AttributedString fit(AttributedString line, int columns, boolean colours) {
    AttributedString fitting = line.columnSubSequence(0, columns);
    return colours ? fitting : new AttributedString(fitting.toString());
  }

  private List<AttributedString> table(Instant now) {
    List<Row> rows = variables.values().stream().flatMap(part -> part.values().stream()).toList();
    for (Row row : rows) {
      nameWidth = Math.max(nameWidth, row.name.length());
      if (!row.failed) {
        valueWidth = Math.max(valueWidth, row.text.length());
        changeWidth = Math.max(changeWidth, row.change.length());
      }
    }
    List<AttributedString> lines = new ArrayList<>();
    for (SampledRobot robot : robots) {
      ConnectionEvent loss = lossOf(robot);
      if (loss != null) {
        String since = "not connected since " + TimeText.instant(loss.time()) + ": ";
        String text = robot.label() + since + SampledRobot.text(loss);
        lines.add(new AttributedString(PrintableText.of(text), BAD));
      }
    }
    lines.add(
        new AttributedString(
            left("NAME", nameWidth)
                + GAP
                + right("VALUE", valueWidth)
                + GAP
                + right("CHANGE", changeWidth)
                + GAP
                + right("AGE", AGE_WIDTH),
            TITLE));
    variables.forEach(
        (name, part) -> {
          SampledRobot owner = owners.get(name);
          boolean isOld = owner != null && lossOf(owner) != null;
          part.values().forEach(row -> lines.add(isOld ? oldLine(row) : line(row, now)));
        });
    return lines;
  }

  /** Returns the event if the connection is lost now. */
  private @Nullable ConnectionEvent lossOf(SampledRobot robot) {
    return robot.isLost() ? losses.get(robot) : null;
  }

  /** Returns a row whose value was read before the connection was lost. */
  private AttributedString oldLine(Row row) {
    String value = row.failed ? row.text : right(row.text, valueWidth);
    String change = right(row.failed ? "" : row.change, changeWidth);
    return new AttributedString(
        left(row.name, nameWidth) + GAP + value + GAP + change + GAP + right("lost", AGE_WIDTH),
        OLD);
  }

  private AttributedString line(Row row, Instant now) {
    AttributedStringBuilder line = new AttributedStringBuilder();
    line.append(left(row.name, nameWidth)).append(GAP);
    if (row.failed) {
      return line.append(row.text, BAD).toAttributedString();
    }
    AttributedStyle style = row.isFresh(now) ? CHANGED : PLAIN;
    return line.append(right(row.text, valueWidth), style)
        .append(GAP)
        .append(right(row.change, changeWidth), style)
        .append(GAP)
        .append(right(age(Duration.between(row.since, now)), AGE_WIDTH))
        .toAttributedString();
  }

  private static String age(Duration age) {
    return TimeText.roughSeconds(age) + " s";
  }

  private static String left(String text, int width) {
    return text + " ".repeat(Math.max(0, width - text.length()));
  }

  private static String right(String text, int width) {
    return " ".repeat(Math.max(0, width - text.length())) + text;
  }

  private List<AttributedString> footer() {
    List<AttributedString> lines = new ArrayList<>();
    lines.add(AttributedString.EMPTY);
    for (SampledRobot robot : robots) {
      lines.add(new AttributedString(robot.label() + robot.summary()));
    }
    return lines;
  }
}
