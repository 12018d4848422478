package no.hials.crosscom.examples;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import no.hials.crosscom.CrossComClient;
import no.hials.crosscom.CrossComException;
import no.hials.crosscom.mock.Fault;
import no.hials.crosscom.mock.MockServer;
import no.hials.crosscom.protocol.value.E6Pos;

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
        CrossComClient client = new CrossComClient(robot.host(), robot.port())) {
      E6Pos target = client.read("$POS_ACT", E6Pos.class);
      robot.refuseConnections();
      robot.enqueue(Fault.closeBefore()); // the write is lost
      CompletableFuture.delayedExecutor(500, TimeUnit.MILLISECONDS)
          .execute(() -> startAgain(robot));

      write(client, "MYPOS", target);
      System.out.println(client.statistics());
    }
  }

  private static void write(CrossComClient client, String name, E6Pos value) throws IOException {
    while (true) {
      try {
        client.write(name, value);
        System.out.println("it was written");
        return;
      } catch (CrossComException e) {
        System.out.println(e.getMessage());
        client.connected().join(); // connects in the background
        if (e.isOutcomeUnknown() && client.read(name, E6Pos.class).equals(value)) {
          System.out.println("it had been written");
          return;
        }
      }
    }
  }

  private static void startAgain(MockServer robot) {
    try {
      robot.acceptConnections();
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}
