package no.hials.crosscom;

import org.jspecify.annotations.Nullable;

/**
 * Operations of a client that return a result, for {@link CrossComClient#async}.
 *
 * @param <T> the type of the result
 */
@FunctionalInterface
public interface CrossComFunction<T extends @Nullable Object> {
  /**
   * Does the operations.
   *
   * @param client the client to use
   * @return the result
   * @throws Exception if an operation fails; the future fails with the same exception
   */
  T apply(CrossComClient client) throws Exception;
}
