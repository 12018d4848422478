package no.hials.crosscom.simulator.internal.data;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.Consumer;
import no.hials.crosscom.lang.Access;
import no.hials.crosscom.lang.DataList;
import no.hials.crosscom.lang.Declaration;
import no.hials.crosscom.lang.Expression;
import no.hials.crosscom.lang.KrlError;
import no.hials.crosscom.lang.Position;
import no.hials.crosscom.lang.TypeSwitch;
import no.hials.crosscom.lang.VariableNote;
import no.hials.crosscom.protocol.value.KrlValue;
import no.hials.crosscom.simulator.LoadingMode;
import no.hials.crosscom.simulator.RefusedException;
import org.jspecify.annotations.Nullable;

/**
 * Declares the contents of a data list and sets its initial values.
 *
 * <p>In a system data list, whose name starts with {@code $}, everything is global
 * (docs/reference/krl-language.md#modules). A declaration replaces an earlier one in the same
 * scope; a system variable keeps its access right, and a bound variable its source. One form is an
 * extension: after the declaration of an array whose name starts with {@code $}, one value can
 * stand for every element, {@code BOOL $IN[4096]=FALSE}, because no data list of KSS declares these
 * arrays.
 *
 * <p>A lenient load accepts more (docs/reference/simulated-controller.md#loading-files): types in
 * any order, CHANNEL, and values of system variables that are not declared, which then have an
 * unknown type. A variable whose initial value is wrong is declared without it.
 *
 * <p>{@code EXT}, {@code EXTFCT} and {@code IMPORT} declare nothing here. Programs find the
 * imported variable when they are linked, because its list can be loaded later.
 *
 * <p>The class is long, because it has a method for each kind of declaration.
 */
public final class DataListLoader {
  private static final TypeSwitch<DataListLoader, Declaration, Void, KrlErrorException>
      DECLARATIONS =
          TypeSwitch.create(
              Declaration.class,
              cases ->
                  cases
                      .run(Declaration.Variables.class, DataListLoader::declareVariables)
                      .run(Declaration.StrucDeclaration.class, DataListLoader::declareStruc)
                      .run(Declaration.EnumDeclaration.class, DataListLoader::declareEnum)
                      .run(Declaration.Signal.class, DataListLoader::declareSignal)
                      .run(Declaration.Channel.class, DataListLoader::checkChannel)
                      .run(Declaration.InitialValue.class, DataListLoader::initialise)
                      .run(Declaration.External.class, DataListLoader::checkExternal));

  private static final String REPLACES = " is known with other parts; this declaration replaces it";

  /** How often types are gone through, each time for those that need the types before. */
  private static final int MAX_TYPE_ROUNDS = 64;

  /** The number of structures in which one is looked for that contains itself. */
  private static final int MAX_SEEN = 64;

  private final DataList list;
  private final boolean isSystem;
  private final Scope module;
  private final Scope globals;
  private final boolean isLenient;
  private final Consumer<KrlError> errors;

  /** The scope of each name of this list, also of the wrong declarations. */
  private final Map<String, Scope> variables = new HashMap<>();

  private final Set<String> types = new HashSet<>();

  /** The structures of the list by their names, once they are needed. */
  private final Map<String, Declaration.StrucDeclaration> structures = new HashMap<>();

  /** The names whose declaration is wrong; errors that follow from it are not reported. */
  private final Set<String> broken = new HashSet<>();

  private final Set<String> brokenTypes = new HashSet<>();

  private DataListLoader(
      DataList list, Scope module, Scope globals, LoadingMode mode, Consumer<KrlError> errors) {
    this.list = list;
    this.isLenient = mode == LoadingMode.LENIENT;
    this.isSystem = isSystem(list);
    this.module = isSystem ? globals : module;
    this.globals = globals;
    this.errors = errors;
  }

  /**
   * Declares the types, variables and signals of a data list and sets their initial values.
   *
   * @param module gets the variables of the module; a scope in {@code globals}
   * @param globals gets the global variables: all of a system data list, and those that a public
   *     one declares GLOBAL
   * @param mode whether the forms that only a lenient load accepts are errors
   * @param errors gets the errors; the rest is still declared
   */
  public static void load(
      DataList list, Scope module, Scope globals, LoadingMode mode, Consumer<KrlError> errors) {
    new DataListLoader(list, module, globals, mode, errors).load();
  }

  private void load() {
    boolean hasAllTypes = false;
    int index = 0;
    for (Declaration declaration : list.declarations()) {
      if (isLenient && !hasAllTypes && !areTypesKnown(declaration)) {
        declareTypes(index);
        hasAllTypes = true;
      }
      if (!hasAllTypes || !isType(declaration)) {
        tell(() -> DECLARATIONS.run(this, declaration));
      }
      index++;
    }
  }

  /** Declares all types from a declaration on, each after the types of its components. */
  private void declareTypes(int first) {
    List<Declaration> left = new ArrayList<>();
    int index = 0;
    for (Declaration declaration : list.declarations()) {
      if (index++ >= first && isType(declaration)) {
        left.add(declaration);
      }
    }
    for (int i = 0; i < MAX_TYPE_ROUNDS && !left.isEmpty(); i++) {
      List<Declaration> later = new ArrayList<>();
      for (Declaration type : left) {
        if (areTypesKnown(type)) {
          tell(() -> DECLARATIONS.run(this, type));
        } else {
          later.add(type);
        }
      }
      if (later.size() == left.size()) {
        break;
      }
      left = later;
    }
    left.forEach(type -> tell(() -> DECLARATIONS.run(this, type)));
  }

  private static boolean isType(Declaration declaration) {
    return declaration instanceof Declaration.StrucDeclaration
        || declaration instanceof Declaration.EnumDeclaration;
  }

  private boolean areTypesKnown(Declaration declaration) {
    if (declaration instanceof Declaration.Variables group) {
      return module.knowsType(group.type());
    }
    return !(declaration instanceof Declaration.StrucDeclaration struc)
        || struc.components().stream().allMatch(component -> module.knowsType(component.type()));
  }

  /** Returns whether an error is about a type that was replaced, which loading again hides. */
  public static boolean isReplacement(KrlError error) {
    return error.message().endsWith(REPLACES);
  }

  /** Returns whether a data list is one of the controller itself, such as {@code $CONFIG}. */
  public static boolean isSystem(DataList list) {
    return list.name().startsWith("$");
  }

  /** A step that can find an error in the file. */
  private interface Step {
    void run() throws KrlErrorException;
  }

  /** Runs a step and reports its error; returns false after an error. */
  private boolean tell(Step step) {
    try {
      step.run();
      return true;
    } catch (KrlErrorException e) {
      errors.accept(e.error());
      return false;
    }
  }

  private Scope target(boolean global, Position position) {
    if (isSystem || (global && list.isPublic())) {
      return globals;
    }
    if (global) {
      errors.accept(
          new KrlError(
              position,
              "GLOBAL needs a public data list, expected DEFDAT "
                  + list.name()
                  + " PUBLIC, found no PUBLIC"));
    }
    return module;
  }

  // types

  private void checkNewType(String name, Position position) throws KrlErrorException {
    if (!types.add(Scope.key(name))) {
      throw new KrlErrorException(
          position, "a data list declares a type once, type " + name + " is declared again");
    }
  }

  private void declareEnum(Declaration.EnumDeclaration declaration) throws KrlErrorException {
    checkNewType(declaration.name(), declaration.position());
    Scope target = target(declaration.global(), declaration.position());
    declareType(
        target,
        declaration.name(),
        declaration.position(),
        () -> Declarations.declare(target, declaration));
  }

  /** Declares a type; a lenient load tells if an earlier one differs, and replaces it. */
  private void declareType(Scope target, String name, Position position, Step declare) {
    Type old = target.ownType(name);
    if (!tell(declare)) {
      brokenTypes.add(Scope.key(name));
      return;
    }
    Type type = target.ownType(name);
    if (isLenient && old != null && type != null && !type.isDeclaredAs(old)) {
      try {
        target.retype(old, type);
      } catch (IllegalArgumentException e) {
        // a structure that contains it would be too large or too deep, and keeps the old type
        errors.accept(new KrlError(position, String.valueOf(e.getMessage())));
      }
      errors.accept(new KrlError(position, "type " + name + REPLACES));
    }
  }

  private void declareStruc(Declaration.StrucDeclaration declaration) throws KrlErrorException {
    checkNewType(declaration.name(), declaration.position());
    Scope target = target(declaration.global(), declaration.position());
    List<Type.Component> components = new ArrayList<>();
    boolean whole = true;
    for (Declaration.Component component : declaration.components()) {
      whole &= tell(() -> components.add(component(target, declaration.name(), component)));
    }
    if (!whole) {
      brokenTypes.add(Scope.key(declaration.name()));
      return;
    }
    declareType(
        target,
        declaration.name(),
        declaration.position(),
        () -> Declarations.declare(target, declaration, components));
  }

  private Type.Component component(Scope target, String struc, Declaration.Component component)
      throws KrlErrorException {
    Position position = component.declarator().position();
    if (!target.knowsType(component.type())) {
      String cycle = contents(component.type(), Scope.key(struc), new HashSet<>());
      if (cycle != null) {
        throw new KrlErrorException(
            position,
            "a structure cannot contain itself, "
                + struc
                + " contains "
                + component.type()
                + cycle);
      }
    }
    checkType(target, component.type(), position);
    return Declarations.component(module, component);
  }

  /**
   * Returns how a structure of this list contains another one, such as {@code ", B contains A"}.
   *
   * @param seen the structures that do not
   * @return empty if both are the same; null if it does not contain the other one
   */
  private @Nullable String contents(String struc, String wanted, Set<String> seen) {
    if (Scope.key(struc).equals(wanted)) {
      return "";
    }
    Declaration.StrucDeclaration declaration = structures().get(Scope.key(struc));
    if (declaration == null || seen.size() == MAX_SEEN || !seen.add(Scope.key(struc))) {
      return null;
    }
    for (Declaration.Component component : declaration.components()) {
      String rest = contents(component.type(), wanted, seen);
      if (rest != null) {
        return ", " + struc + " contains " + component.type() + rest;
      }
    }
    return null;
  }

  private Map<String, Declaration.StrucDeclaration> structures() {
    if (structures.isEmpty()) {
      for (Declaration declaration : list.declarations()) {
        if (declaration instanceof Declaration.StrucDeclaration struc) {
          structures.putIfAbsent(Scope.key(struc.name()), struc);
        }
      }
    }
    return structures;
  }

  private static void checkType(Scope scope, String name, Position position)
      throws KrlErrorException {
    if (!scope.knowsType(name)) {
      throw new KrlErrorException(
          position, "a type is declared before it is used, type " + name + " is not declared");
    }
  }

  // variables

  /** Checks a name and returns the scope of its declaration. */
  private Scope checkNew(String name, boolean global, Position position) throws KrlErrorException {
    Scope target = target(global, position);
    if (target == globals) {
      target = owned(name, position);
    }
    if (variables.putIfAbsent(Scope.key(name), target) != null) {
      throw new KrlErrorException(
          position, "a data list declares a name once, " + name + " is declared again");
    }
    if (name.startsWith("$") && !isSystem) {
      broken.add(Scope.key(name));
      throw new KrlErrorException(
          position,
          "a system variable is declared in a system data list such as $CONFIG, "
              + name
              + " is declared in "
              + list.name());
    }
    return target;
  }

  /**
   * Returns the scope of a GLOBAL name: that of the module if another list has declared it, so that
   * each module uses its own. A system data list replaces the others, as when it is loaded again.
   */
  private Scope owned(String name, Position position) {
    String owner = globals.owner(name);
    if (isSystem || owner == null || owner.equalsIgnoreCase(list.name())) {
      globals.setOwner(name, list.name());
      return globals;
    }
    errors.accept(
        new KrlError(
            position,
            name + " is GLOBAL in " + owner + ", too; this one is only for module " + list.name()));
    return module;
  }

  private void declareVariables(Declaration.Variables group) {
    boolean typeKnown =
        brokenTypes.contains(Scope.key(group.type()))
            ? module.knowsType(group.type())
            : tell(() -> checkType(module, group.type(), group.position()));
    for (Declaration.Declarator declarator : group.variables()) {
      tell(
          () -> {
            Scope target = checkNew(declarator.name(), group.global(), declarator.position());
            boolean declared =
                typeKnown
                    ? tell(() -> declareVariable(group, declarator, target))
                    : isLenient && tell(() -> declareUntyped(declarator, target));
            if (!declared) {
              broken.add(Scope.key(declarator.name()));
            }
          });
    }
  }

  private void declareVariable(
      Declaration.Variables group, Declaration.Declarator source, Scope target)
      throws KrlErrorException {
    Expression initial = source.initial();
    DeclaredType type = DeclaredType.of(module, group.type(), source);
    target.checkRoom(source.name(), type, source.position());
    Storage contents = type.uninitialised();
    if (initial != null) {
      contents = withInitial(contents, source, initial);
    }
    VariableEntry old = own(target, source.name());
    if (isLenient && initial == null && old != null && source.name().startsWith("$")) {
      declareAgain(target, old, type);
    } else if (old != null && old.source() != null) {
      checkBound(old, contents, source.position());
      target.put(old.with(contents));
    } else {
      Access access = access(old, source.name(), group.constant(), group.comment());
      target.put(VariableEntry.variable(source.name(), access, contents));
    }
  }

  /** Declares a variable of an unknown type, which keeps what is written. */
  private void declareUntyped(Declaration.Declarator source, Scope target)
      throws KrlErrorException {
    target.declareUntyped(source.name(), source.position());
    Expression initial = source.initial();
    VariableEntry variable = own(target, source.name());
    if (initial != null && variable != null) {
      target.put(variable.with(withInitial(UntypedStorage.EMPTY, source, initial)));
    }
  }

  /** Declares a variable of the controller again, which keeps its value. */
  private static void declareAgain(Scope target, VariableEntry old, DeclaredType type) {
    Storage contents = old.contents();
    if (contents == null || old.source() != null) {
      return; // a signal, or set by the controller
    }
    Storage changed = type.atLeast(DeclaredType.of(contents)).uninitialised().takeOver(contents);
    if (changed.initialised() || !contents.initialised()) {
      target.put(old.with(changed));
    }
  }

  private Storage withInitial(Storage contents, Declaration.Declarator source, Expression initial)
      throws KrlErrorException {
    try {
      return contents instanceof ArrayStorage
          ? filled(contents, source, initial)
          : assigned(contents, source.name(), source.position(), initial);
    } catch (KrlErrorException e) {
      if (!isLenient) {
        throw e;
      }
      errors.accept(e.error());
      return contents;
    }
  }

  /** Returns an array with one value in every element. */
  private Storage filled(Storage array, Declaration.Declarator source, Expression initial)
      throws KrlErrorException {
    if (!source.name().startsWith("$")) {
      throw byElement(initial.position(), source.name());
    }
    try {
      return array.assign(ConstantExpressions.evaluate(initial, module));
    } catch (RefusedException e) {
      throw new KrlErrorException(initial.position(), source.name() + ": " + e.getMessage());
    }
  }

  private static KrlErrorException byElement(Position position, String name) {
    return new KrlErrorException(
        position,
        "an array gets its values by element, expected lines such as "
            + name
            + "[1]=..., found a value for the whole array");
  }

  private static @Nullable VariableEntry own(Scope scope, String name) {
    return scope.contains(name) ? scope.lookup(Scope.key(name)) : null;
  }

  private static Access access(
      @Nullable VariableEntry old, String name, boolean constant, String comment) {
    if (old != null && name.startsWith("$")) {
      return old.access();
    }
    Access noted = constant ? Access.READ_ONLY : VariableNote.of(comment).access();
    return noted == null ? Access.READ_WRITE : noted;
  }

  private static void checkBound(VariableEntry old, @Nullable Storage contents, Position position)
      throws KrlErrorException {
    Storage kept = old.contents();
    if (kept != null
        && (contents == null || !DeclaredType.of(kept).equals(DeclaredType.of(contents)))) {
      throw new KrlErrorException(
          position,
          "the controller sets "
              + old.name()
              + ", expected "
              + DeclaredType.of(kept)
              + ", found "
              + (contents == null ? "SIGNAL" : DeclaredType.of(contents)));
    }
  }

  // signals

  private void declareSignal(Declaration.Signal signal) throws KrlErrorException {
    Scope target = checkNew(signal.name(), signal.global(), signal.position());
    try {
      VariableEntry old = own(target, signal.name());
      if (old != null && old.source() != null) {
        checkBound(old, null, signal.position());
      }
      target.checkRoom(signal.name(), null, signal.position());
      checkEnd(signal.first());
      checkEnd(signal.last());
      Access access = access(old, signal.name(), false, signal.comment());
      target.put(VariableEntry.signal(signal.name(), access, SignalWiring.of(module, signal)));
    } catch (KrlErrorException e) {
      broken.add(Scope.key(signal.name()));
      throw e;
    }
  }

  private void checkEnd(Expression.@Nullable Variable expression) throws KrlErrorException {
    if (expression == null) {
      return;
    }
    VariablePath path = ConstantExpressions.path(expression, module);
    try {
      boolean isElement =
          path.isLast(0)
              && path.first().index().count() == 1
              && module.storage(path) instanceof ScalarStorage;
      if (isElement) {
        return;
      }
    } catch (RefusedException e) {
      throw refused(expression.position(), path.toString(), e);
    }
    throw new KrlErrorException(
        expression.position(),
        "a SIGNAL is wired to inputs or outputs, expected one such as $OUT[1], found " + path);
  }

  // initial values

  private void initialise(Declaration.InitialValue declaration) throws KrlErrorException {
    String name = declaration.target().name();
    String key = Scope.key(name);
    if (broken.contains(key)) {
      return;
    }
    Scope owner = variables.get(key);
    if (owner == null) {
      if (!isSystem) {
        // assumed: a module's list sets only its own variables
        throw new KrlErrorException(
            declaration.position(),
            "a data list sets only its own variables, " + name + " is not declared in it");
      }
      owner = globals;
    }
    VariableEntry variable = owner.lookup(key);
    if (variable == null && isLenient && name.startsWith("$")) {
      owner.declareUntyped(name, declaration.position());
      variable = owner.lookup(key);
      errors.accept(new KrlError(declaration.position(), Scope.notKnown(name)));
    }
    if (variable == null) {
      throw new KrlErrorException(declaration.position(), "no variable " + name + " is declared");
    }
    Storage contents = variable.contents();
    if (contents == null) {
      throw new KrlErrorException(
          declaration.position(), "a variable has an initial value, " + name + " is a SIGNAL");
    }
    VariablePath path = ConstantExpressions.path(declaration.target(), module);
    try {
      Storage part = contents.read(path);
      Storage changed =
          assigned(part, path.toString(), declaration.position(), declaration.value());
      owner.put(variable.with(contents.change(path, old -> changed)));
    } catch (RefusedException e) {
      throw refused(declaration.position(), path.toString(), e);
    }
  }

  private static KrlErrorException refused(Position position, String name, RefusedException e) {
    return new KrlErrorException(position, name + ": " + e.getMessage());
  }

  /** Returns contents with a value assigned. Of an aggregate, each correct field is assigned. */
  private Storage assigned(Storage storage, String name, Position where, Expression value)
      throws KrlErrorException {
    if (storage instanceof ArrayStorage) {
      throw byElement(where, name);
    }
    if (value instanceof Expression.Aggregate aggregate && storage instanceof StrucStorage struc) {
      return withFields(struc, name, aggregate);
    }
    KrlValue evaluated = ConstantExpressions.evaluate(value, module);
    try {
      return storage.assign(storage.coded(evaluated));
    } catch (RefusedException e) {
      throw refused(value.position(), name, e);
    }
  }

  private Storage withFields(StrucStorage struc, String name, Expression.Aggregate aggregate)
      throws KrlErrorException {
    String typeName = aggregate.type();
    if (typeName != null && !typeName.equalsIgnoreCase(struc.type().name())) {
      throw new KrlErrorException(
          aggregate.position(),
          name + ": needs " + struc.type().name() + ", was given an aggregate of " + typeName);
    }
    Storage result = struc;
    Set<String> names = new HashSet<>();
    for (Expression.AggregateField field : aggregate.fields()) {
      try {
        if (!names.add(Scope.key(field.name()))) {
          throw new KrlErrorException(
              field.position(), "an aggregate has a field once, " + field.name() + " is set again");
        }
        result = withField(result, field);
      } catch (KrlErrorException e) {
        errors.accept(e.error());
      }
    }
    return result;
  }

  private Storage withField(Storage struc, Expression.AggregateField field)
      throws KrlErrorException {
    try {
      VariablePath path = VariablePath.parse(field.name());
      String component = path.first().name();
      Storage contents = struc.component(component);
      Storage part = contents.read(path);
      Storage changed = assigned(part, field.name(), field.position(), field.value());
      return struc.changeComponent(component, old -> contents.change(path, same -> changed));
    } catch (RefusedException e) {
      throw refused(field.position(), field.name(), e);
    }
  }

  // other modules

  private void checkChannel(Declaration.Channel channel) throws KrlErrorException {
    if (isLenient) {
      return;
    }
    throw new KrlErrorException(channel.position(), "CHANNEL is not supported by this simulation");
  }

  private void checkExternal(Declaration.External external) throws KrlErrorException {
    Import.of(external);
  }
}
