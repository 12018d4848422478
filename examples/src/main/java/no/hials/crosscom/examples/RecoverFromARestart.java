package no.hials.crosscom.examples;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.time.Duration;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import no.hials.crosscom.ClientConfig;
import no.hials.crosscom.CrossComAccessException;
import no.hials.crosscom.CrossComClient;
import no.hials.crosscom.CrossComException;
import no.hials.crosscom.CrossComValueException;
import no.hials.crosscom.mock.Fault;
import no.hials.crosscom.mock.MockServer;
import no.hials.crosscom.protocol.value.Axis;

/**
 * Writes a structure while the controller restarts: waits until it is back, looks whether the write
 * was executed, and writes again if not. It needs the simulation, which refuses connections for a
 * while.
 */
public final class RecoverFromARestart {
  private RecoverFromARestart() {}

  /**
   * Runs the example.
   *
   * @param args not used
   * @throws IOException if an access failed unexpectedly
   */
  public static void main(String[] args) throws IOException {
    try (MockServer robot = MockServer.start();
        CrossComClient client = new CrossComClient(config(robot))) {
      Axis target = client.read("$AXIS_ACT", Axis.class).with(0, 12.3456789);
      robot.refuseConnections();
      robot.enqueue(Fault.closeBefore()); // the write is lost
      CompletableFuture.delayedExecutor(500, TimeUnit.MILLISECONDS)
          .execute(() -> startAgain(robot));

      write(client, "MYAXIS", target);

      robot.enqueue(Fault.dropAnswer()); // the answer is lost
      write(client, "MYAXIS", target.with(0, 23.456789));
      System.out.println(client.statistics());
    }
  }

  private static ClientConfig config(MockServer robot) {
    return ClientConfig.create(
        robot.host(), cfg -> cfg.port(robot.port()).requestTimeout(Duration.ofMillis(500)));
  }

  private static void write(CrossComClient client, String name, Axis value) throws IOException {
    while (true) {
      try {
        client.write(name, value);
        System.out.println("it was written");
        return;
      } catch (CrossComAccessException | CrossComValueException e) {
        throw e; // refused: to write it again would not help
      } catch (CrossComException e) {
        System.out.println(e.getMessage());
        client.connected().join(); // connects in the background
        if (e.isOutcomeUnknown() && isAbout(client.read(name, Axis.class), value)) {
          System.out.println("it had been written");
          return;
        }
      }
    }
  }

  /** Compares with a tolerance: the controller has 32-bit values, and prints them rounded. */
  private static boolean isAbout(Axis found, Axis written) {
    return found.largestDifference(written) < 0.001;
  }

  private static void startAgain(MockServer robot) {
    try {
      robot.acceptConnections();
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}
