package no.hials.crosscom.gateway;

import java.nio.file.Files;
import java.nio.file.Path;
import no.hials.crosscom.mock.MockServer;
import no.hials.crosscom.mock.junit.KukaController;
import org.eclipse.milo.opcua.sdk.client.OpcUaClient;
import org.eclipse.milo.opcua.stack.core.UaException;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/** A gateway with one simulated robot and an OPC UA server, and a client. */
@Timeout(60)
abstract class OpcUaServerTest {
  @KukaController MockServer robot;

  /** Shared by all tests of a class, since the server's key takes time to create. */
  @TempDir static Path folder;

  OpcUaPlant plant;
  OpcUaClient client;

  /** Returns the configuration, in which the password of a user such as anna is "of anna". */
  abstract String config();

  /** Returns the beginning of the configuration, the table of the robot cell1. */
  final String cell1() {
    return "[robots.cell1]\nhost = \"%s\"\nport = %d\n".formatted(robot.host(), robot.port());
  }

  @BeforeEach
  void start() throws Exception {
    Files.deleteIfExists(folder.resolve("audit.jsonl"));
    for (String user : new String[] {"anna", "vera"}) {
      Files.writeString(folder.resolve(user + ".txt"), "of " + user + "\n");
    }
    plant = new OpcUaPlant(folder, config());
    client = plant.connect();
  }

  @AfterEach
  void close() throws UaException {
    client.disconnect();
    plant.close();
  }
}
