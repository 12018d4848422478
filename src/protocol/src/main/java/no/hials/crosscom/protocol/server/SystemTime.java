package no.hials.crosscom.protocol.server;

import java.time.DateTimeException;
import java.time.Instant;
import java.time.LocalDateTime;
import java.time.ZoneOffset;
import java.util.Optional;
import no.hials.crosscom.protocol.internal.Ranges;

/**
 * A time in UTC as eight numbers, as in the controller's operating system.
 *
 * @param year u16
 * @param month u16; from 1
 * @param dayOfWeek u16; from 0, Sunday
 * @param day u16; from 1
 * @param hour u16
 * @param minute u16
 * @param second u16
 * @param millisecond u16
 */
public record SystemTime(
    int year,
    int month,
    int dayOfWeek,
    int day,
    int hour,
    int minute,
    int second,
    int millisecond) {
  /** Checks the ranges of the bytes; the numbers need not be a time. */
  public SystemTime {
    Ranges.u16("year", year);
    Ranges.u16("month", month);
    Ranges.u16("day of week", dayOfWeek);
    Ranges.u16("day", day);
    Ranges.u16("hour", hour);
    Ranges.u16("minute", minute);
    Ranges.u16("second", second);
    Ranges.u16("millisecond", millisecond);
  }

  /**
   * Returns the numbers of a time.
   *
   * @param instant a time in the years 0 to 65535; cut to milliseconds
   * @return the numbers
   */
  public static SystemTime of(Instant instant) {
    LocalDateTime time = LocalDateTime.ofInstant(instant, ZoneOffset.UTC);
    return new SystemTime(
        time.getYear(),
        time.getMonthValue(),
        time.getDayOfWeek().getValue() % 7,
        time.getDayOfMonth(),
        time.getHour(),
        time.getMinute(),
        time.getSecond(),
        time.getNano() / 1_000_000);
  }

  /**
   * Returns the time.
   *
   * @return the time, or empty if the numbers are not a time; ignores the day of the week
   */
  public Optional<Instant> instant() {
    try {
      LocalDateTime time =
          LocalDateTime.of(
              year, month, day, hour, minute, second, Math.multiplyExact(millisecond, 1_000_000));
      return Optional.of(time.toInstant(ZoneOffset.UTC));
    } catch (DateTimeException | ArithmeticException e) {
      return Optional.empty();
    }
  }
}
