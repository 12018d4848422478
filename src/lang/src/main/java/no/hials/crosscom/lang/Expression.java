package no.hials.crosscom.lang;

import java.util.List;
import org.jspecify.annotations.Nullable;

/** An expression of a program or a data list. */
public sealed interface Expression {

  /** Returns the position of the first token; for an operation, of its operator. */
  Position position();

  /** Calls the method of a visitor for the kind of this expression. */
  <R extends @Nullable Object> R accept(ExpressionVisitor<R> visitor);

  /** A value that is written out. */
  sealed interface Literal extends Expression {}

  /**
   * A whole number: {@code 100}, {@code 'B0101'}, {@code 'HFF'}.
   *
   * @param position where it is
   * @param value the number
   */
  record IntLiteral(Position position, int value) implements Literal {
    @Override
    public <R extends @Nullable Object> R accept(ExpressionVisitor<R> visitor) {
      return visitor.visit(this);
    }
  }

  /**
   * A number with a decimal point or an exponent.
   *
   * @param position where it is
   * @param value the number, rounded to a 32-bit float
   */
  record RealLiteral(Position position, double value) implements Literal {
    @Override
    public <R extends @Nullable Object> R accept(ExpressionVisitor<R> visitor) {
      return visitor.visit(this);
    }
  }

  /**
   * {@code TRUE} or {@code FALSE}.
   *
   * @param position where it is
   * @param value the value
   */
  record BoolLiteral(Position position, boolean value) implements Literal {
    @Override
    public <R extends @Nullable Object> R accept(ExpressionVisitor<R> visitor) {
      return visitor.visit(this);
    }
  }

  /**
   * A text in double quotes; a text of one character can be a CHAR.
   *
   * @param position where it is
   * @param text the characters between the quotes
   */
  record TextLiteral(Position position, String text) implements Literal {
    @Override
    public <R extends @Nullable Object> R accept(ExpressionVisitor<R> visitor) {
      return visitor.visit(this);
    }
  }

  /**
   * {@code #NAME}.
   *
   * @param position where it is
   * @param name the constant, without {@code #}
   */
  record EnumLiteral(Position position, String name) implements Literal {
    @Override
    public <R extends @Nullable Object> R accept(ExpressionVisitor<R> visitor) {
      return visitor.visit(this);
    }
  }

  /**
   * {@code :NAME}, a channel; only an argument of a call.
   *
   * @param position where it is
   * @param name the channel, without the colon
   */
  record ChannelLiteral(Position position, String name) implements Literal {
    @Override
    public <R extends @Nullable Object> R accept(ExpressionVisitor<R> visitor) {
      return visitor.visit(this);
    }
  }

  /**
   * An aggregate: {@code {X 10,Y 2*I}} or {@code {POS: X 10}}.
   *
   * @param position where it begins
   * @param type the type's name, or null
   * @param fields the fields in the order of the file
   */
  record Aggregate(Position position, @Nullable String type, List<AggregateField> fields)
      implements Expression {
    @Override
    public <R extends @Nullable Object> R accept(ExpressionVisitor<R> visitor) {
      return visitor.visit(this);
    }
  }

  /**
   * A field of an aggregate.
   *
   * @param position where it is
   * @param name the component's name; followed by {@code []} if written, or by {@code [i]} for an
   *     element
   * @param value its value
   */
  record AggregateField(Position position, String name, Expression value) {}

  /**
   * A variable, an element or a component: {@code LOAD_DATA[I].CM.X}.
   *
   * @param position where it begins
   * @param steps the name, then the components; at least one
   */
  record Variable(Position position, List<Step> steps) implements Expression {
    @Override
    public <R extends @Nullable Object> R accept(ExpressionVisitor<R> visitor) {
      return visitor.visit(this);
    }

    /** Returns the name of the variable itself, as written. */
    public String name() {
      return steps.get(0).name();
    }
  }

  /**
   * A name with or without an index.
   *
   * @param name the name as written
   * @param brackets whether brackets follow
   * @param indices the indices in the brackets; empty for {@code []}
   * @param open whether the last dimension is open, as in {@code []} and {@code [1,]}
   */
  record Step(String name, boolean brackets, List<Expression> indices, boolean open) {}

  /**
   * A function call.
   *
   * @param position where it begins
   * @param name the function's name as written
   * @param arguments the arguments; null for an omitted argument
   */
  record FunctionCall(Position position, String name, List<@Nullable Expression> arguments)
      implements Expression {
    @Override
    public <R extends @Nullable Object> R accept(ExpressionVisitor<R> visitor) {
      return visitor.visit(this);
    }
  }

  /**
   * An operation with one operand.
   *
   * @param position where the operator is
   * @param operator the operator
   * @param operand the operand
   */
  record Unary(Position position, UnaryOperator operator, Expression operand)
      implements Expression {
    @Override
    public <R extends @Nullable Object> R accept(ExpressionVisitor<R> visitor) {
      return visitor.visit(this);
    }
  }

  /**
   * An operation with two operands.
   *
   * @param position where the operator is
   * @param operator the operator
   * @param left the left operand
   * @param right the right operand
   */
  record Binary(Position position, BinaryOperator operator, Expression left, Expression right)
      implements Expression {
    @Override
    public <R extends @Nullable Object> R accept(ExpressionVisitor<R> visitor) {
      return visitor.visit(this);
    }
  }

  /** The unary operators. */
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

  /** The binary operators. */
  enum BinaryOperator {
    /** {@code :}, the geometric operator: combines two frames. */
    GEOMETRIC,
    /** {@code *}. */
    MULTIPLY,
    /** {@code /}. */
    DIVIDE,
    /** {@code +}. */
    PLUS,
    /** {@code -}. */
    MINUS,
    /** {@code ==}. */
    EQUAL,
    /** {@code <>}. */
    NOT_EQUAL,
    /** {@code <}. */
    LESS,
    /** {@code <=}. */
    LESS_OR_EQUAL,
    /** {@code >}. */
    GREATER,
    /** {@code >=}. */
    GREATER_OR_EQUAL,
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
