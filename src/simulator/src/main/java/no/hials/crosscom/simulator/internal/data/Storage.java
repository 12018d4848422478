package no.hials.crosscom.simulator.internal.data;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import no.hials.crosscom.protocol.value.KrlArray;
import no.hials.crosscom.protocol.value.KrlInt;
import no.hials.crosscom.protocol.value.KrlReal;
import no.hials.crosscom.protocol.value.KrlString;
import no.hials.crosscom.protocol.value.KrlStruct;
import no.hials.crosscom.protocol.value.KrlValue;
import no.hials.crosscom.simulator.Refusal;
import no.hials.crosscom.simulator.RefusedException;
import org.jspecify.annotations.Nullable;

/**
 * The contents of a variable or of a part of it. Immutable: a write makes a new node, so that a
 * write that is refused half-way has changed nothing, and tables can share their initial contents.
 */
public abstract sealed class Storage {

  private Storage() {}

  /** Makes the new contents of a part out of the old. */
  @FunctionalInterface
  interface Change {
    Storage apply(Storage old) throws RefusedException;
  }

  /** The text as printed, kept since the same variable tends to be read again and again. */
  private @Nullable String text;

  /**
   * Says whether there is something to print.
   *
   * @return whether a part of it has a value
   */
  public abstract boolean initialised();

  /**
   * Gives the value of the whole.
   *
   * @return the value
   * @throws RefusedException if it has none
   */
  public abstract KrlValue value() throws RefusedException;

  /**
   * Gives these contents after a value has been assigned to the whole. As with every change, they
   * may be this object if that changes nothing: programs assign the same again and again.
   */
  abstract Storage assign(KrlValue value) throws RefusedException;

  /** Gives the part that an index stands for. */
  Storage select(Index index) throws RefusedException {
    if (!index.isNone()) {
      throw badIndex("no array, was given index " + index);
    }
    return this;
  }

  /** Gives these contents after a change of the part that an index stands for. */
  Storage change(Index index, Change change) throws RefusedException {
    return change.apply(select(index));
  }

  /** Gives a component by its name in upper case. */
  Storage component(String name) throws RefusedException {
    throw new RefusedException(Refusal.UNKNOWN_COMPONENT, "no structure, has no ." + name);
  }

  /** Gives these contents after a change of a component. */
  Storage changeComponent(String name, Change change) throws RefusedException {
    return change.apply(component(name));
  }

  /** Gives the value as a controller prints it. */
  final String text() throws RefusedException {
    // a race between two threads only prints twice
    String known = text;
    if (known == null) {
      known = value().print();
      text = known;
    }
    return known;
  }

  /**
   * Gives the part that a path stands for; this is what its first name stands for.
   *
   * @param path the path
   * @return the contents of the part
   * @throws RefusedException if there is no such part
   */
  public final Storage read(VariablePath path) throws RefusedException {
    Storage storage = select(path.first().index());
    for (int i = 1; i < path.steps().size(); i++) {
      VariablePath.Step step = path.steps().get(i);
      storage = storage.component(step.name()).select(step.index());
    }
    return storage;
  }

  /** Gives these contents after a value has been assigned to the part a path stands for. */
  final Storage write(VariablePath path, KrlValue value) throws RefusedException {
    return change(path, part -> part.assign(value));
  }

  /**
   * Gives these contents after a program has assigned a value to the part that a path stands for. A
   * REAL is rounded where an INT is needed.
   *
   * @param path the path; this is what its first name stands for
   * @param value the value
   * @return the contents after that
   * @throws RefusedException if there is no such part, or the value is not of its type
   */
  public final Storage store(VariablePath path, KrlValue value) throws RefusedException {
    return change(path, part -> part.assign(part.rounded(value)));
  }

  /** Gives what a program's value becomes when it is assigned to the whole. */
  KrlValue rounded(KrlValue value) throws RefusedException {
    return value;
  }

  /**
   * Gives the characters of a CHAR array. Unlike its value they can be none at all.
   *
   * @return the characters; nothing if this is no CHAR array or it has no value
   */
  public Optional<String> characters() {
    return Optional.empty();
  }

  /**
   * Gives the declared length of a CHAR array.
   *
   * @return how many characters it can hold; 0 if this is no CHAR array
   */
  public int capacity() {
    return 0;
  }

  /** Gives these contents after a change of the part a path stands for. */
  final Storage change(VariablePath path, Change change) throws RefusedException {
    return change(path, 0, change);
  }

  private Storage change(VariablePath path, int step, Change change) throws RefusedException {
    return change(
        path.steps().get(step).index(),
        part ->
            path.isLast(step)
                ? change.apply(part)
                : part.changeComponent(
                    path.steps().get(step + 1).name(),
                    component -> component.change(path, step + 1, change)));
  }

  /**
   * Returns a CHAR array that just holds a text.
   *
   * @param text the text
   * @throws RefusedException if a character is not in ISO 8859-1
   */
  public static Storage ofText(KrlString text) throws RefusedException {
    return new Text(Math.max(1, text.text().length()), null).assign(text);
  }

  static RefusedException badIndex(String what) {
    return new RefusedException(Refusal.BAD_INDEX, what);
  }

  static RefusedException notInitialised() {
    return new RefusedException(Refusal.NOT_INITIALISED, "has no value yet");
  }

  /** Refuses what could never be sent. Only Java code can bring such characters here. */
  static void checkLatin1(KrlString string) throws RefusedException {
    if (string.text().chars().anyMatch(c -> c > 0xFF)) {
      throw new RefusedException(Refusal.OUT_OF_RANGE, "is not ISO 8859-1: " + string);
    }
  }

  /** A value without parts. */
  static final class Scalar extends Storage {
    private final Type.Scalar type;
    private final @Nullable KrlValue value;

    Scalar(Type.Scalar type, @Nullable KrlValue value) {
      this.type = type;
      this.value = value;
    }

    Type type() {
      return type;
    }

    @Override
    public boolean initialised() {
      return value != null;
    }

    @Override
    public KrlValue value() throws RefusedException {
      if (value == null) {
        throw notInitialised();
      }
      return value;
    }

    @Override
    Storage assign(KrlValue newValue) throws RefusedException {
      KrlValue converted = type.convert(newValue);
      return converted.equals(value) ? this : new Scalar(type, converted);
    }

    @Override
    KrlValue rounded(KrlValue newValue) throws RefusedException {
      if (type != Type.Base.INT || !(newValue instanceof KrlReal number)) {
        return newValue;
      }
      // assumed: to the nearest, halves upwards (no source says)
      double nearest = Math.floor(number.value() + 0.5);
      if (nearest != (int) nearest) {
        throw new RefusedException(Refusal.OUT_OF_RANGE, "an INT has 32 bits, was given " + number);
      }
      return new KrlInt((int) nearest);
    }
  }

  /** A CHAR array, or one row of a CHAR array with two dimensions. */
  static final class Text extends Storage {
    private final int capacity;
    private final @Nullable String characters;

    Text(int capacity, @Nullable String characters) {
      this.capacity = capacity;
      this.characters = characters;
    }

    @Override
    public int capacity() {
      return capacity;
    }

    @Override
    public Optional<String> characters() {
      return Optional.ofNullable(characters);
    }

    @Override
    public boolean initialised() {
      return characters != null;
    }

    @Override
    public KrlValue value() throws RefusedException {
      if (characters == null) {
        throw notInitialised();
      }
      // an empty text is printed as one blank (docs/reference/krl-values.md#scalars)
      return new KrlString(characters.isEmpty() ? " " : characters);
    }

    @Override
    Storage assign(KrlValue value) throws RefusedException {
      if (!(value instanceof KrlString string)) {
        throw new RefusedException(
            Refusal.WRONG_TYPE, "needs a text in double quotes, was given " + value.print());
      }
      if (string.text().length() > capacity) {
        throw new RefusedException(
            Refusal.OUT_OF_RANGE,
            "holds " + capacity + " characters, was given " + string.text().length());
      }
      checkLatin1(string);
      return new Text(capacity, string.text());
    }

    @Override
    Storage select(Index index) throws RefusedException {
      if (index.isWhole()) {
        return this;
      }
      int at = position(index);
      if (characters == null) {
        return new Scalar(Type.Base.CHAR, null);
      }
      // assumed: what lies behind the end of the text reads as blank
      char c = at < characters.length() ? characters.charAt(at) : ' ';
      return new Scalar(Type.Base.CHAR, new KrlString(String.valueOf(c)));
    }

    private int position(Index index) throws RefusedException {
      if (index.isNone()) {
        throw badIndex("a CHAR array, needs []");
      }
      if (index.count() != 1 || index.number(0) < 1 || index.number(0) > capacity) {
        throw badIndex("index is one of 1 to " + capacity + ", was given " + index);
      }
      return index.number(0) - 1;
    }

    @Override
    Storage change(Index index, Change change) throws RefusedException {
      if (index.isWhole()) {
        return change.apply(this);
      }
      int at = position(index);
      String changed = ((KrlString) change.apply(select(index)).value()).text();
      StringBuilder all = new StringBuilder(characters == null ? "" : characters);
      while (all.length() <= at) {
        all.append(' ');
      }
      all.setCharAt(at, changed.charAt(0));
      return new Text(capacity, all.toString());
    }
  }

  /** A structure. */
  static final class Struc extends Storage {
    private final Type.Struc type;
    private final Storage[] parts;

    Struc(Type.Struc type, Storage[] parts) {
      this.type = type;
      this.parts = parts;
    }

    Type.Struc type() {
      return type;
    }

    /** Gives the parts in the order of the type's components. */
    List<Storage> parts() {
      return List.of(parts);
    }

    @Override
    public boolean initialised() {
      for (Storage part : parts) {
        if (part.initialised()) {
          return true;
        }
      }
      return false;
    }

    @Override
    public KrlValue value() throws RefusedException {
      List<KrlStruct.Field> fields = new ArrayList<>(parts.length);
      for (int i = 0; i < parts.length; i++) {
        // only initialised components are printed (docs/reference/krl-values.md#structures)
        if (parts[i].initialised()) {
          String name = type.components().get(i).name();
          if (parts[i] instanceof Array array) {
            array.addFields(name, fields);
          } else {
            boolean isText = parts[i] instanceof Text;
            fields.add(new KrlStruct.Field(isText ? name + "[]" : name, parts[i].value()));
          }
        }
      }
      return new KrlStruct(type.name(), fields);
    }

    @Override
    Storage assign(KrlValue value) throws RefusedException {
      Storage result = this;
      for (KrlStruct.Field field : type.check(value).fields()) {
        VariablePath path = VariablePath.parse(field.name());
        result =
            result.changeComponent(
                path.first().name(), component -> component.write(path, field.value()));
      }
      return result;
    }

    @Override
    KrlValue rounded(KrlValue value) throws RefusedException {
      if (!(value instanceof KrlStruct given)) {
        return value;
      }
      KrlStruct struct = type.ofItsKind(given);
      List<KrlStruct.Field> fields = new ArrayList<>(struct.fields().size());
      for (KrlStruct.Field field : struct.fields()) {
        VariablePath path = VariablePath.parse(field.name());
        Storage part = component(path.first().name()).read(path);
        fields.add(new KrlStruct.Field(field.name(), part.rounded(field.value())));
      }
      return new KrlStruct(struct.typeName(), fields);
    }

    private int position(String name) throws RefusedException {
      Integer position = type.positions().get(name);
      if (position == null) {
        throw new RefusedException(Refusal.UNKNOWN_COMPONENT, type.name() + " has no ." + name);
      }
      return position;
    }

    @Override
    Storage component(String name) throws RefusedException {
      return parts[position(name)];
    }

    @Override
    Storage changeComponent(String name, Change change) throws RefusedException {
      int position = position(name);
      Storage part = change.apply(parts[position]);
      if (part == parts[position]) {
        return this;
      }
      Storage[] changed = parts.clone();
      changed[position] = part;
      return new Struc(type, changed);
    }
  }

  /** An array of anything but single characters. */
  static final class Array extends Storage {
    private final int[] lengths;
    private final Storage[] elements;

    /**
     * @param lengths the length of each dimension, without that of the texts in it
     * @param elements all of them, the last index counting fastest
     */
    Array(int[] lengths, Storage[] elements) {
      this.lengths = lengths;
      this.elements = elements;
    }

    /** Gives the length of each dimension, without that of the texts in it. */
    int[] lengths() {
      return lengths.clone();
    }

    /** Gives all elements, the last index counting fastest. */
    List<Storage> elements() {
      return List.of(elements);
    }

    private boolean hasScalars() {
      return elements[0] instanceof Scalar;
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
        // no sample of it is known: assumed to fail (docs/reference/krl-values.md#arrays)
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
     * Adds this component to the fields of its structure: whole if that is possible, else those
     * elements that are initialised. The second form is assumed, no sample is known.
     */
    void addFields(String name, List<KrlStruct.Field> fields) throws RefusedException {
      if (lengths.length == 1 && hasScalars() && allInitialised()) {
        fields.add(new KrlStruct.Field(name + "[]", value()));
        return;
      }
      boolean isText = elements[0] instanceof Text;
      for (int i = 0; i < elements.length; i++) {
        if (elements[i].initialised()) {
          String field = name + new Index(indicesOf(i), isText);
          fields.add(new KrlStruct.Field(field, elements[i].value()));
        }
      }
    }

    /** Gives the indices of an element by its position among all. */
    int[] indicesOf(int offset) {
      int[] numbers = new int[lengths.length];
      int rest = offset;
      for (int i = lengths.length - 1; i >= 0; i--) {
        numbers[i] = rest % lengths[i] + 1;
        rest /= lengths[i];
      }
      return numbers;
    }

    /** Takes all elements, or one value for every element. */
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
          // equal elements stay one object, which matters for thousands of outputs
          changed[i] =
              i > 0 && elements[i] == elements[i - 1] ? changed[i - 1] : elements[i].assign(value);
        }
      }
      return new Array(lengths, changed);
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
      return index.isWhole() && lengths.length == 1 && !(elements[0] instanceof Text);
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
          throw badIndex("index is one of 1 to " + lengths[i] + ", was given " + index);
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
      return new Array(lengths, changed);
    }
  }
}
