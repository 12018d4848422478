package no.hials.crosscom.web.internal.model;

import java.io.IOException;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import no.hials.crosscom.CrossComAccessException;
import no.hials.crosscom.CrossComClient;
import no.hials.crosscom.CrossComValueException;
import no.hials.crosscom.KRL.KRLAny;
import no.hials.crosscom.VariableResult;
import no.hials.crosscom.kinematics.Frames;
import no.hials.crosscom.kinematics.RobotModel;
import no.hials.crosscom.protocol.value.Axis;
import no.hials.crosscom.protocol.value.Frame;
import no.hials.crosscom.protocol.value.KrlEnum;
import no.hials.crosscom.protocol.value.KrlInt;
import no.hials.crosscom.protocol.value.KrlReal;
import no.hials.crosscom.protocol.value.KrlString;
import no.hials.crosscom.protocol.value.KrlStruct;
import no.hials.crosscom.protocol.value.KrlValue;
import org.jspecify.annotations.Nullable;

/**
 * A robot with its place in the world.
 *
 * @param model the arm, with the software limits of the controller where it shows them
 * @param note why this arm was chosen, if the choice may be wrong; empty otherwise
 * @param root the foot of the robot in the world, if nothing carries it
 * @param rail the linear unit that carries the robot; null without one
 * @param target the variable with the target of the axes; empty if the controller shows none
 */
record RobotGeometry(
    RobotModel model, String note, Frame root, @Nullable Rail rail, String target) {
  private static final List<String> NAMES = List.of("$TRAFONAME[]", "$MODEL_NAME[]");

  /** The targets: of the current motion, and of the project's KRL programs. */
  private static final List<String> TARGETS = List.of("$AXIS_FOR", "JOV_AXIS");

  private static final String EXTERNAL_AXES = "$EX_AX_NUM";
  private static final String ROOT = "$ROBROOT";
  private static final String MINIMUM = "$SOFTN_END[%d]";
  private static final String MAXIMUM = "$SOFTP_END[%d]";
  private static final int E1 = 7;
  private static final String E1_TYPE = "$AXIS_TYPE[7]";
  private static final int LINEAR = 1;

  /** The variables of a linear unit (docs/reference/robots.md#external-axes). */
  private static final List<String> UNIT =
      List.of(
          "$EX_KIN.ET1",
          "$ERSYSROOT",
          "$ET1_TA1KR",
          "$ET1_TFLA3",
          at(MINIMUM, E1),
          at(MAXIMUM, E1));

  /**
   * A linear unit, E1.
   *
   * @param minimum the smallest E1, mm
   * @param maximum the largest E1, mm
   * @param from the foot of the robot in the world at the smallest E1
   * @param to the foot of the robot in the world at the largest E1
   */
  record Rail(double minimum, double maximum, Frame from, Frame to) {}

  /** The values that were read. */
  private record Values(Map<String, KrlValue> values) {
    static Values read(CrossComClient client, List<String> names) throws IOException {
      Map<String, KrlValue> values = new HashMap<>();
      for (VariableResult result : client.readVariables(names.stream().map(KRLAny::new).toList())) {
        KrlValue value = result.isOk() ? ((KRLAny) result.variable()).getValue() : null;
        if (value != null) {
          values.put(result.variable().getName(), value);
        } else if (result.failure() != null && !isOfVariable(result.failure())) {
          throw result.failure();
        }
      }
      return new Values(values);
    }

    private static boolean isOfVariable(IOException failure) {
      return failure instanceof CrossComAccessException
          || failure instanceof CrossComValueException;
    }

    Optional<KrlValue> find(String name) {
      return Optional.ofNullable(values.get(name));
    }

    Optional<Double> number(String name) {
      return find(name).flatMap(Values::number);
    }

    /** Returns a number; empty for a value of another type, which a controller should not send. */
    private static Optional<Double> number(KrlValue value) {
      return value instanceof KrlInt || value instanceof KrlReal
          ? Optional.of(value.asDouble())
          : Optional.empty();
    }

    Optional<Frame> frame(String name) {
      return find(name)
          .filter(KrlStruct.class::isInstance)
          .map(
              value ->
                  new Frame(
                      field(value, "X"),
                      field(value, "Y"),
                      field(value, "Z"),
                      field(value, "A"),
                      field(value, "B"),
                      field(value, "C")));
    }

    private static double field(KrlValue frame, String name) {
      return frame.asStruct().get(name).flatMap(Values::number).orElse(0.0);
    }
  }

  /**
   * Reads the geometry of its robot from a controller.
   *
   * @param simulated the arm of a simulated controller; empty for a real one
   */
  static RobotGeometry find(CrossComClient client, Optional<RobotModel> simulated)
      throws IOException {
    List<String> names =
        Stream.of(
                NAMES.stream(),
                TARGETS.stream(),
                Stream.of(ROOT, EXTERNAL_AXES, E1_TYPE),
                IntStream.rangeClosed(1, Axis.COUNT)
                    .boxed()
                    .flatMap(i -> Stream.of(at(MINIMUM, i), at(MAXIMUM, i))))
            .flatMap(it -> it)
            .toList();
    Values values = Values.read(client, names);
    String target =
        TARGETS.stream().filter(it -> values.find(it).isPresent()).findFirst().orElse("");
    Frame root = values.frame(ROOT).orElse(Frame.IDENTITY);
    boolean linear =
        values.number(EXTERNAL_AXES).orElse(0.0) > 0
            && values.number(E1_TYPE).orElse(0.0) == LINEAR;
    Rail rail = linear ? rail(Values.read(client, UNIT)) : null;
    if (simulated.isPresent()) {
      return new RobotGeometry(simulated.get(), "", root, rail, target);
    }
    String name =
        NAMES.stream()
            .flatMap(it -> values.find(it).stream())
            .filter(KrlString.class::isInstance)
            .map(KrlValue::asString)
            .filter(it -> !it.isBlank())
            .findFirst()
            .orElse("");
    Optional<RobotModel> ours = named(name);
    RobotModel model = ours.orElseGet(RobotModel::kr6r900sixx);
    String shown =
        name.isEmpty() ? "the controller does not show its robot" : name.strip() + " is not known";
    String note = ours.isPresent() ? "" : shown + ", so the picture is that of a " + model.name();
    return new RobotGeometry(limited(model, values), note, root, rail, target);
  }

  /**
   * Returns the arm of a {@code $TRAFONAME[]} or {@code $MODEL_NAME[]}. What follows the first
   * blank is the controller and the mounting: {@code #KR6R900 C4SR FLR 230}.
   */
  private static Optional<RobotModel> named(String name) {
    String key = firstWord(name);
    return RobotModel.names().stream()
        .map(RobotModel::named)
        .filter(it -> firstWord(trafoName(it)).equals(key))
        .findFirst();
  }

  private static String trafoName(RobotModel model) {
    KrlValue name = model.machineData().get(NAMES.get(0));
    return name == null ? "" : name.asString();
  }

  private static String firstWord(String name) {
    return name.strip().split(" ", 2)[0].toUpperCase(Locale.ROOT);
  }

  /** Returns a robot with the limits of the controller, if it shows all of them. */
  private static RobotModel limited(RobotModel model, Values values) {
    double[] minimum = new double[Axis.COUNT];
    double[] maximum = new double[Axis.COUNT];
    for (int i = 0; i < Axis.COUNT; i++) {
      Optional<Double> low = values.number(at(MINIMUM, i + 1));
      Optional<Double> high = values.number(at(MAXIMUM, i + 1));
      if (low.isEmpty() || high.isEmpty() || low.get() >= high.get()) {
        return model;
      }
      minimum[i] = low.get();
      maximum[i] = high.get();
    }
    return model.withLimits(Axis.of(minimum), Axis.of(maximum));
  }

  private static @Nullable Rail rail(Values values) {
    double minimum = values.number(at(MINIMUM, E1)).orElse(0.0);
    double maximum = values.number(at(MAXIMUM, E1)).orElse(0.0);
    Optional<Frame> root = values.frame("$ERSYSROOT");
    Optional<Frame> unit = values.frame("$ET1_TA1KR");
    Optional<Frame> foot = values.frame("$ET1_TFLA3");
    boolean carries =
        values
            .find("$EX_KIN.ET1")
            .filter(it -> it instanceof KrlEnum && it.asEnum().equalsIgnoreCase("ERSYS"))
            .isPresent();
    if (!carries || root.isEmpty() || unit.isEmpty() || foot.isEmpty() || minimum >= maximum) {
      return null;
    }
    return new Rail(
        minimum,
        maximum,
        Frames.product(root.get(), unit.get(), along(minimum), foot.get()),
        Frames.product(root.get(), unit.get(), along(maximum), foot.get()));
  }

  private static Frame along(double e1) {
    return new Frame(0, 0, e1, 0, 0, 0);
  }

  private static String at(String array, int index) {
    return String.format(Locale.ROOT, array, index);
  }
}
