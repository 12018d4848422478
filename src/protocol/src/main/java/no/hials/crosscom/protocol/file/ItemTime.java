package no.hials.crosscom.protocol.file;

import java.time.Instant;

/**
 * A time of a file: a Windows FILETIME and the controller's time zone (type 26).
 *
 * @param instant i32 low and i32 high half of a count of 100 ns since 1601; assumed to be in UTC,
 *     as a FILETIME is everywhere else. A multiple of 100 ns that 64 bits hold: from the year
 *     -27627 to 30828
 * @param biasMinutes i32, in minutes; assumed to be -60 one hour east of Greenwich, as in Windows
 */
public record ItemTime(Instant instant, int biasMinutes) {
  private static final int TICK_NANOS = 100;

  private static final long TICKS_PER_SECOND = 10_000_000;

  private static final long EPOCH_SECOND = -11_644_473_600L; // 1601-01-01T00:00:00Z

  private static final Instant MIN = instant(Long.MIN_VALUE);

  private static final Instant MAX = instant(Long.MAX_VALUE);

  /** All bytes 0: the request did not ask for the time. */
  public static final ItemTime NONE = ofTicks(0, 0);

  /** Checks the ranges. */
  public ItemTime {
    if (instant.isBefore(MIN) || instant.isAfter(MAX)) {
      throw new IllegalArgumentException(
          "instant must be " + MIN + " to " + MAX + ", is " + instant);
    }
    if (!instant(ticks(instant)).equals(instant)) {
      throw new IllegalArgumentException("instant must be a multiple of 100 ns, is " + instant);
    }
  }

  /**
   * Creates a time from the number on the wire.
   *
   * @param ticks any count of 100 ns since 1601
   * @param biasMinutes the time zone
   * @return the time
   */
  public static ItemTime ofTicks(long ticks, int biasMinutes) {
    return new ItemTime(instant(ticks), biasMinutes);
  }

  private static Instant instant(long ticks) {
    return Instant.ofEpochSecond(
        EPOCH_SECOND + Math.floorDiv(ticks, TICKS_PER_SECOND),
        Math.floorMod(ticks, TICKS_PER_SECOND) * TICK_NANOS);
  }

  /**
   * Returns the number on the wire.
   *
   * @return the count of 100 ns since 1601
   */
  public long ticks() {
    return ticks(instant);
  }

  private static long ticks(Instant instant) {
    // may overflow twice on the way to a result that fits
    return (instant.getEpochSecond() - EPOCH_SECOND) * TICKS_PER_SECOND
        + instant.getNano() / TICK_NANOS;
  }
}
