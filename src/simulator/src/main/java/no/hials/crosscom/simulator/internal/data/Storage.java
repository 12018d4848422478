package no.hials.crosscom.simulator.internal.data;

import java.util.Optional;
import no.hials.crosscom.protocol.value.KrlString;
import no.hials.crosscom.protocol.value.KrlValue;
import no.hials.crosscom.simulator.Refusal;
import no.hials.crosscom.simulator.RefusedException;
import org.jspecify.annotations.Nullable;

/**
 * The contents of a variable or of a part of it. Immutable: a write makes a new node, so that a
 * write that is refused half-way has changed nothing, and tables can share their initial contents.
 */
public abstract sealed class Storage
    permits ScalarStorage, TextStorage, StrucStorage, ArrayStorage {

  Storage() {}

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
    return new TextStorage(Math.max(1, text.text().length()), null).assign(text);
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
}
