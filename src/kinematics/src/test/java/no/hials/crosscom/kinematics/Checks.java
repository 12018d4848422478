package no.hials.crosscom.kinematics;

import no.hials.crosscom.protocol.value.Axis;
import no.hials.crosscom.protocol.value.Frame;
import org.junit.jupiter.params.aggregator.ArgumentsAccessor;

/** Shared by several tests: rows of a table, and differences of angles. */
final class Checks {

  private Checks() {}

  static Axis axes(ArgumentsAccessor row, int first) {
    return Axis.of(six(row, first));
  }

  static Frame frame(ArgumentsAccessor row, int first) {
    double[] six = six(row, first);
    return new Frame(six[0], six[1], six[2], six[3], six[4], six[5]);
  }

  /** Returns the angle between two directions; 180 and -180 are the same. */
  static double turnBetween(double one, double other) {
    return Math.abs(Math.IEEEremainder(one - other, 360));
  }

  private static double[] six(ArgumentsAccessor row, int first) {
    double[] six = new double[6];
    for (int i = 0; i < six.length; i++) {
      six[i] = row.getDouble(first + i);
    }
    return six;
  }
}
