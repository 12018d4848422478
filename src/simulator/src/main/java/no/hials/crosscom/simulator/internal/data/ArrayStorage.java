package no.hials.crosscom.simulator.internal.data;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import no.hials.crosscom.protocol.value.KrlArray;
import no.hials.crosscom.protocol.value.KrlStruct;
import no.hials.crosscom.protocol.value.KrlValue;
import no.hials.crosscom.simulator.Refusal;
import no.hials.crosscom.simulator.RefusedException;
import org.jspecify.annotations.Nullable;

/** An array, except for a CHAR array with one dimension. */
final class ArrayStorage extends Storage {
  /** The elements of a block, so that a change of one copies few. */
  private static final int BLOCK = 256;

  private final int[] lengths;
  private final int count;

  /** All elements, in blocks; the last index varies fastest. */
  private final Storage[][] blocks;

  /**
   * Creates an array whose elements are all the same.
   *
   * @param lengths the length of each dimension, without the length of texts
   */
  ArrayStorage(int[] lengths, Storage element) {
    this.lengths = lengths;
    int product = 1;
    for (int length : lengths) {
      product *= length;
    }
    count = product;
    Storage[] full = new Storage[Math.min(count, BLOCK)];
    Arrays.fill(full, element);
    // the blocks are never changed, so they can be one
    blocks = new Storage[(count + BLOCK - 1) / BLOCK][];
    Arrays.fill(blocks, full);
  }

  private ArrayStorage(ArrayStorage old, Storage[][] blocks) {
    lengths = old.lengths;
    count = old.count;
    this.blocks = blocks;
  }

  /** Returns an element by its position among all elements, from 0. */
  Storage element(int position) {
    return blocks[position / BLOCK][position % BLOCK];
  }

  /** Returns the number of all elements. */
  int count() {
    return count;
  }

  /** Returns the new contents of an element, given its position and the old. */
  @FunctionalInterface
  private interface ElementChange {
    Storage apply(int position, Storage old) throws RefusedException;
  }

  /** Assigns one value; equal elements share one object, because there are thousands of outputs. */
  private static final class SameValue implements ElementChange {
    private final KrlValue value;
    private @Nullable Storage before;
    private @Nullable Storage after;

    SameValue(KrlValue value) {
      this.value = value;
    }

    @Override
    public Storage apply(int position, Storage old) throws RefusedException {
      Storage known = after;
      if (known == null || old != before) {
        known = old.assign(value);
        before = old;
        after = known;
      }
      return known;
    }
  }

  private Storage changeAll(ElementChange change) throws RefusedException {
    Storage[][] changed = new Storage[blocks.length][];
    for (int i = 0; i < count; i++) {
      if (i % BLOCK == 0) {
        changed[i / BLOCK] = new Storage[Math.min(count - i, BLOCK)];
      }
      changed[i / BLOCK][i % BLOCK] = change.apply(i, element(i));
    }
    return new ArrayStorage(this, changed);
  }

  /** Returns the length of each dimension, without the length of texts. */
  int[] lengths() {
    return lengths.clone();
  }

  private boolean hasScalars() {
    return element(0) instanceof ScalarStorage;
  }

  @Override
  Type type() {
    return element(0).type();
  }

  @Override
  long bytes() {
    return count * element(0).bytes();
  }

  @Override
  public boolean initialised() {
    for (int i = 0; i < count; i++) {
      if (element(i).initialised()) {
        return true;
      }
    }
    return false;
  }

  private boolean allInitialised() {
    for (int i = 0; i < count; i++) {
      if (!element(i).initialised()) {
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
    List<KrlValue> values = new ArrayList<>(count);
    for (int i = 0; i < count; i++) {
      // no sample of a partly initialised array is known: assumed to fail as a scalar does
      values.add(element(i).value());
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
    boolean isText = element(0) instanceof TextStorage;
    for (int i = 0; i < count; i++) {
      if (element(i).initialised()) {
        String field = name + new Index(indicesOf(i), isText);
        fields.add(new KrlStruct.Field(field, element(i).value()));
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
    if (!(value instanceof KrlArray array)) {
      return changeAll(new SameValue(value));
    }
    if (array.elements().size() != count) {
      throw new RefusedException(
          Refusal.OUT_OF_RANGE, "has " + count + " elements, was given " + array.elements().size());
    }
    return changeAll((i, old) -> old.assign(array.elements().get(i)));
  }

  @Override
  Storage takeOver(Storage others) {
    if (!(others instanceof ArrayStorage array)
        || array.lengths.length != lengths.length
        || (array.count != count && lengths.length > 1)) {
      return this;
    }
    try {
      return changeAll((i, old) -> i < array.count ? old.takeOver(array.element(i)) : old);
    } catch (RefusedException e) {
      throw new IllegalStateException("an element takes what fits", e);
    }
  }

  @Override
  KrlValue rounded(KrlValue value) throws RefusedException {
    if (!(value instanceof KrlArray array)) {
      return element(0).rounded(value);
    }
    List<KrlValue> values = new ArrayList<>(array.elements().size());
    for (KrlValue element : array.elements()) {
      values.add(element(0).rounded(element));
    }
    return new KrlArray(values);
  }

  @Override
  Storage select(Index index) throws RefusedException {
    if (isWhole(index)) {
      return this;
    }
    return element(offset(index)).select(index.after(lengths.length));
  }

  private boolean isWhole(Index index) {
    return index.isWhole() && lengths.length == 1 && !(element(0) instanceof TextStorage);
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
    Storage old = element(offset);
    Storage element = old.change(index.after(lengths.length), change);
    if (element == old) {
      return this;
    }
    Storage[][] changed = blocks.clone();
    Storage[] block = changed[offset / BLOCK].clone();
    block[offset % BLOCK] = element;
    changed[offset / BLOCK] = block;
    return new ArrayStorage(this, changed);
  }
}
