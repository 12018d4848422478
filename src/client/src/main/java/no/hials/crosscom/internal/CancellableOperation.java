package no.hials.crosscom.internal;

import org.jspecify.annotations.Nullable;

/**
 * An operation that can be cancelled while it runs.
 *
 * @param <T> the type of its result
 */
@FunctionalInterface
public interface CancellableOperation<T extends @Nullable Object> {
  /** Runs the operation, which must check the cancellation between exchanges. */
  @Nullable T run(Cancellation cancellation) throws Exception;
}
