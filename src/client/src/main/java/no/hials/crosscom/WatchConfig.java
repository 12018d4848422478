package no.hials.crosscom;

import java.time.Duration;
import java.util.List;
import java.util.function.Consumer;

/**
 * What a {@link Watch} is to do. Immutable; made by {@link #create}.
 *
 * @param names the variables to read, in this order; at least one
 * @param period from the beginning of one reading to the beginning of the next; at least 1 ms,
 *     default 100 ms
 * @param changesOnly whether a sample is given only if a value has changed since the last one
 *     given; default false
 * @param deadBand by how much a REAL has to change to count as changed, in its own unit; 0 or more,
 *     default 0
 * @param bufferSize how many samples may wait for a slow listener before further ones are dropped;
 *     1 to 65536, default 256
 */
public record WatchConfig(
    List<String> names, Duration period, boolean changesOnly, double deadBand, int bufferSize) {

  /** Checks every field. */
  public WatchConfig {
    names = List.copyOf(names);
    if (names.isEmpty()) {
      throw new IllegalArgumentException("name at least one variable to watch");
    }
    if (period.compareTo(Duration.ofMillis(1)) < 0 || period.compareTo(Duration.ofDays(1)) > 0) {
      throw new IllegalArgumentException("period must be 1 ms to 1 day, is " + period);
    }
    if (!(deadBand >= 0) || Double.isInfinite(deadBand)) {
      throw new IllegalArgumentException("dead band must be 0 or more, is " + deadBand);
    }
    if (bufferSize < 1 || bufferSize > 65_536) {
      throw new IllegalArgumentException("buffer size must be 1 to 65536, is " + bufferSize);
    }
  }

  /**
   * Creates a configuration.
   *
   * @param names the variables to read
   * @param settings sets the options that differ from their defaults
   * @return the configuration
   * @throws IllegalArgumentException if a value is out of its range
   */
  public static WatchConfig create(List<String> names, Consumer<Builder> settings) {
    Builder builder = new Builder();
    settings.accept(builder);
    return new WatchConfig(
        names, builder.period, builder.changesOnly, builder.deadBand, builder.bufferSize);
  }

  /**
   * Sets the options. Each method returns this builder; the component of the same name describes
   * its option.
   */
  public static final class Builder {
    private Duration period = Duration.ofMillis(100);
    private boolean changesOnly;
    private double deadBand;
    private int bufferSize = 256;

    private Builder() {}

    /** Sets the period. */
    public Builder period(Duration value) {
      period = value;
      return this;
    }

    /** Sets whether only changes are given. */
    public Builder changesOnly(boolean value) {
      changesOnly = value;
      return this;
    }

    /** Sets by how much a REAL has to change. */
    public Builder deadBand(double value) {
      deadBand = value;
      return this;
    }

    /** Sets how many samples may wait. */
    public Builder bufferSize(int value) {
      bufferSize = value;
      return this;
    }
  }
}
