package no.hials.crosscom.simulator.internal.data;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Supplier;
import no.hials.crosscom.lang.Access;
import no.hials.crosscom.lang.Declaration;
import no.hials.crosscom.lang.KrlError;
import no.hials.crosscom.lang.KrlParser;
import no.hials.crosscom.lang.Position;
import no.hials.crosscom.protocol.value.KrlValue;
import no.hials.crosscom.simulator.RefusedException;
import org.jspecify.annotations.Nullable;

/**
 * Declares types, variables and signals in a scope. Type names and constants are looked up in that
 * scope and around it. A declaration replaces an earlier one of the same name in the same scope;
 * variables declared before keep their type. A wrong declaration is an exception and changes
 * nothing.
 */
public final class Declarations {
  /** The position of a declaration that comes from Java code. */
  private static final Position NOWHERE = new Position("", 1, 1);

  private static final String STRUC_RULE =
      "a type is declared as in STRUC WELD REAL SPEED, CHAR NAME[24]";

  private static final String VARIABLE_RULE =
      "a declaration is a type and a name with or without [dimensions]";

  private Declarations() {}

  public static void declare(Scope scope, Declaration.StrucDeclaration struc)
      throws KrlErrorException {
    List<Type.Component> components = new ArrayList<>();
    for (Declaration.Component component : struc.components()) {
      components.add(component(scope, component));
    }
    declare(scope, struc, components);
  }

  static void declare(
      Scope scope, Declaration.StrucDeclaration struc, List<Type.Component> components)
      throws KrlErrorException {
    declareType(scope, struc.position(), () -> Type.Struc.of(struc.name(), components));
  }

  static Type.Component component(Scope scope, Declaration.Component component)
      throws KrlErrorException {
    Declaration.Declarator declarator = component.declarator();
    return new Type.Component(
        declarator.name(), DeclaredType.of(scope, component.type(), declarator));
  }

  public static void declare(Scope scope, Declaration.EnumDeclaration enumeration)
      throws KrlErrorException {
    declareType(
        scope,
        enumeration.position(),
        () -> Type.Enumeration.of(enumeration.name(), enumeration.constants()));
  }

  private static void declareType(Scope scope, Position position, Supplier<Type> type)
      throws KrlErrorException {
    try {
      scope.declareType(type.get());
    } catch (IllegalArgumentException e) {
      throw new KrlErrorException(position, String.valueOf(e.getMessage()));
    }
  }

  public static void declare(Scope scope, Declaration.Signal signal, Access access)
      throws KrlErrorException {
    scope.checkRoom(signal.name(), null, signal.position());
    scope.put(VariableEntry.signal(signal.name(), access, SignalWiring.of(scope, signal)));
  }

  /**
   * Declares a variable without a value.
   *
   * @param type the name of its type
   * @throws KrlErrorException if the declaration is wrong; then nothing has changed
   */
  public static void declare(
      Scope scope, String type, Declaration.Declarator declarator, Access access)
      throws KrlErrorException {
    DeclaredType declared = DeclaredType.of(scope, type, declarator);
    scope.checkRoom(declarator.name(), declared, declarator.position());
    scope.put(VariableEntry.variable(declarator.name(), access, declared.uninitialised()));
  }

  // from the texts of Java code

  /**
   * Declares a structure type.
   *
   * @param declaration such as {@code STRUC WELD REAL SPEED, CHAR NAME[24]}
   * @throws IllegalArgumentException if it is wrong; then nothing has changed
   */
  public static void declareStruc(Scope scope, String declaration) {
    try {
      declare(scope, parse(declaration, Declaration.StrucDeclaration.class, STRUC_RULE));
    } catch (KrlErrorException e) {
      throw new IllegalArgumentException(e.error().message(), e);
    }
  }

  public static void declareEnum(Scope scope, String name, List<String> constants) {
    scope.declareType(Type.Enumeration.of(name, constants));
  }

  /**
   * Declares a variable or a signal.
   *
   * @param declaration such as {@code INT MYINTS[10]} or {@code SIGNAL GROUP $OUT[5] TO $OUT[8]}
   * @param value the initial value of a variable; for an array all elements or one value for every
   *     element; null for none
   * @return the name
   * @throws RefusedException if the value is not of the type; then nothing has changed
   * @throws IllegalArgumentException if the declaration is wrong; then nothing has changed
   */
  public static String declare(
      Scope scope, String declaration, Access access, @Nullable KrlValue value)
      throws RefusedException {
    try {
      if (Scope.key(declaration).startsWith("SIGNAL ")) {
        Declaration.Signal signal = parse(declaration, Declaration.Signal.class, SignalWiring.RULE);
        declare(scope, signal, access);
        return signal.name();
      }
      Declaration.Variables variables =
          parse(declaration, Declaration.Variables.class, VARIABLE_RULE);
      Declaration.Declarator variable = variables.variables().get(0);
      if (variables.variables().size() > 1) {
        throw new KrlErrorException(NOWHERE, "expected one variable, found '" + declaration + "'");
      }
      DeclaredType type = DeclaredType.of(scope, variables.type(), variable);
      scope.checkRoom(variable.name(), type, NOWHERE);
      Storage contents = type.uninitialised();
      scope.put(
          VariableEntry.variable(
              variable.name(), access, value == null ? contents : contents.assign(value)));
      return variable.name();
    } catch (KrlErrorException e) {
      throw new IllegalArgumentException(e.error().message(), e);
    }
  }

  private static <D extends Declaration> D parse(String text, Class<D> kind, String rule) {
    List<KrlError> errors = new ArrayList<>();
    return KrlParser.parseDeclaration(text, errors::add)
        .filter(kind::isInstance)
        .map(kind::cast)
        .orElseThrow(
            () ->
                new IllegalArgumentException(
                    rule
                        + ", is '"
                        + text.strip()
                        + "'"
                        + (errors.isEmpty() ? "" : ": " + errors.get(0).message())));
  }
}
