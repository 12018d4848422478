package no.hials.crosscom.lang;

import java.util.List;
import org.jspecify.annotations.Nullable;

/** A part of a program that has a value. */
public sealed interface Expression {

  /**
   * Gives the place.
   *
   * @return where it begins; of an operation where its operator stands
   */
  Position position();

  /**
   * A whole number: {@code 100}, {@code 'B0101'}, {@code 'HFF'}.
   *
   * @param position where it stands
   * @param value the number
   */
  record IntLiteral(Position position, int value) implements Expression {}

  /**
   * A number with a point or an exponent.
   *
   * @param position where it stands
   * @param value the number, as a 32-bit float holds it
   */
  record RealLiteral(Position position, double value) implements Expression {}

  /**
   * {@code TRUE} or {@code FALSE}.
   *
   * @param position where it stands
   * @param value the value
   */
  record BoolLiteral(Position position, boolean value) implements Expression {}

  /**
   * A text in double quotes; with one character it may be a CHAR.
   *
   * @param position where it stands
   * @param text the characters between the quotes
   */
  record TextLiteral(Position position, String text) implements Expression {}

  /**
   * {@code #NAME}.
   *
   * @param position where it stands
   * @param name the constant, without {@code #}
   */
  record EnumLiteral(Position position, String name) implements Expression {}

  /**
   * An aggregate: {@code {X 10,Y 2*I}} or {@code {POS: X 10}}.
   *
   * @param position where it begins
   * @param type the type's name, or null
   * @param fields the fields in the order of the file
   */
  record Aggregate(Position position, @Nullable String type, List<Field> fields)
      implements Expression {}

  /**
   * A field of an aggregate.
   *
   * @param position where it stands
   * @param name the component's name; with {@code []} if it is written so, with {@code [i]} for an
   *     element
   * @param value its value
   */
  record Field(Position position, String name, Expression value) {}

  /**
   * A variable, an element or a component: {@code LOAD_DATA[I].CM.X}.
   *
   * @param position where it begins
   * @param steps the name and the components behind it; at least one
   */
  record Variable(Position position, List<Step> steps) implements Expression {
    /**
     * Gives the name of the variable itself.
     *
     * @return the first name as written
     */
    public String name() {
      return steps.get(0).name();
    }
  }

  /**
   * A name with an index.
   *
   * @param name the name as written
   * @param brackets whether brackets stand behind it
   * @param indices the indices in the brackets; none for {@code []}
   * @param open whether the last dimension is left open, as in {@code []} and {@code [1,]}
   */
  record Step(String name, boolean brackets, List<Expression> indices, boolean open) {}

  /**
   * A call of a function.
   *
   * @param position where it begins
   * @param name the function's name as written
   * @param arguments the arguments; null for one that is left out
   */
  record Call(Position position, String name, List<@Nullable Expression> arguments)
      implements Expression {}

  /**
   * An operation with one operand.
   *
   * @param position where the operator stands
   * @param operator which
   * @param operand on what
   */
  record Unary(Position position, UnaryOperator operator, Expression operand)
      implements Expression {}

  /**
   * An operation with two operands.
   *
   * @param position where the operator stands
   * @param operator which
   * @param left the left operand
   * @param right the right operand
   */
  record Binary(Position position, BinaryOperator operator, Expression left, Expression right)
      implements Expression {}

  /** The operators with one operand. */
  enum UnaryOperator {
    /** {@code +}. */
    PLUS,
    /** {@code -}. */
    MINUS,
    /** {@code NOT}. */
    NOT,
    /** {@code B_NOT}. */
    B_NOT
  }

  /** The operators with two operands. */
  enum BinaryOperator {
    /** {@code :}, the geometric operator: a frame in a frame. */
    GEOMETRIC,
    /** {@code *}. */
    TIMES,
    /** {@code /}. */
    DIVIDED,
    /** {@code +}. */
    PLUS,
    /** {@code -}. */
    MINUS,
    /** {@code ==}. */
    EQUAL,
    /** {@code <>}. */
    UNEQUAL,
    /** {@code <}. */
    LESS,
    /** {@code <=}. */
    AT_MOST,
    /** {@code >}. */
    GREATER,
    /** {@code >=}. */
    AT_LEAST,
    /** {@code B_AND}. */
    B_AND,
    /** {@code B_EXOR}. */
    B_EXOR,
    /** {@code B_OR}. */
    B_OR,
    /** {@code AND}. */
    AND,
    /** {@code EXOR}. */
    EXOR,
    /** {@code OR}. */
    OR
  }
}
