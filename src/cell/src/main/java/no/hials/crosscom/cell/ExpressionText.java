package no.hials.crosscom.cell;

import java.util.List;
import java.util.stream.Collectors;
import no.hials.crosscom.lang.Expression;
import no.hials.crosscom.lang.ExpressionVisitor;
import no.hials.crosscom.protocol.value.KrlReal;
import no.hials.crosscom.protocol.value.KrlString;

/** Prints expressions in KRL syntax. */
final class ExpressionText implements ExpressionVisitor<String> {
  private static final ExpressionText PRINTER = new ExpressionText();

  private ExpressionText() {}

  static String of(Expression expression) {
    return expression.accept(PRINTER);
  }

  @Override
  public String visit(Expression.IntLiteral number) {
    return Integer.toString(number.value());
  }

  @Override
  public String visit(Expression.RealLiteral number) {
    return KrlReal.of(number.value()).printShort();
  }

  @Override
  public String visit(Expression.BoolLiteral bool) {
    return bool.value() ? "TRUE" : "FALSE";
  }

  @Override
  public String visit(Expression.TextLiteral text) {
    return new KrlString(text.text()).printShort();
  }

  @Override
  public String visit(Expression.EnumLiteral constant) {
    return "#" + constant.name();
  }

  @Override
  public String visit(Expression.ChannelLiteral channel) {
    return ":" + channel.name();
  }

  @Override
  public String visit(Expression.Aggregate aggregate) {
    String type = aggregate.type() == null ? "" : aggregate.type() + ": ";
    return aggregate.fields().stream()
        .map(field -> field.name() + " " + of(field.value()))
        .collect(Collectors.joining(",", "{" + type, "}"));
  }

  @Override
  public String visit(Expression.Variable variable) {
    return variable.steps().stream().map(ExpressionText::step).collect(Collectors.joining("."));
  }

  @Override
  public String visit(Expression.FunctionCall call) {
    return call.name() + "(" + list(call.arguments()) + ")";
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

  @Override
  public String visit(Expression.Unary unary) {
    String operator =
        switch (unary.operator()) {
          case PLUS -> "+";
          case MINUS -> "-";
          case NOT, B_NOT -> unary.operator() + " ";
        };
    return operator + of(unary.operand());
  }

  @Override
  public String visit(Expression.Binary binary) {
    return "(" + of(binary.left()) + operator(binary.operator()) + of(binary.right()) + ")";
  }

  private static String operator(Expression.BinaryOperator operator) {
    return switch (operator) {
      case GEOMETRIC -> ":";
      case MULTIPLY -> "*";
      case DIVIDE -> "/";
      case PLUS -> "+";
      case MINUS -> "-";
      case EQUAL -> "==";
      case NOT_EQUAL -> "<>";
      case LESS -> "<";
      case LESS_OR_EQUAL -> "<=";
      case GREATER -> ">";
      case GREATER_OR_EQUAL -> ">=";
      case B_AND, B_EXOR, B_OR, AND, EXOR, OR -> " " + operator + " ";
    };
  }
}
