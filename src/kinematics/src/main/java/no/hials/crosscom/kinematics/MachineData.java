package no.hials.crosscom.kinematics;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;
import java.util.function.IntFunction;
import java.util.stream.DoubleStream;
import no.hials.crosscom.protocol.value.Axis;
import no.hials.crosscom.protocol.value.KrlEnum;
import no.hials.crosscom.protocol.value.KrlInt;
import no.hials.crosscom.protocol.value.KrlReal;
import no.hials.crosscom.protocol.value.KrlString;
import no.hials.crosscom.protocol.value.KrlStruct;
import no.hials.crosscom.protocol.value.KrlValue;

/**
 * The mapping between a robot and the variables of {@code $machine.dat}
 * (docs/reference/robots.md#machine-data).
 */
final class MachineData {
  /** The angles of the arm stretched upwards, by which machine data count. */
  private static final Axis OFFSET = Axis.of(0, -90, 0, 0, 0, 0);

  /** Assumed for a robot without a home position of its own. */
  private static final Axis HOME = Axis.of(0, -90, 90, 0, 0, 0);

  /** A length or an angle below this is 0, mm or degrees. */
  private static final double NOTHING = 0.01;

  /** The highest speed is this times rpm and D, by N. */
  private static final double DEGREES_PER_SECOND = 6;

  /** Written for {@code $VEL_AXIS_MA}, with the ratio that results in the speed. */
  private static final int RPM = 6000;

  private static final int RATIO = 36_000_000;

  private static final int A5 = 4;
  private static final int ROTARY = 3;
  private static final int ENDLESS = 5;

  /** The length of {@code $TRAFONAME[]}. */
  private static final int NAME_LENGTH = 32;

  private final Function<String, Optional<KrlValue>> variables;

  private MachineData(Function<String, Optional<KrlValue>> variables) {
    this.variables = variables;
  }

  // from machine data

  static RobotModel toModel(Function<String, Optional<KrlValue>> variables)
      throws MachineDataException {
    MachineData data = new MachineData(variables);
    data.requireArm();
    OrthoParallelArm arm = data.arm();
    Axis minimum = data.axes(i -> data.number("$SOFTN_END" + i));
    Axis maximum = data.axes(i -> data.number("$SOFTP_END" + i));
    for (int i = 0; i < Axis.COUNT; i++) {
      if (minimum.get(i) >= maximum.get(i)) {
        throw new MachineDataException(
            "$SOFTN_END" + index(i),
            "less than $SOFTP_END" + index(i) + ", " + maximum.get(i),
            minimum.get(i));
      }
    }
    Axis speed = data.axes(data::speed);
    Axis acceleration = data.accelerations(speed);
    RobotModel model =
        new RobotModel(data.name(), arm, minimum, maximum, speed, acceleration, HOME);
    return model.withHome(data.home(model));
  }

  /** Checks that the arm is of the kind whose inverse is known. */
  private void requireArm() throws MachineDataException {
    require("$NUM_AX", Axis.COUNT);
    require("$MAIN_AXIS", "#NR", constant("$MAIN_AXIS"));
    require("$WRIST_AXIS", "#ZEH", constant("$WRIST_AXIS"));
    requireWrist("$DH_4", 90);
    requireWrist("$DH_5", -90);
    require("$TIRORO", "X", 0);
    require("$TIRORO", "Y", 0);
    require("$TFLWP", "X", 0);
    require("$TFLWP", "Y", 0);
    require("$TX3P3", "B", 90);
    for (String frame : List.of("$TIRORO", "$TFLWP", "$TX3P3")) {
      require(frame, "A", 0);
      require(frame, "C", 0);
    }
    require("$TIRORO", "B", 0);
    require("$TFLWP", "B", 0);
    for (int i = 0; i < Axis.COUNT; i++) {
      String name = "$AXIS_TYPE" + index(i);
      double type = number(name);
      if (type != ROTARY && type != ENDLESS) {
        throw new MachineDataException(name, ROTARY + " or " + ENDLESS + " (rotary)", text(type));
      }
    }
  }

  private void requireWrist(String name, double alpha) throws MachineDataException {
    require(name, "DHART_A", 0);
    require(name, "DHART_D", 0);
    require(name, "DHART_ALPHA", alpha);
  }

  private void require(String name, double expected) throws MachineDataException {
    double found = number(name);
    if (Math.abs(found - expected) > NOTHING) {
      throw new MachineDataException(name, text(expected), text(found));
    }
  }

  private void require(String name, String field, double expected) throws MachineDataException {
    double found = field(name, field);
    if (Math.abs(found - expected) > NOTHING) {
      throw new MachineDataException(name + "." + field, text(expected), text(found));
    }
  }

  private static void require(String name, String expected, String found)
      throws MachineDataException {
    if (!expected.equalsIgnoreCase(found)) {
      throw new MachineDataException(name, expected, found);
    }
  }

  private OrthoParallelArm arm() throws MachineDataException {
    // A5 of machine data turns about the opposite line
    Axis sign = axes(i -> direction(i) * (i.equals(index(A5)) ? -1 : 1));
    return new OrthoParallelArm(
        number("$LENGTH_A"),
        -field("$TX3P3", "Z"),
        rounded(field("$TX3P3", "Y")),
        field("$TIRORO", "Z"),
        positive("$LENGTH_B", number("$LENGTH_B")),
        positive("$TX3P3.X", field("$TX3P3", "X")),
        field("$TFLWP", "Z"),
        sign,
        OFFSET);
  }

  private double direction(String index) throws MachineDataException {
    String name = "$AXIS_DIR" + index;
    double direction = number(name);
    if (Math.abs(direction) != 1) {
      throw new MachineDataException(name, "1 or -1", text(direction));
    }
    return direction;
  }

  private double speed(String index) throws MachineDataException {
    double turns = ratio(index, "N") / ratio(index, "D");
    double speed = Math.abs(number("$VEL_AXIS_MA" + index) * DEGREES_PER_SECOND / turns);
    return positive("$VEL_AXIS_MA" + index + " * 6 / $RAT_MOT_AX" + index, speed);
  }

  private double ratio(String index, String field) throws MachineDataException {
    String name = "$RAT_MOT_AX" + index;
    double number = field(name, field);
    if (number == 0) {
      throw new MachineDataException(name + "." + field, "a number other than 0", text(number));
    }
    return number;
  }

  /** A KR C2 states the time to the highest speed, a KR C4 does not. */
  private Axis accelerations(Axis speed) throws MachineDataException {
    double[] six = speed.toArray();
    for (int i = 0; i < six.length; i++) {
      String name = "$RAISE_TIME" + index(i);
      boolean stated = variables.apply(name).isPresent();
      six[i] /= stated ? positive(name, number(name)) / 1000 : RobotTable.RAISE_TIME;
    }
    return Axis.of(six);
  }

  private String name() throws MachineDataException {
    KrlValue name = value("$TRAFONAME[]");
    if (name instanceof KrlString text && !text.asString().isBlank()) {
      return text.asString().strip();
    }
    throw new MachineDataException("$TRAFONAME[]", "a name", name);
  }

  /** Returns XHOME, else the first further home position, else the default within the limits. */
  private Axis home(RobotModel model) {
    for (String name : List.of("XHOME", "$AXIS_HOME[1]")) {
      Optional<Axis> home =
          variables
              .apply(name)
              .flatMap(MachineData::position)
              .filter(axes -> model.axesOutsideLimits(axes).isEmpty());
      if (home.isPresent()) {
        return home.get();
      }
    }
    Axis home = HOME;
    for (int i = 0; i < Axis.COUNT; i++) {
      home = home.with(i, Math.max(model.minimum(i), Math.min(model.maximum(i), home.get(i))));
    }
    return home;
  }

  /** Returns the six axes of a position; empty if one has no value. */
  private static Optional<Axis> position(KrlValue value) {
    double[] six = new double[Axis.COUNT];
    for (int i = 0; i < six.length; i++) {
      Optional<KrlValue> angle =
          value instanceof KrlStruct struct ? struct.get("A" + (i + 1)) : Optional.empty();
      if (angle.isEmpty()) {
        return Optional.empty();
      }
      six[i] = angle.get().asDouble();
    }
    return Optional.of(Axis.of(six));
  }

  /** Reads a value of an axis, by the index of its element. */
  private interface Element {
    double read(String index) throws MachineDataException;
  }

  private Axis axes(Element element) throws MachineDataException {
    double[] six = new double[Axis.COUNT];
    for (int i = 0; i < six.length; i++) {
      six[i] = element.read(index(i));
    }
    return Axis.of(six);
  }

  private static String index(int axis) {
    return "[" + (axis + 1) + "]";
  }

  private KrlValue value(String name) throws MachineDataException {
    Optional<KrlValue> value = variables.apply(name);
    if (value.isEmpty()) {
      throw new MachineDataException(name, "a value", "none");
    }
    return value.get();
  }

  private double number(String name) throws MachineDataException {
    return number(name, value(name));
  }

  private double field(String name, String field) throws MachineDataException {
    Optional<KrlValue> value =
        value(name) instanceof KrlStruct struct ? struct.get(field) : Optional.empty();
    if (value.isEmpty()) {
      throw new MachineDataException(name + "." + field, "a number", "none");
    }
    return number(name + "." + field, value.get());
  }

  private static double number(String name, KrlValue value) throws MachineDataException {
    if (value instanceof KrlInt || value instanceof KrlReal) {
      return value.asDouble();
    }
    throw new MachineDataException(name, "a number", value);
  }

  private static double positive(String name, double value) throws MachineDataException {
    if (!(value > 0 && value < Double.POSITIVE_INFINITY)) {
      throw new MachineDataException(name, "a number above 0", text(value));
    }
    return value;
  }

  private String constant(String name) throws MachineDataException {
    KrlValue value = value(name);
    return value instanceof KrlEnum constant ? "#" + constant.name() : value.toString();
  }

  private static double rounded(double length) {
    return Math.abs(length) < NOTHING ? 0 : length;
  }

  private static String text(double number) {
    return number == Math.rint(number)
        ? String.format(Locale.ROOT, "%.0f", number)
        : String.valueOf(number);
  }

  // to machine data

  /** Returns the machine data of a robot; without lengths if they cannot describe its geometry. */
  static Map<String, KrlValue> of(RobotModel robot, OrthoParallelArm arm) {
    Map<String, KrlValue> data = new LinkedHashMap<>();
    KrlString name = new KrlString(trafoName(robot.name()));
    data.put("$TRAFONAME[]", name);
    data.put("$MODEL_NAME[]", name);
    if (arm.offset().equals(OFFSET)) {
      data.put("$TIRORO", frame(0, 0, arm.c1(), 0));
      data.put("$LENGTH_A", KrlReal.of(arm.a1()));
      data.put("$LENGTH_B", KrlReal.of(arm.c2()));
      data.put("$TX3P3", frame(arm.c3(), arm.b(), -arm.a2(), 90));
      data.put("$TFLWP", frame(0, 0, arm.c4(), 0));
      put(data, "$AXIS_DIR", i -> new KrlInt((int) (arm.sign().get(i) * (i == A5 ? -1 : 1))));
    }
    put(data, "$SOFTN_END", i -> KrlReal.of(robot.minimum(i)));
    put(data, "$SOFTP_END", i -> KrlReal.of(robot.maximum(i)));
    put(data, "$VEL_AXIS_MA", i -> KrlReal.of(RPM));
    put(data, "$RAT_MOT_AX", i -> ratio(robot.maxSpeed(i)));
    KrlValue home = home(robot.home());
    data.put("XHOME", home);
    data.put("$AXIS_HOME[1]", home);
    return data;
  }

  private static void put(Map<String, KrlValue> data, String array, IntFunction<KrlValue> values) {
    for (int i = 0; i < Axis.COUNT; i++) {
      data.put(array + index(i), values.apply(i));
    }
  }

  private static KrlValue ratio(double speed) {
    int divisor = (int) Math.rint(speed * RATIO / (RPM * DEGREES_PER_SECOND));
    return KrlValue.parse("{FRA: N " + RATIO + ",D " + divisor + "}");
  }

  private static KrlValue frame(double x, double y, double z, double b) {
    return KrlValue.parse(
        String.format(Locale.ROOT, "{FRAME: X %s,Y %s,Z %s,A 0.0,B %s,C 0.0}", x, y, z, b));
  }

  private static KrlValue home(Axis home) {
    return KrlValue.parse(
        String.format(
            Locale.ROOT,
            "{E6AXIS: A1 %s,A2 %s,A3 %s,A4 %s,A5 %s,A6 %s}",
            DoubleStream.of(home.toArray()).boxed().toArray()));
  }

  /**
   * Returns the {@code $TRAFONAME[]} of a robot: known for two robots, derived for the others
   * (docs/reference/robots.md#sources).
   */
  private static String trafoName(String name) {
    if (name.startsWith("#")) {
      return name;
    }
    if (name.equals("KR 6 R900 sixx")) {
      return "#KR6R900 C4SR FLR 230";
    }
    String plain = name.replace(" ", "").replace('-', '_').toUpperCase(Locale.ROOT);
    String derived = "#" + plain + " C4 FLR";
    return derived.substring(0, Math.min(NAME_LENGTH, derived.length()));
  }
}
