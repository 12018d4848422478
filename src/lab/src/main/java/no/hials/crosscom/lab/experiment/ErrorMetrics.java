package no.hials.crosscom.lab.experiment;

import java.util.List;

/** Computes the RMS and the maximum of errors. */
final class ErrorMetrics {
  private ErrorMetrics() {}

  static double rootMeanSquare(double... errors) {
    double sum = 0;
    for (double error : errors) {
      sum += error * error;
    }
    return errors.length == 0 ? 0 : Math.sqrt(sum / errors.length);
  }

  static double maximum(double... errors) {
    double maximum = 0;
    for (double error : errors) {
      maximum = Math.max(maximum, Math.abs(error));
    }
    return maximum;
  }

  /** Returns the RMS and the maximum. */
  static List<ExperimentResult.Figure> figures(String name, String unit, double... errors) {
    return List.of(
        new ExperimentResult.Figure(name + ", RMS", rootMeanSquare(errors), unit),
        new ExperimentResult.Figure(name + ", max", maximum(errors), unit));
  }
}
