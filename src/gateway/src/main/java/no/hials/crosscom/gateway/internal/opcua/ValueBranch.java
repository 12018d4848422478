package no.hials.crosscom.gateway.internal.opcua;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.function.UnaryOperator;
import no.hials.crosscom.cell.Leaf;
import no.hials.crosscom.protocol.value.KrlArray;
import no.hials.crosscom.protocol.value.KrlString;
import no.hials.crosscom.protocol.value.KrlStruct;
import no.hials.crosscom.protocol.value.KrlValue;
import org.jspecify.annotations.Nullable;

/**
 * The node of a value and those of its fields or elements. A node is created when a value first has
 * its field, since only a value tells which fields there are. A value of the same form as the last
 * one costs only a comparison of names.
 */
final class ValueBranch {
  /** Creates nodes. */
  interface Nodes {
    /**
     * Creates a node, or returns the existing one.
     *
     * @param name the name that reads the value on its own
     * @param label the name of the field or element
     * @param parent the node of the structure or array; null at the top
     * @param part returns the part of the reading that is the value of the node
     */
    ValueNode node(
        String name,
        String label,
        @Nullable ValueNode parent,
        Reading reading,
        UnaryOperator<@Nullable KrlValue> part);
  }

  private final String name;
  private final Reading reading;
  private final Nodes nodes;
  private final UnaryOperator<@Nullable KrlValue> part;
  private final ValueNode node;
  private final Map<String, ValueBranch> known = new HashMap<>();
  private List<String> labels = List.of();
  private List<ValueBranch> children = List.of();
  private @Nullable Class<?> type;

  private ValueBranch(
      String name,
      String label,
      @Nullable ValueNode parent,
      Reading reading,
      Nodes nodes,
      UnaryOperator<@Nullable KrlValue> part) {
    this.name = name;
    this.reading = reading;
    this.nodes = nodes;
    this.part = part;
    this.node = nodes.node(name, label, parent, reading, part);
  }

  /** Creates the node of a variable that is read. */
  static ValueBranch whole(String name, Reading reading, Nodes nodes) {
    return new ValueBranch(name, name, null, reading, nodes, value -> value);
  }

  /** Creates the nodes of a value that are missing. */
  void fit(KrlValue value) {
    if (value.getClass() != type) {
      type = value.getClass();
      node.setDataType(UaValues.dataType(value));
      node.describe();
    }
    if (value instanceof KrlStruct struct) {
      if (!hasFieldsOf(struct)) {
        List<String> names = struct.fields().stream().map(KrlStruct.Field::name).toList();
        setChildren(names);
      }
      for (int i = 0; i < children.size(); i++) {
        children.get(i).fit(struct.fields().get(i).value());
      }
    } else if (value instanceof KrlArray array) {
      fitElements(array.elements());
    } else if (Leaf.isWholeArray(name) && !(value instanceof KrlString)) {
      // an array of one element, as Leaf expects it
      fitElements(List.of(value));
    }
  }

  private void fitElements(List<KrlValue> elements) {
    if (labels.size() != elements.size()) {
      List<String> names = new ArrayList<>();
      for (int i = 1; i <= elements.size(); i++) {
        names.add("[" + i + "]");
      }
      setChildren(names);
    }
    for (int i = 0; i < children.size(); i++) {
      children.get(i).fit(elements.get(i));
    }
  }

  private boolean hasFieldsOf(KrlStruct struct) {
    List<KrlStruct.Field> fields = struct.fields();
    if (fields.size() != labels.size()) {
      return false;
    }
    for (int i = 0; i < labels.size(); i++) {
      if (!labels.get(i).equals(fields.get(i).name())) {
        return false;
      }
    }
    return true;
  }

  private void setChildren(List<String> names) {
    List<ValueBranch> now = new ArrayList<>();
    for (int i = 0; i < names.size(); i++) {
      int index = i;
      now.add(known.computeIfAbsent(names.get(i), label -> child(label, index)));
    }
    labels = names;
    children = now;
  }

  private ValueBranch child(String label, int index) {
    boolean element = label.startsWith("[");
    String open = Leaf.isWholeArray(name) ? name.substring(0, name.length() - 1) : name + "[";
    return new ValueBranch(
        element ? open + (index + 1) + "]" : name + "." + label,
        label,
        node,
        reading,
        nodes,
        element ? element(part, index) : field(part, label));
  }

  /** Returns a function from a value to one of its fields. */
  static UnaryOperator<@Nullable KrlValue> field(
      UnaryOperator<@Nullable KrlValue> whole, String name) {
    return value ->
        whole.apply(value) instanceof KrlStruct struct ? struct.get(name).orElse(null) : null;
  }

  /** Returns a function from a value to one of its elements; the first index is 0. */
  static UnaryOperator<@Nullable KrlValue> element(
      UnaryOperator<@Nullable KrlValue> whole, int index) {
    return value -> {
      KrlValue outer = whole.apply(value);
      if (outer instanceof KrlArray array) {
        return index < array.elements().size() ? array.elements().get(index) : null;
      }
      return index == 0 && !(outer instanceof KrlString) ? outer : null;
    };
  }
}
