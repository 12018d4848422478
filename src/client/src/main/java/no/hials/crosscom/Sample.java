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
 * What a {@link Watch} read at one time.
 *
 * @param number from 1; counts the samples that were given
 * @param time when the reading began
 * @param duration how long reading all variables took
 * @param readings what came of each variable, in the order in which they were asked for
 * @param changed the names of those that changed since a sample last said so, by more than the dead
 *     band; all in the first. If somebody was too slow to get a sample, what changed in it is named
 *     again in the next, for all
 * @param missedPeriods how many periods before this sample were left out because the reading before
 *     took too long
 * @param failedPolls how many readings since the last sample failed as a whole, as during a loss of
 *     the connection: there is a gap before this sample if it is not 0
 */
public record Sample(
    long number,
    Instant time,
    Duration duration,
    Map<String, Reading> readings,
    Set<String> changed,
    long missedPeriods,
    long failedPolls) {

  /** Copies the collections, so that they cannot change. */
  public Sample {
    readings = Collections.unmodifiableMap(new LinkedHashMap<>(readings));
    changed = Set.copyOf(changed);
  }

  /**
   * Returns the value of a variable.
   *
   * @param name its name, as it was asked for
   * @return the value
   * @throws CrossComException if it could not be read
   * @throws IllegalArgumentException if it was not asked for
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

  /**
   * What came of reading one variable: a value or a failure.
   *
   * @param value the value; null if reading failed
   * @param failure why it failed, as for an unknown name; null if it did not
   */
  public record Reading(@Nullable KrlValue value, @Nullable CrossComException failure) {

    /** Checks that either value or failure is set. */
    public Reading {
      if ((value == null) == (failure == null)) {
        throw new IllegalArgumentException("a reading is a value or a failure");
      }
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
