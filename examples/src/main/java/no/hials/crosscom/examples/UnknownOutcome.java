package no.hials.crosscom.examples;

import java.io.IOException;
import java.time.Duration;
import no.hials.crosscom.ClientConfig;
import no.hials.crosscom.CrossComClient;
import no.hials.crosscom.CrossComException;
import no.hials.crosscom.mock.Fault;
import no.hials.crosscom.mock.MockServer;

/**
 * Writes twice without an answer, and then checks the outcome: the first write was executed, the
 * second was not. It needs the simulation, which loses the answers.
 */
public final class UnknownOutcome {
  private UnknownOutcome() {}

  /**
   * Runs the example.
   *
   * @param args not used
   * @throws IOException if an access failed unexpectedly
   */
  public static void main(String[] args) throws IOException {
    try (MockServer robot = MockServer.start()) {
      ClientConfig config =
          ClientConfig.create(
              robot.host(), cfg -> cfg.port(robot.port()).requestTimeout(Duration.ofMillis(200)));
      try (CrossComClient client = new CrossComClient(config)) {
        System.out.println("the answer is lost");
        robot.enqueue(Fault.dropAnswer());
        write(client, 7);

        System.out.println("the request is lost");
        robot.enqueue(Fault.drop());
        write(client, 8);

        System.out.println("the connection is closed while reading");
        robot.enqueue(Fault.closeBefore());
        System.out.println(
            "MYINT = " + client.readInt("MYINT")); // reads are repeated automatically
      }
    }
  }

  private static void write(CrossComClient client, int value) throws IOException {
    try {
      client.writeInt("MYINT", value);
    } catch (CrossComException e) {
      if (!e.isOutcomeUnknown()) {
        throw e;
      }
      int found = client.readInt("MYINT");
      System.out.println(
          found == value ? "it was written" : "it was not written, MYINT = " + found);
    }
  }
}
