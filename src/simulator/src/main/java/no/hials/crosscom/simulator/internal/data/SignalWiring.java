package no.hials.crosscom.simulator.internal.data;

import java.util.ArrayList;
import java.util.List;
import no.hials.crosscom.lang.Declaration;
import no.hials.crosscom.lang.Expression;
import no.hials.crosscom.protocol.value.KrlBool;
import no.hials.crosscom.protocol.value.KrlInt;
import no.hials.crosscom.protocol.value.KrlValue;
import no.hials.crosscom.simulator.Refusal;
import no.hials.crosscom.simulator.RefusedException;
import org.jspecify.annotations.Nullable;

/**
 * The wiring of a SIGNAL (docs/reference/krl-values.md#signals-and-inputs): a name for one input or
 * output, or for several as an INT.
 *
 * @param array {@code $IN}, {@code $OUT} or another array in upper case; null without wiring
 * @param first the first element, the lowest bit (assumed)
 * @param last the last element
 * @param isGroup whether it is declared with TO, and so an INT
 */
record SignalWiring(@Nullable String array, int first, int last, boolean isGroup) {
  static final String RULE =
      "a SIGNAL is $OUT[a], $OUT[a] TO $OUT[b] with at most 32 bits, or FALSE";

  private static final int MAX_INDEX = 9_999_999;

  /**
   * Evaluates a declaration. The array need not exist yet.
   *
   * @param scope where constants are looked up
   */
  static SignalWiring of(Scope scope, Declaration.Signal signal) throws KrlErrorException {
    Expression.Variable firstEnd = signal.first();
    Expression.Variable lastEnd = signal.last();
    if (firstEnd == null) {
      return new SignalWiring(null, 0, 0, false);
    }
    VariablePath first = ConstantExpressions.path(firstEnd, scope);
    VariablePath last = lastEnd == null ? first : ConstantExpressions.path(lastEnd, scope);
    if (isElement(first) && isElement(last)) {
      String array = first.first().name();
      int from = first.first().index().number(0);
      int to = last.first().index().number(0);
      boolean inOrder = to >= from && to - from < Integer.SIZE;
      if (array.equals(last.first().name()) && from >= 0 && to <= MAX_INDEX && inOrder) {
        // of one element, TO makes an INT, except that signals of the system stay BOOL (assumed)
        boolean isGroup = lastEnd != null && (to > from || !signal.name().startsWith("$"));
        return new SignalWiring(array, from, to, isGroup);
      }
    }
    throw new KrlErrorException(
        signal.position(),
        RULE + ", is '" + (lastEnd == null ? first.toString() : first + " TO " + last) + "'");
  }

  private static boolean isElement(VariablePath path) {
    return path.isLast(0) && path.first().index().count() == 1 && !path.first().index().isOpen();
  }

  /** Returns the value: a BOOL, or an INT of several elements. */
  KrlValue value(Scope scope) throws RefusedException {
    if (array == null) {
      return new KrlBool(false);
    }
    if (!isGroup) {
      return element(scope, first);
    }
    int bits = 0;
    for (int i = last; i >= first; i--) {
      if (!(element(scope, i) instanceof KrlBool bit)) {
        throw new RefusedException(Refusal.WRONG_TYPE, array + " is not an array of BOOL");
      }
      bits = bits << 1 | (bit.value() ? 1 : 0);
    }
    return new KrlInt(bits);
  }

  private KrlValue element(Scope scope, int index) throws RefusedException {
    return scope.storage(VariablePath.element(String.valueOf(array), index)).value();
  }

  /** Returns the value of each element, given the value of the signal. */
  List<KrlValue> elements(KrlValue value) throws RefusedException {
    if (!isGroup) {
      return List.of(value);
    }
    if (!(value instanceof KrlInt number)) {
      throw new RefusedException(Refusal.WRONG_TYPE, "needs INT, was given " + value.print());
    }
    int width = last - first + 1;
    if (width < Integer.SIZE && number.value() >>> width != 0) {
      throw new RefusedException(
          Refusal.OUT_OF_RANGE, "has " + width + " bits, was given " + number);
    }
    List<KrlValue> bits = new ArrayList<>(width);
    for (int i = 0; i < width; i++) {
      bits.add(new KrlBool((number.value() >>> i & 1) != 0));
    }
    return bits;
  }

  /** Prints the wiring as in a declaration. */
  @Override
  public String toString() {
    if (array == null) {
      return "FALSE";
    }
    String text = array + "[" + first + "]";
    return !isGroup ? text : text + " TO " + array + "[" + last + "]";
  }
}
