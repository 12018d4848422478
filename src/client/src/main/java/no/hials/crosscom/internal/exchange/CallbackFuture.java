package no.hials.crosscom.internal.exchange;

import java.util.concurrent.CompletableFuture;
import java.util.concurrent.Executor;
import org.jspecify.annotations.Nullable;

/** A future whose asynchronous functions, and those of its dependents, run in an executor. */
public class CallbackFuture<T extends @Nullable Object> extends CompletableFuture<T> {
  final Executor callbacks;

  /**
   * @param callbacks runs the functions; the common pool may have only one thread
   */
  public CallbackFuture(Executor callbacks) {
    this.callbacks = callbacks;
  }

  @Override
  public final <U> CompletableFuture<U> newIncompleteFuture() {
    return new CallbackFuture<>(callbacks);
  }

  @Override
  public final Executor defaultExecutor() {
    return callbacks;
  }
}
