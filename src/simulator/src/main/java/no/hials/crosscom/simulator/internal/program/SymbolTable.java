package no.hials.crosscom.simulator.internal.program;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.Set;
import no.hials.crosscom.lang.Access;
import no.hials.crosscom.lang.Declaration;
import no.hials.crosscom.lang.Declaration.Declarator;
import no.hials.crosscom.lang.Expression;
import no.hials.crosscom.lang.Position;
import no.hials.crosscom.lang.Routine;
import no.hials.crosscom.lang.TypeSwitch;
import no.hials.crosscom.simulator.LoadingMode;
import no.hials.crosscom.simulator.RefusedException;
import no.hials.crosscom.simulator.internal.data.Declarations;
import no.hials.crosscom.simulator.internal.data.Import;
import no.hials.crosscom.simulator.internal.data.KrlErrorException;
import no.hials.crosscom.simulator.internal.data.Scope;
import no.hials.crosscom.simulator.internal.data.Storage;
import no.hials.crosscom.simulator.internal.data.VariablePath;
import org.jspecify.annotations.Nullable;

/**
 * The variables that a routine can use: its own, those of its module, and those of the controller.
 */
final class SymbolTable {
  /** Declares the types, which parameters and variables need. */
  private static final TypeSwitch<SymbolTable, Declaration, Void, KrlErrorException> TYPES =
      TypeSwitch.create(
          Declaration.class,
          cases ->
              cases
                  .run(
                      Declaration.StrucDeclaration.class,
                      (table, it) -> Declarations.declare(table.own, it))
                  .run(
                      Declaration.EnumDeclaration.class,
                      (table, it) -> Declarations.declare(table.own, it))
                  .run(Declaration.Variables.class, (table, it) -> {})
                  .run(Declaration.Signal.class, (table, it) -> {})
                  .run(Declaration.External.class, (table, it) -> {})
                  .run(Declaration.Channel.class, SymbolTable::refuseChannel)
                  .run(Declaration.InitialValue.class, SymbolTable::refuse));

  /** Declares everything but the types. */
  private static final TypeSwitch<SymbolTable, Declaration, Void, KrlErrorException> VARIABLES =
      TypeSwitch.create(
          Declaration.class,
          cases ->
              cases
                  .run(Declaration.StrucDeclaration.class, (table, it) -> {})
                  .run(Declaration.EnumDeclaration.class, (table, it) -> {})
                  .run(Declaration.Variables.class, SymbolTable::declareVariables)
                  .run(
                      Declaration.Signal.class,
                      (table, it) -> Declarations.declare(table.own, it, Access.READ_WRITE))
                  .run(Declaration.External.class, SymbolTable::importVariable)
                  .run(Declaration.Channel.class, (table, it) -> {})
                  .run(Declaration.InitialValue.class, (table, it) -> {}));

  private static final String RESULT = "RESULT";

  /** The length of the text that a function of type {@code CHAR[]} returns (assumed). */
  private static final int LONGEST_TEXT = 256;

  private final KrlModule module;
  private final Scope globals;
  private final Imports imports;
  private final Set<String> unknown;
  private final LinkErrors errors;

  /** The declarations of the routine, without values. */
  private final Scope own;

  /** The names of the parameters in upper case. */
  private final Set<String> parameters = new HashSet<>();

  private final Map<String, StorageLocation> locations = new HashMap<>();
  private final List<Storage> locals = new ArrayList<>();

  /**
   * @param imports those of the data list of the module
   * @param unknown the system variables that only programs mention, in upper case
   */
  SymbolTable(
      KrlModule module, Scope globals, Imports imports, Set<String> unknown, LinkErrors errors) {
    this.module = module;
    this.globals = globals;
    this.imports = imports;
    this.unknown = unknown;
    this.errors = errors;
    this.own = new Scope(module.scope());
  }

  List<Storage> locals() {
    return locals;
  }

  /** Returns the scope of all variables that are not in the frame of the routine. */
  Scope scope() {
    return own;
  }

  // declarations

  void declare(Routine routine) {
    for (Routine.Parameter parameter : routine.parameters()) {
      if (!parameters.add(Scope.key(parameter.name()))) {
        errors.add(parameter.position(), "parameter " + parameter.name() + " is declared twice");
      }
    }
    Map<String, Declaration.Variables> ofParameters = new HashMap<>();
    for (Declaration declaration : routine.declarations()) {
      if (declaration instanceof Declaration.Variables variables) {
        for (Declarator variable : variables.variables()) {
          if (parameters.contains(Scope.key(variable.name()))) {
            ofParameters.put(Scope.key(variable.name()), variables);
          }
        }
      }
    }
    routine.declarations().forEach(declaration -> declare(TYPES, declaration));
    for (Routine.Parameter parameter : routine.parameters()) {
      declareParameter(parameter, ofParameters.get(Scope.key(parameter.name())));
    }
    routine.declarations().forEach(declaration -> declare(VARIABLES, declaration));
  }

  private void declare(
      TypeSwitch<SymbolTable, Declaration, Void, KrlErrorException> declarations,
      Declaration declaration) {
    try {
      declarations.run(this, declaration);
    } catch (KrlErrorException e) {
      errors.add(e.error().position(), e.error().message());
    }
  }

  private void declareParameter(
      Routine.Parameter parameter, Declaration.@Nullable Variables variables) {
    int slot = locals.size();
    String key = Scope.key(parameter.name());
    if (parameter.array() > 1 && !parameter.out()) {
      // assumed: KSS passes no array by value
      errors.add(
          parameter.position(),
          "an array of several dimensions is passed only as :OUT, " + key + " is :IN");
    }
    StorageLocation location =
        parameter.out() ? new StorageLocation.Parameter(slot) : new StorageLocation.Local(slot);
    if (variables == null) {
      errors.add(parameter.position(), "parameter " + parameter.name() + " has no declaration");
      declareLocal(new Declarator(parameter.position(), key, List.of(), null), "INT", location);
      return;
    }
    for (Declarator variable : variables.variables()) {
      if (Scope.key(variable.name()).equals(key)) {
        declareLocal(variable, variables.type(), location);
        if (locals.size() == slot) {
          declareUntyped(variable, location);
        }
        return;
      }
    }
  }

  private void declareVariables(Declaration.Variables variables) {
    if (variables.global() || variables.constant()) {
      errors.add(variables.position(), "GLOBAL and CONST are for variables of data lists only");
    }
    for (Declarator variable : variables.variables()) {
      if (!parameters.contains(Scope.key(variable.name()))) {
        checkDimensions(variable);
        StorageLocation location = new StorageLocation.Local(locals.size());
        declareLocal(variable, variables.type(), location);
        if (module.mode() == LoadingMode.LENIENT && !own.knowsType(variables.type())) {
          declareUntyped(variable, location);
        }
      }
    }
  }

  private void refuseChannel(Declaration.Channel channel) throws KrlErrorException {
    throw new KrlErrorException(channel.position(), "CHANNEL is not supported by this simulation");
  }

  private void refuse(Declaration.InitialValue value) throws KrlErrorException {
    throw new KrlErrorException(value.position(), "only a data list sets initial values");
  }

  private void checkDimensions(Declarator variable) {
    for (Expression dimension : variable.dimensions()) {
      if (dimension == null) {
        errors.add(
            variable.position(),
            "only the dimensions of a parameter are open, not those of " + variable.name());
        return;
      }
    }
  }

  private void declareLocal(Declarator variable, String type, StorageLocation location) {
    String key = Scope.key(variable.name());
    if (own.contains(key)) {
      errors.add(variable.position(), key + " is declared twice");
      return;
    }
    try {
      Declarations.declare(own, type, closed(variable), Access.READ_WRITE);
      locals.add(own.contents(key));
      locations.put(key, location);
    } catch (KrlErrorException e) {
      errors.add(e.error().position(), e.error().message());
    } catch (RefusedException e) {
      throw new IllegalStateException(key + " was just declared", e);
    }
  }

  /**
   * Declares a variable of an unknown type, which keeps what is written; a parameter also so that
   * the others keep their slots.
   */
  private void declareUntyped(Declarator variable, StorageLocation location) {
    String key = Scope.key(variable.name());
    try {
      own.declareUntyped(key, variable.position());
      locals.add(own.contents(key));
      locations.put(key, location);
    } catch (KrlErrorException e) {
      errors.add(e.error().position(), e.error().message());
    } catch (RefusedException e) {
      throw new IllegalStateException(key + " was just declared", e);
    }
  }

  /** Returns a declarator whose open dimensions are 1 long until the call. */
  private static Declarator closed(Declarator variable) {
    List<Expression> dimensions = new ArrayList<>();
    for (Expression dimension : variable.dimensions()) {
      dimensions.add(
          dimension == null ? new Expression.IntLiteral(variable.position(), 1) : dimension);
    }
    return new Declarator(variable.position(), variable.name(), dimensions, null);
  }

  /** Declares a variable of another module: {@code IMPORT ... IS /R1/MODULE..NAME}. */
  private void importVariable(Declaration.External external) throws KrlErrorException {
    Optional<Import> wanted = Import.of(external);
    if (wanted.isPresent()) {
      locations.put(wanted.get().name(), imports.resolve(wanted.get()));
    }
  }

  /** Returns a variable for the value of a function; null if its type is wrong. */
  @Nullable Storage result(
      Position position, String type, List<@Nullable Expression> returnDimensions) {
    if (!own.knowsType(type)) {
      errors.add(position, "type " + type + " is not declared");
      return null;
    }
    if (returnDimensions.isEmpty()) {
      return own.uninitialised(type);
    }
    if (returnDimensions.size() > 1) {
      errors.add(position, "an array of several dimensions cannot be returned by this simulation");
      return null;
    }
    Expression length = returnDimensions.get(0);
    Declarator variable =
        new Declarator(
            position,
            RESULT,
            List.of(length == null ? new Expression.IntLiteral(position, LONGEST_TEXT) : length),
            null);
    Scope scope = new Scope(own);
    try {
      Declarations.declare(scope, type, variable, Access.READ_WRITE);
      return scope.contents(RESULT);
    } catch (KrlErrorException e) {
      errors.add(e.error().position(), e.error().message());
      return null;
    } catch (RefusedException e) {
      throw new IllegalStateException(RESULT + " was just declared", e);
    }
  }

  // look-up

  /** Returns the location of a variable by its name in upper case; null if it is not declared. */
  @Nullable StorageLocation find(String key) {
    StorageLocation location = locations.get(key);
    if (location != null) {
      return location;
    }
    for (Scope scope : List.of(own, module.scope())) {
      if (scope.contains(key)) {
        return new StorageLocation.Shared(scope);
      }
    }
    StorageLocation imported = imports.find(key);
    return imported == null && globals.contains(key)
        ? new StorageLocation.Shared(globals)
        : imported;
  }

  /**
   * Returns the location of the variable of an expression and checks its components; null after an
   * error.
   */
  @Nullable StorageLocation resolve(Expression.Variable variable) {
    String key = Scope.key(variable.name());
    if (key.startsWith("$") && module.mode() == LoadingMode.LENIENT) {
      declareUnknown(variable, key);
    }
    StorageLocation location = find(key);
    if (location == null) {
      String missing = imports.missing(key);
      if (missing == null) {
        errors.add(variable.position(), "no variable " + variable.name() + " is declared");
      } else {
        errors.stop(missing);
      }
      return null;
    }
    Scope scope = location instanceof StorageLocation.Shared shared ? shared.scope() : own;
    try {
      if (scope.isSignal(key)) {
        checkSignal(variable);
      } else if (!isWholeArray(variable)) {
        // whatever the indices are
        scope.storage(VariablePath.of(variable, index -> 1));
      }
    } catch (RefusedException e) {
      errors.add(variable.position(), variable.name() + ": " + e.getMessage());
      return null;
    }
    return location;
  }

  /** Declares a system variable that is not known, so that it keeps what programs write. */
  private void declareUnknown(Expression.Variable variable, String key) {
    try {
      if (!own.knows(key)) {
        globals.declareUntyped(variable.name(), variable.position());
        unknown.add(key);
      }
      if (unknown.contains(key)) {
        errors.warn(variable.position(), Scope.notKnown(key));
      }
    } catch (KrlErrorException e) {
      errors.add(e.error().position(), e.error().message());
    }
  }

  private void checkSignal(Expression.Variable variable) {
    if (variable.steps().size() > 1 || variable.steps().get(0).brackets()) {
      errors.add(variable.position(), variable.name() + ": a SIGNAL has no parts");
    }
  }

  /** Returns whether it is {@code NAME[]} or {@code NAME[,]}, which a call can pass. */
  static boolean isWholeArray(Expression.Variable variable) {
    Expression.Step last = variable.steps().get(variable.steps().size() - 1);
    return variable.steps().size() == 1 && last.open() && last.indices().isEmpty();
  }

  /**
   * Returns the name that decides whether access stops the advance run: the variable of the
   * controller, or the array that a SIGNAL is wired to.
   */
  Optional<String> ofController(Expression.Variable variable) {
    String key = Scope.key(variable.name());
    StorageLocation location = find(key);
    if (!(location instanceof StorageLocation.Shared shared)) {
      return Optional.empty();
    }
    Optional<String> wired = shared.scope().wiredArray(key);
    if (wired.isPresent()) {
      return wired;
    }
    return shared.scope() == globals ? Optional.of(key) : Optional.empty();
  }

  /** Returns the number of the output that a SIGNAL is wired to; empty for anything else. */
  OptionalInt output(String name) {
    return own.wiredArray(name).filter("$OUT"::equals).isPresent()
        ? own.wiredElement(name)
        : OptionalInt.empty();
  }
}
