package no.hials.crosscom.variables;

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
import no.hials.crosscom.protocol.value.KrlVisitor;
import no.hials.crosscom.protocol.value.PrintableText;

/** Holds an aggregate. Its nodes are of the raw type, as in the original. */
@SuppressWarnings("rawtypes")
public class Struct extends Variable<List<StructNode>> {
  /**
   * Creates a variable.
   *
   * @param id the number of the request
   * @param name the variable's name
   * @param value the fields
   * @param readTime the time of the access, in ns
   */
  public Struct(int id, String name, List<StructNode> value, long readTime) {
    super(id, name, "Struct", value, readTime);
  }

  /**
   * Parses an aggregate.
   *
   * @param value its text
   * @return its fields in the order of the text: Integer, Double, Boolean, String for an ENUM (with
   *     its {@code #}) or a text, a list of nodes for a nested aggregate
   * @throws IllegalArgumentException if the text is not an aggregate
   */
  public static List<StructNode> parseString(String value) {
    if (KrlValue.parse(value) instanceof KrlStruct struct) {
      return nodes(struct);
    }
    throw new IllegalArgumentException(
        "expected an aggregate in braces, found: " + PrintableText.shortened(value));
  }

  static List<StructNode> nodes(KrlStruct struct) {
    List<StructNode> nodes = new ArrayList<>();
    for (KrlStruct.Field field : struct.fields()) {
      nodes.add(new StructNode<>(field.name(), field.value().accept(new ToJava())));
    }
    return nodes;
  }

  /** Returns a value as the original did. */
  private static final class ToJava implements KrlVisitor<Object> {
    @Override
    public Object visit(KrlInt number) {
      return number.value();
    }

    @Override
    public Object visit(KrlReal number) {
      return Double.valueOf(number.print());
    }

    @Override
    public Object visit(KrlBool bool) {
      return bool.value();
    }

    @Override
    public Object visit(KrlEnum constant) {
      return constant.print();
    }

    @Override
    public Object visit(KrlString string) {
      return string.text();
    }

    @Override
    public Object visit(KrlStruct struct) {
      return nodes(struct);
    }

    @Override
    public Object visit(KrlArray array) {
      return array.print();
    }
  }
}
