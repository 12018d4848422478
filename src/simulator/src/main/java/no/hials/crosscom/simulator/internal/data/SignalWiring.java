package no.hials.crosscom.simulator.internal.data;

import java.util.Locale;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.jspecify.annotations.Nullable;

/**
 * The wiring of a SIGNAL (krl.md 1.5): a name for one input or output, or for several as an INT.
 *
 * @param array {@code $IN}, {@code $OUT} or another array in upper case; null if not wired
 * @param first the first element, the lowest bit (assumed: krl.md marks the bit order as U)
 * @param last the last element
 */
record SignalWiring(@Nullable String array, int first, int last) {
  private static final Pattern FORM =
      Pattern.compile("([^\\[\\]]+)\\[(\\d{1,7})](?:\\s+TO\\s+([^\\[\\]]+)\\[(\\d{1,7})])?");

  static SignalWiring parse(String text) {
    String upper = text.strip().toUpperCase(Locale.ROOT);
    if (upper.equals("FALSE")) {
      return new SignalWiring(null, 0, 0);
    }
    Matcher matcher = FORM.matcher(upper);
    if (matcher.matches() && VariablePath.isName(matcher.group(1))) {
      int first = Integer.parseInt(matcher.group(2));
      if (matcher.group(3) == null) {
        return new SignalWiring(matcher.group(1), first, first);
      }
      int last = Integer.parseInt(matcher.group(4));
      if (matcher.group(1).equals(matcher.group(3))
          && last > first
          && last - first < Integer.SIZE) {
        return new SignalWiring(matcher.group(1), first, last);
      }
    }
    throw new IllegalArgumentException(
        "a SIGNAL is $OUT[a], $OUT[a] TO $OUT[b] with at most 32 bits, or FALSE, is '"
            + text
            + "'");
  }

  boolean isSingle() {
    return first == last;
  }

  /** Prints it as in a declaration. */
  @Override
  public String toString() {
    if (array == null) {
      return "FALSE";
    }
    String text = array + "[" + first + "]";
    return isSingle() ? text : text + " TO " + array + "[" + last + "]";
  }
}
