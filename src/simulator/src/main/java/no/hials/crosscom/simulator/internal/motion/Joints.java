package no.hials.crosscom.simulator.internal.motion;

import no.hials.crosscom.protocol.value.Axis;

/**
 * The positions of all axes.
 *
 * @param robot A1 to A6, degrees
 * @param external E1 to E6, degrees, or mm if linear; 0 for those that do not exist
 */
public record Joints(Axis robot, Axis external) {
  Joints minus(Joints other) {
    return new Joints(robot.minus(other.robot), external.minus(other.external));
  }

  double largestDifference(Joints other) {
    return Math.max(
        robot.largestDifference(other.robot), external.largestDifference(other.external));
  }
}
