package no.hials.crosscom.KRL.structs;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collection;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import no.hials.crosscom.KRL.KRLVariable;
import no.hials.crosscom.protocol.value.KrlBool;
import no.hials.crosscom.protocol.value.KrlInt;
import no.hials.crosscom.protocol.value.KrlReal;
import no.hials.crosscom.protocol.value.KrlStruct;
import no.hials.crosscom.protocol.value.KrlValue;

/** Holds a structure: named fields that one access reads or writes. */
public abstract class KRLStruct extends KRLVariable {
  private final String[] nodes;

  /**
   * Creates a structure.
   *
   * @param name the name on the controller
   * @param nodes the names of its fields
   */
  public KRLStruct(String name, String[] nodes) {
    super(name);
    this.nodes = nodes.clone();
  }

  /**
   * Creates a structure.
   *
   * @param name the name on the controller
   * @param nodes the names of its fields
   */
  protected KRLStruct(String name, Collection<String> nodes) {
    this(name, nodes.toArray(new String[0]));
  }

  /**
   * Returns the values of the fields in a modifiable map, in the order of the fields.
   *
   * @return the map, whose keys are Strings
   */
  @Override
  @SuppressWarnings("rawtypes") // as in the original, so that its programs compile
  public abstract HashMap getValue();

  /**
   * Sets a field from text.
   *
   * @param str the field's name
   * @param obj its value as KRL text
   */
  public abstract void setValue(String str, String obj);

  /** Returns the names of the fields in a new array. */
  public String[] getNodes() {
    return nodes.clone();
  }

  /** Returns the names of the fields; callers must not modify the array. */
  String[] nodes() {
    return nodes;
  }

  @Override
  public String getStringValue() {
    Map<?, ?> values = getValue();
    return getStringValueOf(
        Arrays.stream(nodes).filter(values::containsKey).toList().toArray(new String[0]));
  }

  /**
   * Returns the text that writes only some fields; the others stay unchanged on the controller.
   *
   * @param fields names of fields, at least one
   * @return the text
   * @throws IllegalArgumentException if a name is not a field of this structure, or the field has
   *     no value
   */
  public String getStringValueOf(String... fields) {
    if (fields.length == 0) {
      throw new IllegalArgumentException(getName() + ": name at least one field");
    }
    Map<?, ?> values = getValue();
    List<KrlStruct.Field> parts = new ArrayList<>();
    for (String field : fields) {
      Object value = values.get(field);
      if (value == null) {
        throw new IllegalArgumentException(
            getName() + "." + field + " has no value, fields with a value are " + values.keySet());
      }
      parts.add(new KrlStruct.Field(field, toKrl(value)));
    }
    return new KrlStruct(null, parts).printShort();
  }

  /** Returns a field's value for the printer. */
  private static KrlValue toKrl(Object value) {
    if (value instanceof Integer number) {
      return new KrlInt(number);
    } else if (value instanceof Number number) {
      return KrlReal.of(number.doubleValue());
    } else if (value instanceof Boolean bool) {
      return new KrlBool(bool);
    }
    return KrlValue.parse(value.toString());
  }

  @Override
  protected void setValueFromString(String strValue) {
    if (!(KrlValue.parse(strValue) instanceof KrlStruct struct)) {
      throw new IllegalArgumentException("expected an aggregate in braces, found: " + strValue);
    }
    for (KrlStruct.Field field : struct.fields()) {
      setValue(field.name(), field.value().print());
    }
  }
}
