package no.hials.crosscom.protocol.value;

import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import org.jspecify.annotations.Nullable;

/**
 * An aggregate: the value of a KRL STRUC, with its initialised fields.
 *
 * @param typeName the STRUC's name, as in <code>{E6POS: X 1.0}</code>; null if the text has none
 * @param fields the fields in the order of the text; no name twice in upper or lower case; empty
 *     for an uninitialised variable
 */
public record KrlStruct(@Nullable String typeName, List<Field> fields) implements KrlValue {

  /** Checks the names and that no more than {@link KrlValue#MAX_DEPTH} aggregates are nested. */
  public KrlStruct {
    if (typeName != null && !KrlScanner.isName(typeName)) {
      throw new IllegalArgumentException(
          "a STRUC's type is a name of letters, digits, _ and $, is \"" + typeName + "\"");
    }
    fields = List.copyOf(fields);
    Set<String> names = new HashSet<>();
    for (Field field : fields) {
      if (!names.add(field.name().toUpperCase(Locale.ROOT))) {
        throw new IllegalArgumentException("field " + field.name() + " is there twice");
      }
    }
    int depth = 1 + deepest(fields);
    if (depth > MAX_DEPTH) {
      throw new IllegalArgumentException(
          "aggregates may nest " + MAX_DEPTH + " deep, these nest " + depth);
    }
  }

  private static int deepest(List<Field> fields) {
    int deepest = 0;
    for (Field field : fields) {
      if (field.value() instanceof KrlStruct struct) {
        deepest = Math.max(deepest, 1 + deepest(struct.fields()));
      }
    }
    return deepest;
  }

  /**
   * Returns the value of a field, by its name in upper or lower case.
   *
   * @param name the field's name; the brackets of an array field may be left out
   * @return the value, or empty if the field is missing or uninitialised
   */
  public Optional<KrlValue> get(String name) {
    for (Field field : fields) {
      String own = field.name();
      if (own.equalsIgnoreCase(name)
          || (own.endsWith("[]")
              && own.length() == name.length() + 2
              && own.regionMatches(true, 0, name, 0, name.length()))) {
        return Optional.of(field.value());
      }
    }
    return Optional.empty();
  }

  @Override
  public KrlStruct asStruct() {
    return this;
  }

  @Override
  public <R extends @Nullable Object> R accept(KrlVisitor<R> visitor) {
    return visitor.visit(this);
  }

  @Override
  public String toString() {
    return print();
  }

  /**
   * One field of an aggregate.
   *
   * @param name the name as printed; a CHAR array and a whole numeric array keep their brackets, as
   *     in {@code NAME[] "/R1/MAIN"}
   * @param value the value
   */
  public record Field(String name, KrlValue value) {

    /** Checks the name, and that a whole array's name has brackets. */
    public Field {
      Objects.requireNonNull(value, "value");
      if (!KrlScanner.isFieldName(name)) {
        throw new IllegalArgumentException(
            "a field's name is a name with or without an index, is \"" + name + "\"");
      }
      boolean brackets = name.endsWith("[]");
      if (value instanceof KrlArray && !brackets) {
        throw new IllegalArgumentException(
            "the field of a whole array is called NAME[], is \"" + name + "\"");
      }
      if (brackets && !(value instanceof KrlArray) && !(value instanceof KrlString)) {
        throw new IllegalArgumentException(
            "field " + name + " must hold an array or a CHAR array, holds " + value);
      }
    }
  }
}
