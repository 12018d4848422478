package no.hials.crosscom.examples;

import java.io.IOException;
import java.net.InetAddress;
import java.time.Duration;
import java.util.List;
import no.hials.crosscom.c3.Discovery;
import no.hials.crosscom.c3.DiscoveryConfig;
import no.hials.crosscom.c3.FoundServer;
import no.hials.crosscom.mock.MockServer;
import no.hials.crosscom.protocol.ServerType;

/** Finds the controllers in the network, and prints their descriptions. */
public final class DiscoverServers {
  private static final Duration TIME = Duration.ofMillis(500);

  private DiscoverServers() {}

  /**
   * Runs the example.
   *
   * @param args the addresses to search, also broadcast addresses such as {@code 192.168.1.255}; or
   *     nothing for a simulated controller
   * @throws IOException if nothing could be sent
   */
  public static void main(String[] args) throws IOException {
    if (args.length > 0) {
      InetAddress[] addresses = new InetAddress[args.length];
      for (int i = 0; i < args.length; i++) {
        addresses[i] = InetAddress.getByName(args[i]);
      }
      print(Discovery.find(DiscoveryConfig.create(cfg -> cfg.addresses(addresses).timeout(TIME))));
      return;
    }
    try (MockServer robot =
        MockServer.start(cfg -> cfg.server(ServerType.C3_BRIDGE).standardDiscoveryPort(0))) {
      // without the legacy mode, whose answers come to a fixed port of this computer
      DiscoveryConfig config =
          DiscoveryConfig.create(
              cfg ->
                  cfg.addresses(robot.address().getAddress())
                      .standardPort(robot.standardDiscoveryPort().orElseThrow())
                      .legacy(false)
                      .timeout(TIME));
      print(Discovery.find(config));
    }
  }

  private static void print(List<FoundServer> servers) {
    System.out.println(servers.size() + " found");
    for (FoundServer server : servers) {
      System.out.println(server.model() + ", serial number " + server.serialNumber());
      System.out.println(
          server.type() + " at " + server.address().getHostAddress() + ":" + server.port());
    }
  }
}
