package no.hials.crosscom.simulator.internal.program;

import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.function.DoubleUnaryOperator;
import no.hials.crosscom.protocol.value.KrlBool;
import no.hials.crosscom.protocol.value.KrlEnum;
import no.hials.crosscom.protocol.value.KrlInt;
import no.hials.crosscom.protocol.value.KrlString;
import no.hials.crosscom.protocol.value.KrlStruct;
import no.hials.crosscom.protocol.value.KrlValue;
import no.hials.crosscom.simulator.KrlExecutionException;
import no.hials.crosscom.simulator.RefusedException;
import no.hials.crosscom.simulator.internal.data.FrameArithmetic;
import no.hials.crosscom.simulator.internal.data.Operators;
import no.hials.crosscom.simulator.internal.data.VariablePath;
import no.hials.crosscom.simulator.internal.program.Builtin.Call;
import no.hials.crosscom.simulator.internal.program.Builtin.Kind;
import org.jspecify.annotations.Nullable;

/**
 * The standard functions and the routines of the base technology. Only their names are documented
 * (docs/reference/krl-language.md#functions): parameters and results are assumed, from the names
 * and from programs that use them.
 */
final class Builtins {
  private static final Map<String, Builtin> ALL = new HashMap<>();

  private static final KrlInt DONE = new KrlInt(0);
  private static final KrlInt FAILED = new KrlInt(-1);
  private static final KrlInt NOT_FOUND = new KrlInt(-1);

  static {
    real("ABS", Math::abs);
    real("SIN", x -> Math.sin(Math.toRadians(x)));
    real("COS", x -> Math.cos(Math.toRadians(x)));
    real("TAN", x -> Math.tan(Math.toRadians(x)));
    function("SQRT", List.of(Kind.VALUE), Builtins::squareRoot);
    function("ACOS", List.of(Kind.VALUE), Builtins::arcCosine);
    function("ATAN2", List.of(Kind.VALUE, Kind.VALUE), Builtins::arcTangent);
    function("INV_POS", List.of(Kind.VALUE), call -> FrameArithmetic.inverse(call.value(0)));
    function("FORWARD", List.of(Kind.VALUE, Kind.OUT), Builtins::forward);
    function("INVERSE", List.of(Kind.VALUE, Kind.VALUE, Kind.OUT), Builtins::inverse);
    function("VARSTATE", List.of(Kind.TEXT), Builtins::varState);
    // KUKA's library asks for the length of an omitted argument without protection
    function("STRLEN", List.of(Kind.TEXT), call -> new KrlInt(call.textOrEmpty(0).length()));
    function("STRDECLLEN", List.of(Kind.OUT), call -> new KrlInt(call.capacity(0)));
    function("STRCLEAR", List.of(Kind.OUT), Builtins::clear);
    function("STRCOPY", List.of(Kind.OUT, Kind.TEXT), Builtins::copy);
    function("STRADD", List.of(Kind.OUT, Kind.TEXT), Builtins::add);
    add(
        new Builtin(
            "STRCOMP",
            true,
            List.of(Kind.TEXT, Kind.TEXT, Kind.VALUE),
            1,
            call -> new KrlBool(folded(call, 0, 2).equals(folded(call, 1, 2)))));
    add(
        new Builtin(
            "STRFIND",
            true,
            List.of(Kind.VALUE, Kind.TEXT, Kind.TEXT, Kind.VALUE),
            1,
            Builtins::find));
    MessageBuiltins.ALL.forEach(Builtins::add);
    TextBuiltins.ALL.forEach(Builtins::add);
    add(new Builtin("ERR_RAISE", false, List.of(Kind.VALUE), 0, Builtins::raise));
    add(new Builtin("ERR_CLEAR", false, List.of(Kind.OUT), 0, Builtins::clearError));
    add(new Builtin("IR_STOPM", false, List.of(), 0, call -> null));
    add(new Builtin("BAS", false, List.of(Kind.VALUE, Kind.VALUE), 1, Bas::call));
  }

  private Builtins() {}

  /** Returns a routine by its name in upper case; null if it is unknown. */
  static @Nullable Builtin find(String key) {
    return ALL.get(key);
  }

  private static void add(Builtin builtin) {
    ALL.put(builtin.name(), builtin);
  }

  private static void function(String name, List<Kind> parameters, Builtin.Body body) {
    add(new Builtin(name, true, parameters, 0, body));
  }

  private static void real(String name, DoubleUnaryOperator operator) {
    function(
        name, List.of(Kind.VALUE), call -> Operators.real(operator.applyAsDouble(call.number(0))));
  }

  // numbers

  private static KrlValue squareRoot(Call call) throws KrlExecutionException {
    double number = call.number(0);
    if (number < 0) {
      throw new KrlExecutionException(
          KrlExecutionException.OUT_OF_RANGE,
          "SQRT takes a number of at least 0, was given " + number);
    }
    return Operators.real(Math.sqrt(number));
  }

  private static KrlValue arcCosine(Call call) throws KrlExecutionException {
    double number = call.number(0);
    if (Math.abs(number) > 1) {
      throw new KrlExecutionException(
          KrlExecutionException.OUT_OF_RANGE,
          "ACOS takes a number from -1 to 1, was given " + number);
    }
    return Operators.real(Math.toDegrees(Math.acos(number)));
  }

  private static KrlValue arcTangent(Call call) throws KrlExecutionException {
    double y = call.number(0);
    double x = call.number(1);
    if (y == 0 && x == 0) {
      throw new KrlExecutionException(
          KrlExecutionException.OUT_OF_RANGE, "ATAN2 takes two numbers that are not both 0");
    }
    return Operators.real(Math.toDegrees(Math.atan2(y, x)));
  }

  // positions

  private static KrlValue forward(Call call) throws KrlExecutionException {
    Optional<KrlStruct> result = call.machine().environment().forward(call.position(0));
    call.reference(1).write(result.isPresent() ? DONE : FAILED);
    // an aggregate without fields changes nothing where it is assigned
    return result.orElse(new KrlStruct("E6POS", List.of()));
  }

  private static KrlValue inverse(Call call) throws KrlExecutionException {
    Optional<KrlStruct> result =
        call.machine().environment().inverse(call.position(0), call.position(1));
    call.reference(2).write(result.isPresent() ? DONE : FAILED);
    return result.orElse(new KrlStruct("E6AXIS", List.of()));
  }

  private static KrlValue varState(Call call) throws KrlExecutionException {
    String name = call.text(0).strip().toUpperCase(Locale.ROOT);
    try {
      VariablePath path = VariablePath.parse(name);
      StorageLocation location = call.symbols().find(path.first().name());
      if (location == null) {
        return new KrlEnum("UNKNOWN");
      }
      boolean signal =
          location instanceof StorageLocation.Shared shared
              && shared.scope().isSignal(path.first().name());
      boolean initialised = signal || location.storage(call.machine().frame(), path).initialised();
      return new KrlEnum(initialised ? "INITIALIZED" : "DECLARED");
    } catch (RefusedException e) {
      return new KrlEnum("UNKNOWN");
    }
  }

  // errors

  /** Raises the error of an ERROR_T, unless its number is 0. */
  private static @Nullable KrlValue raise(Call call) throws KrlExecutionException {
    KrlValue error = call.value(0);
    int number =
        error instanceof KrlStruct struct
            ? Operators.intOf(struct.get("NUMBER").orElse(new KrlInt(0)))
            : Operators.intOf(error);
    if (number != 0) {
      call.machine().raise(new KrlExecutionException(number, "the program has raised an error"));
    }
    return null;
  }

  private static @Nullable KrlValue clearError(Call call) throws KrlExecutionException {
    call.reference(0)
        .write(new KrlStruct(null, List.of(new KrlStruct.Field("NUMBER", new KrlInt(0)))));
    return null;
  }

  // texts

  private static KrlValue clear(Call call) throws KrlExecutionException {
    call.capacity(0);
    call.reference(0).write(new KrlString(""));
    return new KrlBool(true);
  }

  private static KrlValue copy(Call call) throws KrlExecutionException {
    String text = call.text(1);
    boolean fits = text.length() <= call.capacity(0);
    if (fits) {
      call.reference(0).write(new KrlString(text));
    }
    return new KrlBool(fits);
  }

  private static KrlValue add(Call call) throws KrlExecutionException {
    String all = call.text(0) + call.text(1);
    String fitting = all.substring(0, Math.min(all.length(), call.capacity(0)));
    call.reference(0).write(new KrlString(fitting));
    return new KrlInt(fitting.length());
  }

  /** Returns a text for comparison: case is ignored without {@code #CASE_SENS}. */
  private static String folded(Call call, int at, int caseAt) throws KrlExecutionException {
    String text = call.text(at);
    boolean sensitive =
        call.arguments().get(caseAt) instanceof KrlEnum constant
            && constant.name().equalsIgnoreCase("CASE_SENS");
    return sensitive ? text : text.toUpperCase(Locale.ROOT);
  }

  private static KrlValue find(Call call) throws KrlExecutionException {
    int from = Operators.intOf(call.value(0));
    int at = folded(call, 1, 3).indexOf(folded(call, 2, 3), from - 1);
    return at < 0 ? NOT_FOUND : new KrlInt(at + 1);
  }
}
