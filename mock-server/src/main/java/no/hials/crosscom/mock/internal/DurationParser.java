package no.hials.crosscom.mock.internal;

import java.math.BigDecimal;
import java.time.Duration;
import java.util.Map;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** Parses times such as {@code 5ms}. */
public final class DurationParser {
  private static final Pattern FORM = Pattern.compile("(\\d{1,9}(?:\\.\\d{1,9})?)(us|ms|s)");
  private static final Map<String, Integer> NANOS_EXPONENT = Map.of("us", 3, "ms", 6, "s", 9);

  private DurationParser() {}

  /** Returns the time, cut to nanoseconds, or empty if the text is not a time. */
  public static Optional<Duration> parse(String text) {
    Matcher matcher = FORM.matcher(text);
    if (!matcher.matches()) {
      return Optional.empty();
    }
    int exponent = NANOS_EXPONENT.getOrDefault(matcher.group(2), 0);
    BigDecimal nanos = new BigDecimal(matcher.group(1)).scaleByPowerOfTen(exponent);
    return Optional.of(Duration.ofNanos(nanos.longValue()));
  }
}
