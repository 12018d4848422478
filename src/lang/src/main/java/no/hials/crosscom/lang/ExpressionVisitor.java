package no.hials.crosscom.lang;

import org.jspecify.annotations.Nullable;

/**
 * Handles each kind of expression; {@link Expression#accept} calls the method for the kind.
 *
 * @param <R> the result
 */
public interface ExpressionVisitor<R extends @Nullable Object> {
  /** Handles a whole number. */
  R visit(Expression.IntLiteral number);

  /** Handles a number with a decimal point or an exponent. */
  R visit(Expression.RealLiteral number);

  /** Handles TRUE or FALSE. */
  R visit(Expression.BoolLiteral bool);

  /** Handles a text. */
  R visit(Expression.TextLiteral text);

  /** Handles a constant of an enumeration. */
  R visit(Expression.EnumLiteral constant);

  /** Handles the name of a channel. */
  R visit(Expression.ChannelLiteral channel);

  /** Handles an aggregate. */
  R visit(Expression.Aggregate aggregate);

  /** Handles a variable, an element or a component. */
  R visit(Expression.Variable variable);

  /** Handles a function call. */
  R visit(Expression.FunctionCall call);

  /** Handles an operation with one operand. */
  R visit(Expression.Unary unary);

  /** Handles an operation with two operands. */
  R visit(Expression.Binary binary);
}
