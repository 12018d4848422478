package no.hials.crosscom.lang;

import java.util.HashMap;
import java.util.Map;
import java.util.Objects;
import java.util.function.Consumer;
import java.util.stream.Stream;

/**
 * A switch over the classes of a sealed family, with a case for each class. A missing case is
 * reported when the switch is created; the compiler of Java 17 cannot report it.
 *
 * <p>Immutable, so thread-safe if its cases are.
 *
 * @param <T> the sealed family, such as {@link Statement}
 * @param <E> the exception that a case may throw
 */
public final class TypeSwitch<T, E extends Exception> {
  private final Map<Class<?>, Case<? super T, E>> cases;

  private TypeSwitch(Map<Class<?>, Case<? super T, E>> cases) {
    this.cases = Map.copyOf(cases);
  }

  /**
   * The code for the values of a class.
   *
   * @param <T> the class
   * @param <E> the exception that the code may throw
   */
  @FunctionalInterface
  public interface Case<T, E extends Exception> {
    /** Handles a value. */
    void handle(T value) throws E;
  }

  /**
   * The cases of a switch that is being created.
   *
   * @param <T> the sealed family
   * @param <E> the exception that a case may throw
   */
  public static final class Cases<T, E extends Exception> {
    private final Map<Class<?>, Case<? super T, E>> cases = new HashMap<>();

    private Cases() {}

    /**
     * Adds the case of a class, or of all classes that a sealed interface permits.
     *
     * @throws IllegalArgumentException if a class has a case already
     */
    public <S extends T> Cases<T, E> on(Class<S> type, Case<? super S, E> code) {
      leaves(type)
          .forEach(
              leaf -> {
                if (cases.put(leaf, value -> code.handle(type.cast(value))) != null) {
                  throw new IllegalArgumentException("two cases for " + leaf.getName());
                }
              });
      return this;
    }
  }

  /**
   * Creates a switch.
   *
   * @param family the sealed family
   * @param options adds the cases
   * @throws IllegalArgumentException if a class of the family has no case, or two
   */
  public static <T, E extends Exception> TypeSwitch<T, E> create(
      Class<T> family, Consumer<Cases<T, E>> options) {
    Cases<T, E> cases = new Cases<>();
    options.accept(cases);
    leaves(family)
        .filter(leaf -> !cases.cases.containsKey(leaf))
        .findAny()
        .ifPresent(
            leaf -> {
              throw new IllegalArgumentException("no case for " + leaf.getName());
            });
    return new TypeSwitch<>(cases.cases);
  }

  /** Runs the case of the class of a value. */
  public void handle(T value) throws E {
    Objects.requireNonNull(cases.get(value.getClass())).handle(value);
  }

  private static Stream<Class<?>> leaves(Class<?> type) {
    return type.isSealed()
        ? Stream.of(type.getPermittedSubclasses()).flatMap(TypeSwitch::leaves)
        : Stream.of(type);
  }
}
