package no.hials.crosscom.simulator.internal.program;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
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
import no.hials.crosscom.simulator.internal.data.DataListLoader;
import no.hials.crosscom.simulator.internal.data.Scope;
import org.jspecify.annotations.Nullable;

/** The modules on the controller, by name in any case. Not safe for use by several threads. */
public final class ProgramLibrary {
  private final Scope globals;
  private final Predicate<String> stopsAdvanceRun;

  /** By name in upper case. */
  private final Map<String, KrlModule> modules = new TreeMap<>();

  /** What came of compiling them; null if that has to be done again. */
  private @Nullable Map<String, Linker.Linked> linked;

  /**
   * Makes a library without modules.
   *
   * @param globals the variables of the controller
   * @param stopsAdvanceRun says of a variable of the controller, by its name in upper case, whether
   *     access to it waits until the robot has ended its motions; of a SIGNAL it is asked for the
   *     inputs or outputs that it is wired to
   */
  public ProgramLibrary(Scope globals, Predicate<String> stopsAdvanceRun) {
    this.globals = globals;
    this.stopsAdvanceRun = stopsAdvanceRun;
  }

  /**
   * Adds a module, in place of one of the same name, and sets up its variables. A program that is
   * selected keeps the old one.
   *
   * @param source its routines, in which the parser has found nothing wrong
   * @param data its data list, or null
   * @return what is wrong in the data list, and then nothing has changed; {@link #check} says what
   *     is wrong in the routines
   */
  public List<KrlError> put(SourceFile source, @Nullable DataList data) {
    List<KrlError> errors = new ArrayList<>();
    Scope scope = new Scope(globals);
    boolean done = data == null || globals.attempt(() -> load(data, scope, errors));
    if (done) {
      modules.put(Scope.key(source.name()), new KrlModule(source, scope));
      linked = null;
    }
    return List.copyOf(errors);
  }

  private boolean load(DataList data, Scope scope, List<KrlError> errors) {
    DataListLoader.load(data, scope, globals, errors::add);
    return errors.isEmpty();
  }

  /**
   * Sets up the variables of a module again that is there already.
   *
   * @param data its data list
   * @return what is wrong in the data list; then nothing has changed
   */
  public List<KrlError> put(DataList data) {
    KrlModule module = modules.get(Scope.key(data.name()));
    return module == null ? List.of() : put(module.source(), data);
  }

  /**
   * Removes a module.
   *
   * @param name its name
   * @return whether there was one
   */
  public boolean remove(String name) {
    linked = null;
    return modules.remove(Scope.key(name)) != null;
  }

  /**
   * Lists the modules.
   *
   * @return the names as written, sorted; a copy
   */
  public SortedSet<String> names() {
    SortedSet<String> names = new TreeSet<>();
    modules.values().forEach(module -> names.add(module.name()));
    return names;
  }

  /**
   * Gives the variables of a module.
   *
   * @param name the module's name
   * @return its data list and, around it, the globals; nothing if there is no such module
   */
  public Optional<Scope> scope(String name) {
    return Optional.ofNullable(modules.get(Scope.key(name))).map(KrlModule::scope);
  }

  /**
   * Checks a module by itself: that all it names is known and used as it is declared.
   *
   * @param name the module's name
   * @return what is wrong, in the order of the file; empty if nothing is
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
      known = new Linker(modules, globals, stopsAdvanceRun).link();
      linked = known;
    }
    return known;
  }

  /**
   * Compiles a module and all that it calls.
   *
   * @param name the module's name
   * @return the program
   * @throws LinkException if there is no such module, or something is wrong in it or in one that it
   *     calls
   */
  public Program program(String name) throws LinkException {
    Linker.Linked module = linked().get(Scope.key(name));
    if (module == null) {
      throw new LinkException(List.of(unknown(name)));
    }
    List<KrlError> errors = new ArrayList<>();
    for (String used : used(Scope.key(name))) {
      errors.addAll(check(used));
    }
    if (!errors.isEmpty()) {
      throw new LinkException(errors);
    }
    return new Program(module.main());
  }

  /** Gives a module and all that it calls, directly or not. */
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
