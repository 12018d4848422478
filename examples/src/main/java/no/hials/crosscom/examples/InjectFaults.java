package no.hials.crosscom.examples;

import java.io.IOException;
import java.time.Duration;
import java.util.LinkedHashMap;
import java.util.Map;
import no.hials.crosscom.ClientConfig;
import no.hials.crosscom.CrossComClient;
import no.hials.crosscom.mock.Fault;
import no.hials.crosscom.mock.MockServer;

/**
 * Lets the simulated server fail in several ways, and shows the exceptions: a program never gets a
 * wrong value.
 */
public final class InjectFaults {
  private InjectFaults() {}

  /**
   * Runs the example. It needs the simulation, which fails on demand.
   *
   * @param args not used
   * @throws IOException if connecting failed
   */
  public static void main(String[] args) throws IOException {
    Map<String, Fault> faults = new LinkedHashMap<>();
    faults.put("no fault", Fault.none());
    faults.put("a slow answer", Fault.delay(Duration.ofMillis(20)));
    faults.put("an answer in single bytes", Fault.oneByteAtATime());
    faults.put("no answer", Fault.drop());
    faults.put("the answer to something else", Fault.wrongId());
    faults.put("half an answer", Fault.closeDuring(4));
    faults.put("an empty answer", Fault.emptyAnswer());
    faults.put("noise", Fault.garbage(1, 40));

    try (MockServer robot = MockServer.start()) {
      ClientConfig config =
          ClientConfig.create(
              robot.host(), cfg -> cfg.port(robot.port()).requestTimeout(Duration.ofMillis(500)));
      for (Map.Entry<String, Fault> fault : faults.entrySet()) {
        robot.clearFaults();
        robot.fault(request -> true, fault.getValue()); // also for the repeated read
        // a new connection each time, since some faults close it
        try (CrossComClient client = new CrossComClient(config)) {
          System.out.println(fault.getKey() + ": " + read(client));
        }
      }
    }
  }

  private static String read(CrossComClient client) {
    try {
      return client.readInt("$OV_PRO") + " %";
    } catch (IOException e) {
      return e.getClass().getSimpleName();
    }
  }
}
