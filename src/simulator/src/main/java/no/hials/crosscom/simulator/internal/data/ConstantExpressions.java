package no.hials.crosscom.simulator.internal.data;

import java.util.ArrayList;
import java.util.List;
import no.hials.crosscom.lang.Access;
import no.hials.crosscom.lang.Expression;
import no.hials.crosscom.lang.Position;
import no.hials.crosscom.lang.TypeSwitch;
import no.hials.crosscom.protocol.value.KrlBool;
import no.hials.crosscom.protocol.value.KrlEnum;
import no.hials.crosscom.protocol.value.KrlInt;
import no.hials.crosscom.protocol.value.KrlReal;
import no.hials.crosscom.protocol.value.KrlString;
import no.hials.crosscom.protocol.value.KrlStruct;
import no.hials.crosscom.protocol.value.KrlValue;
import no.hials.crosscom.simulator.KrlExecutionException;
import no.hials.crosscom.simulator.RefusedException;

/**
 * Evaluates the constant expressions of declarations: literals, aggregates, CONST variables, and
 * {@code + - * /} of them.
 */
public final class ConstantExpressions {
  private static final TypeSwitch<Scope, Expression, KrlValue, KrlErrorException> VALUES =
      TypeSwitch.create(
          Expression.class,
          cases ->
              cases
                  .on(Expression.IntLiteral.class, (scope, it) -> new KrlInt(it.value()))
                  .on(Expression.RealLiteral.class, (scope, it) -> KrlReal.of(it.value()))
                  .on(Expression.BoolLiteral.class, (scope, it) -> new KrlBool(it.value()))
                  .on(Expression.TextLiteral.class, (scope, it) -> new KrlString(it.text()))
                  .on(Expression.EnumLiteral.class, (scope, it) -> new KrlEnum(it.name()))
                  .on(
                      Expression.ChannelLiteral.class,
                      (scope, it) -> {
                        throw notConstant(it.position(), "the channel " + it.name());
                      })
                  .on(Expression.Aggregate.class, ConstantExpressions::struct)
                  .on(Expression.Variable.class, ConstantExpressions::constant)
                  .on(Expression.Unary.class, ConstantExpressions::signed)
                  .on(Expression.Binary.class, ConstantExpressions::computed)
                  .on(Expression.FunctionCall.class, ConstantExpressions::refused));

  private ConstantExpressions() {}

  /**
   * Returns the value of an expression.
   *
   * @param scope where CONST variables are looked up
   * @throws KrlErrorException if the expression is not constant, or has no value
   */
  public static KrlValue evaluate(Expression expression, Scope scope) throws KrlErrorException {
    try {
      return VALUES.apply(scope, expression);
    } catch (IllegalArgumentException e) {
      throw new KrlErrorException(expression.position(), String.valueOf(e.getMessage()));
    }
  }

  private static KrlErrorException notConstant(Position position, String found) {
    return new KrlErrorException(
        position,
        "a value here is made of literals, CONST variables and + - * /, expected one of them, found"
            + " "
            + found);
  }

  private static KrlStruct struct(Scope scope, Expression.Aggregate aggregate)
      throws KrlErrorException {
    List<KrlStruct.Field> fields = new ArrayList<>();
    for (Expression.AggregateField field : aggregate.fields()) {
      KrlValue value = evaluate(field.value(), scope);
      try {
        fields.add(new KrlStruct.Field(field.name(), value));
      } catch (IllegalArgumentException e) {
        throw new KrlErrorException(field.position(), String.valueOf(e.getMessage()));
      }
    }
    return new KrlStruct(aggregate.type(), fields);
  }

  private static KrlValue constant(Scope scope, Expression.Variable expression)
      throws KrlErrorException {
    VariablePath path = path(expression, scope);
    VariableEntry variable = scope.lookup(path.first().name());
    if (variable == null) {
      throw new KrlErrorException(
          expression.position(), "no variable " + expression.name() + " is declared");
    }
    // read-only system variables are not constant: the controller changes them
    boolean isConstant =
        variable.access() == Access.READ_ONLY
            && variable.contents() != null
            && !variable.name().startsWith("$");
    if (!isConstant) {
      throw notConstant(expression.position(), "the variable " + variable.name());
    }
    try {
      return scope.read(path);
    } catch (RefusedException e) {
      throw new KrlErrorException(expression.position(), variable.name() + " " + e.getMessage());
    }
  }

  /**
   * Returns the path of a variable.
   *
   * @throws KrlErrorException if an index is not a constant INT
   */
  static VariablePath path(Expression.Variable variable, Scope scope) throws KrlErrorException {
    return VariablePath.of(variable, index -> integer(index, scope));
  }

  /**
   * Returns the value of an index or of the length of a dimension.
   *
   * @throws KrlErrorException if it is not a constant INT
   */
  static int integer(Expression expression, Scope scope) throws KrlErrorException {
    KrlValue value = evaluate(expression, scope);
    if (value instanceof KrlInt number) {
      return number.value();
    }
    throw new KrlErrorException(
        expression.position(), "an index is an INT, expected one, found " + value.print());
  }

  private static KrlValue signed(Scope scope, Expression.Unary unary) throws KrlErrorException {
    KrlValue operand = evaluate(unary.operand(), scope);
    return switch (unary.operator()) {
      case PLUS -> number(unary.operand(), operand);
      case MINUS -> {
        try {
          yield Operators.negative(number(unary.operand(), operand));
        } catch (KrlExecutionException e) {
          throw new KrlErrorException(unary.position(), String.valueOf(e.getMessage()));
        }
      }
      default -> throw notConstant(unary.position(), unary.operator().toString());
    };
  }

  private static KrlValue computed(Scope scope, Expression.Binary binary) throws KrlErrorException {
    KrlValue left = number(binary.left(), evaluate(binary.left(), scope));
    KrlValue right = number(binary.right(), evaluate(binary.right(), scope));
    return switch (binary.operator()) {
      case PLUS, MINUS, MULTIPLY, DIVIDE -> {
        try {
          yield Operators.of(binary.operator()).apply(left, right);
        } catch (KrlExecutionException e) {
          throw new KrlErrorException(binary.position(), String.valueOf(e.getMessage()));
        }
      }
      default -> throw notConstant(binary.position(), binary.operator().toString());
    };
  }

  private static KrlValue refused(Scope scope, Expression.FunctionCall call)
      throws KrlErrorException {
    throw notConstant(call.position(), "a call of a function");
  }

  private static KrlValue number(Expression expression, KrlValue value) throws KrlErrorException {
    if (value instanceof KrlInt || value instanceof KrlReal) {
      return value;
    }
    throw new KrlErrorException(
        expression.position(), "+ - * / take numbers, expected INT or REAL, found " + value);
  }
}
