package no.hials.crosscom.simulator.internal.data;

import java.util.function.DoubleBinaryOperator;
import java.util.function.LongBinaryOperator;
import no.hials.crosscom.lang.Expression.BinaryOperator;
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
 * Evaluates the operators of KRL. Assumed, since no source defines them
 * (docs/reference/krl-language.md#operators): INT and INT give an INT, and a quotient is truncated;
 * with a REAL the result is a REAL, a 32-bit float; AND, OR and EXOR always evaluate both operands.
 */
public final class Operators {
  private Operators() {}

  /** An operator with two operands. */
  @FunctionalInterface
  public interface Operator {
    KrlValue apply(KrlValue left, KrlValue right) throws KrlExecutionException;
  }

  /** Returns the operation of an operator. */
  public static Operator of(BinaryOperator operator) {
    return switch (operator) {
      case GEOMETRIC -> FrameArithmetic::product;
      case PLUS -> arithmetic(Long::sum, Double::sum);
      case MINUS -> arithmetic((a, b) -> a - b, (a, b) -> a - b);
      case MULTIPLY -> arithmetic((a, b) -> a * b, (a, b) -> a * b);
      case DIVIDE -> Operators::quotient;
      case EQUAL -> (left, right) -> new KrlBool(areEqual(left, right));
      case NOT_EQUAL -> (left, right) -> new KrlBool(!areEqual(left, right));
      case LESS -> (left, right) -> new KrlBool(compare(left, right) < 0);
      case LESS_OR_EQUAL -> (left, right) -> new KrlBool(compare(left, right) <= 0);
      case GREATER -> (left, right) -> new KrlBool(compare(left, right) > 0);
      case GREATER_OR_EQUAL -> (left, right) -> new KrlBool(compare(left, right) >= 0);
      case B_AND -> (left, right) -> new KrlInt(intOf(left) & intOf(right));
      case B_OR -> (left, right) -> new KrlInt(intOf(left) | intOf(right));
      case B_EXOR -> (left, right) -> new KrlInt(intOf(left) ^ intOf(right));
      case AND -> (left, right) -> new KrlBool(Boolean.logicalAnd(boolOf(left), boolOf(right)));
      case OR -> (left, right) -> new KrlBool(Boolean.logicalOr(boolOf(left), boolOf(right)));
      case EXOR -> (left, right) -> new KrlBool(boolOf(left) ^ boolOf(right));
    };
  }

  private static Operator arithmetic(LongBinaryOperator ofInts, DoubleBinaryOperator ofReals) {
    return (left, right) ->
        left instanceof KrlInt a && right instanceof KrlInt b
            ? integer(ofInts.applyAsLong(a.value(), b.value()))
            : real(ofReals.applyAsDouble(number(left), number(right)));
  }

  private static KrlValue quotient(KrlValue left, KrlValue right) throws KrlExecutionException {
    double divisor = number(right);
    if (divisor == 0) {
      throw new KrlExecutionException(
          KrlExecutionException.DIVISION_BY_ZERO,
          "a divisor must not be 0, the dividend is " + left);
    }
    if (left instanceof KrlInt a && right instanceof KrlInt b) {
      return integer((long) a.value() / b.value());
    }
    return real(number(left) / divisor);
  }

  /** Returns the result of the sign {@code -}. */
  public static KrlValue negative(KrlValue operand) throws KrlExecutionException {
    return operand instanceof KrlInt number
        ? integer(-(long) number.value())
        : real(-number(operand));
  }

  /** Returns the result of the sign {@code +}. */
  public static KrlValue positive(KrlValue operand) throws KrlExecutionException {
    number(operand);
    return operand;
  }

  /** Returns the result of NOT. */
  public static KrlValue not(KrlValue operand) throws KrlExecutionException {
    return new KrlBool(!boolOf(operand));
  }

  /** Returns the result of B_NOT. */
  public static KrlValue bitwiseNot(KrlValue operand) throws KrlExecutionException {
    return new KrlInt(~intOf(operand));
  }

  /**
   * Returns the whole number next to a REAL; 2.5 becomes 3, and -2.5 becomes -2
   * (docs/reference/simulated-controller.md#assumed).
   */
  public static double nearest(double real) {
    return Math.floor(real + 0.5);
  }

  /** Returns an INT, and checks its range. */
  public static KrlInt integer(long result) throws KrlExecutionException {
    if (result != (int) result) {
      throw new KrlExecutionException(
          KrlExecutionException.OVERFLOW, "an INT has 32 bits, the result would be " + result);
    }
    return new KrlInt((int) result);
  }

  /**
   * Returns a REAL, rounded to a float. The double of a sum, product or quotient of two floats is
   * precise enough to be rounded correctly.
   */
  public static KrlReal real(double result) throws KrlExecutionException {
    float rounded = (float) result;
    if (!Float.isFinite(rounded)) {
      throw new KrlExecutionException(
          KrlExecutionException.OVERFLOW,
          "a REAL is at most 3.4E+38, the result would be " + result);
    }
    return new KrlReal(rounded);
  }

  /** Returns the number of an INT or REAL. */
  public static double number(KrlValue value) throws KrlExecutionException {
    if (value instanceof KrlInt number) {
      return number.value();
    }
    if (value instanceof KrlReal number) {
      return number.value();
    }
    throw wrongType("a number", value);
  }

  /** Returns the fault of a value of the wrong type. */
  public static KrlExecutionException wrongType(String expected, KrlValue value) {
    return new KrlExecutionException(
        KrlExecutionException.WRONG_TYPE,
        "needs " + expected + ", was given " + value.print().strip());
  }

  /** Returns the number of an INT. */
  public static int intOf(KrlValue value) throws KrlExecutionException {
    if (value instanceof KrlInt number) {
      return number.value();
    }
    throw wrongType("INT", value);
  }

  /** Returns the value of a BOOL. */
  public static boolean boolOf(KrlValue value) throws KrlExecutionException {
    if (value instanceof KrlBool bool) {
      return bool.value();
    }
    throw wrongType("BOOL", value);
  }

  /** Returns the structure of a position. */
  public static KrlStruct positionOf(KrlValue value) throws KrlExecutionException {
    if (value instanceof KrlStruct struct) {
      return struct;
    }
    throw wrongType("a position", value);
  }

  /** Returns the result of {@code ==}. */
  public static boolean areEqual(KrlValue left, KrlValue right) throws KrlExecutionException {
    if (left instanceof KrlBool a && right instanceof KrlBool b) {
      return a.value() == b.value();
    }
    if (left instanceof KrlEnum a && right instanceof KrlEnum b) {
      return a.name().equalsIgnoreCase(b.name());
    }
    return compare(left, right) == 0;
  }

  /** Compares numbers and CHARs; a CHAR is its code if the other one is a number (assumed). */
  static int compare(KrlValue left, KrlValue right) throws KrlExecutionException {
    if (left instanceof KrlInt a && right instanceof KrlInt b) {
      return Integer.compare(a.value(), b.value());
    }
    if (isCharacter(left) && isCharacter(right)) {
      return Character.compare(character(left), character(right));
    }
    if (isNumber(left) && isNumber(right)) {
      return Double.compare(number(left), number(right));
    }
    if (isNumber(left) && isCharacter(right)) {
      return Double.compare(number(left), code(right));
    }
    if (isCharacter(left) && isNumber(right)) {
      return Double.compare(code(left), number(right));
    }
    throw new KrlExecutionException(
        KrlExecutionException.WRONG_TYPE,
        "only numbers and CHAR, two BOOL or two ENUM can be compared, and only numbers and CHAR by"
            + " order; was given "
            + left.print().strip()
            + " and "
            + right.print().strip());
  }

  private static boolean isCharacter(KrlValue value) {
    return value instanceof KrlString string && string.text().length() == 1;
  }

  private static char character(KrlValue value) {
    return ((KrlString) value).text().charAt(0);
  }

  private static int code(KrlValue value) throws KrlExecutionException {
    try {
      return CharacterCodes.codeOf(character(value));
    } catch (RefusedException e) {
      throw KrlExecutionException.of(value.print(), e);
    }
  }

  private static boolean isNumber(KrlValue value) {
    return value instanceof KrlInt || value instanceof KrlReal;
  }
}
