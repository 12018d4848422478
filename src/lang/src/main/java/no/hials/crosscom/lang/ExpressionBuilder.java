package no.hials.crosscom.lang;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Locale;
import no.hials.crosscom.lang.Expression.BinaryOperator;
import no.hials.crosscom.lang.Expression.Step;
import no.hials.crosscom.lang.Expression.UnaryOperator;
import no.hials.crosscom.lang.internal.grammar.KrlGrammarParser;
import no.hials.crosscom.lang.internal.grammar.KrlGrammarParser.AggregateContext;
import no.hials.crosscom.lang.internal.grammar.KrlGrammarParser.ArgumentContext;
import no.hials.crosscom.lang.internal.grammar.KrlGrammarParser.ArgumentsContext;
import no.hials.crosscom.lang.internal.grammar.KrlGrammarParser.BracketsContext;
import no.hials.crosscom.lang.internal.grammar.KrlGrammarParser.DimensionContext;
import no.hials.crosscom.lang.internal.grammar.KrlGrammarParser.ExpressionContext;
import no.hials.crosscom.lang.internal.grammar.KrlGrammarParser.FieldContext;
import no.hials.crosscom.lang.internal.grammar.KrlGrammarParser.NameContext;
import no.hials.crosscom.lang.internal.grammar.KrlGrammarParser.PrimaryContext;
import no.hials.crosscom.lang.internal.grammar.KrlGrammarParser.ReferenceContext;
import no.hials.crosscom.lang.internal.grammar.KrlGrammarParser.StepContext;
import no.hials.crosscom.lang.internal.grammar.KrlGrammarParser.StepsContext;
import no.hials.crosscom.lang.internal.grammar.KrlGrammarParser.VariableContext;
import org.antlr.v4.runtime.ParserRuleContext;
import org.antlr.v4.runtime.Token;
import org.jspecify.annotations.Nullable;

/** Builds the records of expressions. */
final class ExpressionBuilder {
  private static final int INT_BITS = 32;

  /** The magnitude of the smallest INT, valid only after a minus sign. */
  private static final long MIN_MAGNITUDE = 1L << (INT_BITS - 1);

  private final Errors errors;

  ExpressionBuilder(Errors errors) {
    this.errors = errors;
  }

  Position at(ParserRuleContext context) {
    return errors.at(context.getStart());
  }

  Expression build(ExpressionContext context) {
    if (context.operator == null) {
      return primary(context.primary());
    }
    Position position = errors.at(context.operator);
    List<ExpressionContext> operands = context.expression();
    if (operands.size() == 1) {
      return unary(position, context.operator, operands.get(0));
    }
    return new Expression.Binary(
        position, binary(context.operator), build(operands.get(0)), build(operands.get(1)));
  }

  @Nullable Expression buildOptional(@Nullable ExpressionContext context) {
    return context == null ? null : build(context);
  }

  private Expression unary(Position position, Token operator, ExpressionContext operand) {
    if (operator.getType() == KrlGrammarParser.MINUS
        && operand.getText().equals(Long.toString(MIN_MAGNITUDE))) {
      return new Expression.IntLiteral(position, Integer.MIN_VALUE);
    }
    UnaryOperator which = UnaryOperator.valueOf(ErrorWords.tokenName(operator.getType()));
    return new Expression.Unary(position, which, build(operand));
  }

  private static BinaryOperator binary(Token operator) {
    return operator.getType() == KrlGrammarParser.COLON
        ? BinaryOperator.GEOMETRIC
        : BinaryOperator.valueOf(ErrorWords.tokenName(operator.getType()));
  }

  private Expression primary(PrimaryContext context) {
    Token start = context.getStart();
    return switch (start.getType()) {
      case KrlGrammarParser.LEFT_PARENTHESIS -> build(context.expression());
      case KrlGrammarParser.LEFT_BRACE -> aggregate(context.aggregate());
      case KrlGrammarParser.INT,
          KrlGrammarParser.REAL,
          KrlGrammarParser.BITS,
          KrlGrammarParser.TRUE,
          KrlGrammarParser.FALSE,
          KrlGrammarParser.TEXT,
          KrlGrammarParser.ENUM_VALUE ->
          literal(start);
      default -> reference(context.reference());
    };
  }

  private Expression literal(Token token) {
    Position position = errors.at(token);
    String text = token.getText();
    return switch (token.getType()) {
      case KrlGrammarParser.INT -> new Expression.IntLiteral(position, integer(token));
      case KrlGrammarParser.BITS -> new Expression.IntLiteral(position, bits(token));
      case KrlGrammarParser.REAL -> new Expression.RealLiteral(position, real(token));
      case KrlGrammarParser.TEXT ->
          new Expression.TextLiteral(position, text.substring(1, text.length() - 1));
      case KrlGrammarParser.ENUM_VALUE -> new Expression.EnumLiteral(position, text.substring(1));
      default -> new Expression.BoolLiteral(position, token.getType() == KrlGrammarParser.TRUE);
    };
  }

  private int integer(Token token) {
    try {
      return Integer.parseInt(token.getText());
    } catch (NumberFormatException e) {
      errors.add(token, token.getText() + " is not an INT: the largest is " + Integer.MAX_VALUE);
      return 0;
    }
  }

  /** Reads {@code 'B0101'} and {@code 'HFF'} as 32 bits; the first bit is the sign (assumed). */
  private int bits(Token token) {
    String text = token.getText();
    boolean binary = text.toUpperCase(Locale.ROOT).charAt(1) == 'B';
    String digits = text.substring(2, text.length() - 1).replaceFirst("^0+(?=.)", "");
    if (digits.length() > (binary ? INT_BITS : INT_BITS / 4)) {
      errors.add(token, text + " is not an INT: it has more than 32 bits");
      return 0;
    }
    return Integer.parseUnsignedInt(digits, binary ? 2 : 16);
  }

  private double real(Token token) {
    float value = Float.parseFloat(token.getText());
    if (Float.isInfinite(value)) {
      errors.add(token, token.getText() + " is not a REAL: the largest is " + Float.MAX_VALUE);
      return 0;
    }
    return value;
  }

  private Expression aggregate(AggregateContext context) {
    List<Expression.AggregateField> fields = new ArrayList<>();
    String type = null;
    if (context.expression() != null) {
      fields.add(field(context.name(), context.brackets(), context.expression()));
    } else if (context.name() != null) {
      type = context.name().getText();
    }
    for (FieldContext field : context.field()) {
      fields.add(field(field.name(), field.brackets(), field.expression()));
    }
    return new Expression.Aggregate(at(context), type, List.copyOf(fields));
  }

  private Expression.AggregateField field(
      NameContext name, @Nullable BracketsContext brackets, ExpressionContext value) {
    String plain = name.getStart().getText();
    String written = brackets == null ? plain : plain + brackets.getText();
    return new Expression.AggregateField(at(name), written, build(value));
  }

  private Expression reference(ReferenceContext context) {
    return context.arguments() == null
        ? variable(context.name(), context.steps())
        : new Expression.FunctionCall(
            at(context), context.name().getText(), arguments(context.arguments()));
  }

  Expression.Variable variable(VariableContext context) {
    return variable(context.name(), context.steps());
  }

  Expression.Variable variable(NameContext name, StepsContext context) {
    List<Step> steps = new ArrayList<>();
    steps.add(step(name, context.brackets()));
    for (StepContext step : context.step()) {
      steps.add(step(step.name(), step.brackets()));
    }
    return new Expression.Variable(at(name), List.copyOf(steps));
  }

  private Step step(NameContext name, @Nullable BracketsContext brackets) {
    List<Expression> indices = new ArrayList<>();
    boolean open = false;
    for (@Nullable Expression dimension : dimensions(brackets)) {
      if (dimension == null) {
        open = true;
      } else if (open) {
        errors.add(dimension.position(), "an index after an omitted index");
      } else {
        indices.add(dimension);
      }
    }
    return new Step(name.getText(), brackets != null, List.copyOf(indices), open);
  }

  /** Returns the dimensions in brackets, null for an open dimension; empty without brackets. */
  List<@Nullable Expression> dimensions(@Nullable BracketsContext brackets) {
    List<@Nullable Expression> dimensions = new ArrayList<>();
    if (brackets != null) {
      for (DimensionContext dimension : brackets.dimension()) {
        dimensions.add(buildOptional(dimension.expression()));
      }
      if (dimensions.size() > 3) {
        errors.add(
            brackets.getStart(), "expected at most 3 dimensions, found " + dimensions.size());
      }
    }
    return Collections.unmodifiableList(dimensions);
  }

  /** Returns the arguments of a call, null for an omitted argument. */
  List<@Nullable Expression> arguments(ArgumentsContext context) {
    List<@Nullable Expression> arguments = new ArrayList<>();
    for (ArgumentContext argument : context.argument()) {
      arguments.add(
          argument.name() == null
              ? buildOptional(argument.expression())
              : new Expression.ChannelLiteral(at(argument), argument.name().getText()));
    }
    boolean none = arguments.size() == 1 && arguments.get(0) == null;
    return none ? List.of() : Collections.unmodifiableList(arguments);
  }
}
