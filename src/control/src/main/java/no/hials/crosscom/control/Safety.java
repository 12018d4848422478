package no.hials.crosscom.control;

import java.time.Duration;
import java.util.EnumSet;
import java.util.Set;
import java.util.function.Consumer;
import no.hials.crosscom.kinematics.RobotModel;
import no.hials.crosscom.protocol.code.OperatingMode;
import org.jspecify.annotations.Nullable;

/**
 * The limits of a loop, all enabled by default. Immutable; created by {@link #create}.
 *
 * @param path limits of the tool centre point in Cartesian laws, mm; default 100 mm/s, 5 mm, 50 mm
 * @param rotation limits of the tool's rotation in Cartesian laws, degrees; default 30 degrees/s, 2
 *     degrees, 15 degrees
 * @param axes limits of each axis in joint laws, degrees; default 30 degrees/s, 2 degrees, 15
 *     degrees
 * @param axisLimits the ranges of the axes; by default those of the controller ({@code $SOFTN_END},
 *     {@code $SOFTP_END})
 * @param axisMargin the minimum distance of the axes from their limits, degrees; default 5
 * @param workspace the box in which the tool centre point must stay; by default, for Cartesian laws
 *     300 mm to each side of its position at the start, and for joint laws no limit
 * @param workspaceMargin the minimum distance from the sides of the workspace, mm; default 10
 * @param modes the operating modes in which the loop may run; default only T1
 * @param checkInterval the interval at which the mode, the program state, the axes (Cartesian laws)
 *     or the position (joint laws), and the watchdog are read; default 300 ms
 * @param maxFeedbackAge the maximum time to read the position, and to read it and call the law;
 *     default 100 ms
 * @param maxStall the maximum time that the robot may stand still when it was told to move; at most
 *     a fifth of it is counted between two readings, so that a pause of this computer is not taken
 *     for a stall; default 500 ms
 * @param maxInputAge the maximum age of the input for motion; default 200 ms
 * @param watchdog the time without a heartbeat after which the watchdog on the controller stops the
 *     robot ({@code JOV_LIMIT} of {@code krl/config.dat}); zero for no heartbeat; default 500 ms
 */
public record Safety(
    MotionLimits path,
    MotionLimits rotation,
    MotionLimits axes,
    @Nullable AxisLimits axisLimits,
    double axisMargin,
    @Nullable Workspace workspace,
    double workspaceMargin,
    Set<OperatingMode> modes,
    Duration checkInterval,
    Duration maxFeedbackAge,
    Duration maxStall,
    Duration maxInputAge,
    Duration watchdog) {

  /** Half the side of the default workspace of a Cartesian law, mm. */
  static final double REACH = 300;

  private static final Duration SHORTEST = Duration.ofMillis(1);
  private static final Duration SHORTEST_WATCHDOG = Duration.ofMillis(50);
  private static final Duration LONGEST = Duration.ofSeconds(10);

  /** Checks every field. */
  public Safety {
    Checks.notNegative("axis margin", axisMargin);
    Checks.notNegative("workspace margin", workspaceMargin);
    modes = Set.copyOf(modes);
    Checks.holds(!modes.isEmpty(), "at least one operating mode must be allowed");
    Checks.between("check interval", checkInterval, SHORTEST, LONGEST);
    Checks.between("maximum age of the feedback", maxFeedbackAge, SHORTEST, LONGEST);
    Checks.between("maximum time of a stall", maxStall, SHORTEST, LONGEST);
    Checks.between("maximum age of the input", maxInputAge, SHORTEST, LONGEST);
    if (!watchdog.isZero()) {
      Checks.between("time of the watchdog", watchdog, SHORTEST_WATCHDOG, LONGEST);
    }
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
    return builder.build();
  }

  /** Collects the settings of a {@link Safety}. */
  public static final class Builder {
    private MotionLimits path = new MotionLimits(100, 5, 50);
    private MotionLimits rotation = new MotionLimits(30, 2, 15);
    private MotionLimits axes = new MotionLimits(30, 2, 15);
    private @Nullable AxisLimits axisLimits;
    private double axisMargin = 5;
    private @Nullable Workspace workspace;
    private double workspaceMargin = 10;
    private Set<OperatingMode> modes = EnumSet.of(OperatingMode.T1);
    private Duration checkInterval = Duration.ofMillis(300);
    private Duration maxFeedbackAge = Duration.ofMillis(100);
    private Duration maxStall = Duration.ofMillis(500);
    private Duration maxInputAge = Duration.ofMillis(200);
    private Duration watchdog = Duration.ofMillis(500);

    private Builder() {}

    /**
     * Sets the limits of the tool centre point in Cartesian laws.
     *
     * @param speed mm/s
     * @param step between targets, mm
     * @param trackingError mm
     * @return this
     */
    public Builder path(double speed, double step, double trackingError) {
      path = new MotionLimits(speed, step, trackingError);
      return this;
    }

    /**
     * Sets the limits of the tool's rotation in Cartesian laws.
     *
     * @param speed degrees/s
     * @param step between targets, degrees
     * @param trackingError degrees
     * @return this
     */
    public Builder rotation(double speed, double step, double trackingError) {
      rotation = new MotionLimits(speed, step, trackingError);
      return this;
    }

    /**
     * Sets the limits of each axis in joint laws.
     *
     * @param speed degrees/s
     * @param step between targets, degrees
     * @param trackingError degrees
     * @return this
     */
    public Builder axes(double speed, double step, double trackingError) {
      axes = new MotionLimits(speed, step, trackingError);
      return this;
    }

    /**
     * Sets the ranges of the axes, in place of those of the controller.
     *
     * @param limits the ranges
     * @return this
     */
    public Builder axisLimits(AxisLimits limits) {
      axisLimits = limits;
      return this;
    }

    /**
     * Sets the ranges of the axes to those of a robot model, in place of those of the controller.
     *
     * @param model the robot
     * @return this
     */
    public Builder axisLimits(RobotModel model) {
      return axisLimits(AxisLimits.of(model));
    }

    /**
     * Sets the minimum distance of the axes from their limits.
     *
     * @param degrees 0 or more
     * @return this
     */
    public Builder axisMargin(double degrees) {
      axisMargin = degrees;
      return this;
    }

    /**
     * Sets the box in which the tool centre point must stay, for joint laws too.
     *
     * @param box the workspace in {@code $BASE}
     * @return this
     */
    public Builder workspace(Workspace box) {
      workspace = box;
      return this;
    }

    /**
     * Sets the minimum distance from the sides of the workspace.
     *
     * @param mm 0 or more
     * @return this
     */
    public Builder workspaceMargin(double mm) {
      workspaceMargin = mm;
      return this;
    }

    /**
     * Sets the operating modes in which the loop may run. In AUT and EX nobody holds an enabling
     * switch.
     *
     * @param first a mode
     * @param others more modes
     * @return this
     */
    public Builder modes(OperatingMode first, OperatingMode... others) {
      modes = EnumSet.of(first, others);
      return this;
    }

    /**
     * Sets the interval at which the mode, the program state and the other feedback are read.
     *
     * @param interval 1 ms to 10 s
     * @return this
     */
    public Builder checkInterval(Duration interval) {
      checkInterval = interval;
      return this;
    }

    /**
     * Sets the maximum time to read the position, and to read it and call the law.
     *
     * @param time 1 ms to 10 s
     * @return this
     */
    public Builder maxFeedbackAge(Duration time) {
      maxFeedbackAge = time;
      return this;
    }

    /**
     * Sets the maximum time that the robot may stand still when it was told to move. Detecting a
     * stall takes more than five readings, at any interval.
     *
     * @param time 1 ms to 10 s
     * @return this
     */
    public Builder maxStall(Duration time) {
      maxStall = time;
      return this;
    }

    /**
     * Sets the maximum age of the input for motion.
     *
     * @param time 1 ms to 10 s
     * @return this
     */
    public Builder maxInputAge(Duration time) {
      maxInputAge = time;
      return this;
    }

    /**
     * Sets the time without a heartbeat after which the watchdog on the controller stops the robot.
     *
     * @param time 50 ms to 10 s
     * @return this
     */
    public Builder watchdog(Duration time) {
      watchdog = time;
      return this;
    }

    /**
     * Sends no heartbeat, for a program without a watchdog. Then nothing on the controller stops
     * the robot if the connection is lost.
     *
     * @return this
     */
    public Builder noWatchdog() {
      watchdog = Duration.ZERO;
      return this;
    }

    private Safety build() {
      return new Safety(
          path,
          rotation,
          axes,
          axisLimits,
          axisMargin,
          workspace,
          workspaceMargin,
          modes,
          checkInterval,
          maxFeedbackAge,
          maxStall,
          maxInputAge,
          watchdog);
    }
  }
}
