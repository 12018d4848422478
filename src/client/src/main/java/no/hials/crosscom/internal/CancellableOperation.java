package no.hials.crosscom.internal;

/**
 * An operation that can be cancelled while it runs.
 *
 * @param <T> what it gives
 */
@FunctionalInterface
public interface CancellableOperation<T> {
  /**
   * Does it.
   *
   * @param cancellation to be asked on the way
   * @return the result
   * @throws Exception if it fails
   */
  T run(Cancellation cancellation) throws Exception;
}
