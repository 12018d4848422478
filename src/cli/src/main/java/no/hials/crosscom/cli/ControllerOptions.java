package no.hials.crosscom.cli;

import java.io.IOException;
import java.net.InetAddress;
import java.time.Duration;
import no.hials.crosscom.ClientConfig;
import no.hials.crosscom.CrossComClient;
import no.hials.crosscom.CrossComException;
import no.hials.crosscom.mock.MockServer;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Option;

/** The options that say which controller a command talks to. */
final class ControllerOptions {
  @Option(
      names = "--host",
      order = 1,
      paramLabel = "HOST",
      description = "Name or address of the controller. Either this or --mock is needed.")
  private @Nullable String host;

  @Option(
      names = "--port",
      order = 2,
      paramLabel = "PORT",
      converter = Converters.Port.class,
      description = "TCP port of the server there; 7000 if not given.")
  private @Nullable Integer port;

  @Option(
      names = "--mock",
      order = 3,
      description = {
        "Talk to a simulated controller (KR 6 R900 sixx, KR C4) instead, which is started for this"
            + " command and gone after it."
      })
  private boolean mock;

  @Option(
      names = "--timeout",
      order = 4,
      paramLabel = "TIME",
      converter = Converters.Time.class,
      description = {
        "How long to wait at most for the connection, and for each answer: 500 or 500ms, 3s, 1m. If"
            + " not given, 5s for the connection and 3s for an answer."
      })
  private @Nullable Duration timeout;

  /**
   * Connects.
   *
   * @param command has these options
   * @return the connection
   * @throws CrossComException if no connection could be made
   * @throws CannotListenException if the mock server could not be started
   */
  Controller open(ConsoleCommand command) throws IOException {
    if (mock) {
      if (host != null) {
        throw command.wrongUsage("--host and --mock exclude each other");
      }
      if (port != null) {
        throw command.wrongUsage("--port goes with --host; --mock takes a free port");
      }
      return openMock();
    }
    if (host == null) {
      throw command.wrongUsage("which controller? give --host HOST, or --mock for a simulated one");
    }
    if (host.isBlank()) {
      throw command.wrongUsage("--host must not be blank");
    }
    int realPort = port == null ? ClientConfig.DEFAULT_PORT : port;
    return new Controller(connect(host, realPort), null);
  }

  private Controller openMock() throws IOException {
    MockServer server = MockCommand.listen(InetAddress.getLoopbackAddress(), 0, cfg -> {});
    try {
      return new Controller(connect(server.host(), server.port()), server);
    } catch (IOException | RuntimeException e) {
      server.close();
      throw e;
    }
  }

  private CrossComClient connect(String toHost, int toPort) throws CrossComException {
    Duration limit = timeout;
    return new CrossComClient(
        ClientConfig.create(
            toHost,
            cfg -> {
              // one command, one connection: what it tells is what happened
              cfg.port(toPort).reconnect(false).keepAlive(Duration.ZERO);
              if (limit != null) {
                cfg.connectTimeout(limit).requestTimeout(limit);
              }
            }));
  }
}
