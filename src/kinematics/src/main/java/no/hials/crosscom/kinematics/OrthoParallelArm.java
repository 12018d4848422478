package no.hials.crosscom.kinematics;

import java.util.Locale;
import no.hials.crosscom.protocol.value.Axis;
import no.hials.crosscom.protocol.value.Frame;
import org.jspecify.annotations.Nullable;

/**
 * The geometry of an arm with an ortho-parallel base (A2 and A3 parallel, both perpendicular to A1)
 * and a spherical wrist (A4, A5 and A6 intersect in the wrist centre). Its inverse kinematics has a
 * closed solution.
 *
 * <p>Internally, an angle {@code theta} is {@code sign * (axis - offset)}: all are 0 with the arm
 * stretched upwards, and all follow the right-hand rule.
 *
 * @param a1 from A1 to A2, forward, mm
 * @param a2 from A3 to the wrist centre, forward, mm
 * @param b from A1 to the wrist centre, to the left, mm
 * @param c1 from the floor to A2, up, mm
 * @param c2 from A2 to A3, up, mm
 * @param c3 from A3 to the wrist centre, up, mm
 * @param c4 from the wrist centre to the flange, up, mm
 * @param sign 1 or -1 for each axis
 * @param offset the axis positions with the arm stretched upwards, degrees
 */
record OrthoParallelArm(
    double a1,
    double a2,
    double b,
    double c1,
    double c2,
    double c3,
    double c4,
    Axis sign,
    Axis offset) {
  /**
   * Bit 0 of the Status: the wrist centre is behind A1
   * (docs/reference/kinematics.md#status-and-turn).
   */
  static final int BEHIND = 1;

  /** Bit 1 of the Status: A3 is at or above the angle of the straight arm. */
  static final int ELBOW = 2;

  /**
   * Bit 2 of the Status: A5 is negative. At A5 = 0 the sources disagree; the bit is clear here, as
   * in the home position of a real controller.
   */
  static final int WRIST = 4;

  /**
   * The tolerance of a position, mm. A REAL is a 32-bit float, and the axes that were read with a
   * frame must still reach it.
   */
  private static final double LENGTH_TOLERANCE = 1e-3;

  /**
   * This close to A5 = 0, A4 and A6 are one axis, degrees; more than the rounding of a 32-bit
   * float.
   */
  private static final double WRIST_SINGULARITY = 1e-4;

  /** Returns the coordinate systems of A1 to A6, then of the flange. */
  Transform[] chain(Axis axes) {
    Transform one = Transform.IDENTITY.translate(0, 0, c1);
    Transform two = one.rotateZ(theta(axes, 0)).translate(a1, 0, 0);
    Transform three = two.rotateY(theta(axes, 1)).translate(0, 0, c2);
    Transform four = three.rotateY(theta(axes, 2)).translate(a2, b, c3);
    Transform five = four.rotateZ(theta(axes, 3));
    Transform six = five.rotateY(theta(axes, 4));
    Transform flange = six.rotateZ(theta(axes, 5)).translate(0, 0, c4);
    return new Transform[] {one, two, three, four, five, six, flange};
  }

  /**
   * Returns the Jacobian, per degree, with the rows in the order of {@link RobotModel#jacobian}.
   */
  double[][] jacobian(Axis axes) {
    Transform[] chain = chain(axes);
    Vector flange = chain[Axis.COUNT].position();
    double[][] rows = new double[6][Axis.COUNT];
    for (int axis = 0; axis < Axis.COUNT; axis++) {
      Vector line = axis == 1 || axis == 2 || axis == 4 ? Vector.Y : Vector.Z;
      Vector turn = chain[axis].rotation().rotate(line).times(sign.get(axis));
      Vector way = turn.cross(flange.minus(chain[axis].position())).times(Math.toRadians(1));
      double[] column = {way.x(), way.y(), way.z(), turn.x(), turn.y(), turn.z()};
      for (int row = 0; row < column.length; row++) {
        rows[row][axis] = column[row];
      }
    }
    return rows;
  }

  int status(Axis axes) {
    double a3 = sign.a3() * (theta(axes, 2) + forearmAngle());
    int behind = forward(axes) < -LENGTH_TOLERANCE ? BEHIND : 0;
    int elbow = Numbers.normalised(a3) >= 0 ? ELBOW : 0;
    int wrist = Numbers.normalised(axes.a5() - offset.a5()) < 0 ? WRIST : 0;
    return behind | elbow | wrist;
  }

  /** Returns whether the wrist centre is on A1, where front and rear are the same. */
  boolean overhead(Axis axes) {
    return Math.abs(forward(axes)) <= LENGTH_TOLERANCE;
  }

  /**
   * Returns why the flange is out of reach, or null. Of the Status only {@link #BEHIND} matters.
   */
  @Nullable String outOfReach(Frame flange, int status) {
    Vector wrist = wristCentre(Transform.of(flange));
    double fromA1 = Math.hypot(wrist.x(), wrist.y());
    if (fromA1 < Math.abs(b) - LENGTH_TOLERANCE) {
      return tooNear(Math.abs(b), fromA1, "A1");
    }
    double fromA2 = Math.hypot(forward(wrist, status) - a1, wrist.z() - c1);
    double longest = c2 + forearm();
    double shortest = Math.abs(c2 - forearm());
    if (fromA2 > longest + LENGTH_TOLERANCE) {
      return String.format(
              Locale.ROOT,
              "the wrist centre is %.3f mm beyond reach, which is %.3f mm from A2",
              fromA2 - longest,
              longest)
          + side(status);
    }
    return fromA2 < shortest - LENGTH_TOLERANCE
        ? tooNear(shortest, fromA2, "A2") + side(status)
        : null;
  }

  /**
   * Returns the solution of a status, each angle above -180 and up to 180. The flange must be in
   * reach. An angle that is free in a singularity is taken from {@code free}: A1 if the wrist
   * centre is on A1, and A4 if A5 is 0.
   */
  Axis solve(Frame flange, int status, Axis free) {
    Transform target = Transform.of(flange);
    Vector wrist = wristCentre(target);
    double forward = forward(wrist, status);
    double theta1 =
        Math.hypot(wrist.x(), wrist.y()) <= LENGTH_TOLERANCE
            ? theta(free, 0)
            : Math.toDegrees(Math.atan2(wrist.y(), wrist.x()) - Math.atan2(b, forward));
    double bend = bend(Math.hypot(forward - a1, wrist.z() - c1), status);
    double theta2 =
        Math.toDegrees(
            Math.atan2(forward - a1, wrist.z() - c1)
                - Math.atan2(forearm() * Math.sin(bend), c2 + forearm() * Math.cos(bend)));
    double theta3 = Math.toDegrees(bend) - forearmAngle();
    Rotation hand =
        Rotation.aboutZ(theta1)
            .times(Rotation.aboutY(theta2 + theta3))
            .inverse()
            .times(target.rotation());
    double[] wristAngles = wristAngles(hand, status, theta(free, 3));
    return new Axis(
        axis(0, theta1),
        axis(1, theta2),
        axis(2, theta3),
        axis(3, wristAngles[0]),
        axis(4, wristAngles[1]),
        axis(5, wristAngles[2]));
  }

  /**
   * Splits a rotation into the rotations of A4, A5 and A6. The quaternion of Rz(4) Ry(5) Rz(6) is
   *
   * <pre>
   * w =  cos(5/2) cos((4+6)/2)     x = -sin(5/2) sin((4-6)/2)
   * z =  cos(5/2) sin((4+6)/2)     y =  sin(5/2) cos((4-6)/2)
   * </pre>
   *
   * which shows the sum and the difference of A4 and A6.
   */
  private double[] wristAngles(Rotation hand, int status, double free4) {
    double theta5 =
        2
            * Math.toDegrees(
                Math.atan2(Math.hypot(hand.x(), hand.y()), Math.hypot(hand.w(), hand.z())));
    double sum = 2 * Math.toDegrees(Math.atan2(hand.z(), hand.w()));
    if (theta5 < WRIST_SINGULARITY) {
      return new double[] {free4, 0, sum - free4};
    }
    double difference = 2 * Math.toDegrees(Math.atan2(-hand.x(), hand.y()));
    boolean negative = isSet(status, WRIST) == sign.a5() > 0;
    double theta4 = (sum + difference) / 2 + (negative ? 180 : 0);
    return new double[] {theta4, negative ? -theta5 : theta5, sum - theta4};
  }

  /** Returns the angle of the elbow from the straight arm, in radians, by the law of cosines. */
  private double bend(double fromA2, int status) {
    double cosine = (fromA2 * fromA2 - c2 * c2 - forearm() * forearm()) / (2 * c2 * forearm());
    double bend = Math.acos(Math.max(-1, Math.min(1, cosine)));
    return isSet(status, ELBOW) == sign.a3() > 0 ? bend : -bend;
  }

  private Vector wristCentre(Transform flange) {
    return flange.translate(0, 0, -c4).position();
  }

  /** Returns the distance of the wrist centre in front of A1 for these axes, negative behind A1. */
  private double forward(Axis axes) {
    double theta2 = theta(axes, 1);
    double theta3 = theta(axes, 2) + forearmAngle();
    return a1
        + c2 * Math.sin(Math.toRadians(theta2))
        + forearm() * Math.sin(Math.toRadians(theta2 + theta3));
  }

  /** Returns the distance of a wrist centre in front of A1 for this status, negative behind A1. */
  private double forward(Vector wrist, int status) {
    double fromA1 = Math.hypot(wrist.x(), wrist.y());
    double forward = Math.sqrt(Math.max(0, (fromA1 - b) * (fromA1 + b)));
    return isSet(status, BEHIND) ? -forward : forward;
  }

  private double forearm() {
    return Math.hypot(a2, c3);
  }

  /** Returns the angle at A3 between the forearm and the line to the wrist centre, degrees. */
  private double forearmAngle() {
    return Math.toDegrees(Math.atan2(a2, c3));
  }

  private double theta(Axis axes, int axis) {
    return sign.get(axis) * (axes.get(axis) - offset.get(axis));
  }

  private double axis(int axis, double theta) {
    return Numbers.normalised(sign.get(axis) * theta + offset.get(axis));
  }

  private static boolean isSet(int status, int bit) {
    return (status & bit) != 0;
  }

  private static String tooNear(double shortest, double actual, String axis) {
    return String.format(
        Locale.ROOT,
        "the wrist centre is %.3f mm too close to %s, its minimum distance is %.3f mm",
        shortest - actual,
        axis,
        shortest);
  }

  private static String side(int status) {
    return isSet(status, BEHIND) ? ", with the wrist centre behind A1 (bit 0 of the Status)" : "";
  }
}
