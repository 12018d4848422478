package no.hials.crosscom.kinematics;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStream;
import java.io.InputStreamReader;
import java.io.Reader;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Objects;
import no.hials.crosscom.kinematics.UnreachableException.Reason;
import org.jspecify.annotations.Nullable;

/**
 * A six-axis robot: its geometry, limits, speeds and home, and the way from axis angles to the
 * flange and back. Immutable and safe for use by any number of threads.
 *
 * <p>The robot is data: {@link #load(Path)} reads another one from a file in the format of {@code
 * kr6r900sixx.properties}, which lies beside this class and explains its keys. The flange is given
 * in {@code $ROBROOT}; the file's lengths are mm, all angles degrees. An axis index is 0 for A1 to
 * 5 for A6.
 *
 * <p>In a singularity some axis angle is free; {@code $SINGUL_POS} is 0 in krl.md 2, and what that
 * means is assumed: going to a frame by Status and Turn, A1 is 0 if the wrist centre lies on A1
 * (within 0.001 mm), and A4 is 0 if A5 is 0 (within 0.0001 degrees). On a path the angle stays as
 * it is.
 */
public final class RobotModel {
  private static final String KR6R900SIXX = "kr6r900sixx.properties";

  /** The bits of the Status that have a meaning; bit 4 (absolutely accurate) is of no use here. */
  private static final int STATUS_BITS = 0b10111;

  private static final int TURN_BITS = 0b111111;

  /** The Statuses with different solutions: bits 0 to 2. */
  private static final int SOLUTIONS = 8;

  /** Two solutions no further apart than this, degrees, are one. */
  private static final double SAME = 1e-6;

  /**
   * So near to 0, degrees, an axis fits either bit of the Turn: a frame that was read as 32-bit
   * floats must not send an axis that was at 0 once round. Assumed.
   */
  private static final double TURN_TOLERANCE = 0.01;

  /**
   * So little beyond a limit, degrees, an axis is at the limit: again, frames are 32-bit floats.
   */
  private static final double LIMIT_TOLERANCE = 1e-4;

  private final String name;
  private final OrthoParallelArm arm;
  private final Axes minimum;
  private final Axes maximum;
  private final Axes maxSpeed;
  private final Axes maxAcceleration;
  private final Axes home;

  RobotModel(
      String name,
      OrthoParallelArm arm,
      Axes minimum,
      Axes maximum,
      Axes maxSpeed,
      Axes maxAcceleration,
      Axes home) {
    this.name = name;
    this.arm = arm;
    this.minimum = minimum;
    this.maximum = maximum;
    this.maxSpeed = maxSpeed;
    this.maxAcceleration = maxAcceleration;
    this.home = home;
  }

  /**
   * Gives the KR 6 R900 sixx (krl.md 3). Its accelerations are assumed.
   *
   * @return the model
   */
  public static RobotModel kr6r900sixx() {
    return Kr6R900Sixx.MODEL;
  }

  /** Reads the file when it is asked for the first time. */
  private static final class Kr6R900Sixx {
    static final RobotModel MODEL = read();

    private static RobotModel read() {
      InputStream file =
          Objects.requireNonNull(RobotModel.class.getResourceAsStream(KR6R900SIXX), KR6R900SIXX);
      try (Reader reader = new InputStreamReader(file, StandardCharsets.UTF_8)) {
        return load(reader, KR6R900SIXX);
      } catch (IOException e) {
        throw new UncheckedIOException(e);
      }
    }
  }

  /**
   * Reads a model from a file.
   *
   * @param file a properties file in UTF-8
   * @return the model
   * @throws IOException if the file cannot be read, or is not a model: the message then has the
   *     file, the key, what is expected and what was found
   */
  public static RobotModel load(Path file) throws IOException {
    try (BufferedReader reader = Files.newBufferedReader(file)) {
      return load(reader, file.toString());
    }
  }

  /**
   * Reads a model.
   *
   * @param reader the text of a properties file; not closed
   * @param nameForErrors what messages call the file
   * @return the model
   * @throws IOException if the text cannot be read, or is not a model: the message then has the
   *     file, the key, what is expected and what was found
   */
  public static RobotModel load(Reader reader, String nameForErrors) throws IOException {
    return RobotFile.read(reader, nameForErrors).toModel();
  }

  /**
   * Names the robot.
   *
   * @return the name, as "KR 6 R900 sixx"
   */
  public String name() {
    return name;
  }

  /**
   * Gives where the robot stands at first.
   *
   * @return the home position
   */
  public Axes home() {
    return home;
  }

  /**
   * Gives the lower software limit of an axis.
   *
   * @param axis 0 for A1 to 5 for A6
   * @return the smallest angle allowed, degrees
   */
  public double minimum(int axis) {
    return minimum.get(axis);
  }

  /**
   * Gives the upper software limit of an axis.
   *
   * @param axis 0 for A1 to 5 for A6
   * @return the largest angle allowed, degrees
   */
  public double maximum(int axis) {
    return maximum.get(axis);
  }

  /**
   * Gives the highest speed of an axis.
   *
   * @param axis 0 for A1 to 5 for A6
   * @return the speed, degrees/s
   */
  public double maxSpeed(int axis) {
    return maxSpeed.get(axis);
  }

  /**
   * Gives the highest acceleration of an axis, for speeding up and for slowing down.
   *
   * @param axis 0 for A1 to 5 for A6
   * @return the acceleration, degrees/s²
   */
  public double maxAcceleration(int axis) {
    return maxAcceleration.get(axis);
  }

  /**
   * Changes the software limits ({@code $SOFTN_END}, {@code $SOFTP_END}); home may then lie outside
   * of them.
   *
   * @param minimum the smallest angles allowed, degrees
   * @param maximum the largest angles allowed, degrees
   * @return the same robot with these limits
   */
  public RobotModel withLimits(Axes minimum, Axes maximum) {
    for (int axis = 0; axis < Axes.COUNT; axis++) {
      if (minimum.get(axis) >= maximum.get(axis)) {
        throw new IllegalArgumentException(
            String.format(
                Locale.ROOT,
                "the limits of A%d must be a minimum below a maximum, are %s and %s",
                axis + 1,
                minimum.get(axis),
                maximum.get(axis)));
      }
    }
    return new RobotModel(name, arm, minimum, maximum, maxSpeed, maxAcceleration, home);
  }

  /**
   * Finds the axes that are outside their software limits; at a limit is inside.
   *
   * @param axes the axes to check
   * @return the indices of those outside, ascending: 0 for A1 to 5 for A6
   */
  public List<Integer> axesOutsideLimits(Axes axes) {
    return axesOutsideLimits(axes, 0);
  }

  /**
   * Finds the axes that do not keep a distance from their software limits.
   *
   * @param axes the axes to check
   * @param margin the distance to keep, degrees
   * @return the indices of those that do not, ascending: 0 for A1 to 5 for A6
   */
  public List<Integer> axesOutsideLimits(Axes axes, double margin) {
    Numbers.finite("margin", margin);
    List<Integer> outside = new ArrayList<>();
    for (int axis = 0; axis < Axes.COUNT; axis++) {
      double angle = axes.get(axis);
      if (angle < minimum.get(axis) + margin || angle > maximum.get(axis) - margin) {
        outside.add(axis);
      }
    }
    return List.copyOf(outside);
  }

  /**
   * Computes where the flange is.
   *
   * @param axes the axes, inside their limits or not
   * @return the flange in {@code $ROBROOT}
   */
  public Frame forward(Axes axes) {
    return arm.chain(axes)[Axes.COUNT].toFrame();
  }

  /**
   * Computes the Status (krl.md 3): bit 0 is set if the wrist centre lies behind A1, bit 1 if A3 is
   * at or above the angle of the straight arm, bit 2 if A5 is negative (at 0 krl.md 2.1 is
   * followed, whose home position has S 2, and not krl.md 3, which marks its rule U). So home has S
   * 6; the {@code $POS_ACT} of krl.md 2, computed as well, has S 2 there.
   *
   * @param axes the axes
   * @return KRL's S, 0 to 7
   */
  public int status(Axes axes) {
    return arm.status(axes);
  }

  /**
   * Computes the Turn (krl.md 3): bit n is set if axis n+1 is negative.
   *
   * @param axes the axes
   * @return KRL's T, 0 to 63
   */
  public int turn(Axes axes) {
    int turn = 0;
    for (int axis = 0; axis < Axes.COUNT; axis++) {
      if (axes.get(axis) < 0) {
        turn |= 1 << axis;
      }
    }
    return turn;
  }

  /**
   * Finds all solutions, whatever the limits. Solutions that meet in a singularity are one.
   *
   * @param flange the flange in {@code $ROBROOT}
   * @return up to eight solutions in the order of their Status, each angle above -180 and up to 180
   *     degrees; none if the flange is out of reach
   */
  public List<Axes> inverse(Frame flange) {
    List<Axes> solutions = new ArrayList<>();
    for (int status = 0; status < SOLUTIONS; status++) {
      if (arm.outOfReach(flange, status) == null) {
        Axes solution = arm.solve(flange, status, Axes.ZERO);
        if (solutions.stream().allMatch(other -> other.largestDifference(solution) > SAME)) {
          solutions.add(solution);
        }
      }
    }
    return List.copyOf(solutions);
  }

  /**
   * Finds the axes for a frame with Status and Turn, as PTP does. An axis whose bit is set in the
   * Turn is below 0 and above -360, another is from 0 to below 360; but an axis within 0.01 degrees
   * of 0 fits either bit. An axis up to 0.0001 degrees beyond a limit is at the limit.
   *
   * @param flange the flange in {@code $ROBROOT}
   * @param status KRL's S; bit 4 is ignored
   * @param turn KRL's T
   * @return the axes, inside their limits
   * @throws UnreachableException if there are none
   */
  public Axes inverse(Frame flange, int status, int turn) throws UnreachableException {
    requireBits("Status", status, STATUS_BITS);
    requireBits("Turn", turn, TURN_BITS);
    requireReach(arm.outOfReach(flange, status));
    double[] axes = arm.solve(flange, status, Axes.ZERO).toArray();
    for (int axis = 0; axis < axes.length; axis++) {
      boolean negative = (turn & 1 << axis) != 0;
      if (Math.abs(axes[axis]) > TURN_TOLERANCE && negative != axes[axis] < 0) {
        axes[axis] += negative ? -360 : 360;
      }
    }
    return insideLimits(axes);
  }

  /**
   * Finds the axes that are nearest to others, as LIN and CIRC do from one point of the path to the
   * next: bits 0 and 1 of the Status stay (krl.md 3, marked U), and every axis is within 180
   * degrees of where it was. Assumed: bit 2 may change, so that a path through A5 = 0 goes on with
   * A5 on the other side and A4 where it was; so may bit 0 if the wrist centre was on A1.
   *
   * @param flange the flange in {@code $ROBROOT}
   * @param near the axes before, inside their limits or not
   * @return the axes, inside their limits
   * @throws UnreachableException if there are none
   */
  public Axes inverse(Frame flange, Axes near) throws UnreachableException {
    int side = arm.status(near) & ~OrthoParallelArm.WRIST;
    @Nullable Axes nearest = nearest(flange, side, near);
    if (arm.overhead(near)) {
      nearest = nearer(nearest, nearest(flange, side ^ OrthoParallelArm.BEHIND, near), near);
    }
    if (nearest == null) {
      throw new UnreachableException(
          Reason.REACH, Objects.requireNonNull(arm.outOfReach(flange, side)));
    }
    return insideLimits(nearest.toArray());
  }

  /**
   * Computes how the flange moves when the axes turn.
   *
   * @param axes the axes
   * @return a matrix of six rows, with a column for each axis: what the axis, turned with 1
   *     degree/s, adds to the velocity of the flange's origin along X, Y and Z (rows 0 to 2, mm/s)
   *     and to the flange's rotation about X, Y and Z (rows 3 to 5, degrees/s), all directions
   *     being those of {@code $ROBROOT}
   */
  public double[][] jacobian(Axes axes) {
    return arm.jacobian(axes);
  }

  private @Nullable Axes nearest(Frame flange, int side, Axes near) {
    return arm.outOfReach(flange, side) == null
        ? nearer(
            around(arm.solve(flange, side, near), near),
            around(arm.solve(flange, side | OrthoParallelArm.WRIST, near), near),
            near)
        : null;
  }

  private static @Nullable Axes nearer(@Nullable Axes one, @Nullable Axes other, Axes near) {
    if (one == null || other == null) {
      return one == null ? other : one;
    }
    return other.largestDifference(near) < one.largestDifference(near) ? other : one;
  }

  /** Takes each axis to the revolution in which it is within 180 degrees of another. */
  private static Axes around(Axes axes, Axes near) {
    double[] six = axes.toArray();
    for (int axis = 0; axis < six.length; axis++) {
      six[axis] = Numbers.near(six[axis], near.get(axis));
    }
    return Axes.of(six);
  }

  private Axes insideLimits(double[] six) throws UnreachableException {
    for (int axis = 0; axis < six.length; axis++) {
      double inside = Math.max(minimum.get(axis), Math.min(maximum.get(axis), six[axis]));
      if (Math.abs(six[axis] - inside) > LIMIT_TOLERANCE) {
        throw new UnreachableException(
            Reason.AXIS_LIMIT,
            String.format(
                Locale.ROOT,
                "axis limit A%d %s exceeded, would be %.4f degrees",
                axis + 1,
                inside,
                six[axis]));
      }
      six[axis] = inside;
    }
    return Axes.of(six);
  }

  private static void requireReach(@Nullable String outOfReach) throws UnreachableException {
    if (outOfReach != null) {
      throw new UnreachableException(Reason.REACH, outOfReach);
    }
  }

  private static void requireBits(String what, int value, int bits) throws UnreachableException {
    if ((value & ~bits) != 0) {
      throw new UnreachableException(
          Reason.STATUS_OR_TURN,
          String.format(
              Locale.ROOT,
              "no such %s: it has the bits %s, is %d",
              what,
              Integer.toBinaryString(bits),
              value));
    }
  }
}
