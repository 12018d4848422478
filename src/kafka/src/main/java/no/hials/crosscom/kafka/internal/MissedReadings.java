package no.hials.crosscom.kafka.internal;

import java.time.Duration;
import java.time.Instant;
import java.util.HashMap;
import java.util.HashSet;
import java.util.Map;
import java.util.Set;
import java.util.stream.Collectors;
import org.jspecify.annotations.Nullable;

/**
 * Counts the readings of a robot that were left out, for each period on its own: by their number
 * between two readings, and by the time after a start or while the robot was not used. Not
 * thread-safe.
 */
final class MissedReadings {
  /** The key of a stored time: this and the milliseconds of the period. */
  private static final String STORED = "read.";

  /** If it takes longer to connect, the robot is off: its readings are tried. */
  private static final Duration LONGEST_CONNECT = RobotSource.LONGEST_BACKOFF.multipliedBy(2);

  private final Set<Duration> periods;

  /** When the last reading of a period began that is counted, or was made. */
  private final Map<Duration, Instant> last = new HashMap<>();

  /** The periods whose next reading counts those before it by the time. */
  private final Set<Duration> unread = new HashSet<>();

  private Instant connectBy = Instant.MIN;

  /** The last result of {@link #stored()}; null after a change. */
  private @Nullable Map<String, Long> stored;

  /** Creates an object for the periods of a robot that was never read. */
  MissedReadings(Set<Duration> periods) {
    this.periods = Set.copyOf(periods);
  }

  /**
   * Continues from a stored offset. A period that it does not have is new.
   *
   * @param offset an offset that {@link #stored} is a part of
   * @param otherwise the time of all periods, if the offset has none
   */
  void restore(Map<String, ?> offset, Instant otherwise) {
    boolean hasNone = offset.keySet().stream().noneMatch(key -> key.startsWith(STORED));
    for (Duration period : periods) {
      Object time = offset.get(STORED + period.toMillis());
      if (time instanceof Number millis) {
        last.put(period, Instant.ofEpochMilli(millis.longValue()));
      } else if (hasNone) {
        last.put(period, otherwise);
      }
    }
  }

  /** Returns up to when the readings of each period are counted, for the next run. */
  Map<String, Long> stored() {
    Map<String, Long> times = stored;
    if (times == null) {
      times =
          last.entrySet().stream()
              .collect(
                  Collectors.toUnmodifiableMap(
                      it -> STORED + it.getKey().toMillis(), it -> it.getValue().toEpochMilli()));
      stored = times;
    }
    return times;
  }

  /** Returns when the last reading of a period began; null before the first one. */
  @Nullable Instant last(Duration period) {
    return last.get(period);
  }

  /** Returns whether the next reading counts those before it by the time. */
  boolean isUnread(Duration period) {
    return unread.contains(period);
  }

  /** Called when the robot is used from now on. */
  void resume(Instant now) {
    unread.addAll(periods);
    connectBy = now.plus(LONGEST_CONNECT);
  }

  /** Called with a reading, or an attempt, while the robot is not used. */
  void unused(Duration period, Instant time) {
    unread.add(period);
    connectBy = time.plus(LONGEST_CONNECT);
  }

  /**
   * Returns the number of readings that were left out before a reading.
   *
   * @param time when it began
   * @param missed their number since the reading before, as far as the robot was used
   * @param failed whether nothing could be read
   */
  long read(Duration period, Instant time, long missed, boolean failed) {
    Instant before = last.get(period);
    boolean byTime = isUnread(period);
    if (before != null && byTime && failed && time.isBefore(connectBy)) {
      return 0; // perhaps not connected yet: the next one counts it as well
    }
    unread.remove(period);
    last.put(period, time);
    stored = null;
    if (before == null || !byTime) {
      return missed;
    }
    // a robot that is off is tried, and a reading that is due now is made
    Instant end = failed && connectBy.isAfter(before) ? connectBy : time;
    return Math.max(0, Duration.between(before, end).toMillis() - 1) / period.toMillis();
  }
}
