package no.hials.crosscom.cli.lab;

import com.fasterxml.jackson.core.JsonGenerator;
import java.io.IOException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import no.hials.crosscom.cell.JsonLine;
import no.hials.crosscom.cell.Printable;
import no.hials.crosscom.cell.TimeText;
import no.hials.crosscom.cli.base.Console;
import no.hials.crosscom.cli.base.Table;
import no.hials.crosscom.lab.bench.Bench;
import no.hials.crosscom.lab.bench.BenchAccess;
import no.hials.crosscom.lab.bench.BenchTally;
import no.hials.crosscom.lab.plot.Chart;
import no.hials.crosscom.lab.plot.Panel;
import no.hials.crosscom.lab.plot.Quantity;
import no.hials.crosscom.lab.plot.Series;
import org.HdrHistogram.Histogram;

/** Reports the results of {@code bench} as a table, as JSON or as a chart. */
final class BenchReport {
  private static final double[] PERCENTILES = {50, 90, 99, 99.9};
  private static final int BINS_OF_CHART = 80;
  private static final int BINS_OF_TEXT = 16;
  private static final int BAR = 50;
  private static final double NANOS_PER_MILLI = 1e6;

  private final Bench.BenchPlan plan;
  private final Bench.Result result;
  private final Map<String, Double> serverMillis;

  /**
   * Creates a report.
   *
   * @param serverMillis the mean time of a read on the server itself, by the variable's name; empty
   *     if the server does not measure it
   */
  BenchReport(Bench.BenchPlan plan, Bench.Result result, Map<String, Double> serverMillis) {
    this.plan = plan;
    this.result = result;
    this.serverMillis = serverMillis;
  }

  // the table

  /** Prints a line for each access, and the totals. */
  void printTable(Console console) {
    Table table = Table.withTitles(titles());
    for (int i = 0; i < plan.accesses().size(); i++) {
      table.add(row(plan.accesses().get(i), result.tallies().get(i)));
    }
    table.print(console);
    console.print("");
    console.print(summary());
  }

  private String[] titles() {
    List<String> cells = new ArrayList<>(List.of("ACCESS", "TYPE", "BYTES", "COUNT", "FAILED"));
    cells.addAll(List.of("MIN", "50 %", "90 %", "99 %", "99.9 %", "MAX", "MEAN"));
    if (!serverMillis.isEmpty()) {
      cells.add("SERVER");
    }
    return cells.toArray(String[]::new);
  }

  private String[] row(BenchAccess access, BenchTally tally) {
    Histogram times = tally.times();
    List<String> cells = new ArrayList<>();
    cells.add(access.label());
    cells.add(access.type());
    cells.add(Integer.toString(access.bytes()));
    cells.add(Long.toString(times.getTotalCount()));
    cells.add(Long.toString(tally.failureCount()));
    boolean any = times.getTotalCount() > 0;
    cells.add(any ? millis(times.getMinValue()) : Table.NOTHING);
    for (double percentile : PERCENTILES) {
      cells.add(any ? millis(times.getValueAtPercentile(percentile)) : Table.NOTHING);
    }
    cells.add(any ? millis(times.getMaxValue()) : Table.NOTHING);
    cells.add(any ? millis(times.getMean()) : Table.NOTHING);
    if (!serverMillis.isEmpty()) {
      OptionalDouble server = server(access);
      cells.add(server.isPresent() ? decimal(server.getAsDouble()) : Table.NOTHING);
    }
    return cells.toArray(String[]::new);
  }

  private OptionalDouble server(BenchAccess access) {
    Double millis = access.write() ? null : serverMillis.get(access.name());
    return millis == null ? OptionalDouble.empty() : OptionalDouble.of(millis);
  }

  private String summary() {
    return "times in ms; "
        + Printable.count(plan.clients(), "client")
        + ", closed loop; "
        + accesses()
        + " accesses in "
        + decimal(result.duration().toNanos() / 1e9)
        + " s, "
        + String.format(Locale.ROOT, "%.0f", rate())
        + "/s; "
        + plan.warmUp()
        + " rounds before to warm up";
  }

  private long accesses() {
    return result.tallies().stream().mapToLong(tally -> tally.times().getTotalCount()).sum();
  }

  /** Returns the number of answered accesses per second of all clients. */
  private double rate() {
    return accesses() / Math.max(1e-9, result.duration().toNanos() / 1e9);
  }

  /** Returns a line for each access that failed, with its failures by kind. */
  List<String> failures() {
    List<String> lines = new ArrayList<>();
    for (int i = 0; i < plan.accesses().size(); i++) {
      Map<String, Long> failures = result.tallies().get(i).failures();
      if (!failures.isEmpty()) {
        lines.add(
            plan.accesses().get(i).label()
                + " failed: "
                + failures.entrySet().stream()
                    .map(entry -> entry.getKey() + " " + entry.getValue())
                    .collect(Collectors.joining(", ")));
      }
    }
    return lines;
  }

  // histograms

  /** Returns a histogram of each access as lines of text. */
  List<String> histograms() {
    Bins bins = bins(BINS_OF_TEXT);
    List<String> lines = new ArrayList<>();
    for (int i = 0; i < plan.accesses().size(); i++) {
      lines.add("");
      lines.add(plan.accesses().get(i).label() + " [ms]");
      long[] counts = bins.counts(result.tallies().get(i).times());
      long most = Math.max(1, Arrays.stream(counts).max().orElse(1));
      for (int bin = 0; bin <= bins.count; bin++) {
        if (counts[bin] > 0) {
          String from = decimal(bins.start(bin));
          String to = bin == bins.count ? " and more" : " - " + decimal(bins.start(bin + 1));
          int bar = (int) Math.ceil((double) counts[bin] * BAR / most);
          lines.add(
              String.format(Locale.ROOT, "%9s%-12s %8d ", from, to, counts[bin]) + "#".repeat(bar));
        }
      }
    }
    return lines;
  }

  /** Creates a chart: a histogram for each access, one below the other. */
  Chart chart(String title) {
    Bins bins = bins(BINS_OF_CHART);
    List<Panel> panels = new ArrayList<>();
    for (int i = 0; i < plan.accesses().size(); i++) {
      panels.add(panel(bins, plan.accesses().get(i), result.tallies().get(i).times()));
    }
    return Chart.stacked(title, panels);
  }

  /** Creates a chart whose texts are longer than those of any result of these accesses. */
  static Chart largestChart(List<BenchAccess> accesses) {
    String count = "1000000000";
    List<Series> series =
        Stream.of(shown(count, count), "50 %: " + count + " ms", "99 %: " + count + " ms")
            .map(name -> Series.histogram(name, 0, 1, 0))
            .toList();
    return Chart.stacked(
        "Access times", accesses.stream().map(access -> panel(access, series)).toList());
  }

  private Panel panel(Bins bins, BenchAccess access, Histogram times) {
    long[] counts = bins.counts(times);
    long beyond = counts[bins.count];
    long most = 1;
    long[] shown = new long[bins.count];
    for (int i = 0; i < bins.count; i++) {
      shown[i] = counts[i];
      most = Math.max(most, counts[i]);
    }
    String total = String.valueOf(times.getTotalCount());
    String name = shown(total, beyond == 0 ? "" : String.valueOf(beyond));
    List<Series> series = new ArrayList<>();
    series.add(Series.histogram(name, bins.start(0), bins.width, shown));
    if (times.getTotalCount() > 0) {
      double median = times.getValueAtPercentile(50) / NANOS_PER_MILLI;
      double high = times.getValueAtPercentile(99) / NANOS_PER_MILLI;
      series.add(upright("50 %: " + decimal(median) + " ms", bins, median, most));
      series.add(upright("99 %: " + decimal(high) + " ms", bins, high, most));
    }
    return panel(access, series);
  }

  private static String shown(String total, String beyond) {
    return total
        + " accesses"
        + (beyond.isEmpty() ? "" : ", " + beyond + " of them beyond the axis");
  }

  private static Panel panel(BenchAccess access, List<Series> series) {
    String title =
        access.label()
            + " ("
            + access.type()
            + ", "
            + Printable.count(access.bytes(), "byte")
            + ")";
    return Panel.of(
        title,
        new Quantity("access time", "ms"),
        new Quantity("accesses", ""),
        Panel.Scale.FREE,
        series);
  }

  /** Creates a vertical line; only its name if it is beyond the axis. */
  private static Series upright(String name, Bins bins, double at, long height) {
    double x = at < bins.start(bins.count) ? at : Double.NaN;
    return Series.of(
        name, Series.Style.GUIDE, new double[] {x, x}, new double[] {0, 1.05 * height});
  }

  /** The bins of a histogram in ms: {@code count} bins, and one for all longer times. */
  private record Bins(double first, double width, int count) {
    double start(int bin) {
      return first + bin * width;
    }

    long[] counts(Histogram times) {
      long[] counts = new long[count + 1];
      times
          .recordedValues()
          .forEach(
              value -> {
                double millis = value.getValueIteratedTo() / NANOS_PER_MILLI;
                int bin = (int) Math.floor((millis - first) / width);
                counts[Math.max(0, Math.min(count, bin))] += value.getCountAtValueIteratedTo();
              });
      return counts;
    }
  }

  /** Chooses bins for all accesses: from the shortest time to somewhat above 99 % of them. */
  private Bins bins(int atMost) {
    Histogram all = new Histogram(100, 1_000_000, 3);
    all.setAutoResize(true);
    result.tallies().forEach(tally -> all.add(tally.times()));
    if (all.getTotalCount() == 0) {
      return new Bins(0, 1, 1);
    }
    double low = all.getMinValue() / NANOS_PER_MILLI;
    double high = low + 1.3 * (all.getValueAtPercentile(99) / NANOS_PER_MILLI - low);
    double step = step((high - low) / atMost);
    double first = Math.floor(low / step) * step;
    int count = (int) Math.max(1, Math.ceil((high - first) / step + 1e-9));
    return new Bins(first, step, count);
  }

  /**
   * Returns the next higher of 1, 2 and 5 and their products with powers of ten; at least 100 ns.
   */
  private static double step(double least) {
    double power = Math.pow(10, Math.floor(Math.log10(Math.max(least, 1e-4))));
    for (double factor : new double[] {1, 2, 5}) {
      if (factor * power >= least) {
        return factor * power;
      }
    }
    return 10 * power;
  }

  // JSON

  /** Returns a line for each access. */
  List<String> json() {
    List<String> lines = new ArrayList<>();
    for (int i = 0; i < plan.accesses().size(); i++) {
      BenchAccess access = plan.accesses().get(i);
      BenchTally tally = result.tallies().get(i);
      lines.add(JsonLine.object(json -> write(json, access, tally)));
    }
    return lines;
  }

  private void write(JsonGenerator json, BenchAccess access, BenchTally tally) throws IOException {
    Histogram times = tally.times();
    json.writeStringField("access", access.verb());
    json.writeStringField("name", access.name());
    json.writeStringField("type", access.type());
    json.writeNumberField("bytes", access.bytes());
    json.writeNumberField("clients", plan.clients());
    json.writeNumberField("seconds", Double.parseDouble(TimeText.seconds(result.duration())));
    json.writeNumberField("count", times.getTotalCount());
    json.writeObjectFieldStart("failed");
    for (Map.Entry<String, Long> failure : tally.failures().entrySet()) {
      json.writeNumberField(failure.getKey(), failure.getValue());
    }
    json.writeEndObject();
    if (times.getTotalCount() > 0) {
      writeMillis(json, "min_ms", millis(times.getMinValue()));
      for (double percentile : PERCENTILES) {
        String name = "p" + (percentile % 1 == 0 ? "" + (int) percentile : "" + percentile);
        writeMillis(json, name + "_ms", millis(times.getValueAtPercentile(percentile)));
      }
      writeMillis(json, "max_ms", millis(times.getMaxValue()));
      writeMillis(json, "mean_ms", millis(times.getMean()));
    }
    OptionalDouble server = server(access);
    if (server.isPresent()) {
      writeMillis(json, "server_ms", decimal(server.getAsDouble()));
    }
  }

  private static void writeMillis(JsonGenerator json, String name, String millis)
      throws IOException {
    json.writeFieldName(name);
    json.writeNumber(millis);
  }

  private static String millis(long nanos) {
    return millis((double) nanos);
  }

  private static String millis(double nanos) {
    return decimal(nanos / NANOS_PER_MILLI);
  }

  private static String decimal(double millis) {
    return String.format(Locale.ROOT, "%.3f", millis);
  }
}
