package no.hials.crosscom.lab.experiment;

import no.hials.crosscom.control.Law;
import no.hials.crosscom.control.Twist;
import no.hials.crosscom.protocol.value.Axis;
import no.hials.crosscom.protocol.value.Frame;
import no.hials.crosscom.simulator.KrlPrograms;

/** The four kinds of control of the papers, each with the plane in which it draws figures. */
enum ControlMethod {
  /** {@code x_t = x_d}, in increments of the tool. */
  POSITION("position", "position of the tool", RobotProgram.ACTUATOR) {
    @Override
    Law law(Shape shape, double lap) {
      return Law.cartesianPosition(
          state -> {
            Shape.Point p = shape.at((state.time() + state.period()) / lap).times(MM);
            return Twist.linear(0, p.u(), p.v()).move(START, 1);
          });
    }
  },

  /** {@code x_t = x_a + v_d dt}, in increments of the tool. */
  VELOCITY("velocity", "velocity of the tool", RobotProgram.ACTUATOR) {
    @Override
    Law law(Shape shape, double lap) {
      return Law.cartesianVelocity(
          state -> {
            Shape.Point v = shape.velocity(state.time() / lap).times(MM / lap);
            return Twist.linear(0, v.u(), v.v());
          });
    }
  },

  /** {@code q_t = q_d}, in increments of the axes. */
  JOINT_POSITION("joint-position", "angles of A1 and A2", RobotProgram.EXT_MOVE_AXIS) {
    @Override
    Law law(Shape shape, double lap) {
      return Law.jointPosition(
          state -> {
            Shape.Point p = shape.at((state.time() + state.period()) / lap).times(DEGREES);
            return KrlPrograms.START.plus(Axis.of(p.u(), p.v(), 0, 0, 0, 0));
          });
    }
  },

  /** {@code q_t = q_a + w_d dt}, in increments of the axes. */
  JOINT_VELOCITY("joint-velocity", "velocities of A1 and A2", RobotProgram.EXT_MOVE_AXIS) {
    @Override
    Law law(Shape shape, double lap) {
      return Law.jointVelocity(
          state -> {
            Shape.Point w = shape.velocity(state.time() / lap).times(DEGREES / lap);
            return Axis.of(w.u(), w.v(), 0, 0, 0, 0);
          });
    }
  };

  /** The length of 1 in a figure, mm. */
  private static final double MM = 50;

  private static final double DEGREES = 8;
  private static final Frame START = SimulatedRobot.MODEL.forward(KrlPrograms.START);

  private final String label;
  private final String quantity;
  private final RobotProgram program;

  ControlMethod(String label, String quantity, RobotProgram program) {
    this.label = label;
    this.quantity = quantity;
    this.program = program;
  }

  /** Creates the law that draws a figure. */
  abstract Law law(Shape shape, double lap);

  String label() {
    return label;
  }

  /** Returns the controlled quantity. */
  String quantity() {
    return quantity;
  }

  RobotProgram program() {
    return program;
  }

  private boolean isCartesian() {
    return program == RobotProgram.ACTUATOR;
  }

  String unit() {
    return isCartesian() ? "mm" : "°";
  }

  /** Returns the index in a trace of the horizontal coordinate; the vertical one follows it. */
  int firstCoordinate() {
    return isCartesian() ? 1 : 0;
  }

  String name(int coordinate) {
    return isCartesian() ? "XYZABC".substring(coordinate, coordinate + 1) : "A" + (coordinate + 1);
  }

  /** Returns the set point at a time, in the coordinates of a trace. */
  Shape.Point desired(Shape shape, double part) {
    Shape.Point p = shape.at(part).times(isCartesian() ? MM : DEGREES);
    return isCartesian()
        ? new Shape.Point(START.y() + p.u(), START.z() + p.v())
        : new Shape.Point(KrlPrograms.START.get(0) + p.u(), KrlPrograms.START.get(1) + p.v());
  }
}
