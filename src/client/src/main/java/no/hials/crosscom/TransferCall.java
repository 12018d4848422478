package no.hials.crosscom;

import java.util.concurrent.CancellationException;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.Executor;
import java.util.concurrent.RejectedExecutionException;
import java.util.concurrent.atomic.AtomicBoolean;
import no.hials.crosscom.internal.CancellableOperation;
import no.hials.crosscom.internal.Cancellation;
import org.jspecify.annotations.Nullable;

/**
 * A transfer that another thread does, and its result.
 *
 * <p>Other than an {@link AsyncCall} it can be cancelled while it runs, until what it does takes
 * effect: cancelling wins or loses against that, never half.
 */
final class TransferCall<T extends @Nullable Object> extends CompletableFuture<T>
    implements Cancellation {
  /** Set by whoever is first: the operation that is to take effect, or the caller who cancels. */
  private final AtomicBoolean decided = new AtomicBoolean();

  private final Executor callbacks;

  private TransferCall(Executor callbacks) {
    this.callbacks = callbacks;
  }

  /**
   * Queues a transfer.
   *
   * @param executor does it
   * @param callbacks completes the result, and so runs what the program does with it
   * @param operation the transfer
   */
  static <T extends @Nullable Object> CompletableFuture<T> submit(
      Executor executor, Executor callbacks, CancellableOperation<T> operation) {
    TransferCall<T> call = new TransferCall<>(callbacks);
    try {
      executor.execute(() -> call.run(operation));
    } catch (RejectedExecutionException e) {
      call.completeExceptionally(new CrossComClosedException("the client is closed", e, false));
    }
    return call;
  }

  private void run(CancellableOperation<T> operation) {
    if (isDone()) {
      return;
    }
    T result;
    try {
      result = operation.run(this);
    } catch (Exception | Error e) {
      callbacks.execute(() -> completeExceptionally(e));
      return;
    }
    callbacks.execute(() -> complete(result));
  }

  @Override
  public Executor defaultExecutor() {
    return callbacks;
  }

  @Override
  public void check() {
    if (isDone()) {
      throw cancelled();
    }
  }

  @Override
  public void commit() {
    if (isDone() || !decided.compareAndSet(false, true)) {
      throw cancelled();
    }
  }

  private static CancellationException cancelled() {
    return new CancellationException("the transfer was cancelled");
  }

  @Override
  public boolean cancel(boolean mayInterruptIfRunning) {
    return isCancelled()
        || (decided.compareAndSet(false, true) && super.cancel(mayInterruptIfRunning));
  }
}
