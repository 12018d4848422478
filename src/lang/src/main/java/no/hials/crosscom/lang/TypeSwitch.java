package no.hials.crosscom.lang;

import java.util.HashMap;
import java.util.Map;
import java.util.Objects;
import java.util.function.Consumer;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;

/**
 * A switch over the classes of a sealed family such as {@link Statement}, with a case for each
 * class. A missing case is reported when the switch is created; the compiler of Java 17 cannot
 * report it. The simulated controller executes trees by it, and the mock server answers messages.
 *
 * <p>Immutable, so thread-safe if its cases are. A class keeps its switch in a static field, whose
 * cases are methods such as {@code Compiler::branch}.
 *
 * @param <C> the context that the cases use, such as the object whose methods they are
 * @param <T> the sealed family, such as {@code Statement}
 * @param <R> the result; {@link Void} for cases without a result
 * @param <E> the exception that a case may throw
 */
public final class TypeSwitch<C, T, R, E extends Exception> {
  private final Map<Class<?>, TypeCase<C, ? super T, R, E>> cases;

  private TypeSwitch(Map<Class<?>, TypeCase<C, ? super T, R, E>> cases) {
    this.cases = Map.copyOf(cases);
  }

  /** The code for the values of a class. */
  @FunctionalInterface
  public interface TypeCase<C, T, R, E extends Exception> {
    /**
     * Returns the result for a value.
     *
     * @return the result; null in a switch that is only {@linkplain TypeSwitch#run run}
     */
    @Nullable R apply(C context, T value) throws E;
  }

  /** The code for the values of a class, without a result. */
  @FunctionalInterface
  public interface VoidCase<C, T, E extends Exception> {
    /** Handles a value. */
    void run(C context, T value) throws E;
  }

  /** The cases of a switch that is being created. */
  public static final class Cases<C, T, R, E extends Exception> {
    private final Class<T> family;
    private final Map<Class<?>, TypeCase<C, ? super T, R, E>> cases = new HashMap<>();

    private Cases(Class<T> family) {
      this.family = family;
    }

    /** Adds the case of a class, or of all classes that a sealed interface permits. */
    public <S extends T> Cases<C, T, R, E> on(Class<S> type, TypeCase<C, ? super S, R, E> code) {
      leaves(type)
          .forEach(
              leaf -> {
                TypeCase<C, T, R, E> cast =
                    (context, value) -> code.apply(context, type.cast(value));
                if (cases.put(leaf, cast) != null) {
                  throw new IllegalArgumentException("two cases for " + leaf.getName());
                }
              });
      return this;
    }

    /** Adds a case without a result, see {@link #on}. */
    public <S extends T> Cases<C, T, R, E> run(Class<S> type, VoidCase<C, ? super S, E> code) {
      return on(
          type,
          (context, value) -> {
            code.run(context, value);
            return null;
          });
    }

    /** Adds a case without a result for all classes that have no case yet. */
    public Cases<C, T, R, E> otherwise(VoidCase<C, ? super T, E> code) {
      leaves(family)
          .forEach(
              leaf ->
                  cases.putIfAbsent(
                      leaf,
                      (context, value) -> {
                        code.run(context, value);
                        return null;
                      }));
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
  public static <C, T, R, E extends Exception> TypeSwitch<C, T, R, E> create(
      Class<T> family, Consumer<Cases<C, T, R, E>> options) {
    Cases<C, T, R, E> cases = new Cases<>(family);
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

  /**
   * Returns the result of the case of the class of a value.
   *
   * @throws NullPointerException if the case has no result
   */
  public R apply(C context, T value) throws E {
    return Objects.requireNonNull(
        find(value).apply(context, value),
        () -> "the case for " + value.getClass().getName() + " has no result");
  }

  /** Runs the case of the class of a value and ignores its result. */
  public void run(C context, T value) throws E {
    find(value).apply(context, value);
  }

  private TypeCase<C, ? super T, R, E> find(T value) {
    return Objects.requireNonNull(cases.get(value.getClass()));
  }

  private static Stream<Class<?>> leaves(Class<?> type) {
    return type.isSealed()
        ? Stream.of(type.getPermittedSubclasses()).flatMap(TypeSwitch::leaves)
        : Stream.of(type);
  }
}
