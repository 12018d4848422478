package no.hials.crosscom.simulator.internal.program;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.SortedSet;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.function.Predicate;
import no.hials.crosscom.lang.DataList;
import no.hials.crosscom.lang.KrlError;
import no.hials.crosscom.lang.Position;
import no.hials.crosscom.lang.SourceFile;
import no.hials.crosscom.simulator.KrlFileException;
import no.hials.crosscom.simulator.LoadingMode;
import no.hials.crosscom.simulator.internal.data.DataListLoader;
import no.hials.crosscom.simulator.internal.data.Scope;
import org.jspecify.annotations.Nullable;

/** The modules on the controller; their names ignore case. Not thread-safe. */
public final class ProgramLibrary {
  private final Scope globals;
  private final Predicate<String> stopsAdvanceRun;

  /** By name in upper case. */
  private final Map<String, KrlModule> modules = new TreeMap<>();

  /** The system variables that only programs mention, in upper case. */
  private final Set<String> unknown = new HashSet<>();

  /** The compiled modules; null after a change. */
  private @Nullable Map<String, Linker.Linked> linked;

  /**
   * Creates a library without modules.
   *
   * @param globals the variables of the controller
   * @param stopsAdvanceRun whether access to a variable of the controller, by its name in upper
   *     case, waits until the robot has finished its motions; for a SIGNAL it gets the name of the
   *     inputs or outputs
   */
  public ProgramLibrary(Scope globals, Predicate<String> stopsAdvanceRun) {
    this.globals = globals;
    this.stopsAdvanceRun = stopsAdvanceRun;
  }

  /**
   * Adds a module and creates its variables. Replaces a module of the same name; a selected program
   * keeps the old one.
   *
   * @param source its routines; parsed without errors if the mode is strict
   * @param data its data list, or null
   * @param mode whether errors of the data list refuse the module, and those of the routines its
   *     selection
   * @return the errors of the data list; with an error, nothing changes. {@link #check} returns the
   *     errors of the routines
   */
  public List<KrlError> put(SourceFile source, @Nullable DataList data, LoadingMode mode) {
    List<KrlError> errors = new ArrayList<>();
    Scope scope = new Scope(globals);
    countBytes(Scope.key(source.name()));
    boolean done = data == null || globals.attempt(() -> load(data, scope, mode, errors));
    if (done) {
      modules.put(Scope.key(source.name()), new KrlModule(source, scope, mode));
      linked = null;
    }
    countBytes("");
    return List.copyOf(errors);
  }

  /** Counts the variables of the modules but one, which is replaced. */
  private void countBytes(String replaced) {
    long sum = 0;
    for (Map.Entry<String, KrlModule> module : modules.entrySet()) {
      sum += module.getKey().equals(replaced) ? 0 : module.getValue().scope().bytes();
    }
    globals.moduleBytes(sum);
    globals.routineBytes(0);
  }

  private boolean load(DataList data, Scope scope, LoadingMode mode, List<KrlError> errors) {
    DataListLoader.load(data, scope, globals, mode, errors::add);
    return mode == LoadingMode.LENIENT || errors.isEmpty();
  }

  /**
   * Creates the variables of a module again.
   *
   * @return the errors of the data list; with an error, nothing changes
   */
  public List<KrlError> put(DataList data, LoadingMode mode) {
    KrlModule module = modules.get(Scope.key(data.name()));
    return module == null ? List.of() : put(module.source(), data, mode);
  }

  public boolean remove(String name) {
    linked = null;
    boolean removed = modules.remove(Scope.key(name)) != null;
    countBytes("");
    return removed;
  }

  public SortedSet<String> names() {
    SortedSet<String> names = new TreeSet<>();
    modules.values().forEach(module -> names.add(module.name()));
    return names;
  }

  /**
   * Returns the variables of a module, with the globals around them; empty if it does not exist.
   */
  public Optional<Scope> scope(String name) {
    return Optional.ofNullable(modules.get(Scope.key(name))).map(KrlModule::scope);
  }

  /**
   * Returns the errors of a module in the order of the file: unknown names, and names that are not
   * used as declared.
   */
  public List<KrlError> check(String name) {
    Linker.Linked module = linked().get(Scope.key(name));
    return module == null ? List.of(unknown(name)) : module.errors();
  }

  private static KrlError unknown(String name) {
    return new KrlError(new Position(name, 1, 1), "no module " + name + " is loaded");
  }

  private Map<String, Linker.Linked> linked() {
    Map<String, Linker.Linked> known = linked;
    if (known == null) {
      known = new Linker(modules, globals, unknown, stopsAdvanceRun).link();
      linked = known;
    }
    return known;
  }

  /**
   * Compiles a module and all modules it calls.
   *
   * @throws KrlFileException if the module does not exist, or one of them contains an error and was
   *     loaded strictly
   */
  public Program program(String name) throws KrlFileException {
    Linker.Linked module = linked().get(Scope.key(name));
    if (module == null) {
      throw new KrlFileException(List.of(unknown(name)));
    }
    List<KrlError> errors = new ArrayList<>();
    for (String used : used(Scope.key(name))) {
      KrlModule found = modules.get(used);
      Linker.Linked link = linked().get(used);
      boolean strict = found == null || found.mode() == LoadingMode.STRICT;
      if (strict || link == null || !link.executable()) {
        errors.addAll(check(used));
      }
    }
    if (!errors.isEmpty()) {
      throw new KrlFileException(errors);
    }
    return new Program(module.main());
  }

  /** Returns the names of a module and of all modules it calls, directly or not. */
  private Set<String> used(String key) {
    Set<String> used = new TreeSet<>();
    Deque<String> left = new ArrayDeque<>(List.of(key));
    while (!left.isEmpty()) {
      String next = left.pop();
      Linker.Linked module = linked().get(next);
      if (module != null && used.add(next)) {
        left.addAll(module.calledModules());
      }
    }
    return used;
  }
}
