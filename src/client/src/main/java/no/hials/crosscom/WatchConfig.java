package no.hials.crosscom;

import java.time.Duration;
import java.util.List;
import java.util.Objects;
import java.util.function.Consumer;

/**
 * The configuration of a {@link Watch}. Immutable; created by {@link #create}.
 *
 * @param names the variables to read, in this order; at least one
 * @param period from the beginning of one reading to the beginning of the next; at least 1 ms,
 *     default 100 ms
 * @param changesOnly whether samples without a changed value are left out; default false
 * @param deadBand a REAL counts as changed if it differs by more than this, in its own unit; 0 or
 *     more, default 0
 * @param bufferSize the number of samples that may wait for a slow listener before further samples
 *     are dropped; 1 to 65536, default 256
 */
public record WatchConfig(
    List<String> names, Duration period, boolean changesOnly, double deadBand, int bufferSize) {

  /** Checks every field. */
  public WatchConfig {
    names = List.copyOf(Objects.requireNonNull(names, "names"));
    Objects.requireNonNull(period, "period");
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
    Objects.requireNonNull(settings, "settings").accept(builder);
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

    /** Sets whether samples without a changed value are left out. */
    public Builder changesOnly(boolean value) {
      changesOnly = value;
      return this;
    }

    /** Sets the dead band. */
    public Builder deadBand(double value) {
      deadBand = value;
      return this;
    }

    /** Sets the number of samples that may wait for a slow listener. */
    public Builder bufferSize(int value) {
      bufferSize = value;
      return this;
    }
  }
}
