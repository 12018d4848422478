package no.hials.crosscom.simulator.internal.program;

import java.util.Map;
import java.util.Set;
import no.hials.crosscom.lang.Expression;
import no.hials.crosscom.protocol.value.KrlEnum;
import no.hials.crosscom.protocol.value.KrlInt;
import no.hials.crosscom.protocol.value.KrlReal;
import no.hials.crosscom.protocol.value.KrlValue;
import no.hials.crosscom.simulator.KrlExecutionException;
import no.hials.crosscom.simulator.Refusal;
import no.hials.crosscom.simulator.RefusedException;
import no.hials.crosscom.simulator.internal.data.Operators;
import no.hials.crosscom.simulator.internal.data.Scope;
import no.hials.crosscom.simulator.internal.data.VariablePath;
import org.jspecify.annotations.Nullable;

/**
 * The subprogram BAS of the base technology (docs/reference/krl-language.md#bas), which sets speeds
 * and coordinate systems. What {@code #INITMOV} leaves is in
 * docs/reference/system-variables.md#what-initmov-sets; what the others do is assumed from the
 * names of the commands and of the variables of an inline form.
 */
final class Bas {
  private static final int AXES = 6;

  private static final Map<String, Command> COMMANDS =
      Map.ofEntries(
          Map.entry("INITMOV", (bas, argument) -> bas.initialise()),
          Map.entry("ACC_CP", (bas, argument) -> bas.set("$ACC.CP", argument)),
          // assumed: the acceleration on a path that glues
          Map.entry("ACC_GLUE", (bas, argument) -> bas.set("$ACC.CP", argument)),
          Map.entry("VEL_CP", (bas, argument) -> bas.set("$VEL.CP", argument)),
          Map.entry("ACC_PTP", (bas, argument) -> bas.setAxes("$ACC_AXIS", argument)),
          Map.entry("VEL_PTP", (bas, argument) -> bas.setAxes("$VEL_AXIS", argument)),
          Map.entry("TOOL", (bas, argument) -> bas.tool(number(argument))),
          Map.entry("BASE", (bas, argument) -> bas.base(number(argument))),
          Map.entry("FRAMES", (bas, argument) -> bas.frames()),
          Map.entry("PTP_DAT", (bas, argument) -> bas.ptpData()),
          Map.entry(
              "PTP_PARAMS",
              (bas, argument) -> {
                bas.ptpData();
                bas.frames();
                bas.setAxes("$VEL_AXIS", argument);
              }),
          Map.entry("CP_DAT", (bas, argument) -> bas.pathData()),
          Map.entry(
              "CP_PARAMS",
              (bas, argument) -> {
                bas.pathData();
                bas.frames();
                bas.set("$VEL.CP", argument);
              }));

  /**
   * Commands of which only the names are known; they cannot move the robot (assumed). Not
   * {@linkplain #isSimulated simulated}, as {@link #EXTERNAL_BASE}.
   */
  private static final Set<String> WITHOUT_EFFECT = Set.of("OUT_SYNC", "OUT_ASYNC", "GROUP");

  private static final String EXTERNAL_BASE = "EX_BASE";

  @FunctionalInterface
  private interface Command {
    void execute(Bas bas, KrlValue argument) throws KrlExecutionException;
  }

  private final Scope scope;

  private Bas(Scope scope) {
    this.scope = scope;
  }

  static @Nullable KrlValue call(Builtin.Call call) throws KrlExecutionException {
    KrlValue command = call.value(0);
    if (!(command instanceof KrlEnum constant)) {
      throw Operators.wrongType("a command of BAS", command);
    }
    KrlValue argument = call.arguments().get(1) instanceof KrlValue given ? given : new KrlInt(0);
    String name = Scope.key(constant.name());
    Bas bas = new Bas(call.symbols().scope());
    Command known = COMMANDS.get(name);
    if (known != null) {
      known.execute(bas, argument);
    } else if (WITHOUT_EFFECT.contains(name)) {
      MessageBuiltins.notify(call, "BAS(#" + name + ") has no effect in this simulation");
    } else if (name.equals(EXTERNAL_BASE)) {
      bas.externalBase(number(argument));
    } else {
      throw new KrlExecutionException(
          KrlExecutionException.NOT_ALLOWED, "BAS(#" + name + ") is not supported");
    }
    return null;
  }

  /**
   * Returns whether an expression is a command that is simulated. Only for these the built-in
   * routine is better than a loaded one with an error in the CASE of the command.
   */
  static boolean isSimulated(Expression expression) {
    return expression instanceof Expression.EnumLiteral constant
        && COMMANDS.containsKey(Scope.key(constant.name()));
  }

  private void initialise() throws KrlExecutionException {
    // assumed from the names: which defaults of $config.dat it uses
    setAxes("$VEL_AXIS", configured("DEF_VEL_PTP", new KrlInt(100)));
    setAxes("$ACC_AXIS", new KrlInt(100));
    setAxes("$GEAR_JERK", new KrlInt(100));
    set("$ACC", KrlValue.parse("{CP 2.3,ORI1 100.0,ORI2 100.0}"));
    set("$VEL", KrlValue.parse("{CP 2.0,ORI1 200.0,ORI2 200.0}"));
    set("$APO", KrlValue.parse("{CVEL 100,CPTP 50,CDIS 3.0,CORI 5.0}"));
    setIfConfigured("$ACC.CP", "DEF_ACC_CP");
    setIfConfigured("$VEL.CP", "DEF_VEL_CP");
    setIfConfigured("$APO.CPTP", "DEF_APO_CPTP");
    setIfConfigured("$APO.CDIS", "DEF_APO_CDIS");
    set("$ADVANCE", configured("DEF_ADVANCE", new KrlInt(3)));
    set("$ORI_TYPE", new KrlEnum("VAR"));
    set("$CIRC_TYPE", new KrlEnum("BASE"));
    set("$IPO_MODE", new KrlEnum("BASE"));
    set("$ACT_EX_AX", new KrlInt(-1));
    base(0);
    tool(1);
  }

  private void tool(int number) throws KrlExecutionException {
    set("$TOOL", get(number == 0 ? "$NULLFRAME" : "TOOL_DATA[" + number + "]"));
    if (number > 0) {
      set("$LOAD", get("LOAD_DATA[" + number + "]"));
    }
    set("$ACT_TOOL", new KrlInt(number));
  }

  private void base(int number) throws KrlExecutionException {
    set("$BASE", get(number == 0 ? "$WORLD" : "BASE_DATA[" + number + "]"));
    set("$ACT_BASE", new KrlInt(number));
  }

  /** Assumed: the number of the external kinematics that carries the base, from 1. */
  private void externalBase(int kinematics) throws KrlExecutionException {
    if (kinematics > 0) {
      throw new KrlExecutionException(
          KrlExecutionException.NOT_ALLOWED,
          "BAS(#EX_BASE," + kinematics + "): a base on external kinematics is not simulated");
    }
    set("$ACT_EX_AX", new KrlInt(-1));
  }

  private void frames() throws KrlExecutionException {
    tool(number(get("FDAT_ACT.TOOL_NO")));
    base(number(get("FDAT_ACT.BASE_NO")));
    set("$IPO_MODE", get("FDAT_ACT.IPO_FRAME"));
  }

  /** A value that the inline form omits stays as it is. */
  private void ptpData() throws KrlExecutionException {
    setAxesIfGiven("$VEL_AXIS", "PDAT_ACT.VEL");
    setAxesIfGiven("$ACC_AXIS", "PDAT_ACT.ACC");
    KrlValue mode = find("PDAT_ACT.APO_MODE");
    boolean distance = mode instanceof KrlEnum constant && constant.name().equals("CDIS");
    setIfGiven(distance ? "$APO.CDIS" : "$APO.CPTP", "PDAT_ACT.APO_DIST");
  }

  private void pathData() throws KrlExecutionException {
    if (!scope.knows("LDAT_ACT")) {
      return;
    }
    KrlValue percent = find("LDAT_ACT.ACC");
    if (percent != null) {
      double full = Operators.number(get("DEF_ACC_CP"));
      set("$ACC.CP", KrlReal.of(full * Operators.number(percent) / 100));
    }
    setIfGiven("$APO.CDIS", "LDAT_ACT.APO_DIST");
    setIfGiven("$ORI_TYPE", "LDAT_ACT.ORI_TYP");
    setIfGiven("$CIRC_TYPE", "LDAT_ACT.CIRC_TYP");
  }

  private void setIfGiven(String name, String from) throws KrlExecutionException {
    KrlValue value = find(from);
    if (value != null) {
      set(name, value);
    }
  }

  private void setIfConfigured(String name, String from) throws KrlExecutionException {
    if (scope.knows(from)) {
      setIfGiven(name, from);
    }
  }

  private KrlValue configured(String name, KrlValue otherwise) throws KrlExecutionException {
    KrlValue value = scope.knows(name) ? find(name) : null;
    return value == null ? otherwise : value;
  }

  private void setAxesIfGiven(String array, String from) throws KrlExecutionException {
    KrlValue percent = find(from);
    if (percent != null) {
      setAxes(array, percent);
    }
  }

  private static int number(KrlValue value) throws KrlExecutionException {
    return (int) Operators.nearest(Operators.number(value));
  }

  private void setAxes(String array, KrlValue percent) throws KrlExecutionException {
    for (int axis = 1; axis <= AXES; axis++) {
      set(array + "[" + axis + "]", percent);
    }
  }

  private KrlValue get(String name) throws KrlExecutionException {
    try {
      return scope.read(VariablePath.parse(name));
    } catch (RefusedException e) {
      throw KrlExecutionException.of("BAS: " + name, e);
    }
  }

  /**
   * Returns the value of a variable that must be declared; null if it has no value, or if its type
   * lacks the component: the types of inline forms differ between versions of KSS.
   */
  private @Nullable KrlValue find(String name) throws KrlExecutionException {
    try {
      return scope.read(VariablePath.parse(name));
    } catch (RefusedException e) {
      if (e.reason() == Refusal.NOT_INITIALISED || e.reason() == Refusal.UNKNOWN_COMPONENT) {
        return null;
      }
      throw KrlExecutionException.of("BAS: " + name, e);
    }
  }

  private void set(String name, KrlValue value) throws KrlExecutionException {
    try {
      scope.write(VariablePath.parse(name), value, Scope.Writer.PROGRAM);
    } catch (RefusedException e) {
      throw KrlExecutionException.of("BAS: " + name, e);
    }
  }
}
