package no.hials.crosscom.control;

import java.time.Duration;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import no.hials.crosscom.control.input.InputDevice;
import org.jspecify.annotations.Nullable;

/**
 * The settings of a loop. Immutable; created by {@link #create}. The {@link Builder} describes the
 * options.
 */
public final class LoopConfig {
  private static final Duration MIN_TIME = Duration.ofMillis(4);
  private static final Duration MAX_TIME = Duration.ofSeconds(1);
  private static final Duration LONGEST_DURATION = Duration.ofDays(365);
  private static final int LONGEST_TRACE = 1_000_000;

  private final Options options;

  private LoopConfig(Options options) {
    this.options = options;
    Checks.holds(
        options.inputKnown,
        "a loop needs an input device, whose dead-man allows motion, or noInput() for a law that"
            + " moves the robot without one");
    Duration watchdog = options.safety.watchdog();
    Checks.holds(
        watchdog.isZero() || watchdog.compareTo(options.period.multipliedBy(4)) >= 0,
        "time of the watchdog must be at least 4 periods, is " + watchdog);
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
    Options options = builder.options;
    builder.options = new Options(); // a builder that is kept changes nothing
    return new LoopConfig(options);
  }

  /** Returns the part of a period's motion in one increment. */
  double part(boolean velocity) {
    double step = Math.min(1, (double) stepTime().toNanos() / period().toNanos());
    return velocity ? step : Math.min(gain(), step);
  }

  /** Returns the time {@code dt} between commands. */
  public Duration period() {
    return options.period;
  }

  /** Returns the variable that the KRL program follows; null for the default of the law. */
  public @Nullable Target target() {
    return options.target;
  }

  /** Returns the largest part of the distance that a position law sends as an increment. */
  public double gain() {
    return options.gain;
  }

  /** Returns the time that the program takes for one increment. */
  public Duration stepTime() {
    return options.stepTime;
  }

  /** Returns the limits. */
  public Safety safety() {
    return options.safety;
  }

  /** Returns the device whose dead-man allows motion; null without a device. */
  public @Nullable InputDevice input() {
    return options.input;
  }

  /** Returns whether the loop stops another driver, instead of refusing to start. */
  public boolean takeover() {
    return options.takeover;
  }

  /** Returns the condition of each write. */
  public BooleanSupplier writeIf() {
    return options.writeIf;
  }

  /** Returns the time after which the loop ends; zero for never. */
  public Duration duration() {
    return options.duration;
  }

  /** Returns the number of last cycles kept for {@link Trace}. */
  public int traceLength() {
    return options.traceLength;
  }

  /** The options as they were set. */
  private static final class Options {
    private Duration period = Duration.ofMillis(20);
    private @Nullable Target target;
    private double gain = 0.25;
    private Duration stepTime = Duration.ofMillis(12);
    private Safety safety = Safety.create(changes -> {});
    private @Nullable InputDevice input;
    private boolean inputKnown;
    private boolean takeover;
    private BooleanSupplier writeIf = () -> true;
    private Duration duration = Duration.ZERO;
    private int traceLength = 10_000;
  }

  /** Sets the options. Each method sets one option and returns this builder. */
  public static final class Builder {
    private Options options = new Options();

    private Builder() {}

    // commands

    /** Sets the time {@code dt} between commands, 4 ms to 1 s. The default is 20 ms. */
    public Builder period(Duration dt) {
      options.period = Checks.between("period", dt, MIN_TIME, MAX_TIME);
      return this;
    }

    /**
     * Sets the variable that the KRL program follows. The default is the variable of the program in
     * {@code krl} for the kind of law: {@code JOV_POS} and {@code JOV_AXIS} for positions, the
     * increments {@code MYPOS} and {@code MYAXIS} for velocities.
     */
    public Builder target(Target variable) {
      options.target = variable;
      return this;
    }

    /**
     * Sets the largest part of the distance to its position that a position law sends as an
     * increment, more than 0 and at most 1: the program makes one or two more increments until the
     * robot shows the first. The default is 0.25.
     */
    public Builder gain(double part) {
      Checks.holds(part > 0 && part <= 1, "gain must be more than 0 and at most 1, is " + part);
      options.gain = part;
      return this;
    }

    /**
     * Sets the time that the program takes for one increment, 4 ms to 1 s. An increment is the
     * motion of this time, since the program makes several in a longer period. The default is 12
     * ms, a cycle of the controller and so the shortest possible. If the program takes longer, the
     * robot is slower.
     */
    public Builder stepTime(Duration time) {
      options.stepTime = Checks.between("time of a step", time, MIN_TIME, MAX_TIME);
      return this;
    }

    // what allows motion

    /** Sets the limits. */
    public Builder safety(Safety limits) {
      options.safety = limits;
      return this;
    }

    /** Sets the limits to the defaults with changes. */
    public Builder safety(Consumer<Safety.Builder> changes) {
      return safety(Safety.create(changes));
    }

    /**
     * Sets the device whose dead-man allows motion. The loop reads the device but does not close
     * it.
     */
    public Builder input(InputDevice device) {
      options.input = device;
      options.inputKnown = true;
      return this;
    }

    /** Lets the law move the robot without a dead-man. */
    public Builder noInput() {
      options.input = null;
      options.inputKnown = true;
      return this;
    }

    /**
     * Takes over from another client that sends a heartbeat. A control loop stops when its
     * heartbeat is replaced; if the other client does not stop within 5 s, this loop does not
     * start. By default, a loop does not start while another client sends a heartbeat. A client
     * without a heartbeat is not noticed.
     */
    public Builder takeover() {
      options.takeover = true;
      return this;
    }

    /**
     * Sets a condition that is checked before each write, also of the start. If it is false, the
     * loop does not start, or it ends as if it was asked to stop: it only writes the command to
     * stand. The default is always true.
     *
     * @param condition called by the thread that starts the loop and by that of the loop; must not
     *     block
     */
    public Builder writeIf(BooleanSupplier condition) {
      options.writeIf = condition;
      return this;
    }

    // its end and its record

    /** Sets the time after which the loop ends. The default is zero, which means never. */
    public Builder duration(Duration time) {
      options.duration = Checks.between("duration", time, Duration.ZERO, LONGEST_DURATION);
      return this;
    }

    /**
     * Sets the number of last cycles to keep for {@link Trace}, 0 to 1,000,000; each needs 200
     * bytes. The default is 10,000.
     */
    public Builder traceLength(int cycles) {
      Checks.holds(
          cycles >= 0 && cycles <= LONGEST_TRACE,
          "length of the trace must be 0 to " + LONGEST_TRACE + ", is " + cycles);
      options.traceLength = cycles;
      return this;
    }
  }
}
