package no.hials.crosscom.control;

import no.hials.crosscom.protocol.value.Axis;
import no.hials.crosscom.protocol.value.Frame;

/**
 * A control law: computes the next command, once in each period.
 *
 * <p>The thread of the loop calls it, one call at a time, and it must return well within the
 * period. Any exception stops the robot and ends the loop. It is not called while nobody holds the
 * dead-man.
 */
public sealed interface Law {

  /** Computes the position of the tool: {@code x_t = x_d}. */
  @FunctionalInterface
  non-sealed interface CartesianPosition extends Law {
    /**
     * Returns the desired position.
     *
     * @param state the state of the robot, and the time
     * @return the desired position of the tool at the end of this period, in {@code $BASE}
     * @throws Exception to stop the robot
     */
    Frame position(State state) throws Exception;
  }

  /** Computes the velocity of the tool: {@code x_t = x_a + v_d * dt}. */
  @FunctionalInterface
  non-sealed interface CartesianVelocity extends Law {
    /**
     * Returns the desired velocity. If the loop sends increments, it shortens them by the square
     * root of the override {@code $OV_PRO}.
     *
     * @param state the state of the robot, and the time
     * @return the desired velocity of the tool, along and about the axes of {@code $BASE}
     * @throws Exception to stop the robot
     */
    Twist velocity(State state) throws Exception;
  }

  /** Computes the axis positions: {@code q_t = q_d}. */
  @FunctionalInterface
  non-sealed interface JointPosition extends Law {
    /**
     * Returns the desired positions.
     *
     * @param state the state of the robot, and the time
     * @return the desired axis positions at the end of this period, degrees
     * @throws Exception to stop the robot
     */
    Axis position(State state) throws Exception;
  }

  /** Computes the axis velocities: {@code q_t = q_a + w_d * dt}. */
  @FunctionalInterface
  non-sealed interface JointVelocity extends Law {
    /**
     * Returns the desired velocities. If the loop sends increments, it shortens them by the square
     * root of the override {@code $OV_PRO}.
     *
     * @param state the state of the robot, and the time
     * @return the desired axis velocities, degrees/s
     * @throws Exception to stop the robot
     */
    Axis velocity(State state) throws Exception;
  }

  /** Returns a lambda as a law of this kind. */
  static CartesianPosition cartesianPosition(CartesianPosition law) {
    return law;
  }

  /** Returns a lambda as a law of this kind. */
  static CartesianVelocity cartesianVelocity(CartesianVelocity law) {
    return law;
  }

  /** Returns a lambda as a law of this kind. */
  static JointPosition jointPosition(JointPosition law) {
    return law;
  }

  /** Returns a lambda as a law of this kind. */
  static JointVelocity jointVelocity(JointVelocity law) {
    return law;
  }
}
