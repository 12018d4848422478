package no.hials.crosscom.control;

import java.io.IOException;
import java.util.List;
import java.util.Locale;

/**
 * What a loop has measured so far.
 *
 * @param cycles the cycles that were begun
 * @param holding those of them in which the robot had to stand because of the dead-man
 * @param missed the cycles that were left out, because the one before took too long
 * @param missedByAccess those of them that were missed since the accesses to the controller alone
 *     took longer than a period; the others are the law's, or the computer's, which {@code late}
 *     shows
 * @param saturated the cycles in which an increment was cut to the step limit
 * @param period from the begin of one cycle to that of the next; missed cycles make it longer
 * @param late how long after its time a cycle began: what the computer took to wake the thread
 * @param read how long reading where the robot is took
 * @param write how long writing the command took
 * @param own how long the law and all the rest of a cycle took
 * @param errors how far the robot was from the target before, for each quantity of the law
 */
public record LoopStatistics(
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

  /** Makes the list unmodifiable. */
  public LoopStatistics {
    errors = List.copyOf(errors);
  }

  /**
   * Times of one kind, in ms.
   *
   * @param count how many there are; without any the others are 0
   * @param least the shortest
   * @param mean their mean
   * @param median what half of them do not exceed, to 0.01 ms
   * @param percentile99 what 99 of 100 do not exceed, to 0.01 ms
   * @param most the longest
   */
  public record Times(
      long count, double least, double mean, double median, double percentile99, double most) {}

  /**
   * How far the robot was from its target.
   *
   * @param quantity what was measured: {@code path} and {@code rotation}, or {@code A1} to {@code
   *     A6}
   * @param unit mm or degrees
   * @param rootMeanSquare the root of the mean of the squares
   * @param most the largest
   */
  public record TrackingError(String quantity, String unit, double rootMeanSquare, double most) {}

  /**
   * Writes the numbers as lines of {@code name,value}, times in ms.
   *
   * @param csv where to; it is neither flushed nor closed
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
      line(csv, name + "max", error.most());
    }
  }

  private static void lines(Appendable csv, String name, Times times) throws IOException {
    line(csv, name + "_min_ms", times.least());
    line(csv, name + "_mean_ms", times.mean());
    line(csv, name + "_median_ms", times.median());
    line(csv, name + "_p99_ms", times.percentile99());
    line(csv, name + "_max_ms", times.most());
  }

  private static void line(Appendable csv, String name, long value) throws IOException {
    csv.append(name).append(',').append(Long.toString(value)).append('\n');
  }

  private static void line(Appendable csv, String name, double value) throws IOException {
    csv.append(name).append(',').append(String.format(Locale.ROOT, "%.4f", value)).append('\n');
  }
}
