package no.hials.crosscom;

import java.util.Map;
import java.util.Objects;
import java.util.function.BiConsumer;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.function.Supplier;
import java.util.stream.Collectors;
import no.hials.crosscom.KRL.KRLAny;
import no.hials.crosscom.KRL.KRLBool;
import no.hials.crosscom.KRL.KRLBoolArray;
import no.hials.crosscom.KRL.KRLChar;
import no.hials.crosscom.KRL.KRLInt;
import no.hials.crosscom.KRL.KRLIntArray;
import no.hials.crosscom.KRL.KRLReal;
import no.hials.crosscom.KRL.KRLRealArray;
import no.hials.crosscom.KRL.KRLRecord;
import no.hials.crosscom.KRL.KRLString;
import no.hials.crosscom.KRL.KRLVariable;
import no.hials.crosscom.internal.EnumNames;
import no.hials.crosscom.internal.VariableAccess;
import no.hials.crosscom.protocol.value.KrlValue;
import org.jspecify.annotations.Nullable;

/**
 * A variable whose values are those of a Java type. Only one thread at a time may use it.
 *
 * @param variable the variable
 * @param getter returns its value
 * @param setter sets its value
 */
record Slot<T>(KRLVariable variable, Supplier<T> getter, Consumer<T> setter) {
  private static final Map<Class<?>, Function<String, Slot<?>>> TYPES =
      Map.of(
          Integer.class, type(KRLInt::new, KRLInt::getValue, KRLInt::setValue),
          Double.class, type(KRLReal::new, KRLReal::getValue, KRLReal::setValue),
          Boolean.class, type(KRLBool::new, KRLBool::getValue, KRLBool::setValue),
          Character.class, type(KRLChar::new, KRLChar::getValue, KRLChar::setValue),
          String.class, type(KRLString::new, KRLString::getValue, KRLString::setValue),
          int[].class, type(KRLIntArray::new, KRLIntArray::getValue, KRLIntArray::setValue),
          double[].class, type(KRLRealArray::new, KRLRealArray::getValue, KRLRealArray::setValue),
          boolean[].class, type(KRLBoolArray::new, KRLBoolArray::getValue, KRLBoolArray::setValue),
          KrlValue.class,
              type(KRLAny::new, KRLAny::getValue, (any, value) -> any.getStringValue()));

  /** The names of those types in alphabetical order, for messages. */
  private static final String KNOWN_TYPES =
      TYPES.keySet().stream().map(Class::getSimpleName).sorted().collect(Collectors.joining(", "));

  private static <V extends KRLVariable, T> Function<String, Slot<?>> type(
      Function<String, V> constructor, Function<V, @Nullable T> getter, BiConsumer<V, T> setter) {
    return name -> {
      V variable = constructor.apply(name);
      return new Slot<T>(
          variable,
          () -> Objects.requireNonNull(getter.apply(variable)),
          value -> setter.accept(variable, value));
    };
  }

  /**
   * Creates a slot.
   *
   * @param name the variable's name
   * @throws IllegalArgumentException if the type maps to no KRL type
   */
  @SuppressWarnings("unchecked") // each entry of the table makes slots of its key
  static <T> Slot<T> of(String name, Class<T> type) {
    Function<String, Slot<?>> known = TYPES.get(type);
    if (known == null) {
      if (type.isEnum()) {
        known = enumOf(name, type);
      } else if (type.isRecord()) {
        known = recordOf(type.asSubclass(Record.class));
      } else {
        throw new IllegalArgumentException(
            name
                + ": the Java type must be one of "
                + KNOWN_TYPES
                + ", an enum or a record, is "
                + type.getTypeName());
      }
    }
    return (Slot<T>) known.apply(name);
  }

  private static <R extends Record> Function<String, Slot<?>> recordOf(Class<R> type) {
    return type(
        name -> new KRLRecord<>(name, type), KRLRecord<R>::getValue, KRLRecord<R>::setValue);
  }

  private static <T> Function<String, Slot<?>> enumOf(String name, Class<T> type) {
    EnumNames names;
    try {
      names = EnumNames.of(type);
    } catch (IllegalArgumentException e) {
      throw new IllegalArgumentException(name + " " + e.getMessage(), e);
    }
    return type(
        variableName -> VariableAccess.get().newEnum(variableName, type),
        variable -> {
          String text = variable.stringValue();
          Object constant = names.constant(text.substring(1));
          if (constant == null) {
            throw new IllegalArgumentException(
                "the answer of the controller must be " + names.expected() + ", is " + text);
          }
          return constant;
        },
        (variable, value) -> variable.setValue(names.name(value)));
  }

  /**
   * Returns the variable's value after a read.
   *
   * @throws CrossComValueException if it is not a value of the type
   */
  T value() throws CrossComValueException {
    try {
      return getter.get();
    } catch (IllegalArgumentException e) {
      throw new CrossComValueException(
          variable.getName(), variable.getStringValue(), String.valueOf(e.getMessage()), e);
    }
  }
}
