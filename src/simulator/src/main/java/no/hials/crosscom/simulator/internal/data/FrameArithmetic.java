package no.hials.crosscom.simulator.internal.data;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import no.hials.crosscom.kinematics.Frames;
import no.hials.crosscom.protocol.value.Frame;
import no.hials.crosscom.protocol.value.KrlStruct;
import no.hials.crosscom.protocol.value.KrlValue;
import no.hials.crosscom.simulator.KrlExecutionException;

/** Computes with values of the types FRAME, POS and E6POS. */
public final class FrameArithmetic {
  private static final List<String> COMPONENTS = List.of("X", "Y", "Z", "A", "B", "C");

  private FrameArithmetic() {}

  /**
   * Returns the result of the geometric operator, {@code left:right}, which combines two frames.
   * Assumed: it has the type of the right operand, and its Status, Turn and external axes.
   */
  static KrlValue product(KrlValue left, KrlValue right) throws KrlExecutionException {
    Frame result = Frames.product(frame(left), frame(right));
    return replaced((KrlStruct) right, result);
  }

  /** Returns the inverse of a frame, with the type of the operand. */
  public static KrlValue inverse(KrlValue operand) throws KrlExecutionException {
    return replaced((KrlStruct) operand, Frames.inverse(frame(operand)));
  }

  private static Frame frame(KrlValue value) throws KrlExecutionException {
    if (!(value instanceof KrlStruct struct)
        || struct.fields().stream()
            .noneMatch(field -> COMPONENTS.contains(field.name().toUpperCase(Locale.ROOT)))) {
      throw Operators.wrongType("FRAME, POS or E6POS", value);
    }
    double[] numbers = new double[COMPONENTS.size()];
    for (int i = 0; i < numbers.length; i++) {
      String name = COMPONENTS.get(i);
      Optional<KrlValue> component = struct.get(name);
      if (component.isEmpty()) {
        throw new KrlExecutionException(
            KrlExecutionException.NOT_INITIALISED,
            "component " + name + " of " + struct + " has no value yet");
      }
      numbers[i] = Operators.number(component.get());
    }
    return new Frame(numbers[0], numbers[1], numbers[2], numbers[3], numbers[4], numbers[5]);
  }

  private static KrlStruct replaced(KrlStruct struct, Frame frame) throws KrlExecutionException {
    double[] numbers = {frame.x(), frame.y(), frame.z(), frame.a(), frame.b(), frame.c()};
    List<KrlStruct.Field> fields = new ArrayList<>(struct.fields().size());
    for (int i = 0; i < numbers.length; i++) {
      fields.add(new KrlStruct.Field(COMPONENTS.get(i), Operators.real(numbers[i])));
    }
    for (KrlStruct.Field field : struct.fields()) {
      if (!COMPONENTS.contains(field.name().toUpperCase(Locale.ROOT))) {
        fields.add(field);
      }
    }
    return new KrlStruct(struct.typeName(), fields);
  }
}
