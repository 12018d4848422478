package no.hials.crosscom.simulator.internal.program;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.HashMap;
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

  /** The data of these modules, and the data lists without routines; by name in upper case. */
  private final Map<String, KrlModule.Data> data = new HashMap<>();

  /** The bytes of all their variables, which are counted when a list is loaded. */
  private long bytes;

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
   * @param list its data list, or null
   * @param mode whether errors of the data list refuse the module, and those of the routines its
   *     selection
   * @return the errors of the data list; with an error, nothing changes. {@link #check} returns the
   *     errors of the routines
   */
  public List<KrlError> put(SourceFile source, @Nullable DataList list, LoadingMode mode) {
    return put(Scope.key(source.name()), source, list, mode);
  }

  private List<KrlError> put(
      String key, @Nullable SourceFile source, @Nullable DataList list, LoadingMode mode) {
    List<KrlError> errors = new ArrayList<>();
    Scope scope = new Scope(globals);
    long replaced = bytesOf(key);
    count(-replaced); // its room is free for the new one
    boolean done = false;
    try {
      done = list == null || globals.attempt(() -> load(list, scope, mode, errors));
    } finally {
      count(done ? scope.bytes() : replaced);
    }
    if (done) {
      KrlModule.Data loaded = KrlModule.Data.of(list, scope);
      data.put(key, loaded);
      if (source != null) {
        modules.put(key, new KrlModule(source, loaded, mode));
      }
      linked = null;
    }
    return List.copyOf(errors);
  }

  /** Counts the bytes of variables that are added to or removed from those of the modules. */
  private void count(long more) {
    bytes += more;
    globals.moduleBytes(bytes);
    globals.routineBytes(0);
  }

  private long bytesOf(String key) {
    KrlModule.Data known = data.get(key);
    return known == null ? 0 : known.scope().bytes();
  }

  private boolean load(DataList list, Scope scope, LoadingMode mode, List<KrlError> errors) {
    DataListLoader.load(list, scope, globals, mode, errors::add);
    return mode == LoadingMode.LENIENT || errors.isEmpty();
  }

  /**
   * Creates the variables of a module again, or those of a data list without routines, which other
   * modules can import.
   *
   * @return the errors of the data list; with an error, nothing changes
   */
  public List<KrlError> put(DataList list, LoadingMode mode) {
    String key = Scope.key(list.name());
    KrlModule module = modules.get(key);
    return put(key, module == null ? null : module.source(), list, mode);
  }

  /** Removes a module and its data list; returns false if there is neither. */
  public boolean remove(String name) {
    String key = Scope.key(name);
    linked = null;
    modules.remove(key);
    count(-bytesOf(key));
    return data.remove(key) != null;
  }

  /** Returns the modules with routines, which can be selected. */
  public SortedSet<String> names() {
    SortedSet<String> names = new TreeSet<>();
    modules.values().forEach(module -> names.add(module.name()));
    return names;
  }

  /**
   * Returns the variables of a module, with the globals around them; empty if it does not exist.
   */
  public Optional<Scope> scope(String name) {
    return Optional.ofNullable(data.get(Scope.key(name))).map(KrlModule.Data::scope);
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
      known = new Linker(modules, data, globals, unknown, stopsAdvanceRun).link();
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
