package no.hials.crosscom.protocol;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import java.util.function.Function;
import java.util.function.Supplier;
import org.assertj.core.api.ThrowingConsumer;

/**
 * Random inputs for property tests: the same in every run, others with {@code -Dseed=}. Limits of
 * each range come more often than by chance.
 */
public final class Samples {
  private static final long SEED = Long.getLong("seed", 1);

  private Samples() {}

  /** Checks a property of many samples; a failure names the sample. */
  public static <T> void forAll(int tries, Function<Random, T> samples, ThrowingConsumer<T> test) {
    Random random = new Random(SEED);
    for (int i = 0; i < tries; i++) {
      T sample = samples.apply(random);
      try {
        test.accept(sample);
      } catch (AssertionError | RuntimeException e) {
        String text = Arrays.deepToString(new Object[] {sample});
        throw new AssertionError("sample " + i + " with -Dseed=" + SEED + ": " + text, e);
      }
    }
  }

  /** Returns a value of one of some generators. */
  @SafeVarargs
  public static <T> T oneOf(Random random, Supplier<? extends T>... generators) {
    return generators[random.nextInt(generators.length)].get();
  }

  /** Returns one of some values. */
  @SafeVarargs
  public static <T> T anyOf(Random random, T... values) {
    return values[random.nextInt(values.length)];
  }

  /** Returns a number of a range, both limits included. */
  public static long between(Random random, long minimum, long maximum) {
    return switch (random.nextInt(20)) {
      case 0 -> minimum;
      case 1 -> maximum;
      case 2 -> Math.max(minimum, Math.min(maximum, random.nextInt(21) - 10));
      default -> minimum == maximum ? minimum : random.nextLong(minimum, maximum);
    };
  }

  /** Returns an int of a range, both limits included. */
  public static int between(Random random, int minimum, int maximum) {
    return (int) between(random, (long) minimum, (long) maximum);
  }

  /** Returns a list of a random length. */
  public static <T> List<T> list(Random random, int minimum, int maximum, Supplier<T> elements) {
    int size = between(random, minimum, maximum);
    List<T> list = new ArrayList<>();
    for (int i = 0; i < size; i++) {
      list.add(elements.get());
    }
    return list;
  }

  /** Returns a text of a random length, of characters up to one. */
  public static String text(Random random, int maximumLength, char last) {
    return string(random, 0, maximumLength, () -> (char) random.nextInt(last + 1));
  }

  /** Returns a text of a random length, of the characters of an alphabet. */
  public static String text(Random random, int minimum, int maximum, String alphabet) {
    return string(
        random, minimum, maximum, () -> alphabet.charAt(random.nextInt(alphabet.length())));
  }

  /** Returns bytes of a random length. */
  public static byte[] bytes(Random random, int maximumLength) {
    byte[] bytes = new byte[between(random, 0, maximumLength)];
    random.nextBytes(bytes);
    return bytes;
  }

  private static String string(
      Random random, int minimum, int maximum, Supplier<Character> characters) {
    StringBuilder text = new StringBuilder();
    list(random, minimum, maximum, characters).forEach(text::append);
    return text.toString();
  }
}
