package no.hials.crosscom.gateway.internal.broker;

import java.util.concurrent.CompletableFuture;
import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;

/**
 * Asks a broker whether it has handled what was sent before. The messages sent since a question
 * share the next one, which is asked when the others are answered, or after some bytes, so that a
 * slow connection has answers all the time. Thread-safe.
 */
final class RoundTrips {
  private final Supplier<CompletableFuture<?>> question;

  /**
   * Completes with the answer to the next question; null if nothing was sent since the last one.
   */
  private @Nullable CompletableFuture<@Nullable Void> next;

  private long bytes;
  private int running;

  /**
   * Creates an object without questions.
   *
   * @param question sends a question; completes with the answer
   */
  RoundTrips(Supplier<CompletableFuture<?>> question) {
    this.question = question;
  }

  /**
   * Returns a future that completes when the broker has handled what was sent before the call.
   *
   * @param size the size of the message that was sent
   * @param most the number of bytes after which a question is asked, also if others are not
   *     answered
   */
  synchronized CompletableFuture<@Nullable Void> next(int size, int most) {
    CompletableFuture<@Nullable Void> result = next == null ? new CompletableFuture<>() : next;
    next = result;
    bytes += size;
    if (running == 0 || bytes >= most) {
      ask(result);
    }
    return result;
  }

  private void ask(CompletableFuture<@Nullable Void> result) {
    next = null;
    bytes = 0;
    running++;
    CompletableFuture<?> unused =
        question.get().whenComplete((answer, failure) -> ended(result, failure));
  }

  private void ended(CompletableFuture<@Nullable Void> result, @Nullable Throwable failure) {
    synchronized (this) {
      running--;
      if (next != null && running == 0) {
        ask(next);
      }
    }
    if (failure == null) {
      result.complete(null);
    } else {
      result.completeExceptionally(failure);
    }
  }
}
