package no.hials.crosscom.control;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;

/**
 * The last cycles of a loop: when they were, how long the accesses took, and where the robot was to
 * be and was. It can be looked at while the loop runs, by any thread.
 */
public final class Trace {
  private static final int COORDINATES = 6;
  private static final int FIRST_COORDINATE = 5;
  private static final int COLUMNS = FIRST_COORDINATE + 3 * COORDINATES;

  private final List<String> names;
  private final int length;
  private final double[] rows;

  /** The rows that were ever added. */
  private long count;

  Trace(List<String> names, int length) {
    this.names = names;
    this.length = length;
    this.rows = new double[length * COLUMNS];
  }

  /**
   * One cycle.
   *
   * @param time when it began, s from the start of the loop
   * @param period from the begin of the cycle before, ms; 0 for the first
   * @param read how long reading took, ms
   * @param write how long writing took, ms
   * @param moving whether the law was asked; false while the dead-man let the robot stand
   * @param desired where the law wanted the robot to be: X, Y, Z, A, B, C or A1 to A6
   * @param sent what was written, in the same order
   * @param actual where the robot was when it was read, in the same order
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
    /** Makes the lists unmodifiable. */
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

  /**
   * Gives the cycles that are kept.
   *
   * @return the last ones, the oldest first; a copy
   */
  public List<Cycle> cycles() {
    List<Cycle> cycles = new ArrayList<>();
    double[] row = new double[COLUMNS];
    for (long next = copy(0, row); next > 0; next = copy(next, row)) {
      cycles.add(cycle(row));
    }
    return cycles;
  }

  /**
   * Gives the last cycle.
   *
   * @return it; nothing if there was none, or none is kept
   */
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
   * Copies a row, or the oldest one if it was overwritten meanwhile.
   *
   * @return the index of the row behind it; 0 if there is no such row yet
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
   * Writes the cycles that are kept, one a line below a line of names.
   *
   * @param csv where to; it is neither flushed nor closed
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
