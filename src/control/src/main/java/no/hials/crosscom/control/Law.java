package no.hials.crosscom.control;

import no.hials.crosscom.kinematics.Axes;
import no.hials.crosscom.kinematics.Frame;

/**
 * Decides where the robot is to go: the user's own control method, asked once in each period.
 *
 * <p>It is called by the loop's thread, one call at a time, and must answer well within the period.
 * Whatever it throws stops the robot and ends the loop. It is not called while the robot has to
 * stand because nobody holds the dead-man.
 */
public sealed interface Law {

  /** Gives the position that the tool is to have: {@code x_t = x_d}. */
  @FunctionalInterface
  non-sealed interface CartesianPosition extends Law {
    /**
     * Decides.
     *
     * @param state where the robot is, and the time
     * @return where the tool is to be at the end of this period, in {@code $BASE}
     * @throws Exception to stop the robot
     */
    Frame position(State state) throws Exception;
  }

  /** Gives the velocity that the tool is to have: {@code x_t = x_a + v_d * dt}. */
  @FunctionalInterface
  non-sealed interface CartesianVelocity extends Law {
    /**
     * Decides.
     *
     * @param state where the robot is, and the time
     * @return how fast the tool is to move, along and about the axes of {@code $BASE}
     * @throws Exception to stop the robot
     */
    Twist velocity(State state) throws Exception;
  }

  /** Gives the angles that the axes are to have: {@code q_t = q_d}. */
  @FunctionalInterface
  non-sealed interface JointPosition extends Law {
    /**
     * Decides.
     *
     * @param state where the robot is, and the time
     * @return where the axes are to be at the end of this period, degrees
     * @throws Exception to stop the robot
     */
    Axes position(State state) throws Exception;
  }

  /** Gives the velocities that the axes are to have: {@code q_t = q_a + w_d * dt}. */
  @FunctionalInterface
  non-sealed interface JointVelocity extends Law {
    /**
     * Decides.
     *
     * @param state where the robot is, and the time
     * @return how fast the axes are to turn, degrees/s
     * @throws Exception to stop the robot
     */
    Axes velocity(State state) throws Exception;
  }

  /**
   * Names the kind of a lambda.
   *
   * @param law the law
   * @return the same
   */
  static CartesianPosition cartesianPosition(CartesianPosition law) {
    return law;
  }

  /**
   * Names the kind of a lambda.
   *
   * @param law the law
   * @return the same
   */
  static CartesianVelocity cartesianVelocity(CartesianVelocity law) {
    return law;
  }

  /**
   * Names the kind of a lambda.
   *
   * @param law the law
   * @return the same
   */
  static JointPosition jointPosition(JointPosition law) {
    return law;
  }

  /**
   * Names the kind of a lambda.
   *
   * @param law the law
   * @return the same
   */
  static JointVelocity jointVelocity(JointVelocity law) {
    return law;
  }
}
