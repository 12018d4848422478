package no.hials.crosscom.simulator.internal.data;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import no.hials.crosscom.protocol.value.KrlBool;
import no.hials.crosscom.protocol.value.KrlEnum;
import no.hials.crosscom.protocol.value.KrlInt;
import no.hials.crosscom.protocol.value.KrlReal;
import no.hials.crosscom.protocol.value.KrlString;
import no.hials.crosscom.protocol.value.KrlStruct;
import no.hials.crosscom.protocol.value.KrlValue;
import no.hials.crosscom.simulator.Refusal;
import no.hials.crosscom.simulator.RefusedException;

/** The type of a variable without dimensions, of an element or of a component. */
sealed interface Type {

  /** Returns the name as declared. */
  String name();

  /**
   * Returns the types of the components, of arrays that of an element; empty without components.
   */
  List<Type> elements();

  /** The bytes that a value without parts takes, about. */
  long SCALAR_BYTES = 64;

  /** Returns whether another type of the same name has the same parts; upper case is lower case. */
  default boolean isDeclaredAs(Type other) {
    return equals(other);
  }

  /** Returns contents of this type without a value. */
  Storage uninitialised();

  /** Returns the bytes that contents of this type take at most, about. */
  long bytes();

  /** Returns the bytes that the type itself takes, about. */
  long definitionBytes();

  /** A type whose values have no parts. */
  sealed interface Scalar extends Type {

    /**
     * Returns the value to store, given a written value.
     *
     * @throws RefusedException if the value is not of this type
     */
    KrlValue convert(KrlValue value) throws RefusedException;

    @Override
    default List<Type> elements() {
      return List.of();
    }

    @Override
    default Storage uninitialised() {
      return new ScalarStorage(this, null);
    }

    @Override
    default long bytes() {
      return SCALAR_BYTES;
    }
  }

  private static RefusedException wrongType(Type type, KrlValue value) {
    return new RefusedException(
        Refusal.WRONG_TYPE, "needs " + type.name() + ", was given " + value.print());
  }

  /** The type of a system variable that no data list declares. */
  enum Undeclared implements Type {
    /** Not known. */
    UNKNOWN;

    @Override
    public List<Type> elements() {
      return List.of();
    }

    @Override
    public Storage uninitialised() {
      return UntypedStorage.EMPTY;
    }

    @Override
    public long bytes() {
      return SCALAR_BYTES;
    }

    @Override
    public long definitionBytes() {
      return 0;
    }
  }

  /** The base types of KRL. */
  enum Base implements Scalar {
    /**
     * A signed 32-bit number. The text of a REAL is accepted if it is a whole number: the original
     * client wrote {@code 50.0} to {@code $OV_PRO}, and its README shows that a controller accepted
     * it. Other REALs are refused, not rounded (assumed).
     */
    INT,
    /**
     * A 32-bit float; the text of an INT is accepted
     * (docs/reference/krl-values.md#what-a-write-accepts).
     */
    REAL,
    /** TRUE or FALSE. */
    BOOL,
    /** One character; an array of it is a text. */
    CHAR;

    @Override
    public long definitionBytes() {
      return 0;
    }

    @Override
    public KrlValue convert(KrlValue value) throws RefusedException {
      if (this == INT
          && value instanceof KrlReal number
          && number.value() == (int) number.value()) {
        return new KrlInt((int) number.value());
      }
      if (this == REAL && value instanceof KrlInt number) {
        return KrlReal.of(number.value());
      }
      boolean fits =
          switch (this) {
            case INT -> value instanceof KrlInt;
            case REAL -> value instanceof KrlReal;
            case BOOL -> value instanceof KrlBool;
            case CHAR -> value instanceof KrlString;
          };
      if (!fits) {
        throw wrongType(this, value);
      }
      if (value instanceof KrlString string && string.text().length() != 1) {
        throw new RefusedException(Refusal.OUT_OF_RANGE, "needs one character, was given " + value);
      }
      return value;
    }
  }

  /**
   * A type with named constants.
   *
   * @param name as declared
   * @param constants by their names in upper case
   */
  record Enumeration(String name, Map<String, KrlEnum> constants) implements Scalar {

    static Enumeration of(String name, List<String> constants) {
      Map<String, KrlEnum> byName = new HashMap<>();
      for (String constant : constants) {
        byName.put(constant.toUpperCase(Locale.ROOT), new KrlEnum(constant));
      }
      if (byName.isEmpty() || byName.size() < constants.size()) {
        throw new IllegalArgumentException(
            "ENUM " + name + " must have at least one constant and none twice, has " + constants);
      }
      return new Enumeration(name, Map.copyOf(byName));
    }

    @Override
    public boolean isDeclaredAs(Type other) {
      return other instanceof Enumeration enumeration
          && constants.keySet().equals(enumeration.constants.keySet());
    }

    @Override
    public long definitionBytes() {
      return (1 + constants.size()) * Scope.NAME_BYTES;
    }

    @Override
    public KrlValue convert(KrlValue value) throws RefusedException {
      if (!(value instanceof KrlEnum constant)) {
        throw wrongType(this, value);
      }
      KrlEnum own = constants.get(constant.name().toUpperCase(Locale.ROOT));
      if (own == null) {
        throw new RefusedException(Refusal.OUT_OF_RANGE, "ENUM " + name + " has no " + value);
      }
      return own;
    }
  }

  /**
   * A component of a structure.
   *
   * @param name as declared, without dimensions
   * @param type its type
   */
  record Component(String name, DeclaredType type) {
    private boolean isDeclaredAs(Component other) {
      return name.equalsIgnoreCase(other.name)
          && type.element().name().equalsIgnoreCase(other.type.element().name())
          && type.dimensions().equals(other.type.dimensions());
    }
  }

  /**
   * A structure.
   *
   * @param name as declared
   * @param components in print order
   * @param positions the position of each component, by its name in upper case
   * @param depth the levels of nested structures, this one included
   * @param bytes see {@link Type#bytes}
   */
  record Struc(
      String name,
      List<Component> components,
      Map<String, Integer> positions,
      int depth,
      long bytes)
      implements Type {
    private static final List<Set<String>> ASSIGNABLE =
        List.of(
            Set.of("FRAME", "POS", "E3POS", "E6POS"),
            Set.of("AXIS", "E3AXIS", "E6AXIS"),
            Set.of("APO", "CONT"));

    @Override
    public List<Type> elements() {
      return components.stream().map(component -> component.type().element()).toList();
    }

    static Struc of(String name, List<Component> components) {
      Map<String, Integer> positions = new HashMap<>();
      int deepest = 0;
      long bytes = 0;
      for (Component component : components) {
        String key = component.name().toUpperCase(Locale.ROOT);
        if (positions.put(key, positions.size()) != null) {
          throw new IllegalArgumentException("STRUC " + name + " has " + key + " twice");
        }
        bytes += component.type().bytes();
        if (component.type().element() instanceof Struc struc) {
          deepest = Math.max(deepest, struc.depth);
        }
      }
      if (components.isEmpty() || deepest >= KrlValue.MAX_DEPTH) {
        throw new IllegalArgumentException(
            "STRUC "
                + name
                + " must have a component and nest at most "
                + KrlValue.MAX_DEPTH
                + " deep, has "
                + components.size()
                + " and nests "
                + (deepest + 1));
      }
      if (bytes > Scope.MAX_BYTES) {
        throw new IllegalArgumentException(Scope.tooLarge("STRUC " + name, bytes));
      }
      return new Struc(name, List.copyOf(components), Map.copyOf(positions), deepest + 1, bytes);
    }

    /** Returns this structure with another type in the components of one type. */
    Struc with(Type old, Type type) {
      List<Component> changed = new ArrayList<>();
      for (Component component : components) {
        DeclaredType own = component.type();
        changed.add(
            own.element().equals(old)
                ? new Component(component.name(), new DeclaredType(type, own.dimensions()))
                : component);
      }
      return of(name, changed);
    }

    @Override
    public boolean isDeclaredAs(Type other) {
      if (!(other instanceof Struc struc) || components.size() != struc.components.size()) {
        return false;
      }
      for (int i = 0; i < components.size(); i++) {
        if (!components.get(i).isDeclaredAs(struc.components.get(i))) {
          return false;
        }
      }
      return true;
    }

    @Override
    public long definitionBytes() {
      return (1 + components.size()) * Scope.NAME_BYTES;
    }

    @Override
    public Storage uninitialised() {
      Storage[] parts = new Storage[components.size()];
      for (int i = 0; i < parts.length; i++) {
        parts[i] = components.get(i).type().uninitialised();
      }
      return new StrucStorage(this, parts);
    }

    /**
     * Converts a position of another type: keeps the components that this type has. Assumed,
     * because programs assign {@code $POS_ACT} to a FRAME. CONT and APO can be assigned to each
     * other (docs/reference/krl-values.md#fields-of-the-structures).
     */
    KrlStruct ofItsKind(KrlStruct value) {
      String given = value.typeName();
      if (given == null || given.equalsIgnoreCase(name)) {
        return value;
      }
      for (Set<String> kind : ASSIGNABLE) {
        if (kind.contains(name.toUpperCase(Locale.ROOT))
            && kind.contains(given.toUpperCase(Locale.ROOT))) {
          return new KrlStruct(
              name,
              value.fields().stream()
                  .filter(field -> positions.containsKey(field.name().toUpperCase(Locale.ROOT)))
                  .toList());
        }
      }
      return value;
    }

    /** Checks the type name of an aggregate, which can be missing. */
    KrlStruct check(KrlValue value) throws RefusedException {
      if (value instanceof KrlStruct struct
          && (struct.typeName() == null || struct.typeName().equalsIgnoreCase(name))) {
        return struct;
      }
      throw wrongType(this, value);
    }
  }
}
