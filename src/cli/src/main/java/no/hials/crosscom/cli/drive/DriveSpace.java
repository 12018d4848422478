package no.hials.crosscom.cli.drive;

import static no.hials.crosscom.kinematics.Frames.product;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import no.hials.crosscom.control.Law;
import no.hials.crosscom.control.State;
import no.hials.crosscom.control.Twist;
import no.hials.crosscom.control.input.Input;
import no.hials.crosscom.protocol.value.Axis;
import no.hials.crosscom.protocol.value.Frame;

/** The coordinates that an input device moves, and the KRL program that follows. */
enum DriveSpace {
  /** Along and about the axes of {@code $BASE}. */
  BASE("actuator", "MYPOS", "mm/s", 25, 250, "X", "Y", "Z", "A", "B", "C"),
  /** Along and about the current axes of the tool. */
  TOOL("actuator", "MYPOS", "mm/s", 25, 250, "X", "Y", "Z", "A", "B", "C"),
  /** Each axis of the robot. */
  JOINTS("ext_move_axis", "MYAXIS", "deg/s", 5, 60, "A1", "A2", "A3", "A4", "A5", "A6");

  /** The KRL program, as its file is called. */
  final String program;

  /** The variable that it follows. */
  final String variable;

  final String unit;
  final double usualSpeed;
  final double maxSpeed;

  @SuppressWarnings("ImmutableEnumChecker") // it is a List.of
  final List<String> names;

  DriveSpace(
      String program,
      String variable,
      String unit,
      double usualSpeed,
      double maxSpeed,
      String... names) {
    this.program = program;
    this.variable = variable;
    this.unit = unit;
    this.usualSpeed = usualSpeed;
    this.maxSpeed = maxSpeed;
    this.names = List.of(names);
  }

  /**
   * Creates the law that follows an input device.
   *
   * @param speed the speed at full deflection, in {@link #unit}
   * @param turn the speed of a rotation of the tool at full deflection, degrees/s
   */
  Law law(double speed, double turn) {
    return switch (this) {
      case BASE -> Law.cartesianVelocity(state -> twist(state.input(), speed, turn));
      case TOOL -> Law.cartesianVelocity(state -> inBase(state, twist(state.input(), speed, turn)));
      case JOINTS -> Law.jointVelocity(state -> axes(state.input(), speed));
    };
  }

  /** Creates a twist no faster than a single axis at full deflection, in the same direction. */
  static Twist twist(Input input, double speed, double turn) {
    double way = Math.sqrt(square(input, 0) + square(input, 1) + square(input, 2));
    double rotation = Math.sqrt(square(input, 3) + square(input, 4) + square(input, 5));
    double linear = speed / Math.max(1, way);
    double angular = turn / Math.max(1, rotation);
    // A is about Z, C about X
    return new Twist(
        linear * input.axis(0),
        linear * input.axis(1),
        linear * input.axis(2),
        angular * input.axis(5),
        angular * input.axis(4),
        angular * input.axis(3));
  }

  private static double square(Input input, int axis) {
    return input.axis(axis) * input.axis(axis);
  }

  private static Twist inBase(State state, Twist inTool) {
    Frame tool = state.position();
    Frame rotation = new Frame(0, 0, 0, tool.a(), tool.b(), tool.c());
    Frame way = product(rotation, new Frame(inTool.x(), inTool.y(), inTool.z(), 0, 0, 0));
    Frame turn =
        product(rotation, new Frame(inTool.aboutX(), inTool.aboutY(), inTool.aboutZ(), 0, 0, 0));
    return new Twist(way.x(), way.y(), way.z(), turn.x(), turn.y(), turn.z());
  }

  static Axis axes(Input input, double speed) {
    double[] axes = new double[6];
    for (int i = 0; i < axes.length; i++) {
      axes[i] = speed * input.axis(i);
    }
    return Axis.of(axes);
  }

  /** Shows six numbers with their names. */
  String shown(List<Double> six) {
    List<String> parts = new ArrayList<>();
    for (int i = 0; i < six.size(); i++) {
      parts.add(String.format(Locale.ROOT, "%s %.1f", names.get(i), six.get(i)));
    }
    return String.join(" ", parts);
  }

  /** Shows which deflections are not 0. */
  String shown(Input input) {
    List<String> parts = new ArrayList<>();
    for (int i = 0; i < names.size(); i++) {
      if (input.axis(i) != 0) {
        parts.add(String.format(Locale.ROOT, "%s %+.0f%%", names.get(i), 100 * input.axis(i)));
      }
    }
    return parts.isEmpty() ? "none" : String.join(" ", parts);
  }
}
