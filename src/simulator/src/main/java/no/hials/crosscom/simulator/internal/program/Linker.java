package no.hials.crosscom.simulator.internal.program;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.Predicate;
import no.hials.crosscom.lang.KrlError;
import no.hials.crosscom.lang.Position;
import no.hials.crosscom.lang.Routine;
import no.hials.crosscom.simulator.internal.data.Scope;
import no.hials.crosscom.simulator.internal.data.Storage;
import no.hials.crosscom.simulator.internal.data.VariablePath;

/**
 * Compiles all modules of a library: first the heads of all routines, so that calls can be checked,
 * then the bodies.
 */
final class Linker {
  private final Map<String, KrlModule> modules;
  private final Scope globals;
  private final Set<String> unknown;
  private final Predicate<String> stopsAdvanceRun;
  private long routineBytes;
  private final Map<String, CompiledRoutine> globalRoutines = new HashMap<>();
  private final Map<String, Map<String, CompiledRoutine>> ownRoutines = new HashMap<>();

  /**
   * A compiled module.
   *
   * @param main the routine that is selected
   * @param errors the errors
   * @param calledModules the names of the modules it calls, in upper case
   * @param executable whether it can be executed, up to the first statement with an error
   */
  record Linked(
      CompiledRoutine main, List<KrlError> errors, Set<String> calledModules, boolean executable) {}

  /**
   * @param modules by their names in upper case
   * @param globals the variables of the controller
   * @param unknown gets the system variables that only lenient modules mention, in upper case
   * @param stopsAdvanceRun whether access to a variable of the controller stops the advance run
   */
  Linker(
      Map<String, KrlModule> modules,
      Scope globals,
      Set<String> unknown,
      Predicate<String> stopsAdvanceRun) {
    this.modules = modules;
    this.globals = globals;
    this.unknown = unknown;
    this.stopsAdvanceRun = stopsAdvanceRun;
  }

  /** Compiles all modules; returns them by their names in upper case. */
  Map<String, Linked> link() {
    Map<String, LinkErrors> errors = new HashMap<>();
    modules.forEach((key, module) -> errors.put(key, declare(key, module)));
    Map<String, Linked> linked = new HashMap<>();
    errors.forEach(
        (key, found) -> {
          KrlModule module = modules.get(key);
          if (module != null) {
            linked.put(key, compiled(key, module, found));
          }
        });
    return linked;
  }

  private LinkErrors declare(String key, KrlModule module) {
    LinkErrors errors = new LinkErrors();
    Map<String, CompiledRoutine> own = new HashMap<>();
    boolean first = true;
    for (Routine routine : module.source().routines()) {
      CompiledRoutine head = head(module, routine);
      if (own.put(Scope.key(routine.name()), head) != null) {
        errors.add(
            routine.position(), "routine " + routine.name() + " is declared twice in this module");
      }
      // assumed: the first routine is global without GLOBAL
      if (first || routine.global()) {
        globalRoutines.put(Scope.key(routine.name()), head);
      }
      first = false;
    }
    ownRoutines.put(key, own);
    return errors;
  }

  private static CompiledRoutine head(KrlModule module, Routine routine) {
    List<CompiledRoutine.Parameter> parameters = new ArrayList<>();
    for (Routine.Parameter parameter : routine.parameters()) {
      VariablePath path = VariablePath.of(Scope.key(parameter.name()));
      parameters.add(new CompiledRoutine.Parameter(path, parameter.array() > 0, parameter.out()));
    }
    return new CompiledRoutine(
        module.name(), routine.name(), routine.returnType() != null, parameters);
  }

  /** Compiles a module; a failure of the compiler is an error of this module alone. */
  private Linked compiled(String key, KrlModule module, LinkErrors errors) {
    try {
      return compile(key, module, errors);
    } catch (RuntimeException | VirtualMachineError e) {
      Position position = module.source().position();
      errors.add(position, "the module cannot be compiled: " + e);
      return new Linked(
          head(module, module.source().routines().get(0)), errors.sorted(), Set.of(), false);
    }
  }

  private Linked compile(String key, KrlModule module, LinkErrors errors) {
    Set<String> called = new TreeSet<>();
    Map<String, CompiledRoutine> own = ownRoutines.getOrDefault(key, Map.of());
    for (Routine routine : module.source().routines()) {
      CompiledRoutine head = own.get(Scope.key(routine.name()));
      if (head != null) {
        compile(module, routine, head, errors, called);
      }
    }
    CompiledRoutine main = own.get(Scope.key(module.name()));
    if (main == null) {
      throw new IllegalStateException("module " + module.name() + " has no routine of its name");
    }
    return new Linked(main, errors.sorted(), called, true);
  }

  private void compile(
      KrlModule module,
      Routine routine,
      CompiledRoutine head,
      LinkErrors errors,
      Set<String> called) {
    SymbolTable symbols = new SymbolTable(module, globals, modules, unknown, errors);
    symbols.declare(routine);
    routineBytes += symbols.scope().bytes();
    globals.routineBytes(routineBytes);
    RoutineContext context =
        new RoutineContext(
            symbols,
            List.of(ownRoutines.getOrDefault(Scope.key(module.name()), Map.of()), globalRoutines),
            stopsAdvanceRun,
            errors,
            called);
    String type = routine.returnType();
    if (!routine.returnDimensions().isEmpty()) {
      errors.add(routine.position(), "an array cannot be returned by this simulation");
    }
    Storage result = type == null ? null : symbols.result(routine.position(), type);
    CompiledCode code =
        new StatementCompiler(context, type != null)
            .routine(routine.name(), routine.body(), routine.end());
    head.complete(
        new CompiledRoutine.Body(
            code, List.copyOf(symbols.locals()), result, context.temporaries()));
  }
}
