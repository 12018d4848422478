package no.hials.crosscom.cell;

import java.util.List;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import no.hials.crosscom.protocol.value.KrlArray;
import no.hials.crosscom.protocol.value.KrlBool;
import no.hials.crosscom.protocol.value.KrlEnum;
import no.hials.crosscom.protocol.value.KrlInt;
import no.hials.crosscom.protocol.value.KrlReal;
import no.hials.crosscom.protocol.value.KrlString;
import no.hials.crosscom.protocol.value.KrlStruct;
import no.hials.crosscom.protocol.value.KrlValue;
import no.hials.crosscom.protocol.value.KrlVisitor;

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
    return value.accept(new Unfolding(name)).toList();
  }

  /** Returns the leaves of each kind of value. */
  private record Unfolding(String name) implements KrlVisitor<Stream<Leaf>> {
    @Override
    public Stream<Leaf> visit(KrlInt number) {
      return element(number);
    }

    @Override
    public Stream<Leaf> visit(KrlReal number) {
      return element(number);
    }

    @Override
    public Stream<Leaf> visit(KrlBool bool) {
      return element(bool);
    }

    @Override
    public Stream<Leaf> visit(KrlEnum constant) {
      return element(constant);
    }

    /** Returns a scalar, or the only element of an array whose trailing blank was cut off. */
    private Stream<Leaf> element(KrlValue value) {
      return Stream.of(new Leaf(isWholeArray(name) ? Leaf.element(name, 1) : name, value));
    }

    @Override
    public Stream<Leaf> visit(KrlString string) {
      return Stream.of(new Leaf(name, string));
    }

    @Override
    public Stream<Leaf> visit(KrlStruct struct) {
      return struct.fields().stream()
          .flatMap(field -> field.value().accept(new Unfolding(name + "." + field.name())));
    }

    @Override
    public Stream<Leaf> visit(KrlArray array) {
      return IntStream.range(0, array.elements().size())
          .mapToObj(i -> new Leaf(Leaf.element(name, i + 1), array.elements().get(i)));
    }
  }

  /** Returns whether a name stands for a whole array, {@code NAME[]} or {@code NAME[2,]}. */
  public static boolean isWholeArray(String name) {
    return name.endsWith("[]") || name.endsWith(",]");
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
