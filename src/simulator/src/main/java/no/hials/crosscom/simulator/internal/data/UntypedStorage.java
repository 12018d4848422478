package no.hials.crosscom.simulator.internal.data;

import java.util.ArrayList;
import java.util.Collections;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import no.hials.crosscom.protocol.value.KrlArray;
import no.hials.crosscom.protocol.value.KrlString;
import no.hials.crosscom.protocol.value.KrlStruct;
import no.hials.crosscom.protocol.value.KrlValue;
import no.hials.crosscom.simulator.Refusal;
import no.hials.crosscom.simulator.RefusedException;
import org.jspecify.annotations.Nullable;

/**
 * The contents of a system variable whose type is not known, or of a part of it: it keeps what is
 * written, a value or values of elements or components. A part has a value if one was written.
 */
final class UntypedStorage extends Storage {
  /** Contents that were never written. */
  static final UntypedStorage EMPTY = new UntypedStorage(null, null, Map.of());

  /**
   * The maximum number of elements or components, so that a program cannot fill the memory;
   * assumed.
   */
  static final int MAX_PARTS = 4096;

  /** The value of a scalar or a text; null for anything else. */
  private final @Nullable KrlValue value;

  /** The type of the last aggregate; null without one. */
  private final @Nullable String type;

  /** The elements by {@code [1]} or {@code [1,]}, or the components by their names. */
  private final Map<String, UntypedStorage> parts;

  private final long bytes;
  private final int depth;

  private UntypedStorage(
      @Nullable KrlValue value, @Nullable String type, Map<String, UntypedStorage> parts) {
    this.value = value;
    this.type = type;
    this.parts = parts;
    long sum = Type.SCALAR_BYTES;
    int deepest = 0;
    for (UntypedStorage part : parts.values()) {
      sum += Scope.NAME_BYTES + part.bytes;
      deepest = Math.max(deepest, part.depth);
    }
    bytes = value instanceof KrlString string ? sum + string.text().length() : sum;
    depth = deepest + 1;
  }

  @Override
  Type type() {
    return Type.Undeclared.UNKNOWN;
  }

  @Override
  long bytes() {
    return bytes;
  }

  @Override
  public boolean initialised() {
    return value != null || parts.values().stream().anyMatch(UntypedStorage::initialised);
  }

  @Override
  public Optional<String> characters() {
    return value instanceof KrlString string ? Optional.of(string.text()) : Optional.empty();
  }

  /**
   * Returns the elements or components that have a value: the elements in the order of their
   * indices, the components in the order in which they were first written.
   */
  Map<String, UntypedStorage> parts() {
    Map<String, UntypedStorage> written = new LinkedHashMap<>();
    List<String> names = new ArrayList<>(parts.keySet());
    if (isArray()) {
      names.sort(Comparator.comparingInt(String::length).thenComparing(Comparator.naturalOrder()));
    }
    for (String name : names) {
      if (part(name).initialised()) {
        written.put(name, part(name));
      }
    }
    return written;
  }

  /** Returns whether it has elements, not components. */
  boolean isArray() {
    return !parts.isEmpty() && parts.keySet().iterator().next().startsWith("[");
  }

  @Override
  public KrlValue value() throws RefusedException {
    if (value != null) {
      // an empty text is printed as one blank (docs/reference/krl-values.md#scalars)
      return value instanceof KrlString string && string.text().isEmpty()
          ? new KrlString(" ")
          : value;
    }
    if (!initialised()) {
      throw notInitialised();
    }
    if (isArray()) {
      return array();
    }
    List<KrlStruct.Field> fields = new ArrayList<>();
    for (Map.Entry<String, UntypedStorage> part : parts().entrySet()) {
      part.getValue().addTo(fields, part.getKey());
    }
    return new KrlStruct(type, fields);
  }

  private KrlArray array() throws RefusedException {
    List<KrlValue> elements = new ArrayList<>();
    for (UntypedStorage element : parts().values()) {
      elements.add(element.value());
    }
    try {
      return new KrlArray(elements);
    } catch (IllegalArgumentException e) {
      throw new RefusedException(
          Refusal.WHOLE_ARRAY, "can only be read by element: " + e.getMessage());
    }
  }

  private void addTo(List<KrlStruct.Field> fields, String name) throws RefusedException {
    if (isArray()) {
      for (Map.Entry<String, UntypedStorage> element : parts().entrySet()) {
        fields.add(new KrlStruct.Field(name + element.getKey(), element.getValue().value()));
      }
    } else {
      fields.add(new KrlStruct.Field(value instanceof KrlString ? name + "[]" : name, value()));
    }
  }

  @Override
  Storage assign(KrlValue newValue) throws RefusedException {
    if (newValue instanceof KrlArray) {
      throw new RefusedException(Refusal.WHOLE_ARRAY, "an array is written by element");
    }
    if (!(newValue instanceof KrlStruct struct)) {
      return newValue.equals(value) ? this : new UntypedStorage(newValue, null, Map.of());
    }
    Storage result =
        new UntypedStorage(
            null,
            struct.typeName() == null ? type : struct.typeName(),
            isArray() ? Map.of() : parts);
    for (KrlStruct.Field field : struct.fields()) {
      VariablePath path = VariablePath.parse(field.name());
      result = result.changeComponent(path.first().name(), part -> part.write(path, field.value()));
    }
    return result;
  }

  @Override
  Storage select(Index index) {
    return index.isNone() || index.isWhole() ? this : part(index.toString());
  }

  private UntypedStorage part(String name) {
    return parts.getOrDefault(name, EMPTY);
  }

  @Override
  Storage change(Index index, Change change) throws RefusedException {
    return index.isNone() || index.isWhole()
        ? change.apply(this)
        : with(index.toString(), change, isArray());
  }

  @Override
  Storage component(String name) {
    return part(name.toUpperCase(Locale.ROOT));
  }

  @Override
  Storage changeComponent(String name, Change change) throws RefusedException {
    return with(name.toUpperCase(Locale.ROOT), change, !isArray());
  }

  /** Returns the contents with another part; it loses parts of the other kind. */
  private Storage with(String name, Change change, boolean keepsParts) throws RefusedException {
    UntypedStorage old = keepsParts ? part(name) : EMPTY;
    UntypedStorage changed = (UntypedStorage) change.apply(old);
    if (changed == old) {
      return this;
    }
    Map<String, UntypedStorage> all = new LinkedHashMap<>(keepsParts ? parts : Map.of());
    all.put(name, changed);
    if (all.size() > MAX_PARTS || changed.depth >= KrlValue.MAX_DEPTH) {
      throw new RefusedException(
          Refusal.OUT_OF_RANGE,
          "a variable of unknown type has at most "
              + MAX_PARTS
              + " parts and "
              + KrlValue.MAX_DEPTH
              + " levels");
    }
    return new UntypedStorage(null, type, Collections.unmodifiableMap(all));
  }
}
