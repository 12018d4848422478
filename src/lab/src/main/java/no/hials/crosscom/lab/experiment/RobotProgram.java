package no.hials.crosscom.lab.experiment;

import no.hials.crosscom.control.Law;
import no.hials.crosscom.control.Target;
import no.hials.crosscom.control.Twist;
import no.hials.crosscom.protocol.value.Axis;

/** The programs of {@code krl} that move by increments, as the programs of the papers did. */
enum RobotProgram {
  ACTUATOR("MYPOS") {
    @Override
    Law standing() {
      return Law.cartesianVelocity(state -> Twist.linear(0, 0, 0));
    }
  },
  EXT_MOVE_AXIS("MYAXIS") {
    @Override
    Law standing() {
      return Law.jointVelocity(state -> Axis.ZERO);
    }
  };

  private final String variable;

  RobotProgram(String variable) {
    this.variable = variable;
  }

  Target target() {
    return Target.increment(variable);
  }

  /** Creates a law of the program's kind that keeps the robot at rest. */
  abstract Law standing();
}
