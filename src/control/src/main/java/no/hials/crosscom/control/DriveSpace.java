package no.hials.crosscom.control;

import static no.hials.crosscom.kinematics.Frames.product;

import java.util.List;
import java.util.function.Function;
import no.hials.crosscom.control.input.Input;
import no.hials.crosscom.protocol.value.Axis;
import no.hials.crosscom.protocol.value.Frame;

/** The coordinates that an input device moves, and the KRL program that follows. */
public enum DriveSpace {
  /** Along and about the axes of {@code $BASE}. */
  BASE("actuator", "MYPOS", "mm/s", 25, 250, "X", "Y", "Z", "A", "B", "C"),
  /** Along and about the current axes of the tool. */
  TOOL("actuator", "MYPOS", "mm/s", 25, 250, "X", "Y", "Z", "A", "B", "C"),
  /** Each axis of the robot. */
  JOINTS("ext_move_axis", "MYAXIS", "deg/s", 5, 60, "A1", "A2", "A3", "A4", "A5", "A6");

  private final String program;
  private final String variable;
  private final String unit;
  private final double usualSpeed;
  private final double maxSpeed;

  @SuppressWarnings("ImmutableEnumChecker") // it is a List.of
  private final List<String> names;

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

  /** Returns the KRL program that follows, as its file in {@code krl} is called. */
  public String program() {
    return program;
  }

  /** Returns the variable that the program follows. */
  public String variable() {
    return variable;
  }

  /** Returns the unit of the speeds: mm/s, or deg/s for the axes. */
  public String unit() {
    return unit;
  }

  /** Returns a low speed for the start. */
  public double usualSpeed() {
    return usualSpeed;
  }

  /** Returns the highest speed that a person should ask for. */
  public double maxSpeed() {
    return maxSpeed;
  }

  /** Returns the names of the six directions. */
  public List<String> names() {
    return names;
  }

  /**
   * Creates the law that follows an input device.
   *
   * @param input returns the deflections for the state of the robot; {@code State::input} for those
   *     of the device
   * @param speed the speed at full deflection, in {@link #unit}
   * @param turn the speed of a rotation of the tool at full deflection, degrees/s
   */
  public Law law(Function<State, Input> input, double speed, double turn) {
    return switch (this) {
      case BASE -> Law.cartesianVelocity(state -> twist(input.apply(state), speed, turn));
      case TOOL ->
          Law.cartesianVelocity(state -> inBase(state, twist(input.apply(state), speed, turn)));
      case JOINTS -> Law.jointVelocity(state -> axes(input.apply(state), speed));
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

  private static Axis axes(Input input, double speed) {
    double[] axes = new double[6];
    for (int i = 0; i < axes.length; i++) {
      axes[i] = speed * input.axis(i);
    }
    return Axis.of(axes);
  }
}
