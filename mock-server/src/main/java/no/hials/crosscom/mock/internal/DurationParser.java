package no.hials.crosscom.mock.internal;

import java.math.BigDecimal;
import java.time.Duration;
import java.util.Locale;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * Parses times such as {@code 5ms}: those of the command line's options, and µs. A test compares
 * the two.
 */
public final class DurationParser {
  private static final Pattern FORM =
      Pattern.compile("(\\d{1,10}(?:\\.\\d{1,9})?)\\s?(us|ms|s|m|min|)", Pattern.CASE_INSENSITIVE);

  private static final Duration LONGEST = Duration.ofHours(1);

  private DurationParser() {}

  /** Returns the time, cut to nanoseconds, or empty if the text is not a time up to an hour. */
  public static Optional<Duration> parse(String text) {
    Matcher matcher = FORM.matcher(text);
    if (!matcher.matches()) {
      return Optional.empty();
    }
    long unit =
        switch (matcher.group(2).toLowerCase(Locale.ROOT)) {
          case "us" -> 1_000;
          case "s" -> 1_000_000_000;
          case "m", "min" -> 60_000_000_000L;
          default -> 1_000_000;
        };
    BigDecimal nanos = new BigDecimal(matcher.group(1)).multiply(BigDecimal.valueOf(unit));
    return nanos.compareTo(BigDecimal.valueOf(LONGEST.toNanos())) > 0
        ? Optional.empty()
        : Optional.of(Duration.ofNanos(nanos.longValue()));
  }
}
