package no.hials.crosscom;

import java.time.Duration;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Objects;
import java.util.Set;
import java.util.function.Consumer;
import no.hials.crosscom.internal.VariableName;
import org.jspecify.annotations.Nullable;

/**
 * The variables and options of a {@link Watch}. Immutable; created by {@link #create} or {@link
 * #ofHandles}. The {@link Builder} describes the options.
 */
public final class WatchConfig {
  private final List<String> names;
  private final List<Handle<?>> handles;
  private final Duration period;
  private final boolean changesOnly;
  private final double deadBand;
  private final boolean missedSamples;
  private final int bufferSize;

  private WatchConfig(
      List<String> names, List<? extends Handle<?>> handles, Consumer<Builder> settings) {
    Builder builder = new Builder();
    Objects.requireNonNull(settings, "settings").accept(builder);
    Set<String> seen = new HashSet<>();
    for (String name : names) {
      boolean isNew = seen.add(VariableName.check(name).toUpperCase(Locale.ROOT));
      check(isNew, "a variable can be watched only once: " + name + " is repeated");
    }
    this.names = List.copyOf(names);
    this.handles = List.copyOf(handles);
    period = builder.period;
    changesOnly = builder.changesOnly;
    deadBand = builder.deadBand;
    missedSamples = builder.missedSamples;
    bufferSize = builder.bufferSize;
    check(!names.isEmpty(), "name at least one variable to watch");
  }

  /**
   * Creates a configuration.
   *
   * @param names the variables to read, in this order; at least one, each once in any case
   * @param settings sets the options that differ from their defaults
   * @return the configuration
   * @throws IllegalArgumentException if a value is out of its range
   */
  public static WatchConfig create(List<String> names, Consumer<Builder> settings) {
    return new WatchConfig(Objects.requireNonNull(names, "names"), List.of(), settings);
  }

  /**
   * Creates a configuration whose samples have the values as Java types, by {@link
   * Sample#get(Handle)}.
   *
   * @param handles handles of the client that reads them, in this order; at least one, each of
   *     another variable
   * @param settings sets the options that differ from their defaults
   * @return the configuration
   * @throws IllegalArgumentException if a value is out of its range
   */
  public static WatchConfig ofHandles(
      List<? extends Handle<?>> handles, Consumer<Builder> settings) {
    List<String> names =
        Objects.requireNonNull(handles, "handles").stream().map(Handle::name).toList();
    return new WatchConfig(names, handles, settings);
  }

  private static void check(boolean holds, String rule) {
    if (!holds) {
      throw new IllegalArgumentException(rule);
    }
  }

  /** Returns the variables to read, in this order. */
  public List<String> names() {
    return names;
  }

  /** Returns the handles of these variables; empty if they are read by name. */
  public List<Handle<?>> handles() {
    return handles;
  }

  /** Returns the time from the beginning of one reading to the beginning of the next. */
  public Duration period() {
    return period;
  }

  /** Returns whether samples without a changed value are left out. */
  public boolean changesOnly() {
    return changesOnly;
  }

  /** Returns the difference up to which a REAL counts as unchanged, in its own unit. */
  public double deadBand() {
    return deadBand;
  }

  /** Returns whether a reading that fails as a whole is a sample without values. */
  public boolean missedSamples() {
    return missedSamples;
  }

  /** Returns the number of samples that may wait for a slow listener. */
  public int bufferSize() {
    return bufferSize;
  }

  /** Returns whether the other is a configuration with equal options. */
  @Override
  public boolean equals(@Nullable Object other) {
    return other instanceof WatchConfig config && values().equals(config.values());
  }

  @Override
  public int hashCode() {
    return values().hashCode();
  }

  @Override
  public String toString() {
    return "WatchConfig" + values();
  }

  private Map<String, Object> values() {
    Map<String, Object> values = new LinkedHashMap<>();
    values.put("names", names);
    values.put("handles", handles);
    values.put("period", period);
    values.put("changesOnly", changesOnly);
    values.put("deadBand", deadBand);
    values.put("missedSamples", missedSamples);
    values.put("bufferSize", bufferSize);
    return values;
  }

  /** Sets the options. Each method sets one option and returns this builder. */
  public static final class Builder {
    private Duration period = Duration.ofMillis(100);
    private boolean changesOnly;
    private double deadBand;
    private boolean missedSamples;
    private int bufferSize = 256;

    private Builder() {}

    /**
     * Sets the time from the beginning of one reading to the beginning of the next, 1 ms to 1 day.
     * The default is 100 ms.
     */
    public Builder period(Duration value) {
      Objects.requireNonNull(value, "period");
      check(
          value.compareTo(Duration.ofMillis(1)) >= 0 && value.compareTo(Duration.ofDays(1)) <= 0,
          "period must be 1 ms to 1 day, is " + value);
      period = value;
      return this;
    }

    /** Sets whether samples without a changed value are left out. The default is false. */
    public Builder changesOnly(boolean value) {
      changesOnly = value;
      return this;
    }

    /**
     * Sets the dead band, 0 or more: a REAL counts as changed if it differs by more than this, in
     * its own unit. A number is a REAL if the controller prints it so in one of the two readings,
     * or if it is read by a handle of {@code Double} or {@code double[]}; every change of an INT
     * counts. The default is 0.
     */
    public Builder deadBand(double value) {
      check(value >= 0 && Double.isFinite(value), "dead band must be 0 or more, is " + value);
      deadBand = value;
      return this;
    }

    /**
     * Sets whether a reading that fails as a whole is a sample without values, in which all
     * variables are {@link Sample.ReadingStatus#MISSED}; with {@link #changesOnly} only the first
     * of several such readings is. The default is false.
     */
    public Builder missedSamples(boolean value) {
      missedSamples = value;
      return this;
    }

    /**
     * Sets the number of samples that may wait for a slow listener before further samples are
     * dropped, 1 to 65536. The default is 256.
     */
    public Builder bufferSize(int value) {
      check(value >= 1 && value <= 65_536, "buffer size must be 1 to 65536, is " + value);
      bufferSize = value;
      return this;
    }
  }
}
