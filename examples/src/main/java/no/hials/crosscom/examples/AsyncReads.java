package no.hials.crosscom.examples;

import java.io.IOException;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import no.hials.crosscom.CrossComAccessException;
import no.hials.crosscom.CrossComClient;

/** Reads without waiting for the answers, combines two of them, and handles a failure. */
public final class AsyncReads {
  private AsyncReads() {}

  /**
   * Runs the example.
   *
   * @param args {@code HOST PORT}, or nothing for a simulated controller
   * @throws IOException if connecting failed
   * @throws ExecutionException if reading failed
   * @throws InterruptedException if the wait was interrupted
   * @throws TimeoutException if the answers took more than 10 s
   */
  public static void main(String[] args)
      throws IOException, ExecutionException, InterruptedException, TimeoutException {
    try (ExampleConnection connection = ExampleConnection.of(args)) {
      read(connection.client());
    }
  }

  private static void read(CrossComClient client)
      throws ExecutionException, InterruptedException, TimeoutException {
    // This saves no time, since the server answers one request at a time. But this thread stays
    // free, as a user interface needs.
    CompletableFuture<String> mode = client.async(c -> c.readText("$MODE_OP"));
    CompletableFuture<String> override = client.async(c -> c.readText("$OV_PRO"));
    System.out.println("asked for the mode and the override");

    CompletableFuture<String> both = mode.thenCombine(override, (m, o) -> m + " at " + o + " %");
    System.out.println(both.get(10, TimeUnit.SECONDS));

    try {
      client.async(c -> c.readText("NO_SUCH_VARIABLE")).get(10, TimeUnit.SECONDS);
    } catch (ExecutionException e) {
      // the cause is the exception of the blocking method
      if (e.getCause() instanceof CrossComAccessException refused) {
        System.out.println("refused: " + refused.getVariable());
      } else {
        throw e;
      }
    }
  }
}
