package no.hials.crosscom.protocol.value;

import java.util.List;
import org.jspecify.annotations.Nullable;

/**
 * The value of a KRL variable, in the forms that a KR C4 prints (docs/reference/krl-values.md).
 *
 * <p>Values are immutable, so threads can share them. For every value {@code v}, {@code
 * KrlValue.parse(v.print())} equals {@code v}.
 */
public sealed interface KrlValue
    permits KrlInt, KrlReal, KrlBool, KrlString, KrlEnum, KrlStruct, KrlArray {

  /** The largest depth of nested aggregates. Real controllers print three or four levels. */
  int MAX_DEPTH = 64;

  /**
   * Parses the text of one value: {@code 100}, {@code 'B0101'}, {@code 1.5E-05}, {@code TRUE},
   * {@code "text"}, {@code #T1}, an aggregate, or the blank-separated elements of an array.
   *
   * <p>A lone element followed by a blank is an array of one element, because a controller prints a
   * blank at the end of a whole array (docs/reference/krl-values.md#arrays); without the blank it
   * is a scalar.
   *
   * @param text the text, as a controller sends it
   * @return the value
   * @throws KrlSyntaxException if the text is not a KRL value
   */
  static KrlValue parse(CharSequence text) {
    return KrlValueParser.parse(text);
  }

  /**
   * Calls the visitor's method for this kind of value.
   *
   * @param visitor the methods
   * @param <R> the result
   * @return the result of the method
   */
  <R extends @Nullable Object> R accept(KrlVisitor<R> visitor);

  /**
   * Returns the number of an INT.
   *
   * @throws IllegalStateException if the value is not an INT
   */
  default int asInt() {
    throw not("an INT");
  }

  /**
   * Returns the number of a REAL or INT: for a REAL, the double nearest to the digits that a KR C4
   * prints, so that 0.1 is 0.1.
   *
   * @throws IllegalStateException if the value is not a number
   */
  default double asDouble() {
    throw not("a REAL or INT");
  }

  /**
   * Returns the value of a BOOL.
   *
   * @throws IllegalStateException if the value is not a BOOL
   */
  default boolean asBool() {
    throw not("a BOOL");
  }

  /**
   * Returns the text of a CHAR or CHAR array, without quotes; one blank is the empty text, which a
   * controller prints like this.
   *
   * @throws IllegalStateException if the value is not a text
   */
  default String asString() {
    throw not("a CHAR or CHAR array");
  }

  /**
   * Returns the name of an ENUM's value, without the {@code #}.
   *
   * @throws IllegalStateException if the value is not of an ENUM
   */
  default String asEnum() {
    throw not("a value of an ENUM");
  }

  /**
   * Returns the value as an aggregate.
   *
   * @throws IllegalStateException if the value is not an aggregate
   */
  default KrlStruct asStruct() {
    throw not("an aggregate");
  }

  /**
   * Returns the elements of a whole array.
   *
   * @throws IllegalStateException if the value is not an array
   */
  default List<KrlValue> asList() {
    throw not("an array");
  }

  private IllegalStateException not(String kind) {
    return new IllegalStateException("the value must be " + kind + ", is " + print());
  }

  /**
   * Returns the value as a KR C4 (KSS 8.3 and later) prints it: REALs with 6 or 9 significant
   * digits, an aggregate as <code>{TYPE: X 1.00000, Y 2.00000}</code>, an array with a trailing
   * blank.
   *
   * @return the text
   */
  default String print() {
    return KrlPrinter.print(this, RealStyle.KRC4);
  }

  /**
   * Returns the value as the shortest text that keeps every number, for writing it: a controller
   * accepts an aggregate of at most 255 bytes (docs/reference/krl-values.md#lengths).
   *
   * @return the text
   */
  default String printShort() {
    return KrlPrinter.print(this, RealStyle.SHORTEST);
  }
}
