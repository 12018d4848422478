package no.hials.crosscom.cell;

import java.io.IOException;
import java.time.Duration;
import java.util.concurrent.CancellationException;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.RejectedExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import org.jspecify.annotations.Nullable;

/** Waits for calls of {@link no.hials.crosscom.CrossComClient#async}. */
public final class AsyncCalls {
  private AsyncCalls() {}

  /**
   * Waits for the end of a call, and cancels it if the client has not sent it within a time.
   *
   * @param call a future whose {@code cancel} returns false once the call has been sent
   * @param sendWithin the time from now; zero or less if it is over
   * @return the result of the call
   * @throws NotSentException if the call was not sent in time, or the client had too many calls
   * @throws CancellationException if somebody else has cancelled the call
   * @throws IOException if the call failed
   * @throws InterruptedException if the wait was interrupted; the call goes on
   */
  public static <T extends @Nullable Object> T await(CompletableFuture<T> call, Duration sendWithin)
      throws IOException, InterruptedException {
    try {
      try {
        return call.get(Math.max(0, sendWithin.toNanos()), TimeUnit.NANOSECONDS);
      } catch (TimeoutException e) {
        if (call.cancel(false)) {
          throw new NotSentException("it waited too long for the connection to the robot");
        }
        return call.get();
      }
    } catch (ExecutionException e) {
      Throwable cause = e.getCause();
      if (cause instanceof IOException failure) {
        throw failure;
      }
      if (cause instanceof RejectedExecutionException full) {
        throw new NotSentException(String.valueOf(full.getMessage()));
      }
      if (cause instanceof RuntimeException failure) {
        throw failure;
      }
      throw new IOException(cause);
    }
  }
}
