package no.hials.crosscom.cli;

import java.io.IOException;
import java.net.InetAddress;
import java.time.Duration;
import java.util.function.Consumer;
import no.hials.crosscom.ClientConfig;
import no.hials.crosscom.CrossComClient;
import no.hials.crosscom.CrossComException;
import no.hials.crosscom.mock.MockServer;
import no.hials.crosscom.protocol.ServerType;
import org.jspecify.annotations.Nullable;

/**
 * A controller that the user chose, not connected yet.
 *
 * @param name what the user calls it, as {@code cell1}; empty if it has no name
 * @param host name or address; null for a simulated controller, which {@link #open} starts
 * @param port TCP port there
 * @param timeout limit for connecting and for each answer; null for the client's own limits
 * @param readOnly whether writes are refused here
 * @param server which server a simulated controller has
 */
record Robot(
    String name,
    @Nullable String host,
    int port,
    @Nullable Duration timeout,
    boolean readOnly,
    ServerType server) {

  /** One command, one connection: what it tells is what happened. */
  static final Consumer<ClientConfig.Builder> ONE_SHOT =
      cfg -> cfg.reconnect(false).keepAlive(Duration.ZERO);

  /** Keeps the connection up, for commands that run on. */
  static final Consumer<ClientConfig.Builder> LASTING = cfg -> {};

  /** Gives what to print before a line about this controller: nothing if it has no name. */
  String label() {
    return name.isEmpty() ? "" : name + ": ";
  }

  /**
   * Connects, and starts the controller before if it is a simulated one.
   *
   * @param settings sets what the user does not choose: {@link #ONE_SHOT} or {@link #LASTING}
   * @throws CrossComException if no connection could be made
   * @throws CannotListenException if the mock server could not be started
   */
  RobotConnection open(Consumer<ClientConfig.Builder> settings) throws IOException {
    if (host != null) {
      return new RobotConnection(this, connect(host, port, settings), null);
    }
    MockServer simulation =
        MockCommand.listen(InetAddress.getLoopbackAddress(), 0, cfg -> cfg.server(server));
    try {
      return new RobotConnection(
          this, connect(simulation.host(), simulation.port(), settings), simulation);
    } catch (IOException | RuntimeException e) {
      simulation.close();
      throw e;
    }
  }

  private CrossComClient connect(String toHost, int toPort, Consumer<ClientConfig.Builder> settings)
      throws CrossComException {
    Duration limit = timeout;
    return new CrossComClient(
        ClientConfig.create(
            toHost,
            cfg -> {
              cfg.port(toPort);
              if (limit != null) {
                cfg.connectTimeout(limit).requestTimeout(limit);
              }
              settings.accept(cfg);
            }));
  }
}
