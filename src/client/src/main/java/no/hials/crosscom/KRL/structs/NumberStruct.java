package no.hials.crosscom.KRL.structs;

import java.util.Arrays;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.Locale;
import java.util.Map;
import no.hials.crosscom.protocol.value.KrlInt;
import no.hials.crosscom.protocol.value.KrlReal;
import no.hials.crosscom.protocol.value.KrlScanner;
import no.hials.crosscom.protocol.value.KrlText;
import no.hials.crosscom.protocol.value.KrlValue;

/**
 * The base class of the geometric structures: fields that are numbers, kept in an array.
 *
 * <p>A field is in one of three states: never set (it is 0.0, and written as 0.0), set, or missing.
 * A missing field was not in the controller's last answer, because it is not initialised there.
 * Reading a missing field is an error, and a write leaves it out, because any number would be
 * wrong.
 */
abstract class NumberStruct extends KRLStruct {
  private double[] values;
  private boolean[] missing;
  private boolean[] given;
  private double[] scratchValues;
  private boolean[] scratchMissing;

  /** Fields from the controller that are not fields of this structure; rarely any. */
  private Map<String, KrlValue> foreign = Map.of();

  /** The fields as a map; a change of the map is a change of the structure. */
  protected final HashMap<String, Double> struct = new FieldMap(this);

  NumberStruct(String name, String... nodes) {
    super(name, nodes);
    values = new double[nodes.length];
    missing = new boolean[nodes.length];
    given = new boolean[nodes.length];
    scratchValues = new double[nodes.length];
    scratchMissing = new boolean[nodes.length];
  }

  /** Returns whether a field is an INT on the controller. */
  boolean isInt(int index) {
    return false;
  }

  /**
   * Returns whether an answer with fields of another type can be of this type.
   *
   * @param seen bit i is set if the answer has the field {@code nodes()[i]}
   */
  boolean accepts(long seen) {
    return seen != 0;
  }

  private int indexOf(String field) {
    String[] nodes = nodes();
    for (int i = 0; i < nodes.length; i++) {
      if (nodes[i].equalsIgnoreCase(field)) {
        return i;
      }
    }
    return -1;
  }

  private int ownIndexOf(String field) {
    int index = indexOf(field);
    if (index < 0) {
      throw new IllegalArgumentException(
          getName() + " has the fields " + Arrays.toString(nodes()) + ", not " + field);
    }
    return index;
  }

  final double get(String field) {
    return get(ownIndexOf(field));
  }

  private double get(int index) {
    if (missing[index]) {
      throw new IllegalStateException(
          getName()
              + "."
              + nodes()[index]
              + " was not in the controller's answer: it is not initialised, or not a field of that"
              + " variable");
    }
    return values[index];
  }

  final double[] get(String first, int count) {
    int from = ownIndexOf(first);
    double[] part = new double[count];
    for (int i = 0; i < count; i++) {
      part[i] = get(from + i);
    }
    return part;
  }

  final void set(String field, double value) {
    set(ownIndexOf(field), value);
  }

  private void set(int index, double value) {
    check(index, value);
    values[index] = value;
    missing[index] = false;
    given[index] = true;
  }

  private void check(int index, double value) {
    try {
      KrlReal.toFloat(value);
    } catch (IllegalArgumentException e) {
      throw new IllegalArgumentException(
          getName() + "." + nodes()[index] + ": " + e.getMessage(), e);
    }
    if (isInt(index) && value != (int) value) {
      throw new IllegalArgumentException(
          getName() + "." + nodes()[index] + " must be an INT, is " + value);
    }
  }

  final void set(String first, int count, double... newValues) {
    if (newValues.length != count) {
      throw new IllegalArgumentException(
          getName() + ": the number of values must be " + count + ", is " + newValues.length);
    }
    int from = ownIndexOf(first);
    for (int i = 0; i < count; i++) {
      check(from + i, newValues[i]);
    }
    for (int i = 0; i < count; i++) {
      set(from + i, newValues[i]);
    }
  }

  /**
   * Returns all values.
   *
   * @return a new array in the order of {@link #getNodes}, in mm and degrees
   * @throws IllegalStateException if a field was missing in the controller's last answer
   */
  public double[] asArray() {
    return get(nodes()[0], nodes().length);
  }

  /**
   * Returns whether a field was set or read. Otherwise it is 0.0.
   *
   * @param field its name
   */
  public boolean isSet(String field) {
    return given[ownIndexOf(field)];
  }

  /**
   * Returns the values of the fields, and of numbers from the controller that are not fields of
   * this structure, as when {@code $POS_ACT} is read into an E6AXIS. Fields that were missing in
   * the controller's last answer are absent.
   *
   * <p>The map is a view: it shows later changes of this structure, and {@code put} sets a field.
   * Fields cannot be removed. A copy is {@code new HashMap<>(getValue())}.
   *
   * @return the fields of this structure in the order of {@link #getNodes}, then the others
   */
  @Override
  public HashMap<String, Double> getValue() {
    return struct;
  }

  /** Returns a copy of {@link #getValue}. */
  final LinkedHashMap<String, Double> copyOfFields() {
    LinkedHashMap<String, Double> map = new LinkedHashMap<>();
    String[] nodes = nodes();
    for (int i = 0; i < nodes.length; i++) {
      if (!missing[i]) {
        map.put(nodes[i], values[i]);
      }
    }
    foreign.forEach(
        (name, value) -> {
          if (value instanceof KrlReal || value instanceof KrlInt) {
            map.put(name, value.asDouble());
          }
        });
    return map;
  }

  /**
   * Sets a field from text.
   *
   * @param str the field's name; a field that is not of this structure is kept but not written
   * @param obj a number as KRL text
   * @throws IllegalArgumentException if the text is not a number
   */
  @Override
  public void setValue(String str, String obj) {
    int index = indexOf(str);
    if (index >= 0) {
      KrlScanner scanner = new KrlScanner(obj);
      double value = scanner.readReal();
      scanner.expectEnd();
      set(index, value);
    } else {
      setForeign(str, KrlValue.parse(obj));
    }
  }

  /** Sets a field; a field that is not of this structure is kept but not written. */
  final void put(String field, double value) {
    int index = indexOf(field);
    if (index >= 0) {
      set(index, value);
    } else {
      setForeign(field, KrlReal.of(value));
    }
  }

  private void setForeign(String field, KrlValue value) {
    Map<String, KrlValue> more = new LinkedHashMap<>(foreign);
    more.put(field.toUpperCase(Locale.ROOT), value);
    foreign = more;
  }

  /**
   * Returns the text that writes the whole structure.
   *
   * @return an aggregate of the fields of this structure, except those that were missing in the
   *     controller's last answer and not set since; fields that were never set or read are 0.0
   * @throws IllegalStateException if no field is left
   */
  @Override
  public String getStringValue() {
    KrlText text = new KrlText();
    appendValue(text);
    return text.toString();
  }

  @Override
  protected boolean holdsText() {
    return false;
  }

  @Override
  protected final boolean appendValue(KrlText text) {
    boolean empty = true;
    text.openStruct();
    for (int i = 0; i < values.length; i++) {
      if (!missing[i]) {
        append(text, i);
        empty = false;
      }
    }
    if (empty) {
      throw new IllegalStateException(
          getName()
              + " has no field to write: the controller's last answer had none, and none was set"
              + " since");
    }
    text.closeStruct();
    return true;
  }

  @Override
  public String getStringValueOf(String... fields) {
    if (fields.length == 0) {
      throw new IllegalArgumentException(getName() + ": name at least one field");
    }
    KrlText text = new KrlText();
    text.openStruct();
    for (String field : fields) {
      int index = ownIndexOf(field);
      if (!given[index]) {
        throw new IllegalArgumentException(
            getName() + "." + nodes()[index] + " has no value: it was neither set nor read");
      }
      append(text, index);
    }
    text.closeStruct();
    return text.toString();
  }

  private void append(KrlText text, int index) {
    text.nextField(nodes()[index]);
    if (isInt(index)) {
      text.append((int) values[index]);
    } else {
      text.append((float) values[index]);
    }
  }

  @Override
  protected final boolean setValueFrom(KrlScanner scanner, boolean written) {
    // a write may name only some fields; the answer to a read names all that exist
    if (written) {
      System.arraycopy(values, 0, scratchValues, 0, values.length);
      System.arraycopy(missing, 0, scratchMissing, 0, missing.length);
    } else {
      Arrays.fill(scratchMissing, true);
    }
    long seen = 0;
    Map<String, KrlValue> others = null;
    int next = 0;
    scanner.openStruct();
    while (true) {
      int index = next;
      if (next == values.length || !scanner.nextFieldIs(nodes()[next])) {
        if (!scanner.nextField()) {
          break;
        }
        index = find(scanner, next);
      }
      if (index < 0) {
        if (others == null) {
          others = new LinkedHashMap<>();
        }
        others.put(scanner.fieldName().toUpperCase(Locale.ROOT), scanner.readFieldValue());
        continue;
      }
      if ((seen & 1L << index) != 0) {
        throw scanner.wrong("field " + nodes()[index] + " once");
      }
      seen |= 1L << index;
      scratchValues[index] = scanner.readReal();
      scratchMissing[index] = false;
      next = index + 1;
    }
    scanner.expectEnd();
    if (others != null && !accepts(seen)) {
      throw new IllegalArgumentException(
          "expected fields of " + Arrays.toString(nodes()) + ", found " + others.keySet());
    }
    accept(seen);
    if (others != null || !written) {
      foreign = others == null ? Map.of() : others;
    }
    return true;
  }

  private void accept(long seen) {
    double[] oldValues = values;
    values = scratchValues;
    scratchValues = oldValues;
    boolean[] oldMissing = missing;
    missing = scratchMissing;
    scratchMissing = oldMissing;
    for (int i = 0; i < given.length; i++) {
      given[i] = (given[i] && !missing[i]) || (seen & 1L << i) != 0;
    }
  }

  /**
   * Returns the field at the scanner; a controller sends them almost in the order of this
   * structure.
   */
  private int find(KrlScanner scanner, int start) {
    String[] nodes = nodes();
    for (int i = 0; i < nodes.length; i++) {
      int index = start + i < nodes.length ? start + i : start + i - nodes.length;
      if (scanner.fieldIs(nodes[index])) {
        return index;
      }
    }
    return -1;
  }

  @Override
  protected void setValueFromString(String strValue) {
    setValueFrom(new KrlScanner(strValue), false);
  }
}
