package no.hials.crosscom;

import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.net.SocketTimeoutException;
import java.time.Duration;
import java.util.List;
import java.util.function.Consumer;
import no.hials.crosscom.KRL.KRLAny;
import no.hials.crosscom.mock.MockServer;
import no.hials.crosscom.mock.RecordedRequest;
import no.hials.crosscom.protocol.ServerType;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.params.Parameter;
import org.junit.jupiter.params.ParameterizedClass;
import org.junit.jupiter.params.provider.EnumSource;

/**
 * The contract of the client: creates a simulated controller and a client for each test, and runs
 * it once with each kind of server.
 */
@ParameterizedClass
@EnumSource(ServerType.class)
abstract class RobotTest {
  /** Never runs out unless a test wants it to. */
  static final Duration LONG = Duration.ofSeconds(60);

  /** Runs out when a test waits for it. */
  static final Duration SHORT = Duration.ofMillis(100);

  @Parameter ServerType server;

  MockServer robot;
  CrossComClient client;

  @BeforeEach
  final void connect() throws Exception {
    robot = MockServer.start(cfg -> cfg.server(server));
    client = client(LONG);
  }

  @AfterEach
  final void disconnect() throws Exception {
    client.close();
    robot.close();
  }

  /** Returns the requests but those by which the client finds out which server there is. */
  final List<RecordedRequest> requests() {
    return robot.requests().stream().filter(r -> !r.name().startsWith("@PROXY_")).toList();
  }

  /** Detects the server, so that the faults of a test do not hit the question for it. */
  final void detectServer() {
    client.readVariables(new KRLAny("$OV_PRO"), new KRLAny("$OV_JOG"));
    robot.clearRequests();
  }

  /** Makes a client that does not connect again, so that a test sees each failure. */
  final CrossComClient client(Duration requestTimeout) throws Exception {
    return client(cfg -> cfg.requestTimeout(requestTimeout).reconnect(false));
  }

  /** Creates a client that sends nothing on its own. */
  final CrossComClient client(Consumer<ClientConfig.Builder> settings) throws Exception {
    return new CrossComClient(
        ClientConfig.create(
            robot.host(),
            cfg -> {
              cfg.port(robot.port()).requestTimeout(LONG).keepAlive(Duration.ZERO);
              settings.accept(cfg);
            }));
  }

  /**
   * Returns a socket that answers no request to connect: its backlog is full. The sockets that fill
   * it end with it.
   *
   * @param port its port; 0 for a free one
   */
  @SuppressWarnings("resource")
  static ServerSocket withFullBacklog(int port) throws IOException {
    ServerSocket full = new ServerSocket(port, 1, InetAddress.getLoopbackAddress());
    try {
      while (true) {
        new Socket().connect(full.getLocalSocketAddress(), 100);
      }
    } catch (SocketTimeoutException e) {
      return full;
    }
  }
}
