package no.hials.crosscom.kinematics;

import no.hials.crosscom.protocol.value.Axis;

/**
 * The geometry of a {@link RobotModel}: lengths in mm with the arm stretched upwards, as in
 * docs/reference/robots.md#arms.
 *
 * <p>The chain from the foot to the flange is Tz(c1) Rz(t1) Tx(a1) Ry(t2) Tz(c2) Ry(t3) T(a2, b,
 * c3) Rz(t4) Ry(t5) Rz(t6) Tz(c4), where t is {@code direction * (axis - offset)}.
 *
 * @param a1 from A1 to A2, forward
 * @param a2 from A3 to the wrist centre, forward
 * @param b from A1 to the wrist centre, to the left
 * @param c1 from the floor to A2, up
 * @param c2 from A2 to A3, up
 * @param c3 from A3 to the wrist centre, up
 * @param c4 from the wrist centre to the flange, up
 * @param direction 1 for an axis that turns by the right-hand rule, otherwise -1
 * @param offset the axis positions with the arm stretched upwards, degrees
 */
public record ArmGeometry(
    double a1,
    double a2,
    double b,
    double c1,
    double c2,
    double c3,
    double c4,
    Axis direction,
    Axis offset) {}
