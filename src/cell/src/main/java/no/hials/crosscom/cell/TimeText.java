package no.hials.crosscom.cell;

import java.math.BigDecimal;
import java.time.Duration;
import java.time.Instant;
import java.time.format.DateTimeFormatter;
import java.time.format.DateTimeFormatterBuilder;
import java.util.Locale;

/** Prints times with a fixed number of digits after the point. */
public final class TimeText {
  private static final DateTimeFormatter INSTANT =
      new DateTimeFormatterBuilder().appendInstant(6).toFormatter(Locale.ROOT);

  private TimeText() {}

  /** Prints a time as {@code 2026-05-04T10:15:30.123456Z}. */
  public static String instant(Instant time) {
    return INSTANT.format(time);
  }

  /** Prints seconds as {@code 12.345678}. */
  public static String seconds(Duration time) {
    return decimal(time, 6, 6);
  }

  /** Prints seconds as {@code 12.3}. */
  public static String roughSeconds(Duration time) {
    return decimal(time, 1, 1);
  }

  /** Prints milliseconds as {@code 2.125}. */
  public static String millis(Duration time) {
    return decimal(time, 6, 3);
  }

  /** Prints milliseconds as {@code 2.1}. */
  static String roughMillis(Duration time) {
    return decimal(time, 4, 1);
  }

  /**
   * Prints the whole number of 10^-{@code digits} seconds, with {@code scale} of its digits after
   * the point.
   */
  private static String decimal(Duration time, int digits, int scale) {
    long unit = 1;
    for (int i = digits; i < 9; i++) {
      unit *= 10;
    }
    return BigDecimal.valueOf(time.toNanos() / unit, scale).toPlainString();
  }
}
