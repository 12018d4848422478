package no.hials.crosscom.examples;

import java.io.IOException;
import java.util.Objects;
import no.hials.crosscom.CrossComClient;
import no.hials.crosscom.Server;
import no.hials.crosscom.c3.BridgeInfo;
import no.hials.crosscom.mock.MockServer;
import no.hials.crosscom.protocol.MessageType;
import no.hials.crosscom.protocol.ServerType;

/** Finds out the kind of server and its abilities, before a method needs them. */
public final class InspectTheServer {
  private InspectTheServer() {}

  /**
   * Runs the example.
   *
   * @param args {@code HOST PORT}, or nothing for a simulated controller of each kind
   * @throws IOException if an access failed
   */
  public static void main(String[] args) throws IOException {
    if (Arguments.nameAController(args)) {
      inspect(args[0], Integer.parseInt(args[1]));
      return;
    }
    for (ServerType type : ServerType.values()) {
      try (MockServer robot = MockServer.start(cfg -> cfg.server(type))) {
        inspect(robot.host(), robot.port());
      }
    }
  }

  private static void inspect(String host, int port) throws IOException {
    try (CrossComClient client = new CrossComClient(host, port)) {
      Server server = client.getServer(); // asked once per connection
      System.out.println("server: " + server.type());
      System.out.println("version: " + Objects.toString(server.version(), "unknown"));
      System.out.println("several at once: " + server.knows(MessageType.READ_MULTIPLE));
      System.out.println("files: " + server.knows(MessageType.CREATE_FILE));
      System.out.println("programs: " + server.knows(MessageType.PROGRAM_CONTROL));
      if (server.type() == ServerType.C3_BRIDGE) {
        BridgeInfo info = client.information().get();
        System.out.println("computer: " + info.host() + ", build: " + info.build());
      }
    }
  }
}
