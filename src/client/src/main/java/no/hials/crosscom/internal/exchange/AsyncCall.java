package no.hials.crosscom.internal.exchange;

import java.util.concurrent.CancellationException;
import java.util.concurrent.Executor;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.BooleanSupplier;
import no.hials.crosscom.internal.CancellableOperation;
import no.hials.crosscom.internal.Cancellation;
import org.jspecify.annotations.Nullable;

/**
 * An operation in another thread, and its result.
 *
 * <p>The operation can be cancelled until it is committed: before its first exchange, or if it
 * transfers a file, before the transfer takes effect. If {@link #cancel} returns true, nothing was
 * sent or has effect; if the operation is committed, it returns false and the operation goes on.
 */
final class AsyncCall<T extends @Nullable Object> extends CallbackFuture<T>
    implements Cancellation {
  private enum State {
    OPEN,
    COMMITTED,
    CANCELLED
  }

  private final AtomicReference<State> state = new AtomicReference<>(State.OPEN);
  private final Runnable ended;

  /** Removes the call from the queue; returns whether it was there. Set before it is queued. */
  private BooleanSupplier dequeue = () -> false;

  /** Used by the thread that runs the call. */
  private BooleanSupplier condition = () -> true;

  /**
   * @param callbacks completes the result, which runs the program's callbacks
   * @param ended called after the program's callbacks
   */
  AsyncCall(Executor callbacks, Runnable ended) {
    super(callbacks);
    this.ended = ended;
  }

  void onCancel(BooleanSupplier newDequeue) {
    dequeue = newDequeue;
  }

  void run(CancellableOperation<T> operation) {
    if (isDone()) {
      ended.run();
      return;
    }
    T result;
    try {
      result = operation.run(this);
    } catch (Exception | Error e) {
      // the program's callbacks must not delay other operations
      end(callbacks, () -> completeExceptionally(e));
      return;
    } finally {
      // the operation may have sent something by another thread
      state.compareAndSet(State.OPEN, State.COMMITTED);
    }
    end(callbacks, () -> complete(result));
  }

  private void end(Executor executor, Runnable completion) {
    executor.execute(
        () -> {
          try {
            completion.run();
          } finally {
            ended.run();
          }
        });
  }

  /** Fails without having run. */
  void refuse(Executor executor, Exception failure) {
    end(executor, () -> completeExceptionally(failure));
  }

  @Override
  public void check() {
    if (isDone()) {
      throw cancelled();
    }
  }

  @Override
  public void commit() {
    if (state.get() == State.COMMITTED) {
      return;
    }
    if (!condition.getAsBoolean()) {
      boolean unused = cancel(false);
    }
    if (isDone() || !state.compareAndSet(State.OPEN, State.COMMITTED)) {
      throw cancelled();
    }
  }

  @Override
  public void commitIf(BooleanSupplier newCondition) {
    condition = newCondition;
  }

  private static CancellationException cancelled() {
    return new CancellationException("cancelled before it was sent");
  }

  @Override
  public boolean cancel(boolean mayInterruptIfRunning) {
    if (isCancelled()) {
      return true;
    }
    if (!state.compareAndSet(State.OPEN, State.CANCELLED)) {
      return false;
    }
    try {
      return super.cancel(mayInterruptIfRunning);
    } finally {
      if (dequeue.getAsBoolean()) {
        ended.run(); // otherwise the thread that runs the call does it
      }
    }
  }
}
