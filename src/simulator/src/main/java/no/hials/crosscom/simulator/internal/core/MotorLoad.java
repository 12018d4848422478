package no.hials.crosscom.simulator.internal.core;

import no.hials.crosscom.kinematics.RobotModel;
import no.hials.crosscom.protocol.value.Axis;

/**
 * Torques, currents and temperatures of the motors that follow the motion, so that loggers have
 * something to log. Invented: no mass of the robot and no motor is known.
 */
final class MotorLoad {
  /** The highest torque of A1 to A6, Nm. */
  private static final Axis HIGHEST_TORQUE = Axis.of(600, 600, 350, 60, 60, 40);

  /** The shares of the highest torque at the highest speed and acceleration. */
  private static final double BY_SPEED = 0.2;

  private static final double BY_ACCELERATION = 0.6;

  /** The time to the highest speed, s, as for the motions. */
  private static final double RAISE_TIME = 0.3;

  private static final double PERCENT = 100;

  /** The rise of the temperature at the highest current, K, and its time constant, s. */
  private static final double HEATING = 200;

  private static final double THERMAL_TIME = 60;

  private final double[] velocity = new double[PositionValues.ROBOT_AXES];
  private final double[] share = new double[PositionValues.ROBOT_AXES];
  private final double[] rise = new double[PositionValues.ROBOT_AXES];

  /**
   * Called after each cycle.
   *
   * @param now degrees/s
   * @param seconds the length of the cycle
   */
  void cycle(Axis now, RobotModel robot, double seconds) {
    for (int i = 0; i < PositionValues.ROBOT_AXES; i++) {
      double highest = robot.maxSpeed(i);
      double acceleration = (now.get(i) - velocity[i]) / seconds;
      velocity[i] = now.get(i);
      double part =
          BY_SPEED * velocity[i] / highest + BY_ACCELERATION * acceleration * RAISE_TIME / highest;
      share[i] = Math.max(-1, Math.min(1, part));
      rise[i] += (HEATING * share[i] * share[i] - rise[i]) * seconds / THERMAL_TIME;
    }
  }

  /** Returns Nm. */
  double[] torques() {
    double[] torques = new double[PositionValues.ROBOT_AXES];
    for (int i = 0; i < torques.length; i++) {
      torques[i] = share[i] * HIGHEST_TORQUE.get(i);
    }
    return torques;
  }

  /** Returns % of the highest currents, with the signs of the torques. */
  double[] currents() {
    double[] currents = new double[PositionValues.ROBOT_AXES];
    for (int i = 0; i < currents.length; i++) {
      currents[i] = PERCENT * share[i];
    }
    return currents;
  }

  /** Returns by how many K the motors are warmer than at the start. */
  double[] temperatureRises() {
    return rise.clone();
  }
}
