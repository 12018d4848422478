package no.hials.crosscom.control;

import java.time.Duration;
import java.util.function.Consumer;
import no.hials.crosscom.control.input.InputDevice;
import org.jspecify.annotations.Nullable;

/**
 * The settings of a loop. Immutable; created by {@link #create}.
 *
 * @param period the time {@code dt} between commands, 4 ms to 1 s; default 20 ms
 * @param target the variable that the KRL program follows; by default the variable of the program
 *     in {@code krl} for the kind of law: {@code JOV_POS} and {@code JOV_AXIS} for positions, the
 *     increments {@code MYPOS} and {@code MYAXIS} for velocities
 * @param gain the largest part of the distance to its position that a position law sends as an
 *     increment, since the program makes one or two more increments until the robot shows the
 *     first; more than 0, at most 1, default 0.25
 * @param stepTime the time that the program takes for one increment; an increment is the motion of
 *     this time, since the program makes several in a longer period. 4 ms to 1 s; default 12 ms, a
 *     cycle of the controller and so the shortest possible. If the program takes longer, the robot
 *     is slower
 * @param safety the limits
 * @param input the device whose dead-man allows motion; empty if the law moves the robot without
 *     one ({@link Builder#noInput})
 * @param duration the time after which the loop ends; zero for never, the default
 * @param traceLength the number of last cycles kept for {@link Trace}, 0 to 1,000,000; default
 *     10,000
 */
public record LoopConfig(
    Duration period,
    @Nullable Target target,
    double gain,
    Duration stepTime,
    Safety safety,
    @Nullable InputDevice input,
    Duration duration,
    int traceLength) {

  private static final Duration SHORTEST = Duration.ofMillis(4);
  private static final Duration LONGEST = Duration.ofSeconds(1);
  private static final Duration LONGEST_DURATION = Duration.ofDays(365);
  private static final int LONGEST_TRACE = 1_000_000;

  /** Checks every field. */
  public LoopConfig {
    Checks.between("period", period, SHORTEST, LONGEST);
    Checks.between("time of a step", stepTime, SHORTEST, LONGEST);
    Checks.holds(gain > 0 && gain <= 1, "gain must be more than 0 and at most 1, is " + gain);
    Checks.between("duration", duration, Duration.ZERO, LONGEST_DURATION);
    Checks.holds(
        traceLength >= 0 && traceLength <= LONGEST_TRACE,
        "length of the trace must be 0 to " + LONGEST_TRACE + ", is " + traceLength);
    Checks.holds(
        safety.watchdog().isZero() || safety.watchdog().compareTo(period.multipliedBy(4)) >= 0,
        "time of the watchdog must be at least 4 periods, is " + safety.watchdog());
  }

  /** Returns the part of a period's motion in one increment. */
  double part(boolean velocity) {
    double step = Math.min(1, (double) stepTime.toNanos() / period.toNanos());
    return velocity ? step : Math.min(gain, step);
  }

  /**
   * Creates a configuration.
   *
   * @param settings changes the defaults, and sets {@link Builder#input} or {@link Builder#noInput}
   * @return the configuration
   * @throws IllegalArgumentException if a value is out of range, or neither an input device nor
   *     {@code noInput} was set
   */
  public static LoopConfig create(Consumer<Builder> settings) {
    Builder builder = new Builder();
    settings.accept(builder);
    return builder.build();
  }

  /** Collects the settings of a {@link LoopConfig}. */
  public static final class Builder {
    private Duration period = Duration.ofMillis(20);
    private @Nullable Target target;
    private double gain = 0.25;
    private Duration stepTime = Duration.ofMillis(12);
    private Safety safety = Safety.create(changes -> {});
    private @Nullable InputDevice input;
    private boolean inputKnown;
    private Duration duration = Duration.ZERO;
    private int traceLength = 10_000;

    private Builder() {}

    /**
     * Sets the time between commands.
     *
     * @param dt 4 ms to 1 s
     * @return this
     */
    public Builder period(Duration dt) {
      period = dt;
      return this;
    }

    /**
     * Sets the variable that the KRL program follows.
     *
     * @param variable the variable
     * @return this
     */
    public Builder target(Target variable) {
      target = variable;
      return this;
    }

    /**
     * Sets the largest part of the distance that a position law sends as an increment.
     *
     * @param part more than 0, at most 1
     * @return this
     */
    public Builder gain(double part) {
      gain = part;
      return this;
    }

    /**
     * Sets the time that the program takes for one increment.
     *
     * @param time 4 ms to 1 s
     * @return this
     */
    public Builder stepTime(Duration time) {
      stepTime = time;
      return this;
    }

    /**
     * Sets the limits.
     *
     * @param limits the limits
     * @return this
     */
    public Builder safety(Safety limits) {
      safety = limits;
      return this;
    }

    /**
     * Changes limits.
     *
     * @param changes changes the defaults
     * @return this
     */
    public Builder safety(Consumer<Safety.Builder> changes) {
      return safety(Safety.create(changes));
    }

    /**
     * Sets the device whose dead-man allows motion. The loop reads the device but does not close
     * it.
     *
     * @param device the device
     * @return this
     */
    public Builder input(InputDevice device) {
      input = device;
      inputKnown = true;
      return this;
    }

    /**
     * Lets the law move the robot without a dead-man.
     *
     * @return this
     */
    public Builder noInput() {
      input = null;
      inputKnown = true;
      return this;
    }

    /**
     * Sets the time after which the loop ends.
     *
     * @param time more than zero, or zero for never
     * @return this
     */
    public Builder duration(Duration time) {
      duration = time;
      return this;
    }

    /**
     * Sets the number of last cycles to keep.
     *
     * @param cycles 0 to 1,000,000; each needs 200 bytes
     * @return this
     */
    public Builder traceLength(int cycles) {
      traceLength = cycles;
      return this;
    }

    private LoopConfig build() {
      Checks.holds(
          inputKnown,
          "a loop needs an input device, whose dead-man allows motion, or noInput() for a law that"
              + " moves the robot without one");
      return new LoopConfig(period, target, gain, stepTime, safety, input, duration, traceLength);
    }
  }
}
