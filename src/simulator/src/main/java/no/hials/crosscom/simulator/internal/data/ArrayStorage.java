package no.hials.crosscom.simulator.internal.data;

import java.util.ArrayList;
import java.util.List;
import no.hials.crosscom.protocol.value.KrlArray;
import no.hials.crosscom.protocol.value.KrlStruct;
import no.hials.crosscom.protocol.value.KrlValue;
import no.hials.crosscom.simulator.Refusal;
import no.hials.crosscom.simulator.RefusedException;

/** An array, except for a CHAR array with one dimension. */
final class ArrayStorage extends Storage {
  private final int[] lengths;
  private final Storage[] elements;

  /**
   * @param lengths the length of each dimension, without the length of texts
   * @param elements all elements; the last index varies fastest
   */
  ArrayStorage(int[] lengths, Storage[] elements) {
    this.lengths = lengths;
    this.elements = elements;
  }

  /** Returns the length of each dimension, without the length of texts. */
  int[] lengths() {
    return lengths.clone();
  }

  /** Returns all elements; the last index varies fastest. */
  List<Storage> elements() {
    return List.of(elements);
  }

  private boolean hasScalars() {
    return elements[0] instanceof ScalarStorage;
  }

  @Override
  Type type() {
    return elements[0].type();
  }

  @Override
  long bytes() {
    return elements.length * elements[0].bytes();
  }

  @Override
  public boolean initialised() {
    for (Storage element : elements) {
      if (element.initialised()) {
        return true;
      }
    }
    return false;
  }

  private boolean allInitialised() {
    for (Storage element : elements) {
      if (!element.initialised()) {
        return false;
      }
    }
    return true;
  }

  @Override
  public KrlValue value() throws RefusedException {
    if (!hasScalars()) {
      // no sample is known: assumed to fail (docs/reference/krl-values.md#arrays)
      throw new RefusedException(
          Refusal.WHOLE_ARRAY, "an array of structures can only be read by element");
    }
    List<KrlValue> values = new ArrayList<>(elements.length);
    for (Storage element : elements) {
      // no sample of a partly initialised array is known: assumed to fail as a scalar does
      values.add(element.value());
    }
    return new KrlArray(values);
  }

  /**
   * Adds this component to the fields of its structure: as one field if possible, else a field for
   * each element with a value. The second form is assumed.
   */
  void addFields(String name, List<KrlStruct.Field> fields) throws RefusedException {
    if (lengths.length == 1 && hasScalars() && allInitialised()) {
      fields.add(new KrlStruct.Field(name + "[]", value()));
      return;
    }
    boolean isText = elements[0] instanceof TextStorage;
    for (int i = 0; i < elements.length; i++) {
      if (elements[i].initialised()) {
        String field = name + new Index(indicesOf(i), isText);
        fields.add(new KrlStruct.Field(field, elements[i].value()));
      }
    }
  }

  /** Returns the indices of an element, given its position among all elements. */
  int[] indicesOf(int offset) {
    int[] numbers = new int[lengths.length];
    int rest = offset;
    for (int i = lengths.length - 1; i >= 0; i--) {
      numbers[i] = rest % lengths[i] + 1;
      rest /= lengths[i];
    }
    return numbers;
  }

  /** Assigns all elements, or one value to every element. */
  @Override
  Storage assign(KrlValue value) throws RefusedException {
    Storage[] changed = new Storage[elements.length];
    if (value instanceof KrlArray array) {
      if (array.elements().size() != elements.length) {
        throw new RefusedException(
            Refusal.OUT_OF_RANGE,
            "has " + elements.length + " elements, was given " + array.elements().size());
      }
      for (int i = 0; i < changed.length; i++) {
        changed[i] = elements[i].assign(array.elements().get(i));
      }
    } else {
      for (int i = 0; i < changed.length; i++) {
        // equal elements share one object: there are thousands of outputs
        changed[i] =
            i > 0 && elements[i] == elements[i - 1] ? changed[i - 1] : elements[i].assign(value);
      }
    }
    return new ArrayStorage(lengths, changed);
  }

  @Override
  Storage takeOver(Storage others) {
    if (!(others instanceof ArrayStorage array) || array.elements.length != elements.length) {
      return this;
    }
    Storage[] changed = new Storage[elements.length];
    for (int i = 0; i < changed.length; i++) {
      changed[i] = elements[i].takeOver(array.elements[i]);
    }
    return new ArrayStorage(lengths, changed);
  }

  @Override
  KrlValue rounded(KrlValue value) throws RefusedException {
    if (!(value instanceof KrlArray array)) {
      return elements[0].rounded(value);
    }
    List<KrlValue> values = new ArrayList<>(array.elements().size());
    for (KrlValue element : array.elements()) {
      values.add(elements[0].rounded(element));
    }
    return new KrlArray(values);
  }

  @Override
  Storage select(Index index) throws RefusedException {
    if (isWhole(index)) {
      return this;
    }
    return elements[offset(index)].select(index.after(lengths.length));
  }

  private boolean isWhole(Index index) {
    return index.isWhole() && lengths.length == 1 && !(elements[0] instanceof TextStorage);
  }

  private int offset(Index index) throws RefusedException {
    if (index.count() < lengths.length) {
      throw badIndex(
          "an array of "
              + lengths.length
              + " dimensions, was given "
              + (index.isNone() ? "no index" : "index " + index));
    }
    int offset = 0;
    for (int i = 0; i < lengths.length; i++) {
      int number = index.number(i);
      if (number < 1 || number > lengths[i]) {
        throw badIndex("an index is 1 to " + lengths[i] + ", was given " + index);
      }
      offset = offset * lengths[i] + number - 1;
    }
    return offset;
  }

  @Override
  Storage change(Index index, Change change) throws RefusedException {
    if (isWhole(index)) {
      return change.apply(this);
    }
    int offset = offset(index);
    Storage element = elements[offset].change(index.after(lengths.length), change);
    if (element == elements[offset]) {
      return this;
    }
    Storage[] changed = elements.clone();
    changed[offset] = element;
    return new ArrayStorage(lengths, changed);
  }
}
