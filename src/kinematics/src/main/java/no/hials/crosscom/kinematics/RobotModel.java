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
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.function.Function;
import no.hials.crosscom.kinematics.UnreachableException.Reason;
import no.hials.crosscom.protocol.value.Axis;
import no.hials.crosscom.protocol.value.Frame;
import no.hials.crosscom.protocol.value.KrlValue;
import org.jspecify.annotations.Nullable;

/**
 * A six-axis robot: its geometry, limits, speeds and home position, and its forward and inverse
 * kinematics. Immutable and thread-safe.
 *
 * <p>The robot is data: {@link #named} finds one of many robots, {@link #fromMachineData} reads
 * that of a controller, and {@link #load(Path)} reads a file in the format of {@code
 * kr6r900sixx.properties}, which is next to this class and explains its keys. The flange is in
 * {@code $ROBROOT} coordinates; lengths are in mm and angles in degrees. An axis index is 0 for A1
 * to 5 for A6.
 *
 * <p>In a singularity an axis angle is free. With Status and Turn, A1 is then 0 if the wrist centre
 * is on A1 (within 0.001 mm), and A4 is 0 if A5 is 0 (within 0.0001 degrees); this meaning of
 * {@code $SINGUL_POS} = 0 is assumed. On a path the angle stays the same.
 */
public final class RobotModel {
  private static final String KR6R900SIXX = "kr6r900sixx.properties";

  /** The bits of the Status; bit 4 (absolutely accurate robot) is accepted and ignored. */
  private static final int STATUS_BITS = 0b10111;

  private static final int TURN_BITS = 0b111111;

  /** The number of Statuses with different solutions: bits 0 to 2. */
  private static final int SOLUTIONS = 8;

  /** Solutions within this distance, degrees, are the same. */
  private static final double SAME = 1e-6;

  /**
   * This close to 0, degrees, an axis fits either bit of the Turn: a frame that was read as 32-bit
   * floats must not turn an axis at 0 by a full revolution. Assumed.
   */
  private static final double TURN_TOLERANCE = 0.01;

  /**
   * This close beyond a limit, degrees, an axis is at the limit, since frames are 32-bit floats.
   */
  private static final double LIMIT_TOLERANCE = 1e-4;

  private final String name;
  private final OrthoParallelArm arm;
  private final Axis minimum;
  private final Axis maximum;
  private final Axis maxSpeed;
  private final Axis maxAcceleration;
  private final Axis home;

  RobotModel(
      String name,
      OrthoParallelArm arm,
      Axis minimum,
      Axis maximum,
      Axis maxSpeed,
      Axis maxAcceleration,
      Axis home) {
    this.name = name;
    this.arm = arm;
    this.minimum = minimum;
    this.maximum = maximum;
    this.maxSpeed = maxSpeed;
    this.maxAcceleration = maxAcceleration;
    this.home = home;
  }

  /**
   * Returns the KR 6 R900 sixx (docs/reference/kinematics.md#kr-6-r900-sixx). Its accelerations are
   * assumed.
   */
  public static RobotModel kr6r900sixx() {
    return Kr6R900Sixx.MODEL;
  }

  /** Reads the file on first use. */
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
   * Returns a robot by its name. Its accelerations and home are assumed
   * (docs/reference/robots.md#sources).
   *
   * @param name such as "KR 210 R2700-2", in any case, with or without blanks
   * @throws IllegalArgumentException if the name is not one of {@link #names}; the message has the
   *     nearest ones
   */
  public static RobotModel named(String name) {
    return RobotTable.named(name);
  }

  /** Returns the names of the robots that {@link #named} knows. */
  public static List<String> names() {
    return RobotTable.names();
  }

  /**
   * Reads a model from a file.
   *
   * @param file a properties file in UTF-8
   * @throws IOException if the file cannot be read or is not a model; the message then has the
   *     file, the key, and the expected and actual value
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
   * @param nameForErrors the name of the file in messages
   * @throws IOException if the text cannot be read or is not a model; the message then has the
   *     file, the key, and the expected and actual value
   */
  public static RobotModel load(Reader reader, String nameForErrors) throws IOException {
    return RobotFile.read(reader, nameForErrors).toModel();
  }

  /**
   * Returns the robot that machine data describe (docs/reference/robots.md#machine-data). Its home
   * is XHOME, else {@code $AXIS_HOME[1]}, else assumed, as are accelerations without {@code
   * $RAISE_TIME}.
   *
   * @param variables returns the value of a variable such as {@code $LENGTH_A}, {@code $TX3P3},
   *     {@code $SOFTN_END[1]} or {@code $TRAFONAME[]}, or empty
   * @throws MachineDataException if a value is missing or the arm is of another kind, such as a
   *     palletizer; the message has the variable, and the expected and actual value
   */
  public static RobotModel fromMachineData(Function<String, Optional<KrlValue>> variables)
      throws MachineDataException {
    return MachineData.toModel(variables);
  }

  /**
   * Returns this robot's machine data, from which {@link #fromMachineData} creates it again.
   * Without the lengths of a robot whose axes have other offsets than a KUKA's.
   *
   * @return the values by variable, such as {@code $LENGTH_A} or {@code $SOFTN_END[1]}
   */
  public Map<String, KrlValue> machineData() {
    return MachineData.of(this, arm);
  }

  /** Returns the name of the robot, such as "KR 6 R900 sixx". */
  public String name() {
    return name;
  }

  /** Returns the lengths of the arm, and the directions of its axes. */
  public ArmGeometry geometry() {
    return new ArmGeometry(
        arm.a1(),
        arm.a2(),
        arm.b(),
        arm.c1(),
        arm.c2(),
        arm.c3(),
        arm.c4(),
        arm.sign(),
        arm.offset());
  }

  /** Returns the home position, where a simulated robot starts. */
  public Axis home() {
    return home;
  }

  /**
   * Returns the lower software limit of an axis.
   *
   * @param axis 0 for A1 to 5 for A6
   * @return the smallest angle allowed, degrees
   */
  public double minimum(int axis) {
    return minimum.get(axis);
  }

  /**
   * Returns the upper software limit of an axis.
   *
   * @param axis 0 for A1 to 5 for A6
   * @return the largest angle allowed, degrees
   */
  public double maximum(int axis) {
    return maximum.get(axis);
  }

  /**
   * Returns the highest speed of an axis.
   *
   * @param axis 0 for A1 to 5 for A6
   * @return the speed, degrees/s
   */
  public double maxSpeed(int axis) {
    return maxSpeed.get(axis);
  }

  /**
   * Returns the highest acceleration of an axis, for speeding up and for slowing down.
   *
   * @param axis 0 for A1 to 5 for A6
   * @return the acceleration, degrees/s²
   */
  public double maxAcceleration(int axis) {
    return maxAcceleration.get(axis);
  }

  RobotModel withHome(Axis position) {
    return new RobotModel(name, arm, minimum, maximum, maxSpeed, maxAcceleration, position);
  }

  /**
   * Returns this robot with other software limits ({@code $SOFTN_END}, {@code $SOFTP_END}). Home
   * may be outside them.
   *
   * @param minimum the smallest angles allowed, degrees
   * @param maximum the largest angles allowed, degrees
   */
  public RobotModel withLimits(Axis minimum, Axis maximum) {
    for (int axis = 0; axis < Axis.COUNT; axis++) {
      if (minimum.get(axis) >= maximum.get(axis)) {
        throw new IllegalArgumentException(
            String.format(
                Locale.ROOT,
                "the minimum of A%d must be less than its maximum, are %s and %s",
                axis + 1,
                minimum.get(axis),
                maximum.get(axis)));
      }
    }
    return new RobotModel(name, arm, minimum, maximum, maxSpeed, maxAcceleration, home);
  }

  /**
   * Returns the axes that are outside their software limits; an axis at its limit is inside.
   *
   * @param axes the positions to check
   * @return the indices of the axes, ascending: 0 for A1 to 5 for A6
   */
  public List<Integer> axesOutsideLimits(Axis axes) {
    return axesOutsideLimits(axes, 0);
  }

  /**
   * Returns the axes that are outside their software limits or closer to them than a margin.
   *
   * @param axes the positions to check
   * @param margin the margin, degrees
   * @return the indices of the axes, ascending: 0 for A1 to 5 for A6
   */
  public List<Integer> axesOutsideLimits(Axis axes, double margin) {
    if (!Double.isFinite(margin)) {
      throw new IllegalArgumentException("margin must be finite, is " + margin);
    }
    List<Integer> outside = new ArrayList<>();
    for (int axis = 0; axis < Axis.COUNT; axis++) {
      double angle = axes.get(axis);
      if (angle < minimum.get(axis) + margin || angle > maximum.get(axis) - margin) {
        outside.add(axis);
      }
    }
    return List.copyOf(outside);
  }

  /**
   * Returns the pose of the flange.
   *
   * @param axes the positions, inside their limits or not
   * @return the flange in {@code $ROBROOT}
   */
  public Frame forward(Axis axes) {
    return arm.chain(axes)[Axis.COUNT].toFrame();
  }

  /**
   * Returns the Status: bit 0 is set if the wrist centre is behind A1, bit 1 if A3 is at or above
   * the angle of the straight arm, bit 2 if A5 is negative
   * (docs/reference/kinematics.md#status-and-turn).
   *
   * @param axes the positions
   * @return KRL's S, 0 to 7
   */
  public int status(Axis axes) {
    return arm.status(axes);
  }

  /**
   * Returns the Turn: bit n is set if axis n+1 is negative.
   *
   * @param axes the positions
   * @return KRL's T, 0 to 63
   */
  public int turn(Axis axes) {
    int turn = 0;
    for (int axis = 0; axis < Axis.COUNT; axis++) {
      if (axes.get(axis) < 0) {
        turn |= 1 << axis;
      }
    }
    return turn;
  }

  /**
   * Returns all inverse solutions, ignoring the limits. Solutions that coincide in a singularity
   * are returned once.
   *
   * @param flange the flange in {@code $ROBROOT}
   * @return up to eight solutions in the order of their Status, each angle above -180 and up to 180
   *     degrees; empty if the flange is out of reach
   */
  public List<Axis> inverse(Frame flange) {
    List<Axis> solutions = new ArrayList<>();
    for (int status = 0; status < SOLUTIONS; status++) {
      if (arm.outOfReach(flange, status) == null) {
        Axis solution = arm.solve(flange, status, Axis.ZERO);
        if (solutions.stream().allMatch(other -> other.largestDifference(solution) > SAME)) {
          solutions.add(solution);
        }
      }
    }
    return List.copyOf(solutions);
  }

  /**
   * Returns the axis positions for a frame with Status and Turn, as PTP does. An axis whose Turn
   * bit is set is above -360 and below 0; other axes are from 0 to below 360. An axis within 0.01
   * degrees of 0 fits either bit. An axis up to 0.0001 degrees beyond a limit is set to the limit.
   *
   * @param flange the flange in {@code $ROBROOT}
   * @param status KRL's S; bit 4 is ignored
   * @param turn KRL's T
   * @return the positions, inside their limits
   * @throws UnreachableException without a solution
   */
  public Axis inverse(Frame flange, int status, int turn) throws UnreachableException {
    requireBits("Status", status, STATUS_BITS);
    requireBits("Turn", turn, TURN_BITS);
    requireReach(arm.outOfReach(flange, status));
    double[] axes = arm.solve(flange, status, Axis.ZERO).toArray();
    for (int axis = 0; axis < axes.length; axis++) {
      boolean negative = (turn & 1 << axis) != 0;
      if (Math.abs(axes[axis]) > TURN_TOLERANCE && negative != axes[axis] < 0) {
        axes[axis] += negative ? -360 : 360;
      }
    }
    return insideLimits(axes);
  }

  /**
   * Returns the axis positions that are nearest to other positions, as LIN and CIRC do from one
   * point of the path to the next. Bits 0 and 1 of the Status stay the same, and every axis stays
   * within 180 degrees. Assumed: bit 2 may change, so that a path through A5 = 0 continues with A5
   * on the other side and A4 unchanged; bit 0 may change if the wrist centre was on A1.
   *
   * @param flange the flange in {@code $ROBROOT}
   * @param near the previous positions, inside their limits or not
   * @return the positions, inside their limits
   * @throws UnreachableException without a solution
   */
  public Axis inverse(Frame flange, Axis near) throws UnreachableException {
    int side = arm.status(near) & ~OrthoParallelArm.WRIST;
    @Nullable Axis nearest = nearest(flange, side, near);
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
   * Returns the Jacobian matrix: the velocity of the flange per axis velocity.
   *
   * @param axes the positions
   * @return six rows with a column for each axis: the velocity of the flange along X, Y and Z (rows
   *     0 to 2, mm/s) and about X, Y and Z (rows 3 to 5, degrees/s) at 1 degree/s of the axis, in
   *     the directions of {@code $ROBROOT}
   */
  public double[][] jacobian(Axis axes) {
    return arm.jacobian(axes);
  }

  private @Nullable Axis nearest(Frame flange, int side, Axis near) {
    return arm.outOfReach(flange, side) == null
        ? nearer(
            around(arm.solve(flange, side, near), near),
            around(arm.solve(flange, side | OrthoParallelArm.WRIST, near), near),
            near)
        : null;
  }

  private static @Nullable Axis nearer(@Nullable Axis one, @Nullable Axis other, Axis near) {
    if (one == null || other == null) {
      return one == null ? other : one;
    }
    return other.largestDifference(near) < one.largestDifference(near) ? other : one;
  }

  /** Moves each axis by full revolutions until it is within 180 degrees of another position. */
  private static Axis around(Axis axes, Axis near) {
    double[] six = axes.toArray();
    for (int axis = 0; axis < six.length; axis++) {
      six[axis] = Numbers.near(six[axis], near.get(axis));
    }
    return Axis.of(six);
  }

  private Axis insideLimits(double[] six) throws UnreachableException {
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
    return Axis.of(six);
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
              "%s has only the bits %s, is %d",
              what,
              Integer.toBinaryString(bits),
              value));
    }
  }
}
