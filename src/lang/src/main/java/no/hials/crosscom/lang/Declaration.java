package no.hials.crosscom.lang;

import java.util.List;
import org.jspecify.annotations.Nullable;

/** A declaration, or a line that sets an initial value. */
public sealed interface Declaration {

  /** Returns the position of the first token. */
  Position position();

  /** Calls the method of a visitor for the kind of this declaration. */
  <R extends @Nullable Object> R accept(DeclarationVisitor<R> visitor);

  /**
   * A name with dimensions and an initial value.
   *
   * @param position where the name is
   * @param name the name as written
   * @param dimensions the length of each dimension: constant expressions; empty without an array;
   *     null for an open dimension, as in {@code NAME[]}
   * @param initial the initial value, or null
   */
  record Declarator(
      Position position,
      String name,
      List<@Nullable Expression> dimensions,
      @Nullable Expression initial) {}

  /**
   * Variables of one type, with or without {@code DECL}.
   *
   * @param position where it begins
   * @param global whether it is {@code GLOBAL}
   * @param constant whether it is {@code CONST}; a later line of the list can set its value
   * @param type the type's name as written
   * @param variables at least one
   * @param comment the comment on the same line, without {@code ;}; empty without a comment
   */
  record Variables(
      Position position,
      boolean global,
      boolean constant,
      String type,
      List<Declarator> variables,
      String comment)
      implements Declaration {
    @Override
    public <R extends @Nullable Object> R accept(DeclarationVisitor<R> visitor) {
      return visitor.visit(this);
    }
  }

  /**
   * A structure type.
   *
   * @param position where it begins
   * @param global whether it is {@code GLOBAL}
   * @param name the type's name as written
   * @param components the components in the order of the file; none has an initial value
   * @param comment the comment on the same line, without {@code ;}; empty without a comment
   */
  record StrucDeclaration(
      Position position, boolean global, String name, List<Component> components, String comment)
      implements Declaration {
    @Override
    public <R extends @Nullable Object> R accept(DeclarationVisitor<R> visitor) {
      return visitor.visit(this);
    }
  }

  /**
   * A component of a structure type.
   *
   * @param type the type's name as written
   * @param declarator name and dimensions
   */
  record Component(String type, Declarator declarator) {}

  /**
   * An enumeration type.
   *
   * @param position where it begins
   * @param global whether it is {@code GLOBAL}
   * @param name the type's name as written
   * @param constants the constants, without {@code #}
   * @param comment the comment on the same line, without {@code ;}; empty without a comment
   */
  record EnumDeclaration(
      Position position, boolean global, String name, List<String> constants, String comment)
      implements Declaration {
    @Override
    public <R extends @Nullable Object> R accept(DeclarationVisitor<R> visitor) {
      return visitor.visit(this);
    }
  }

  /**
   * A signal: {@code SIGNAL NAME $OUT[1] TO $OUT[8]}, or {@code SIGNAL NAME FALSE} for a signal
   * without wiring.
   *
   * @param position where it begins
   * @param global whether it is {@code GLOBAL}
   * @param name the name as written
   * @param first the input or output, or the first of several; null without wiring
   * @param last the last of several; null for a single one
   * @param comment the comment on the same line, without {@code ;}; empty without a comment
   */
  record Signal(
      Position position,
      boolean global,
      String name,
      Expression.@Nullable Variable first,
      Expression.@Nullable Variable last,
      String comment)
      implements Declaration {
    @Override
    public <R extends @Nullable Object> R accept(DeclarationVisitor<R> visitor) {
      return visitor.visit(this);
    }
  }

  /**
   * A channel to an interface: {@code CHANNEL :SER_1 :SER_1 $PSER_1}.
   *
   * @param position where it begins
   * @param name the name of the channel as written
   * @param interfaceName the name of the interface as written
   * @param settings the variable with its settings
   * @param comment the comment on the same line, without {@code ;}; empty without a comment
   */
  record Channel(
      Position position,
      String name,
      String interfaceName,
      Expression.Variable settings,
      String comment)
      implements Declaration {
    @Override
    public <R extends @Nullable Object> R accept(DeclarationVisitor<R> visitor) {
      return visitor.visit(this);
    }
  }

  /**
   * A line of a data list that sets an element or a component: {@code $SOFTN_END[1]=-170.0}.
   *
   * @param position where it begins
   * @param target the element or component
   * @param value the value
   * @param comment the comment on the same line, without {@code ;}; empty without a comment
   */
  record InitialValue(
      Position position, Expression.Variable target, Expression value, String comment)
      implements Declaration {
    @Override
    public <R extends @Nullable Object> R accept(DeclarationVisitor<R> visitor) {
      return visitor.visit(this);
    }
  }

  /**
   * A reference to a routine or variable of another module: {@code EXT}, {@code EXTP}, {@code
   * EXTFCT}, {@code EXTFCTP}, {@code IMPORT}.
   *
   * @param position where it begins
   * @param name the name that becomes visible
   * @param source the source in {@code IMPORT ... IS /R1/MODULE..NAME}; empty without {@code
   *     IMPORT}
   */
  record External(Position position, String name, String source) implements Declaration {
    @Override
    public <R extends @Nullable Object> R accept(DeclarationVisitor<R> visitor) {
      return visitor.visit(this);
    }
  }
}
