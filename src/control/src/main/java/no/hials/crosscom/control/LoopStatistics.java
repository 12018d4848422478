package no.hials.crosscom.control;

import java.io.IOException;
import java.util.List;
import java.util.Locale;

/** The measurements of a loop so far. */
public final class LoopStatistics {
  private final long cycles;
  private final long holding;
  private final long missed;
  private final long missedByAccess;
  private final long saturated;
  private final Times period;
  private final Times late;
  private final Times read;
  private final Times write;
  private final Times own;
  private final List<TrackingError> errors;

  LoopStatistics(
      long cycles,
      long holding,
      long missed,
      long missedByAccess,
      long saturated,
      Times period,
      Times late,
      Times read,
      Times write,
      Times own,
      List<TrackingError> errors) {
    this.cycles = cycles;
    this.holding = holding;
    this.missed = missed;
    this.missedByAccess = missedByAccess;
    this.saturated = saturated;
    this.period = period;
    this.late = late;
    this.read = read;
    this.write = write;
    this.own = own;
    this.errors = List.copyOf(errors);
  }

  /** Returns the number of started cycles. */
  public long cycles() {
    return cycles;
  }

  /** Returns the cycles in which the robot stood still without the dead-man. */
  public long holding() {
    return holding;
  }

  /** Returns the number of cycles skipped because the previous cycle took too long. */
  public long missed() {
    return missed;
  }

  /**
   * Returns the missed cycles for which the accesses to the controller alone took longer than a
   * period; the other cycles were missed because of the law, or because of the computer, which
   * {@link #late} shows.
   */
  public long missedByAccess() {
    return missedByAccess;
  }

  /** Returns the cycles in which an increment was cut to the step limit. */
  public long saturated() {
    return saturated;
  }

  /** Returns the time between the starts of cycles, including missed cycles. */
  public Times period() {
    return period;
  }

  /**
   * Returns the delay of the start of a cycle: the time that the computer took to wake the thread.
   */
  public Times late() {
    return late;
  }

  /** Returns the time to read the position of the robot. */
  public Times read() {
    return read;
  }

  /** Returns the time to write the command. */
  public Times write() {
    return write;
  }

  /** Returns the time of the law and the rest of a cycle. */
  public Times own() {
    return own;
  }

  /** Returns the distance of the robot from the previous target, for each quantity of the law. */
  public List<TrackingError> errors() {
    return errors;
  }

  /**
   * Statistics of a kind of time, in ms.
   *
   * @param count the number of times; if it is 0, the others are 0
   * @param minimum the shortest time
   * @param mean the mean
   * @param median the median, to 0.01 ms
   * @param percentile99 the 99th percentile, to 0.01 ms
   * @param maximum the longest time
   */
  public record Times(
      long count,
      double minimum,
      double mean,
      double median,
      double percentile99,
      double maximum) {}

  /**
   * The tracking error of a quantity.
   *
   * @param quantity the quantity: {@code path} and {@code rotation}, or {@code A1} to {@code A6}
   * @param unit mm or degrees
   * @param rootMeanSquare the root mean square
   * @param maximum the largest error
   */
  public record TrackingError(
      String quantity, String unit, double rootMeanSquare, double maximum) {}

  /**
   * Writes the numbers as lines of {@code name,value}, times in ms.
   *
   * @param csv the destination; neither flushed nor closed
   * @throws IOException if writing failed
   */
  public void writeCsv(Appendable csv) throws IOException {
    csv.append("name,value\n");
    line(csv, "cycles", cycles);
    line(csv, "holding", holding);
    line(csv, "missed", missed);
    line(csv, "missed_by_access", missedByAccess);
    line(csv, "saturated", saturated);
    lines(csv, "period", period);
    lines(csv, "late", late);
    lines(csv, "read", read);
    lines(csv, "write", write);
    lines(csv, "own", own);
    for (TrackingError error : errors) {
      String name = "error_" + error.quantity().toLowerCase(Locale.ROOT) + "_";
      line(csv, name + "rms", error.rootMeanSquare());
      line(csv, name + "max", error.maximum());
    }
  }

  private static void lines(Appendable csv, String name, Times times) throws IOException {
    line(csv, name + "_min_ms", times.minimum());
    line(csv, name + "_mean_ms", times.mean());
    line(csv, name + "_median_ms", times.median());
    line(csv, name + "_p99_ms", times.percentile99());
    line(csv, name + "_max_ms", times.maximum());
  }

  private static void line(Appendable csv, String name, long value) throws IOException {
    csv.append(name).append(',').append(Long.toString(value)).append('\n');
  }

  private static void line(Appendable csv, String name, double value) throws IOException {
    csv.append(name).append(',').append(String.format(Locale.ROOT, "%.4f", value)).append('\n');
  }
}
