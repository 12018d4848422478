package no.hials.crosscom.protocol.value;

import org.jspecify.annotations.Nullable;

/**
 * Stands for any value of a KRL variable, in the forms that a KR C4 prints it.
 *
 * <p>Values are immutable and can be shared between threads. For every value {@code v}, {@code
 * KrlValue.parse(v.print())} equals {@code v}. What the forms look like is in krl.md section 1
 * (recorded answers of real controllers).
 */
public sealed interface KrlValue
    permits KrlInt, KrlReal, KrlBool, KrlString, KrlEnum, KrlStruct, KrlArray {

  /** How deep aggregates may nest. Real controllers print three or four levels. */
  int MAX_DEPTH = 64;

  /**
   * Parses the text of one value: {@code 100}, {@code 'B0101'}, {@code 1.5E-05}, {@code TRUE},
   * {@code "text"}, {@code #T1}, an aggregate, or the blank-separated elements of an array.
   *
   * <p>A lone element followed by a blank is an array of one element, because a controller ends the
   * text of a whole array with a blank (krl.md 1.4); without the blank it is a scalar.
   *
   * @param text the text, as it came from a controller
   * @return the value
   * @throws KrlSyntaxException if the text is not a KRL value; it gives the position, what was
   *     expected and what was found
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
   * Prints the value as a KR C4 (KSS 8.3 and later) does: REALs with 6 or 9 significant digits, an
   * aggregate as <code>{TYPE: X 1.00000, Y 2.00000}</code>, an array with a trailing blank.
   *
   * @return the text
   */
  default String print() {
    return KrlPrinter.print(this, RealStyle.KRC4);
  }

  /**
   * Prints the value for writing it: the fewest characters that still keep every number, since the
   * text of a written aggregate may have 255 bytes at most.
   *
   * @return the text
   */
  default String printShort() {
    return KrlPrinter.print(this, RealStyle.SHORTEST);
  }
}
