package no.hials.crosscom.cell;

import java.util.List;
import java.util.stream.Collectors;
import no.hials.crosscom.lang.Expression;
import no.hials.crosscom.protocol.value.KrlReal;
import no.hials.crosscom.protocol.value.KrlString;

/** Prints expressions in KRL syntax. */
final class ExpressionText {
  private ExpressionText() {}

  static String of(Expression expression) {
    if (expression instanceof Expression.IntLiteral number) {
      return Integer.toString(number.value());
    } else if (expression instanceof Expression.RealLiteral number) {
      return KrlReal.of(number.value()).printShort();
    } else if (expression instanceof Expression.BoolLiteral bool) {
      return bool.value() ? "TRUE" : "FALSE";
    } else if (expression instanceof Expression.TextLiteral text) {
      return new KrlString(text.text()).printShort();
    } else if (expression instanceof Expression.EnumLiteral constant) {
      return "#" + constant.name();
    } else if (expression instanceof Expression.Aggregate aggregate) {
      return aggregate(aggregate);
    } else if (expression instanceof Expression.Variable variable) {
      return variable.steps().stream().map(ExpressionText::step).collect(Collectors.joining("."));
    } else if (expression instanceof Expression.FunctionCall call) {
      return call.name() + "(" + list(call.arguments()) + ")";
    } else if (expression instanceof Expression.Unary unary) {
      return unary(unary);
    } else if (expression instanceof Expression.Binary binary) {
      return "(" + of(binary.left()) + operator(binary.operator()) + of(binary.right()) + ")";
    }
    throw new IllegalArgumentException("unknown expression: " + expression);
  }

  private static String aggregate(Expression.Aggregate aggregate) {
    String type = aggregate.type() == null ? "" : aggregate.type() + ": ";
    return aggregate.fields().stream()
        .map(field -> field.name() + " " + of(field.value()))
        .collect(Collectors.joining(",", "{" + type, "}"));
  }

  private static String step(Expression.Step step) {
    if (!step.brackets()) {
      return step.name();
    }
    String indices = list(step.indices());
    return step.name() + "[" + indices + (step.open() && !indices.isEmpty() ? "," : "") + "]";
  }

  private static String list(List<? extends Expression> expressions) {
    return expressions.stream()
        .map(argument -> argument == null ? "" : of(argument))
        .collect(Collectors.joining(","));
  }

  private static String unary(Expression.Unary unary) {
    String operator =
        switch (unary.operator()) {
          case PLUS -> "+";
          case MINUS -> "-";
          case NOT, B_NOT -> unary.operator() + " ";
        };
    return operator + of(unary.operand());
  }

  private static String operator(Expression.BinaryOperator operator) {
    return switch (operator) {
      case GEOMETRIC -> ":";
      case TIMES -> "*";
      case DIVIDED -> "/";
      case PLUS -> "+";
      case MINUS -> "-";
      case EQUAL -> "==";
      case UNEQUAL -> "<>";
      case LESS -> "<";
      case AT_MOST -> "<=";
      case GREATER -> ">";
      case AT_LEAST -> ">=";
      case B_AND, B_EXOR, B_OR, AND, EXOR, OR -> " " + operator + " ";
    };
  }
}
