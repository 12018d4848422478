package no.hials.crosscom.simulator.internal.data;

import java.util.Optional;
import no.hials.crosscom.protocol.value.KrlString;
import no.hials.crosscom.protocol.value.KrlValue;
import no.hials.crosscom.simulator.Refusal;
import no.hials.crosscom.simulator.RefusedException;
import org.jspecify.annotations.Nullable;

/** A CHAR array, or one row of a CHAR array with two dimensions. */
final class TextStorage extends Storage {
  private final int capacity;
  private final @Nullable String characters;

  TextStorage(int capacity, @Nullable String characters) {
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
  Type type() {
    return Type.Base.CHAR;
  }

  @Override
  long bytes() {
    return Type.SCALAR_BYTES + capacity;
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
    return new TextStorage(capacity, string.text());
  }

  @Override
  Storage select(Index index) throws RefusedException {
    if (index.isWhole()) {
      return this;
    }
    int at = position(index);
    if (characters == null) {
      return new ScalarStorage(Type.Base.CHAR, null);
    }
    // assumed: the elements after the end of the text read as blanks
    char c = at < characters.length() ? characters.charAt(at) : ' ';
    return new ScalarStorage(Type.Base.CHAR, new KrlString(String.valueOf(c)));
  }

  private int position(Index index) throws RefusedException {
    if (index.isNone()) {
      throw badIndex("a CHAR array, needs []");
    }
    if (index.count() != 1 || index.number(0) < 1 || index.number(0) > capacity) {
      throw badIndex("an index is 1 to " + capacity + ", was given " + index);
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
    return new TextStorage(capacity, all.toString());
  }
}
