package no.hials.crosscom.control;

import java.time.Duration;
import java.util.EnumSet;
import java.util.Set;
import java.util.function.Consumer;
import no.hials.crosscom.kinematics.RobotModel;
import no.hials.crosscom.protocol.code.OperatingMode;
import org.jspecify.annotations.Nullable;

/**
 * The limits of a loop, all enabled by default. Immutable; created by {@link #create}. The {@link
 * Builder} describes the options.
 */
public final class Safety {
  /** Half the side of the default workspace of a Cartesian law, mm. */
  static final double REACH = 300;

  private static final Duration MIN_TIME = Duration.ofMillis(1);
  private static final Duration MIN_WATCHDOG_TIME = Duration.ofMillis(50);
  private static final Duration MAX_TIME = Duration.ofSeconds(10);

  private final Options options;

  private Safety(Options options) {
    this.options = options;
  }

  /**
   * Creates limits.
   *
   * @param changes changes the defaults
   * @return the limits
   * @throws IllegalArgumentException if a value is out of range
   */
  public static Safety create(Consumer<Builder> changes) {
    Builder builder = new Builder();
    changes.accept(builder);
    Options options = builder.options;
    builder.options = new Options(); // a builder that is kept changes nothing
    return new Safety(options);
  }

  /** Returns the limits of the tool centre point in Cartesian laws, mm. */
  public MotionLimits path() {
    return options.path;
  }

  /** Returns the limits of the tool's rotation in Cartesian laws, degrees. */
  public MotionLimits rotation() {
    return options.rotation;
  }

  /** Returns the limits of each axis in joint laws, degrees. */
  public MotionLimits axes() {
    return options.axes;
  }

  /** Returns the ranges of the axes; null for those of the controller. */
  public @Nullable AxisLimits axisLimits() {
    return options.axisLimits;
  }

  /** Returns the minimum distance of the axes from their limits, degrees. */
  public double axisMargin() {
    return options.axisMargin;
  }

  /** Returns the minimum angle of A5 from 0 in Cartesian laws, degrees. */
  public double wristMargin() {
    return options.wristMargin;
  }

  /** Returns the box in which the tool centre point must stay; null for the default. */
  public @Nullable Workspace workspace() {
    return options.workspace;
  }

  /** Returns the minimum distance from the sides of the workspace, mm. */
  public double workspaceMargin() {
    return options.workspaceMargin;
  }

  /** Returns the operating modes in which the loop may run. */
  public Set<OperatingMode> modes() {
    return options.modes;
  }

  /** Returns the interval at which the mode, the program state and the watchdog are read. */
  public Duration checkInterval() {
    return options.checkInterval;
  }

  /**
   * Returns the maximum time to read the position, and to read it and call the law, and the maximum
   * age of the position by the clock of the controller.
   */
  public Duration maxFeedbackAge() {
    return options.maxFeedbackAge;
  }

  /** Returns whether the age of the position is checked by the clock of the controller. */
  public boolean clock() {
    return options.clock;
  }

  /** Returns the maximum time that the robot may stand still when it was told to move. */
  public Duration maxStall() {
    return options.maxStall;
  }

  /** Returns the maximum age of the input for motion. */
  public Duration maxInputAge() {
    return options.maxInputAge;
  }

  /** Returns the time without a heartbeat after which the watchdog stops the robot; or zero. */
  public Duration watchdog() {
    return options.watchdog;
  }

  /** The options as they were set. */
  private static final class Options {
    private MotionLimits path = new MotionLimits(100, 5, 50);
    private MotionLimits rotation = new MotionLimits(30, 2, 15);
    private MotionLimits axes = new MotionLimits(30, 2, 15);
    private @Nullable AxisLimits axisLimits;
    private double axisMargin = 5;
    private double wristMargin = 10;
    private @Nullable Workspace workspace;
    private double workspaceMargin = 10;
    private Set<OperatingMode> modes = Set.of(OperatingMode.T1);
    private Duration checkInterval = Duration.ofMillis(300);
    private Duration maxFeedbackAge = Duration.ofMillis(100);
    private boolean clock = true;
    private Duration maxStall = Duration.ofMillis(500);
    private Duration maxInputAge = Duration.ofMillis(200);
    private Duration watchdog = Duration.ofMillis(500);
  }

  /** Sets the limits. Each method sets one option and returns this builder. */
  public static final class Builder {
    private Options options = new Options();

    private Builder() {}

    // motion

    /**
     * Sets the limits of the tool centre point in Cartesian laws. The default is 100 mm/s, 5 mm and
     * 50 mm.
     *
     * @param speed mm/s
     * @param step between targets, mm
     * @param trackingError mm
     */
    public Builder path(double speed, double step, double trackingError) {
      options.path = new MotionLimits(speed, step, trackingError);
      return this;
    }

    /**
     * Sets the limits of the tool's rotation in Cartesian laws. The default is 30 degrees/s, 2
     * degrees and 15 degrees.
     *
     * @param speed degrees/s
     * @param step between targets, degrees
     * @param trackingError degrees
     */
    public Builder rotation(double speed, double step, double trackingError) {
      options.rotation = new MotionLimits(speed, step, trackingError);
      return this;
    }

    /**
     * Sets the limits of each axis in joint laws. The default is 30 degrees/s, 2 degrees and 15
     * degrees.
     *
     * @param speed degrees/s
     * @param step between targets, degrees
     * @param trackingError degrees
     */
    public Builder axes(double speed, double step, double trackingError) {
      options.axes = new MotionLimits(speed, step, trackingError);
      return this;
    }

    // positions

    /**
     * Sets the ranges of the axes. The default is the limits of the controller, {@code $SOFTN_END}
     * and {@code $SOFTP_END}.
     */
    public Builder axisLimits(AxisLimits limits) {
      options.axisLimits = limits;
      return this;
    }

    /** Sets the ranges of the axes to those of a robot model. */
    public Builder axisLimits(RobotModel model) {
      return axisLimits(AxisLimits.of(model));
    }

    /** Sets the minimum distance of the axes from their limits, 0 degrees or more; default 5. */
    public Builder axisMargin(double degrees) {
      options.axisMargin = Checks.notNegative("axis margin", degrees);
      return this;
    }

    /**
     * Sets the minimum angle of A5 from 0 in Cartesian laws, 0 degrees or more; default 10. Near 0,
     * a singularity of the wrist, a step of the tool below a millimetre can turn A4 and A6 by tens
     * of degrees, and the robot finishes that step after it is told to stand. 0 for a robot without
     * such a wrist.
     */
    public Builder wristMargin(double degrees) {
      options.wristMargin = Checks.notNegative("wrist margin", degrees);
      return this;
    }

    /**
     * Sets the box in {@code $BASE} in which the tool centre point must stay, for joint laws too.
     * The default is 300 mm to each side of its position at the start for Cartesian laws, and no
     * limit for joint laws.
     */
    public Builder workspace(Workspace box) {
      options.workspace = box;
      return this;
    }

    /** Sets the minimum distance from the sides of the workspace, 0 mm or more; default 10. */
    public Builder workspaceMargin(double mm) {
      options.workspaceMargin = Checks.notNegative("workspace margin", mm);
      return this;
    }

    // the controller

    /**
     * Sets the operating modes in which the loop may run. The default is only T1: in AUT and EX
     * nobody holds an enabling switch.
     */
    public Builder modes(OperatingMode first, OperatingMode... others) {
      options.modes = Set.copyOf(EnumSet.of(first, others));
      return this;
    }

    /**
     * Sets the interval at which the mode, the program state, the override (velocity laws) and the
     * watchdog are read, 1 ms to 10 s. The default is 300 ms. The axes (Cartesian laws) and the
     * position (joint laws with a workspace) are read in each cycle from C3 Bridge, and after each
     * of these variables from KUKAVARPROXY.
     */
    public Builder checkInterval(Duration interval) {
      options.checkInterval = Checks.between("check interval", interval, MIN_TIME, MAX_TIME);
      return this;
    }

    /**
     * Sets the time without a heartbeat, 50 ms to 10 s, after which the watchdog on the controller
     * stops the robot ({@code JOV_LIMIT} of {@code krl/config.dat}). The default is 500 ms.
     */
    public Builder watchdog(Duration time) {
      options.watchdog =
          time.isZero()
              ? time
              : Checks.between("time of the watchdog", time, MIN_WATCHDOG_TIME, MAX_TIME);
      return this;
    }

    /**
     * Sends no heartbeat, for a program without a watchdog. Then nothing on the controller stops
     * the robot if the connection is lost.
     */
    public Builder noWatchdog() {
      return watchdog(Duration.ZERO);
    }

    // feedback and input

    /**
     * Sets the maximum time to read the position, and to read it and call the law, 1 ms to 10 s.
     * The default is 100 ms. A position may also be at most this time and 12 ms old by the clock of
     * the controller, {@code $ROB_TIMER}. C3 Bridge reads the clock with each position in one
     * message; KUKAVARPROXY takes an access of its own, so the clock is read once in a {@link
     * #checkInterval}.
     */
    public Builder maxFeedbackAge(Duration time) {
      options.maxFeedbackAge =
          Checks.between("maximum age of the feedback", time, MIN_TIME, MAX_TIME);
      return this;
    }

    /**
     * Does not check the age of the position by the clock of the controller, for a controller
     * without {@code $ROB_TIMER} or a simulation that is slower than real time. Then a server that
     * answers with old positions is not noticed until the tracking error is too large.
     */
    public Builder noClock() {
      options.clock = false;
      return this;
    }

    /**
     * Sets the maximum time that the robot may stand still when it was told to move, 1 ms to 10 s.
     * The default is 500 ms. At most a fifth of it is counted between two readings, so that a pause
     * of this computer is not taken for a stall; detecting a stall takes more than five readings,
     * at any interval.
     */
    public Builder maxStall(Duration time) {
      options.maxStall = Checks.between("maximum time of a stall", time, MIN_TIME, MAX_TIME);
      return this;
    }

    /** Sets the maximum age of the input for motion, 1 ms to 10 s. The default is 200 ms. */
    public Builder maxInputAge(Duration time) {
      options.maxInputAge = Checks.between("maximum age of the input", time, MIN_TIME, MAX_TIME);
      return this;
    }
  }
}
