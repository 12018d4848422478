package no.hials.crosscom.kinematics;

import java.util.Random;
import java.util.function.Function;
import org.assertj.core.api.ThrowingConsumer;

/**
 * Random inputs for property tests: the same in every run, others with {@code -Dseed=}. Limits of
 * each range come more often than by chance.
 */
final class Samples {
  private static final long SEED = Long.getLong("seed", 1);
  private static final int TRIES = 300;

  private Samples() {}

  /** Checks a property of many samples; a failure names the sample. */
  static <T> void forAll(Function<Random, T> samples, ThrowingConsumer<T> test) {
    Random random = new Random(SEED);
    for (int i = 0; i < TRIES; i++) {
      T sample = samples.apply(random);
      try {
        test.accept(sample);
      } catch (AssertionError | RuntimeException e) {
        throw new AssertionError("sample " + i + " with -Dseed=" + SEED + ": " + sample, e);
      }
    }
  }

  /** Returns a number of a range, both limits included. */
  static double between(Random random, double minimum, double maximum) {
    return switch (random.nextInt(30)) {
      case 0 -> minimum;
      case 1 -> maximum;
      case 2 -> Math.max(minimum, Math.min(maximum, random.nextInt(3) - 1));
      default -> random.nextDouble(minimum, maximum);
    };
  }
}
