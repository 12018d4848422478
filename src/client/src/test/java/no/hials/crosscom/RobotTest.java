package no.hials.crosscom;

import java.time.Duration;
import java.util.function.Consumer;
import no.hials.crosscom.mock.MockServer;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;

/** Gives each test a simulated controller and a client of it. */
abstract class RobotTest {
  /** Never runs out unless a test wants it to. */
  static final Duration LONG = Duration.ofSeconds(60);

  /** Runs out when a test waits for it. */
  static final Duration SHORT = Duration.ofMillis(100);

  MockServer robot;
  CrossComClient client;

  @BeforeEach
  final void connect() throws Exception {
    robot = MockServer.start();
    client = client(LONG);
  }

  @AfterEach
  final void disconnect() throws Exception {
    client.close();
    robot.close();
  }

  /** Makes a client that does not connect again, so that a test sees each failure. */
  final CrossComClient client(Duration requestTimeout) throws Exception {
    return client(cfg -> cfg.requestTimeout(requestTimeout).reconnect(false));
  }

  /** Makes a client that does nothing by itself but what a test asks for. */
  final CrossComClient client(Consumer<ClientConfig.Builder> settings) throws Exception {
    return new CrossComClient(
        ClientConfig.create(
            robot.host(),
            cfg -> {
              cfg.port(robot.port()).requestTimeout(LONG).keepAlive(Duration.ZERO);
              settings.accept(cfg);
            }));
  }
}
