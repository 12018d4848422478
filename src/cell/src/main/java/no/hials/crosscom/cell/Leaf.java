package no.hials.crosscom.cell;

import java.util.ArrayList;
import java.util.List;
import no.hials.crosscom.protocol.value.KrlArray;
import no.hials.crosscom.protocol.value.KrlBool;
import no.hials.crosscom.protocol.value.KrlEnum;
import no.hials.crosscom.protocol.value.KrlInt;
import no.hials.crosscom.protocol.value.KrlReal;
import no.hials.crosscom.protocol.value.KrlString;
import no.hials.crosscom.protocol.value.KrlStruct;
import no.hials.crosscom.protocol.value.KrlValue;

/**
 * A number, text or constant within a value.
 *
 * @param name the name that reads it alone, such as {@code $POS_ACT.X} or {@code
 *     $TORQUE_AXIS_ACT[3]}
 * @param value INT, REAL, BOOL, ENUM or text
 */
public record Leaf(String name, KrlValue value) {

  /**
   * Returns the leaves of a value: the value itself, or the leaves of its initialised fields or
   * elements.
   */
  public static List<Leaf> of(String name, KrlValue value) {
    List<Leaf> leaves = new ArrayList<>();
    unfold(name, value, leaves);
    return leaves;
  }

  private static void unfold(String name, KrlValue value, List<Leaf> leaves) {
    if (value instanceof KrlStruct struct) {
      for (KrlStruct.Field field : struct.fields()) {
        unfold(name + "." + field.name(), field.value(), leaves);
      }
    } else if (value instanceof KrlArray array) {
      for (int i = 0; i < array.elements().size(); i++) {
        leaves.add(new Leaf(element(name, i + 1), array.elements().get(i)));
      }
    } else if (isWholeArray(name) && isElement(value)) {
      // an array of one element, whose trailing blank KUKAVARPROXY cut off
      leaves.add(new Leaf(element(name, 1), value));
    } else {
      leaves.add(new Leaf(name, value));
    }
  }

  /** Returns whether a name stands for a whole array, {@code NAME[]} or {@code NAME[2,]}. */
  public static boolean isWholeArray(String name) {
    return name.endsWith("[]") || name.endsWith(",]");
  }

  /** Returns whether a value can be an element of an array. */
  static boolean isElement(KrlValue value) {
    return value instanceof KrlInt
        || value instanceof KrlReal
        || value instanceof KrlBool
        || value instanceof KrlEnum;
  }

  private static String element(String name, int index) {
    String open = isWholeArray(name) ? name.substring(0, name.length() - 1) : name + "[";
    return open + index + "]";
  }

  /**
   * Returns the value without quotes: the controller's digits, {@code TRUE}, {@code #T1}, a text.
   */
  public String text() {
    return value instanceof KrlString string ? string.text() : value.print();
  }
}
