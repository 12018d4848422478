package no.hials.crosscom.control;

import java.time.Duration;
import java.util.EnumSet;
import java.util.Set;
import java.util.function.Consumer;
import no.hials.crosscom.kinematics.RobotModel;
import org.jspecify.annotations.Nullable;

/**
 * The limits of a loop, all on unless they are switched off. Immutable; made by {@link #create}.
 *
 * @param path limits of the tool centre point in Cartesian laws, mm; default 100 mm/s, 5 mm, 50 mm
 * @param rotation limits of the tool's rotation in Cartesian laws, degrees; default 30 degrees/s, 2
 *     degrees, 15 degrees
 * @param axes limits of each axis in joint laws, degrees; default 30 degrees/s, 2 degrees, 15
 *     degrees
 * @param axisLimits the ranges of the axes; if none are given, those that the controller says
 *     ({@code $SOFTN_END}, {@code $SOFTP_END})
 * @param axisMargin the distance that the axes have to keep from their limits, degrees; default 5
 * @param workspace where the tool centre point has to stay; if none is given, a cube that reaches
 *     300 mm from where it is at the start for Cartesian laws, and no limit for joint laws
 * @param workspaceMargin the distance to keep from the workspace's sides, mm; default 10
 * @param modes the operating modes in which the loop may run; default T1 only
 * @param checkInterval how often the mode, the program's state, the axes (Cartesian laws) or the
 *     position (joint laws), and the watchdog are read; default 300 ms
 * @param maxFeedbackAge how long reading where the robot is may take, and together with it the law;
 *     default 100 ms
 * @param maxStall how long the robot may stand although it was told to move; from one reading to
 *     the next a fifth of it is counted at most, so that a pause of this computer is not taken for
 *     a stall; default 500 ms
 * @param maxInputAge how old the input may be for motion; default 200 ms
 * @param watchdog how long the watchdog on the controller waits for a heartbeat until it stops the
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

  /** Half the side of the workspace of a Cartesian law that has none, mm. */
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
    Checks.between("greatest age of the feedback", maxFeedbackAge, SHORTEST, LONGEST);
    Checks.between("greatest time of a stall", maxStall, SHORTEST, LONGEST);
    Checks.between("greatest age of the input", maxInputAge, SHORTEST, LONGEST);
    if (!watchdog.isZero()) {
      Checks.between("time of the watchdog", watchdog, SHORTEST_WATCHDOG, LONGEST);
    }
  }

  /**
   * Makes limits.
   *
   * @param changes sets what is not to have its default
   * @return the limits
   * @throws IllegalArgumentException if a value is out of its range
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
     * @param step from one target to the next, mm
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
     * @param step from one target to the next, degrees
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
     * @param step from one target to the next, degrees
     * @param trackingError degrees
     * @return this
     */
    public Builder axes(double speed, double step, double trackingError) {
      axes = new MotionLimits(speed, step, trackingError);
      return this;
    }

    /**
     * Sets the ranges of the axes, in place of what the controller says.
     *
     * @param limits the ranges
     * @return this
     */
    public Builder axisLimits(AxisLimits limits) {
      axisLimits = limits;
      return this;
    }

    /**
     * Sets the ranges of the axes to those of a model, in place of what the controller says.
     *
     * @param model the robot
     * @return this
     */
    public Builder axisLimits(RobotModel model) {
      return axisLimits(AxisLimits.of(model));
    }

    /**
     * Sets the distance that the axes have to keep from their limits.
     *
     * @param degrees 0 or more
     * @return this
     */
    public Builder axisMargin(double degrees) {
      axisMargin = degrees;
      return this;
    }

    /**
     * Sets where the tool centre point has to stay, for joint laws too.
     *
     * @param box the workspace in {@code $BASE}
     * @return this
     */
    public Builder workspace(Workspace box) {
      workspace = box;
      return this;
    }

    /**
     * Sets the distance to keep from the workspace's sides.
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
     * @param first one of them
     * @param others the others
     * @return this
     */
    public Builder modes(OperatingMode first, OperatingMode... others) {
      modes = EnumSet.of(first, others);
      return this;
    }

    /**
     * Sets how often the mode, the program's state and the other one of axes and position are read.
     *
     * @param interval 1 ms to 10 s
     * @return this
     */
    public Builder checkInterval(Duration interval) {
      checkInterval = interval;
      return this;
    }

    /**
     * Sets how long reading where the robot is may take, and together with it the law.
     *
     * @param time 1 ms to 10 s
     * @return this
     */
    public Builder maxFeedbackAge(Duration time) {
      maxFeedbackAge = time;
      return this;
    }

    /**
     * Sets how long the robot may stand although it was told to move. It takes more than five
     * readings to be seen, however far apart they are.
     *
     * @param time 1 ms to 10 s
     * @return this
     */
    public Builder maxStall(Duration time) {
      maxStall = time;
      return this;
    }

    /**
     * Sets how old the input may be for motion.
     *
     * @param time 1 ms to 10 s
     * @return this
     */
    public Builder maxInputAge(Duration time) {
      maxInputAge = time;
      return this;
    }

    /**
     * Sets how long the watchdog on the controller waits for a heartbeat.
     *
     * @param time 50 ms to 10 s
     * @return this
     */
    public Builder watchdog(Duration time) {
      watchdog = time;
      return this;
    }

    /**
     * Sends no heartbeat, for a program without a watchdog: then nothing on the controller stops
     * the robot when the connection is lost.
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
