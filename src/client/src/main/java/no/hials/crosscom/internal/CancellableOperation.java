package no.hials.crosscom.internal;

import org.jspecify.annotations.Nullable;

/**
 * An operation that can be cancelled while it runs.
 *
 * @param <T> the type of its result
 */
@FunctionalInterface
public interface CancellableOperation<T extends @Nullable Object> {
  /**
   * Runs the operation.
   *
   * @param cancellation to be asked on the way
   * @return the result, or null if it has none
   * @throws Exception if it fails
   */
  @Nullable T run(Cancellation cancellation) throws Exception;
}
