package no.hials.crosscom.simulator;

import java.util.Locale;

/** The pace of the simulated controller's time. */
public sealed interface SimulationClock {

  /**
   * Returns a clock at the pace of real time.
   *
   * @return the clock
   */
  static SimulationClock real() {
    return new Running(1);
  }

  /**
   * Returns a clock at a multiple of real time, as far as the machine can keep up.
   *
   * @param factor more than 0, at most 10,000
   * @return the clock
   */
  static SimulationClock times(double factor) {
    return new Running(factor);
  }

  /**
   * Returns a clock that is as fast as the machine allows while a program runs.
   *
   * @return the clock
   */
  static SimulationClock unlimited() {
    return new Unlimited();
  }

  /**
   * Returns a clock that stands still until {@link Controller#step} is called.
   *
   * @return the clock
   */
  static SimulationClock stepped() {
    return new Stepped();
  }

  /**
   * Parses a clock.
   *
   * @param text {@code real}, {@code max}, {@code stepped}, or a factor such as {@code 10}
   * @return the clock
   * @throws IllegalArgumentException if it is not one of these
   */
  static SimulationClock parse(String text) {
    return switch (text.strip().toLowerCase(Locale.ROOT)) {
      case "real" -> real();
      case "max" -> unlimited();
      case "stepped" -> stepped();
      default -> times(factor(text.strip()));
    };
  }

  private static double factor(String text) {
    try {
      return Double.parseDouble(text);
    } catch (NumberFormatException e) {
      throw new IllegalArgumentException(
          "a clock is real, max, stepped or a factor such as 10, is '" + text + "'", e);
    }
  }

  /**
   * Time in proportion to real time.
   *
   * @param factor the multiple of real time; more than 0, at most 10,000
   */
  record Running(double factor) implements SimulationClock {
    private static final double MAX_FACTOR = 10_000;

    /** Checks the range. */
    public Running {
      if (!(factor > 0 && factor <= MAX_FACTOR)) {
        throw new IllegalArgumentException(
            "a clock's factor must be more than 0 and at most 10000, is " + factor);
      }
    }
  }

  /** Time as fast as possible while a program runs, and as real time otherwise. */
  record Unlimited() implements SimulationClock {}

  /** Time that a test advances. */
  record Stepped() implements SimulationClock {}
}
