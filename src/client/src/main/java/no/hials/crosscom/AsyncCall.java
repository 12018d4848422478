package no.hials.crosscom;

import java.util.concurrent.Callable;
import java.util.concurrent.CancellationException;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.Executor;
import java.util.concurrent.RejectedExecutionException;
import java.util.concurrent.ThreadPoolExecutor;
import java.util.concurrent.atomic.AtomicBoolean;
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

  private final ReconnectingConnection link;
  private @Nullable Thread runner;

  private final Executor callbacks;

  private AsyncCall(ReconnectingConnection link, Executor callbacks) {
    this.link = link;
    this.callbacks = callbacks;
  }

  @Override
  public Executor defaultExecutor() {
    return callbacks;
  }

  /**
   * Queues an operation.
   *
   * @param executor does it, in one thread
   * @param callbacks completes the result, and so runs what the program does with it; the common
   *     pool would not do, as it may have one thread only
   * @param link asks {@link #begin} before it sends
   * @param operation the operation
   */
  static <T extends @Nullable Object> CompletableFuture<T> submit(
      ThreadPoolExecutor executor,
      Executor callbacks,
      ReconnectingConnection link,
      Callable<T> operation) {
    AsyncCall<T> call = new AsyncCall<>(link, callbacks);
    try {
      executor.execute(() -> call.run(operation));
    } catch (RejectedExecutionException e) {
      call.completeExceptionally(new CrossComClosedException("the client is closed", e, false));
    }
    return call;
  }

  private void run(Callable<T> operation) {
    if (isDone()) {
      return;
    }
    T result;
    runner = Thread.currentThread();
    link.setUnsent(this);
    try {
      result = operation.call();
    } catch (Exception | Error e) {
      // what follows on the future is the program's code, which must not hold up other operations
      callbacks.execute(() -> completeExceptionally(e));
      return;
    } finally {
      link.setUnsent(null);
    }
    callbacks.execute(() -> complete(result));
  }

  /** Says whether the calling thread does this operation. */
  boolean isOwn() {
    return runner == Thread.currentThread();
  }

  /**
   * Begins the operation, now that its turn has come, unless it was cancelled.
   *
   * @throws CancellationException if it was
   */
  void begin() {
    if (isDone() || !decided.compareAndSet(false, true)) {
      throw new CancellationException("cancelled before it was sent");
    }
  }

  @Override
  public boolean cancel(boolean mayInterruptIfRunning) {
    return isCancelled()
        || (decided.compareAndSet(false, true) && super.cancel(mayInterruptIfRunning));
  }
}
