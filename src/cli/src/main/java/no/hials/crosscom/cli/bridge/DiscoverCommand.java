package no.hials.crosscom.cli.bridge;

import com.fasterxml.jackson.core.JsonGenerator;
import java.io.IOException;
import java.net.BindException;
import java.net.Inet4Address;
import java.net.InetAddress;
import java.net.NetworkInterface;
import java.net.SocketException;
import java.net.UnknownHostException;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import no.hials.crosscom.c3.Discovery;
import no.hials.crosscom.c3.DiscoveryConfig;
import no.hials.crosscom.c3.FoundServer;
import no.hials.crosscom.cell.JsonLine;
import no.hials.crosscom.cli.base.CannotListenException;
import no.hials.crosscom.cli.base.ConsoleCommand;
import no.hials.crosscom.cli.base.Converters;
import no.hials.crosscom.cli.base.ExitCode;
import no.hials.crosscom.cli.base.Table;
import no.hials.crosscom.protocol.ServerType;
import no.hials.crosscom.protocol.Version;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;

/** {@code discover}. */
@Command(
    name = "discover",
    description =
        "Searches the network for controllers by UDP and prints each robot's model and serial"
            + " number, and the type, version and address of its server. Exit code 3 if none"
            + " answers.",
    footer = {
      "",
      "In standard mode, C3 Bridge answers on UDP port 7000. In legacy mode, KUKAVARPROXY and C3"
          + " Bridge answer on port 6999, to port 7000 of this computer. Only one program can use"
          + " that port: if it is in use, the command prints a message and uses standard mode"
          + " only, unless --legacy is given. Routers do not forward broadcasts; use --address"
          + " for a controller in another network.",
      "",
      "JSON: one object per server (JSON Lines) with model, serial, type (C3_BRIDGE or"
          + " KUKAVARPROXY), version, host and port. An unknown version is null; other unknown"
          + " values are empty.",
      "",
      "Examples:",
      "  jopenshowvar discover",
      "  jopenshowvar discover --interface eth1 --timeout 3s",
      "  jopenshowvar discover --address 172.31.1.147 --json"
    })
public final class DiscoverCommand extends ConsoleCommand {
  @Option(
      names = "--timeout",
      paramLabel = "TIME",
      description = "How long to collect answers, such as 500ms, 3s. Default: 1s.")
  private Duration timeout = Duration.ofSeconds(1);

  @Option(
      names = "--address",
      paramLabel = "HOST",
      description = "Ask this IPv4 address, of a host or for broadcasts. Can be repeated.")
  private List<String> addresses = new ArrayList<>();

  @Option(
      names = "--interface",
      paramLabel = "NAME",
      description =
          "Broadcast on this network interface, such as eth0. Can be repeated. Default without"
              + " --address: all interfaces.")
  private List<String> interfaces = new ArrayList<>();

  @Option(
      names = "--legacy",
      negatable = true,
      fallbackValue = "true",
      description =
          "Fail if legacy mode is not possible. With --no-legacy: use standard mode" + " only.")
  private @Nullable Boolean legacy;

  @Option(
      names = "--ports",
      paramLabel = "STANDARD,LEGACY,REPLY",
      split = ",",
      hideParamSyntax = true,
      converter = Converters.ListeningPort.class,
      description = "The UDP ports to use. Default: 7000,6999,7000.")
  private List<Integer> ports = List.of(7000, 6999, 7000);

  @Option(names = "--json", description = "Print JSON, see below.")
  private boolean json;

  @Override
  public ExitCode run() throws IOException {
    if (ports.size() != 3 || ports.get(0) == 0 || ports.get(1) == 0) {
      throw wrongUsage("--ports needs three numbers, of which only the last may be 0");
    }
    List<FoundServer> servers = find();
    if (servers.isEmpty()) {
      console().error("no server answered within " + timeout.toMillis() + " ms");
      return ExitCode.NOT_CONNECTED;
    }
    if (json) {
      servers.forEach(
          server -> console().print(JsonLine.object(out -> DiscoverCommand.write(out, server))));
    } else {
      print(servers);
    }
    return ExitCode.DONE;
  }

  private List<FoundServer> find() throws CannotListenException {
    if (legacy != null) {
      return find(legacy);
    }
    try {
      return find(true);
    } catch (CannotListenException e) {
      Throwable failed = e.getCause();
      if (failed == null || !(failed.getCause() instanceof BindException)) {
        throw e;
      }
      console().error("standard mode only: " + e.getMessage());
      return find(false);
    }
  }

  private List<FoundServer> find(boolean withLegacy) throws CannotListenException {
    DiscoveryConfig config;
    try {
      config = DiscoveryConfig.create(cfg -> configure(cfg, withLegacy));
    } catch (IllegalArgumentException e) {
      throw wrongUsage("no network interface can send broadcasts; give --address");
    }
    try {
      return Discovery.find(config);
    } catch (IOException e) {
      throw new CannotListenException(String.valueOf(e.getMessage()), e);
    }
  }

  private void configure(DiscoveryConfig.Builder cfg, boolean withLegacy) {
    cfg.timeout(timeout).legacy(withLegacy).standardPort(ports.get(0));
    cfg.legacyPorts(ports.get(1), ports.get(2));
    addresses.forEach(name -> cfg.addresses(address(name)));
    try {
      for (String name : interfaces) {
        NetworkInterface found = NetworkInterface.getByName(name);
        if (found == null) {
          throw wrongUsage("this computer has no network interface " + name);
        }
        cfg.networkInterface(found);
      }
      if (addresses.isEmpty() && interfaces.isEmpty()) {
        cfg.allNetworkInterfaces();
      }
    } catch (SocketException e) {
      throw wrongUsage("the network interfaces cannot be listed: " + e.getMessage());
    }
  }

  private InetAddress address(String name) {
    try {
      for (InetAddress address : InetAddress.getAllByName(name)) {
        if (!name.isBlank() && address instanceof Inet4Address) {
          return address;
        }
      }
    } catch (UnknownHostException e) {
      // said below
    }
    throw wrongUsage(
        "--address needs an IPv4 address or the name of a host that has one, is " + name);
  }

  private void print(List<FoundServer> servers) {
    Table table = Table.withTitles("MODEL", "SERIAL", "SERVER", "VERSION", "ADDRESS");
    for (FoundServer server : servers) {
      table.add(
          server.model(),
          server.serialNumber(),
          server.type() == ServerType.C3_BRIDGE ? "C3 Bridge" : "KUKAVARPROXY",
          version(server) == null ? "" : String.valueOf(version(server)),
          server.address().getHostAddress() + ":" + server.port());
    }
    table.print(console());
  }

  private static @Nullable String version(FoundServer server) {
    Version version = server.version();
    return version == null ? null : version.toString();
  }

  private static void write(JsonGenerator out, FoundServer server) throws IOException {
    out.writeStringField("model", server.model());
    out.writeStringField("serial", server.serialNumber());
    out.writeStringField("type", server.type().name());
    out.writeStringField("version", version(server));
    out.writeStringField("host", server.address().getHostAddress());
    out.writeNumberField("port", server.port());
  }
}
