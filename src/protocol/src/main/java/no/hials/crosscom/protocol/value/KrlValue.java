package no.hials.crosscom.protocol.value;

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
