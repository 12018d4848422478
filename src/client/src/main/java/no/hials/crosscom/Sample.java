package no.hials.crosscom;

import java.time.Duration;
import java.time.Instant;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Set;
import no.hials.crosscom.protocol.value.KrlValue;
import org.jspecify.annotations.Nullable;

/**
 * The values that a {@link Watch} read at one time. Unless the server reads several variables in
 * one message, they were read one after the other. If the connection is lost in between, the
 * reading starts again, so that values from before and after a restart of the controller are in one
 * sample only if it is lost twice.
 *
 * @param number the number of the sample, from 1
 * @param time when the reading began
 * @param nanoTime the same, by {@link System#nanoTime}
 * @param duration how long reading all variables took
 * @param readings the result for each variable, in the order of {@link WatchConfig#names}
 * @param results the results for handles, for {@link #get}; empty if the watch is of names
 * @param changed the variables that changed by more than the dead band since they were last
 *     reported as changed; all in the first sample. If a slow listener missed a sample, the next
 *     sample repeats its changes, for all listeners
 * @param missedPeriods the number of periods skipped before this sample because the reading before
 *     took too long
 * @param failedPolls the number of readings since the last sample that failed as a whole, for
 *     example without a connection; if not 0, there is a gap before this sample. In a sample
 *     without values ({@link WatchConfig.Builder#missedSamples}) this reading is counted too
 */
public record Sample(
    long number,
    Instant time,
    long nanoTime,
    Duration duration,
    Map<String, Reading> readings,
    ReadResults results,
    Set<String> changed,
    long missedPeriods,
    long failedPolls) {

  /** Copies the collections, so that they cannot change. */
  public Sample {
    readings = Collections.unmodifiableMap(new LinkedHashMap<>(readings));
    changed = Set.copyOf(changed);
  }

  /** Creates a sample of a watch of names, whose reading has just ended. */
  public Sample(
      long number,
      Instant time,
      Duration duration,
      Map<String, Reading> readings,
      Set<String> changed,
      long missedPeriods,
      long failedPolls) {
    this(
        number,
        time,
        System.nanoTime() - duration.toNanos(),
        duration,
        readings,
        ReadResults.NONE,
        changed,
        missedPeriods,
        failedPolls);
  }

  /**
   * Returns the value of a variable as the Java type of its handle.
   *
   * @param handle one of {@link WatchConfig#handles}
   * @return the value
   * @throws CrossComException if it could not be read
   * @throws IllegalArgumentException if the watch does not read the handle
   */
  public <T> T get(Handle<T> handle) throws CrossComException {
    return results.get(handle);
  }

  /**
   * Returns the value of a variable.
   *
   * @param name its name, as in {@link WatchConfig#names}
   * @return the value
   * @throws CrossComException if it could not be read
   * @throws IllegalArgumentException if the watch does not read it
   */
  public KrlValue value(String name) throws CrossComException {
    Reading reading = readings.get(name);
    if (reading == null) {
      throw new IllegalArgumentException(
          "the watched variables are " + readings.keySet() + ", not " + name);
    }
    return reading.orThrow();
  }

  /** Returns whether readings failed before this sample. */
  public boolean hasGapBefore() {
    return failedPolls > 0;
  }

  /** The result of reading one variable. */
  public enum ReadingStatus {
    /** It was read, and the sample reports it as changed: see {@link Sample#changed}. */
    FRESH,
    /** It was read, and is unchanged or within the dead band. */
    REPEATED,
    /** This variable could not be read; the others of the sample may have been. */
    FAILED,
    /** It was not read, because the whole reading failed. */
    MISSED
  }

  /**
   * The result of reading one variable: a value or a failure.
   *
   * @param value the value; null if reading failed
   * @param failure the reason, for example an unknown name; null after a success
   * @param status whether it was read, and has changed
   * @param time when its request was sent; the time of the sample if none was
   * @param accessTime how long its exchange took, which several variables can share; zero if the
   *     exchange failed
   */
  public record Reading(
      @Nullable KrlValue value,
      @Nullable CrossComException failure,
      ReadingStatus status,
      Instant time,
      Duration accessTime) {

    /** Checks that either value or failure is set, as the status says. */
    public Reading {
      boolean read = status == ReadingStatus.FRESH || status == ReadingStatus.REPEATED;
      if ((value != null) != read || (failure == null) != read) {
        throw new IllegalArgumentException("a reading is a value or a failure, as its status says");
      }
    }

    /** Returns this reading, not fresh. */
    Reading asRepeated() {
      return status == ReadingStatus.FRESH
          ? new Reading(value, failure, ReadingStatus.REPEATED, time, accessTime)
          : this;
    }

    /**
     * Returns the value.
     *
     * @return the value
     * @throws CrossComException the failure
     */
    public KrlValue orThrow() throws CrossComException {
      if (value != null) {
        return value;
      }
      throw failure;
    }
  }
}
