package no.hials.crosscom.simulator.internal.core;

import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;
import java.util.regex.Pattern;
import no.hials.crosscom.protocol.value.Axis;
import no.hials.crosscom.protocol.value.Frame;
import no.hials.crosscom.protocol.value.KrlArray;
import no.hials.crosscom.protocol.value.KrlInt;
import no.hials.crosscom.protocol.value.KrlReal;
import no.hials.crosscom.protocol.value.KrlStruct;
import no.hials.crosscom.protocol.value.KrlValue;
import no.hials.crosscom.simulator.internal.motion.Joints;

/** Converts frames and axis positions to KRL values and back. */
final class PositionValues {
  private static final String[] FRAME = {"X", "Y", "Z", "A", "B", "C"};
  private static final String[] EXTERNAL = {"E1", "E2", "E3", "E4", "E5", "E6"};
  private static final Pattern AXIS = Pattern.compile("A[1-6]", Pattern.CASE_INSENSITIVE);
  private static final Pattern EXTERNAL_AXIS = Pattern.compile("E[1-6]", Pattern.CASE_INSENSITIVE);

  /** The number of elements in the controller's arrays of axes. */
  static final int AXES = 12;

  /** The number of axes of the robot itself. */
  static final int ROBOT_AXES = 6;

  private PositionValues() {}

  private static KrlStruct.Field real(String name, double value) {
    return new KrlStruct.Field(name, KrlReal.of(value));
  }

  private static void addFrame(List<KrlStruct.Field> fields, Frame frame) {
    double[] numbers = {frame.x(), frame.y(), frame.z(), frame.a(), frame.b(), frame.c()};
    for (int i = 0; i < FRAME.length; i++) {
      fields.add(real(FRAME[i], numbers[i]));
    }
  }

  private static void addExternal(List<KrlStruct.Field> fields, Axis external) {
    for (int i = 0; i < EXTERNAL.length; i++) {
      fields.add(real(EXTERNAL[i], external.get(i)));
    }
  }

  static KrlStruct frame(Frame frame) {
    List<KrlStruct.Field> fields = new ArrayList<>();
    addFrame(fields, frame);
    return new KrlStruct("FRAME", fields);
  }

  static KrlStruct e6Pos(Frame frame, int status, int turn, Axis external) {
    List<KrlStruct.Field> fields = new ArrayList<>();
    addFrame(fields, frame);
    fields.add(new KrlStruct.Field("S", new KrlInt(status)));
    fields.add(new KrlStruct.Field("T", new KrlInt(turn)));
    addExternal(fields, external);
    return new KrlStruct("E6POS", fields);
  }

  static KrlStruct e6Axis(Joints joints) {
    List<KrlStruct.Field> fields = new ArrayList<>();
    for (int i = 0; i < ROBOT_AXES; i++) {
      fields.add(real("A" + (i + 1), joints.robot().get(i)));
    }
    addExternal(fields, joints.external());
    return new KrlStruct("E6AXIS", fields);
  }

  /** Returns an array of all axes; those that the robot does not have are 0. */
  static KrlArray axisArray(double[] robotAxes) {
    List<KrlValue> numbers = new ArrayList<>();
    for (int i = 0; i < AXES; i++) {
      numbers.add(KrlReal.of(i < robotAxes.length ? robotAxes[i] : 0));
    }
    return new KrlArray(numbers);
  }

  /** Returns the number in a field of an aggregate; empty if the field has no value. */
  static OptionalDouble number(KrlStruct struct, String field) {
    return struct
        .get(field)
        .map(PositionValues::number)
        .map(OptionalDouble::of)
        .orElse(OptionalDouble.empty());
  }

  static double number(KrlValue value) {
    if (value instanceof KrlInt number) {
      return number.value();
    }
    if (value instanceof KrlReal number) {
      return number.value();
    }
    throw new IllegalArgumentException("needs a number, was given " + value);
  }

  /** Converts an aggregate to a frame; missing fields come from another frame. */
  static Frame toFrame(KrlStruct struct, Frame missing) {
    return new Frame(
        number(struct, "X").orElse(missing.x()),
        number(struct, "Y").orElse(missing.y()),
        number(struct, "Z").orElse(missing.z()),
        number(struct, "A").orElse(missing.a()),
        number(struct, "B").orElse(missing.b()),
        number(struct, "C").orElse(missing.c()));
  }

  /** Converts an aggregate to an axis position; missing fields come from another position. */
  static Axis toAxes(KrlStruct struct, Axis missing) {
    return axes(struct, "A", missing);
  }

  /** Converts E1 to E6 of an aggregate; missing fields come from another position. */
  static Axis toExternal(KrlStruct struct, Axis missing) {
    return axes(struct, "E", missing);
  }

  private static Axis axes(KrlStruct struct, String letter, Axis missing) {
    Axis axes = missing;
    for (int i = 0; i < ROBOT_AXES; i++) {
      OptionalDouble angle = number(struct, letter + (i + 1));
      if (angle.isPresent()) {
        axes = axes.with(i, angle.getAsDouble());
      }
    }
    return axes;
  }

  /** Returns whether an aggregate is an axis position rather than a Cartesian one. */
  static boolean isAxes(KrlStruct struct) {
    return struct.fields().stream().anyMatch(field -> AXIS.matcher(field.name()).matches());
  }

  /** Returns whether an aggregate has external axes only. */
  static boolean isExternal(KrlStruct struct) {
    return !struct.fields().isEmpty()
        && struct.fields().stream()
            .allMatch(field -> EXTERNAL_AXIS.matcher(field.name()).matches());
  }
}
