package no.hials.crosscom.mock.internal;

import java.util.HashMap;
import java.util.Map;
import java.util.Objects;
import java.util.function.Function;
import java.util.stream.Stream;

/**
 * A switch over the classes of a sealed family, with a result. {@link #complete} reports a missing
 * case; the compiler of Java 17 cannot report it.
 *
 * @param <T> the sealed family
 * @param <R> the result
 */
public final class SealedSwitch<T, R> {
  private final Class<T> family;
  private final Map<Class<?>, Function<T, R>> cases = new HashMap<>();

  private SealedSwitch(Class<T> family) {
    this.family = family;
  }

  /** Creates a switch without cases. */
  public static <T, R> SealedSwitch<T, R> over(Class<T> family) {
    return new SealedSwitch<>(family);
  }

  /**
   * Adds the case of a class, or of all classes that a sealed interface permits. It replaces an
   * earlier case.
   */
  public <S extends T> SealedSwitch<T, R> on(Class<S> type, Function<? super S, R> code) {
    classes(type).forEach(leaf -> cases.put(leaf, value -> code.apply(type.cast(value))));
    return this;
  }

  /**
   * Checks that every class of the family has a case.
   *
   * @throws IllegalStateException if a class has none
   */
  public SealedSwitch<T, R> complete() {
    classes(family)
        .filter(leaf -> !cases.containsKey(leaf))
        .forEach(
            leaf -> {
              throw new IllegalStateException("no case for " + leaf.getName());
            });
    return this;
  }

  /** Returns the result of the case of the value's class. */
  public R apply(T value) {
    return Objects.requireNonNull(cases.get(value.getClass())).apply(value);
  }

  private static Stream<Class<?>> classes(Class<?> type) {
    return type.isSealed()
        ? Stream.of(type.getPermittedSubclasses()).flatMap(SealedSwitch::classes)
        : Stream.of(type);
  }
}
