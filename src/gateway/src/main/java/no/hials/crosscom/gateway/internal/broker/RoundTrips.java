package no.hials.crosscom.gateway.internal.broker;

import java.util.concurrent.CompletableFuture;
import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;

/**
 * Asks a broker whether it has handled what was sent before. One question at a time is under way;
 * what is sent meanwhile shares the next one. Thread-safe.
 */
final class RoundTrips {
  private final Supplier<CompletableFuture<?>> question;
  private @Nullable CompletableFuture<@Nullable Void> running;
  private @Nullable CompletableFuture<@Nullable Void> next;

  /**
   * Creates an object without questions.
   *
   * @param question sends a question; completes with the answer
   */
  RoundTrips(Supplier<CompletableFuture<?>> question) {
    this.question = question;
  }

  /** Returns a future that completes when the broker has handled what was sent before the call. */
  synchronized CompletableFuture<@Nullable Void> next() {
    CompletableFuture<@Nullable Void> result = next == null ? new CompletableFuture<>() : next;
    if (running == null) {
      ask(result);
    } else {
      next = result;
    }
    return result;
  }

  private void ask(CompletableFuture<@Nullable Void> result) {
    running = result;
    CompletableFuture<?> unused =
        question.get().whenComplete((answer, failure) -> ended(result, failure));
  }

  private void ended(CompletableFuture<@Nullable Void> result, @Nullable Throwable failure) {
    synchronized (this) {
      CompletableFuture<@Nullable Void> waiting = next;
      running = null;
      next = null;
      if (waiting != null) {
        ask(waiting);
      }
    }
    if (failure == null) {
      result.complete(null);
    } else {
      result.completeExceptionally(failure);
    }
  }
}
