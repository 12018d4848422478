package no.hials.crosscom.internal;

import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.Locale;
import java.util.Map;
import java.util.Objects;
import java.util.regex.Pattern;
import no.hials.crosscom.KRL.KrlName;
import org.jspecify.annotations.Nullable;

/** The names that the constants of a Java enum have in KRL. Immutable. */
public final class EnumNames {
  private static final Pattern NAME = Pattern.compile("[A-Za-z_$][A-Za-z0-9_$]*");

  private static final ClassValue<EnumNames> NAMES =
      new ClassValue<>() {
        @Override
        protected EnumNames computeValue(Class<?> type) {
          return new EnumNames(type);
        }
      };

  private final Map<String, Object> byName = new LinkedHashMap<>();
  private final Map<Object, String> names = new HashMap<>();

  private EnumNames(Class<?> type) {
    for (Object constant : type.getEnumConstants()) {
      String javaName = ((Enum<?>) constant).name();
      String name = krlName(annotation(type, javaName), javaName);
      if (name == null) {
        throw new IllegalArgumentException(
            "is of type " + type.getTypeName() + ", whose " + javaName + " has no KRL name");
      }
      if (byName.put(name, constant) != null) {
        throw new IllegalArgumentException(
            "is of type " + type.getTypeName() + ", which has the name " + name + " twice");
      }
      names.put(constant, name);
    }
  }

  private static @Nullable KrlName annotation(Class<?> type, String constant) {
    try {
      return type.getDeclaredField(constant).getAnnotation(KrlName.class);
    } catch (NoSuchFieldException e) {
      throw new AssertionError("each constant of an enum is a field of it", e);
    }
  }

  /**
   * Returns the names of an enum.
   *
   * @throws IllegalArgumentException if a constant has no KRL name, or two have the same; the
   *     message completes a sentence about the value
   */
  public static EnumNames of(Class<?> type) {
    return NAMES.get(type);
  }

  /** Returns a name on the controller, in upper case; null if it is not a KRL name. */
  public static @Nullable String krlName(@Nullable KrlName given, String javaName) {
    String name = given == null ? javaName : given.value();
    return NAME.matcher(name).matches() ? name.toUpperCase(Locale.ROOT) : null;
  }

  /** Returns the constant of a name without the {@code #}, ignoring case; null if none has it. */
  public @Nullable Object constant(String name) {
    return byName.get(name.toUpperCase(Locale.ROOT));
  }

  /** Returns the name of a constant, without the {@code #}. */
  public String name(Object constant) {
    return Objects.requireNonNull(names.get(constant));
  }

  /** Returns the rule that a wrong name breaks. */
  public String expected() {
    return "one of #" + String.join(", #", byName.keySet());
  }
}
