package no.hials.crosscom.simulator.internal.program;

import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.Predicate;
import no.hials.crosscom.lang.Expression;
import no.hials.crosscom.lang.KrlError;
import no.hials.crosscom.lang.Position;
import no.hials.crosscom.lang.TypeSwitch;
import no.hials.crosscom.simulator.internal.data.Scope;
import org.jspecify.annotations.Nullable;

/** The routine that is being compiled, and the names it can use. */
final class RoutineContext {
  private static final TypeSwitch<RoutineContext, Expression, Boolean, RuntimeException> STOPS =
      TypeSwitch.create(
          Expression.class,
          cases ->
              cases
                  .on(Expression.Literal.class, (context, it) -> false)
                  .on(Expression.Variable.class, (context, it) -> context.stopsAdvanceRun(it))
                  .on(
                      Expression.Unary.class,
                      (context, it) -> context.stopsAdvanceRun(it.operand()))
                  .on(
                      Expression.Binary.class,
                      (context, it) ->
                          context.stopsAdvanceRun(it.left()) || context.stopsAdvanceRun(it.right()))
                  .on(
                      Expression.FunctionCall.class,
                      (context, it) -> context.stopAdvanceRun(it.arguments()))
                  .on(
                      Expression.Aggregate.class,
                      (context, it) ->
                          it.fields().stream()
                              .anyMatch(field -> context.stopsAdvanceRun(field.value()))));

  private final SymbolTable symbols;
  private final List<Map<String, CompiledRoutine>> routines;
  private final Map<String, CompiledRoutine> builtIn;
  private final Set<CompiledRoutine> calledRoutines = new HashSet<>();
  private final Predicate<String> stopsAdvanceRun;
  private final LinkErrors errors;
  private final Set<String> calledModules;
  private int temporaries;

  /** How many branches, loops and actions surround the code that is being compiled. */
  private int depth;

  private @Nullable KrlError stop;

  /**
   * @param symbols the variables it can use
   * @param routines the routines it can call, by their names in upper case; those of its module
   *     first
   * @param builtIn the routines of the built-in modules, by their names in upper case
   * @param stopsAdvanceRun whether access to a variable of the controller stops the advance run
   * @param errors gets the errors
   * @param calledModules gets the modules it calls
   */
  RoutineContext(
      SymbolTable symbols,
      List<Map<String, CompiledRoutine>> routines,
      Map<String, CompiledRoutine> builtIn,
      Predicate<String> stopsAdvanceRun,
      LinkErrors errors,
      Set<String> calledModules) {
    this.symbols = symbols;
    this.routines = routines;
    this.builtIn = builtIn;
    this.stopsAdvanceRun = stopsAdvanceRun;
    this.errors = errors;
    this.calledModules = calledModules;
  }

  SymbolTable symbols() {
    return symbols;
  }

  void error(Position position, String message) {
    errors.add(position, message);
  }

  /** Compiles a statement or a part of it; returns its first error, null without one. */
  @Nullable String compile(Runnable compilation) {
    return errors.compile(compilation);
  }

  /** Returns a routine with a source; null if it is unknown. */
  @Nullable CompiledRoutine routine(String name) {
    String key = Scope.key(name);
    for (Map<String, CompiledRoutine> known : routines) {
      CompiledRoutine routine = known.get(key);
      if (routine != null) {
        calledModules.add(Scope.key(routine.module()));
        if (depth == 0) {
          calledRoutines.add(routine);
        }
        return routine;
      }
    }
    return null;
  }

  /** Returns a routine of the built-in modules; null if it is unknown. */
  @Nullable CompiledRoutine builtInRoutine(String name) {
    return builtIn.get(Scope.key(name));
  }

  /** Begins code that some calls of the routine do not reach, or do not stop at. */
  void enterBranch() {
    depth++;
  }

  void leaveBranch() {
    depth--;
  }

  /** Records an error at which the routine stops. */
  void stopsAt(Position position, String message) {
    if (depth == 0 && stop == null) {
      stop = new KrlError(position, message);
    }
  }

  /** Returns the first error that every call of the routine reaches; null without one. */
  @Nullable KrlError stop() {
    return stop;
  }

  /** Returns the routines with a source that every call of it calls. */
  Set<CompiledRoutine> calledRoutines() {
    return calledRoutines;
  }

  int newTemporary() {
    return temporaries++;
  }

  int temporaries() {
    return temporaries;
  }

  /** Returns whether one of the expressions uses a variable that stops the advance run. */
  boolean stopAdvanceRun(List<? extends @Nullable Expression> expressions) {
    return expressions.stream()
        .anyMatch(expression -> expression != null && stopsAdvanceRun(expression));
  }

  private boolean stopsAdvanceRun(Expression expression) {
    return STOPS.apply(this, expression);
  }

  private boolean stopsAdvanceRun(Expression.Variable variable) {
    return symbols.ofController(variable).filter(stopsAdvanceRun).isPresent()
        || variable.steps().stream().anyMatch(step -> stopAdvanceRun(step.indices()));
  }
}
