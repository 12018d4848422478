package no.hials.crosscom.control;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;

/**
 * The last cycles of a loop: their times, the times of the accesses, and the desired and actual
 * positions. Thread-safe, even while the loop runs.
 */
public final class Trace {
  private static final int COORDINATES = 6;
  private static final int FIRST_COORDINATE = 5;
  private static final int COLUMNS = FIRST_COORDINATE + 3 * COORDINATES;

  private final List<String> names;
  private final int length;
  private final double[] rows;

  /** The number of rows added so far. */
  private long count;

  Trace(List<String> names, int length) {
    this.names = names;
    this.length = length;
    this.rows = new double[length * COLUMNS];
  }

  /**
   * A cycle.
   *
   * @param time its start, s from the start of the loop
   * @param period the time since the start of the previous cycle, ms; 0 for the first
   * @param read the time to read, ms
   * @param write the time to write, ms
   * @param moving whether the law was called; false while the robot stood still without the
   *     dead-man
   * @param desired the desired position of the law: X, Y, Z, A, B, C or A1 to A6
   * @param sent the written values, in the same order
   * @param actual the position read, in the same order
   */
  public record Cycle(
      double time,
      double period,
      double read,
      double write,
      boolean moving,
      List<Double> desired,
      List<Double> sent,
      List<Double> actual) {
    /** Copies the lists. */
    public Cycle {
      desired = List.copyOf(desired);
      sent = List.copyOf(sent);
      actual = List.copyOf(actual);
    }
  }

  synchronized void add(
      double time,
      double period,
      double read,
      double write,
      boolean moving,
      double[] desired,
      double[] sent,
      double[] actual) {
    if (length == 0) {
      return;
    }
    int at = (int) (count % length) * COLUMNS;
    rows[at] = time;
    rows[at + 1] = period;
    rows[at + 2] = read;
    rows[at + 3] = write;
    rows[at + 4] = moving ? 1 : 0;
    System.arraycopy(desired, 0, rows, at + FIRST_COORDINATE, COORDINATES);
    System.arraycopy(sent, 0, rows, at + FIRST_COORDINATE + COORDINATES, COORDINATES);
    System.arraycopy(actual, 0, rows, at + FIRST_COORDINATE + 2 * COORDINATES, COORDINATES);
    count++;
  }

  /** Returns a copy of the last cycles, the oldest first. */
  public List<Cycle> cycles() {
    List<Cycle> cycles = new ArrayList<>();
    double[] row = new double[COLUMNS];
    for (long next = copy(0, row); next > 0; next = copy(next, row)) {
      cycles.add(cycle(row));
    }
    return cycles;
  }

  /** Returns the last cycle; empty before the first cycle, or if no cycles are kept. */
  public Optional<Cycle> last() {
    double[] row = new double[COLUMNS];
    synchronized (this) {
      if (length == 0 || count == 0) {
        return Optional.empty();
      }
      copy(count - 1, row);
    }
    return Optional.of(cycle(row));
  }

  private static Cycle cycle(double[] row) {
    return new Cycle(
        row[0], row[1], row[2], row[3], row[4] != 0, six(row, 0), six(row, 1), six(row, 2));
  }

  private static List<Double> six(double[] row, int group) {
    List<Double> six = new ArrayList<>();
    for (int i = 0; i < COORDINATES; i++) {
      six.add(row[FIRST_COORDINATE + group * COORDINATES + i]);
    }
    return six;
  }

  /**
   * Copies a row, or the oldest row if that row has been overwritten.
   *
   * @return the index of the next row; 0 if the row does not exist yet
   */
  private synchronized long copy(long index, double[] row) {
    long present = Math.max(index, count - length);
    if (present >= count) {
      return 0;
    }
    System.arraycopy(rows, (int) (present % length) * COLUMNS, row, 0, COLUMNS);
    return present + 1;
  }

  /**
   * Writes the last cycles, one per line after a line of names.
   *
   * @param csv the destination; neither flushed nor closed
   * @throws IOException if writing failed
   */
  public void writeCsv(Appendable csv) throws IOException {
    csv.append("time_s,period_ms,read_ms,write_ms,moving");
    for (String group : List.of("desired", "sent", "actual")) {
      for (String name : names) {
        csv.append(',').append(group).append('_').append(name);
      }
    }
    csv.append('\n');
    for (Cycle cycle : cycles()) {
      csv.append(String.format(Locale.ROOT, "%.4f", cycle.time()));
      number(csv, "%.3f", cycle.period());
      number(csv, "%.3f", cycle.read());
      number(csv, "%.3f", cycle.write());
      csv.append(cycle.moving() ? ",1" : ",0");
      for (List<Double> six : List.of(cycle.desired(), cycle.sent(), cycle.actual())) {
        for (double value : six) {
          number(csv, "%.5f", value);
        }
      }
      csv.append('\n');
    }
  }

  private static void number(Appendable csv, String format, double value) throws IOException {
    csv.append(',').append(String.format(Locale.ROOT, format, value));
  }
}
