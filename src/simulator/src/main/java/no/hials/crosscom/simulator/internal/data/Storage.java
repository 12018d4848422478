package no.hials.crosscom.simulator.internal.data;

import java.util.Optional;
import no.hials.crosscom.protocol.value.KrlString;
import no.hials.crosscom.protocol.value.KrlValue;
import no.hials.crosscom.simulator.Refusal;
import no.hials.crosscom.simulator.RefusedException;
import org.jspecify.annotations.Nullable;

/**
 * The contents of a variable or of a part of it. Immutable: a write creates new contents, so a
 * write that is refused half-way changes nothing, and tables can share their initial contents.
 */
public abstract sealed class Storage
    permits ScalarStorage, TextStorage, StrucStorage, ArrayStorage, UntypedStorage {

  Storage() {}

  /** Returns the new contents of a part, given the old. */
  @FunctionalInterface
  interface Change {
    Storage apply(Storage old) throws RefusedException;
  }

  /** The printed value, kept because programs and clients read the same variables repeatedly. */
  private @Nullable String text;

  /** Returns whether a part has a value. */
  public abstract boolean initialised();

  /**
   * Returns the value of the whole.
   *
   * @throws RefusedException if it has no value
   */
  public abstract KrlValue value() throws RefusedException;

  /**
   * Returns the contents after a value has been assigned to the whole. Like every change, this
   * returns the same object if nothing changes, because programs often assign the same value again.
   */
  abstract Storage assign(KrlValue value) throws RefusedException;

  /** Returns the contents with those values of others that fit. */
  Storage takeOver(Storage others) {
    try {
      return others.initialised() ? assign(others.value()) : this;
    } catch (RefusedException e) {
      return this;
    }
  }

  /** Returns the part at an index. */
  Storage select(Index index) throws RefusedException {
    if (!index.isNone()) {
      throw badIndex("not an array, was given index " + index);
    }
    return this;
  }

  /** Returns the contents after a change of the part at an index. */
  Storage change(Index index, Change change) throws RefusedException {
    return change.apply(select(index));
  }

  /** Returns a component by its name in upper case. */
  Storage component(String name) throws RefusedException {
    throw new RefusedException(Refusal.UNKNOWN_COMPONENT, "not a structure, has no ." + name);
  }

  /** Returns the contents after a change of a component. */
  Storage changeComponent(String name, Change change) throws RefusedException {
    return change.apply(component(name));
  }

  /** Returns the type of the value, of an array that of an element. */
  abstract Type type();

  /**
   * Returns the bytes that the contents take at most, about; the same for all values, if the type
   * is known.
   */
  abstract long bytes();

  /** Returns the value as a controller prints it. */
  final String text() throws RefusedException {
    // a race of two threads only prints the value twice
    String known = text;
    if (known == null) {
      known = value().print();
      text = known;
    }
    return known;
  }

  /**
   * Returns the part at a path, whose first name stands for these contents.
   *
   * @throws RefusedException if the part does not exist
   */
  public final Storage read(VariablePath path) throws RefusedException {
    Storage storage = select(path.first().index());
    for (int i = 1; i < path.steps().size(); i++) {
      VariablePath.PathStep step = path.steps().get(i);
      storage = storage.component(step.name()).select(step.index());
    }
    return storage;
  }

  /** Returns the contents after a value has been assigned to the part at a path. */
  final Storage write(VariablePath path, KrlValue value) throws RefusedException {
    return change(path, part -> part.assign(value));
  }

  /**
   * Returns the contents after a program has assigned a value to the part at a path. A REAL is
   * rounded if the part is an INT.
   *
   * @throws RefusedException if the part does not exist or has another type
   */
  public final Storage store(VariablePath path, KrlValue value) throws RefusedException {
    return change(path, part -> part.assign(part.rounded(value)));
  }

  /** Returns the value to store if a program assigns a value to the whole. */
  KrlValue rounded(KrlValue value) throws RefusedException {
    return value;
  }

  /**
   * Returns the value to store if a program or a data list assigns a value to the whole: a CHAR
   * becomes its code and an INT the character, if the part needs that.
   */
  KrlValue coded(KrlValue value) throws RefusedException {
    return value;
  }

  /**
   * Returns the characters of a CHAR array, which can be none; empty if it has no value or is not a
   * CHAR array.
   */
  public Optional<String> characters() {
    return Optional.empty();
  }

  /** Returns whether its whole is {@code NAME[]}. */
  public boolean hasBrackets() {
    return this instanceof TextStorage || this instanceof ArrayStorage;
  }

  /** Returns the declared length of a CHAR array; 0 if this is not a CHAR array. */
  public int capacity() {
    return 0;
  }

  /** Returns the contents after a change of the part at a path. */
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

  /** Returns a CHAR array with the length and the characters of a text. */
  public static Storage ofText(KrlString text) {
    return new TextStorage(Math.max(1, text.text().length()), text.text());
  }

  static RefusedException badIndex(String what) {
    return new RefusedException(Refusal.BAD_INDEX, what);
  }

  static RefusedException notInitialised() {
    return new RefusedException(Refusal.NOT_INITIALISED, "has no value yet");
  }
}
