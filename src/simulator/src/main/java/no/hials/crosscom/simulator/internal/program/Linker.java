package no.hials.crosscom.simulator.internal.program;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.Predicate;
import no.hials.crosscom.lang.Declaration;
import no.hials.crosscom.lang.KrlError;
import no.hials.crosscom.lang.Position;
import no.hials.crosscom.lang.Routine;
import no.hials.crosscom.lang.SourceFile;
import no.hials.crosscom.simulator.LoadingMode;
import no.hials.crosscom.simulator.internal.data.Scope;
import no.hials.crosscom.simulator.internal.data.Storage;
import no.hials.crosscom.simulator.internal.data.VariablePath;

/**
 * Compiles all modules of a library: first the heads of all routines, so that calls can be checked,
 * then the bodies.
 *
 * <p>A routine of a module of KSS, such as {@code BAS}, in which every call stops at an error, or
 * in one that it calls of its module, gives way to the built-in one. Errors in branches do not
 * count: programs may never reach them.
 */
final class Linker {
  private final Map<String, KrlModule> modules;
  private final Map<String, KrlModule.Data> data;
  private final Scope globals;
  private final Set<String> unknown;
  private final Predicate<String> stopsAdvanceRun;
  private long routineBytes;
  private final Map<String, CompiledRoutine> globalRoutines = new HashMap<>();
  private final Map<String, Map<String, CompiledRoutine>> ownRoutines = new HashMap<>();
  private final Map<String, CompiledRoutine> builtIn = new HashMap<>();

  /** The warnings of all modules. */
  private final Set<String> warned = new HashSet<>();

  /** Where the routines of modules of KSS stop in every call, and what they call. */
  private final Map<CompiledRoutine, KrlError> stops = new HashMap<>();

  private final Map<CompiledRoutine, Set<CompiledRoutine>> calls = new LinkedHashMap<>();

  /** Why routines give way to built-in ones, by module and name, both in upper case. */
  private final Map<String, Map<String, KrlError>> replaced;

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
   * @param data the data lists of these and of modules without routines, likewise
   * @param globals the variables of the controller
   * @param unknown gets the system variables that only lenient modules mention, in upper case
   * @param stopsAdvanceRun whether access to a variable of the controller stops the advance run
   */
  Linker(
      Map<String, KrlModule> modules,
      Map<String, KrlModule.Data> data,
      Scope globals,
      Set<String> unknown,
      Predicate<String> stopsAdvanceRun) {
    this(modules, data, globals, unknown, stopsAdvanceRun, Map.of());
  }

  private Linker(
      Map<String, KrlModule> modules,
      Map<String, KrlModule.Data> data,
      Scope globals,
      Set<String> unknown,
      Predicate<String> stopsAdvanceRun,
      Map<String, Map<String, KrlError>> replaced) {
    this.modules = modules;
    this.data = data;
    this.replaced = replaced;
    this.globals = globals;
    this.unknown = unknown;
    this.stopsAdvanceRun = stopsAdvanceRun;
  }

  /** Compiles all modules; returns them by their names in upper case. */
  Map<String, Linked> link() {
    linkBuiltIn();
    Map<String, LinkErrors> errors = new LinkedHashMap<>();
    modules.forEach((key, module) -> errors.put(key, declare(key, module)));
    Map<String, Linked> linked = new HashMap<>();
    errors.forEach(
        (key, found) -> {
          KrlModule module = modules.get(key);
          if (module != null) {
            linked.put(key, compiled(key, module, found));
          }
        });
    Map<String, Map<String, KrlError>> replaceable = replaceable();
    return replaced.isEmpty() && !replaceable.isEmpty()
        ? new Linker(modules, data, globals, unknown, stopsAdvanceRun, replaceable).link()
        : linked;
  }

  /** Compiles the built-in modules, which see no other. */
  private void linkBuiltIn() {
    for (SourceFile source : BuiltInModules.SOURCES) {
      KrlModule module = builtIn(source);
      for (Routine routine : source.routines()) {
        builtIn.put(Scope.key(routine.name()), head(module, routine));
      }
    }
    for (SourceFile source : BuiltInModules.SOURCES) {
      KrlModule module = builtIn(source);
      for (Routine routine : source.routines()) {
        CompiledRoutine head = builtIn.get(Scope.key(routine.name()));
        if (head != null) {
          compile(
              module,
              new Imports(Map.of(), globals),
              routine,
              head,
              List.of(builtIn),
              new LinkErrors(new HashSet<>()),
              new TreeSet<>());
        }
      }
    }
  }

  private KrlModule builtIn(SourceFile source) {
    KrlModule.Data none = KrlModule.Data.of(null, new Scope(globals));
    return new KrlModule(source, none, LoadingMode.LENIENT);
  }

  /** Returns the routines of modules of KSS that cannot be executed and are built in, too. */
  private Map<String, Map<String, KrlError>> replaceable() {
    boolean more = true;
    while (more) {
      more = false;
      for (Map.Entry<CompiledRoutine, Set<CompiledRoutine>> entry : calls.entrySet()) {
        for (CompiledRoutine called : entry.getValue()) {
          KrlError stop = stops.get(called);
          more |=
              stop != null
                  && called.module().equals(entry.getKey().module())
                  && stops.putIfAbsent(entry.getKey(), stop) == null;
        }
      }
    }
    Map<String, Map<String, KrlError>> found = new HashMap<>();
    stops.forEach(
        (routine, stop) -> {
          String key = Scope.key(routine.name());
          if (builtIn.containsKey(key) || Builtins.find(key) != null) {
            found
                .computeIfAbsent(Scope.key(routine.module()), module -> new HashMap<>())
                .put(key, stop);
          }
        });
    return found;
  }

  private static boolean isOfKss(KrlModule module) {
    return BuiltInModules.SOURCES.stream()
        .anyMatch(source -> source.name().equalsIgnoreCase(module.name()));
  }

  private LinkErrors declare(String key, KrlModule module) {
    LinkErrors errors = new LinkErrors(warned);
    Map<String, CompiledRoutine> own = new HashMap<>();
    boolean first = true;
    for (Routine routine : module.source().routines()) {
      CompiledRoutine head = head(module, routine);
      if (own.put(Scope.key(routine.name()), head) != null) {
        errors.add(
            routine.position(), "routine " + routine.name() + " is declared twice in this module");
      }
      KrlError stop = replaced.getOrDefault(key, Map.of()).get(Scope.key(routine.name()));
      if (stop != null) {
        errors.add(
            routine.position(),
            "the built-in "
                + routine.name()
                + " replaces this routine, which would stop in line "
                + stop.position().line()
                + ": "
                + stop.message());
      }
      // assumed: the first routine is global without GLOBAL
      if (stop == null && (first || routine.global())) {
        declareGlobal(key, routine, head, errors);
      }
      first = false;
    }
    ownRoutines.put(key, own);
    return errors;
  }

  /** Adds a routine that all modules can call. Of two, that with the name of its module counts. */
  private void declareGlobal(
      String moduleKey, Routine routine, CompiledRoutine head, LinkErrors errors) {
    String key = Scope.key(routine.name());
    CompiledRoutine other = globalRoutines.get(key);
    boolean counts = other == null || key.equals(moduleKey);
    if (counts) {
      globalRoutines.put(key, head);
    }
    if (other != null && !other.module().equals(head.module())) {
      errors.add(
          routine.position(),
          "routine "
              + routine.name()
              + " is also in module "
              + other.module()
              + "; other modules call that of "
              + (counts ? head.module() : other.module()));
    }
  }

  private static CompiledRoutine head(KrlModule module, Routine routine) {
    List<CompiledRoutine.Parameter> parameters = new ArrayList<>();
    for (Routine.Parameter parameter : routine.parameters()) {
      VariablePath path = VariablePath.of(Scope.key(parameter.name()));
      boolean array = parameter.array() > 0 || isDeclaredAsArray(routine, parameter.name());
      parameters.add(new CompiledRoutine.Parameter(path, array, parameter.out()));
    }
    return new CompiledRoutine(
        module.name(), routine.name(), routine.returnType() != null, parameters);
  }

  /**
   * Routines of KSS omit the brackets in the head, as in {@code F(NAME:IN)}, {@code CHAR NAME[]}.
   */
  private static boolean isDeclaredAsArray(Routine routine, String parameter) {
    return routine.declarations().stream()
        .filter(Declaration.Variables.class::isInstance)
        .flatMap(each -> ((Declaration.Variables) each).variables().stream())
        .anyMatch(each -> each.name().equalsIgnoreCase(parameter) && !each.dimensions().isEmpty());
  }

  /** Compiles a module; a failure of the compiler is an error of this module alone. */
  private Linked compiled(String key, KrlModule module, LinkErrors errors) {
    try {
      return compile(key, module, errors);
    } catch (RuntimeException | VirtualMachineError e) {
      Position position = module.source().position();
      errors.add(position, "the module cannot be compiled: " + e);
      return new Linked(
          head(module, module.source().routines().get(0)), errors.complete(), Set.of(), false);
    }
  }

  private Linked compile(String key, KrlModule module, LinkErrors errors) {
    Imports imports = new Imports(data, globals);
    imports.add(module.data(), errors);
    Set<String> called = new TreeSet<>();
    Map<String, CompiledRoutine> own = ownRoutines.getOrDefault(key, Map.of());
    Map<String, CompiledRoutine> callable = new HashMap<>(own);
    callable.keySet().removeAll(replaced.getOrDefault(key, Map.of()).keySet());
    for (Routine routine : module.source().routines()) {
      CompiledRoutine head = own.get(Scope.key(routine.name()));
      if (head != null) {
        RoutineContext context =
            compile(
                module, imports, routine, head, List.of(callable, globalRoutines), errors, called);
        if (isOfKss(module)) {
          calls.put(head, context.calledRoutines());
          if (context.stop() != null) {
            stops.put(head, context.stop());
          }
        }
      }
    }
    CompiledRoutine main = own.get(Scope.key(module.name()));
    if (main == null) {
      throw new IllegalStateException("module " + module.name() + " has no routine of its name");
    }
    return new Linked(main, errors.complete(), called, true);
  }

  private RoutineContext compile(
      KrlModule module,
      Imports imports,
      Routine routine,
      CompiledRoutine head,
      List<Map<String, CompiledRoutine>> routines,
      LinkErrors errors,
      Set<String> called) {
    SymbolTable symbols = new SymbolTable(module, globals, imports, unknown, errors);
    symbols.declare(routine);
    routineBytes += symbols.scope().bytes();
    globals.routineBytes(routineBytes);
    RoutineContext context =
        new RoutineContext(symbols, routines, builtIn, stopsAdvanceRun, errors, called);
    String type = routine.returnType();
    Storage result =
        type == null ? null : symbols.result(routine.position(), type, routine.returnDimensions());
    CompiledCode code =
        new StatementCompiler(context, type != null)
            .routine(routine.name(), routine.body(), routine.end());
    head.complete(
        new CompiledRoutine.Body(
            code, List.copyOf(symbols.locals()), result, context.temporaries()));
    return context;
  }
}
