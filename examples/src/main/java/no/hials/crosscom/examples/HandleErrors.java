package no.hials.crosscom.examples;

import java.io.IOException;
import java.time.Duration;
import no.hials.crosscom.ClientConfig;
import no.hials.crosscom.CrossComAccessException;
import no.hials.crosscom.CrossComClient;
import no.hials.crosscom.CrossComException;
import no.hials.crosscom.mock.MockServer;

/** Shows the exceptions of failed accesses, and how to set time limits. */
public final class HandleErrors {
  private HandleErrors() {}

  /**
   * Runs the example.
   *
   * @param args not used
   * @throws IOException if connecting failed
   */
  public static void main(String[] args) throws IOException {
    try (MockServer robot = MockServer.start()) {
      ClientConfig config =
          ClientConfig.create(
              robot.host(), cfg -> cfg.port(robot.port()).requestTimeout(Duration.ofMillis(500)));
      try (CrossComClient client = new CrossComClient(config)) {
        access(client);
      }
    }
  }

  private static void access(CrossComClient client) {
    try {
      System.out.println("MYSPEED = " + client.readInt("MYSPEED"));
    } catch (CrossComAccessException e) {
      System.out.println(e.getVariable() + ": " + e.getMessage());
    } catch (IOException e) {
      System.out.println("no answer: " + e.getMessage());
    }

    try {
      client.writeInt("MYSPEED", 10);
    } catch (CrossComException e) {
      System.out.println(
          e.isOutcomeUnknown() ? "check before you write again" : "nothing was written");
    } catch (IOException e) {
      System.out.println(e.getMessage());
    }
  }
}
