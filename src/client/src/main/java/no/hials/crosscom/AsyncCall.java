package no.hials.crosscom;

import java.util.concurrent.Callable;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.RejectedExecutionException;
import java.util.concurrent.ThreadPoolExecutor;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.locks.Lock;
import org.jspecify.annotations.Nullable;

/**
 * An operation that another thread does, and its result.
 *
 * <p>Cancelling wins or loses against sending, never half: if {@link #cancel} gives true, nothing
 * was sent; if the operation has begun, it gives false and the operation goes on.
 */
final class AsyncCall<T extends @Nullable Object> extends CompletableFuture<T> {
  /** Set by whoever is first: the operation that begins, or the caller who cancels. */
  private final AtomicBoolean decided = new AtomicBoolean();

  private AsyncCall() {}

  /**
   * Queues an operation.
   *
   * @param executor does it
   * @param lock is held while it is done, so that it has begun only when its turn has come
   * @param operation the operation
   */
  static <T extends @Nullable Object> CompletableFuture<T> submit(
      ThreadPoolExecutor executor, Lock lock, Callable<T> operation) {
    AsyncCall<T> call = new AsyncCall<>();
    try {
      executor.execute(() -> call.run(lock, operation));
    } catch (RejectedExecutionException e) {
      call.completeExceptionally(new CrossComClosedException("the client is closed", e, false));
    }
    return call;
  }

  private void run(Lock lock, Callable<T> operation) {
    T result;
    lock.lock();
    try {
      if (isDone() || !decided.compareAndSet(false, true)) {
        return;
      }
      result = operation.call();
    } catch (Exception | Error e) {
      // what follows on the future is the program's code, which must not hold up other operations
      defaultExecutor().execute(() -> completeExceptionally(e));
      return;
    } finally {
      lock.unlock();
    }
    defaultExecutor().execute(() -> complete(result));
  }

  @Override
  public boolean cancel(boolean mayInterruptIfRunning) {
    return isCancelled()
        || (decided.compareAndSet(false, true) && super.cancel(mayInterruptIfRunning));
  }
}
