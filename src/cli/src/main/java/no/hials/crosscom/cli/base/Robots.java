package no.hials.crosscom.cli.base;

import java.io.IOException;
import java.net.InetAddress;
import java.util.Objects;
import java.util.function.Consumer;
import no.hials.crosscom.ClientConfig;
import no.hials.crosscom.cell.Robot;
import no.hials.crosscom.cell.RobotConnection;
import no.hials.crosscom.mock.MockServer;
import no.hials.crosscom.mock.MockServerConfig;
import no.hials.crosscom.protocol.ServerType;
import org.jspecify.annotations.Nullable;

/** Connects to the robots that the user chose, and starts the simulated ones. */
public final class Robots {
  private Robots() {}

  /**
   * Connects to a robot, after starting it if it is simulated.
   *
   * @param settings sets the options that the user does not choose: {@link Robot#ONE_SHOT} or
   *     {@link Robot#LASTING}
   * @throws CannotListenException if the mock server could not be started
   */
  public static RobotConnection open(Robot robot, Consumer<ClientConfig.Builder> settings)
      throws IOException {
    return open(robot, settings, cfg -> {});
  }

  /**
   * Connects to a robot, after starting it if it is simulated.
   *
   * @param more configures the simulated controller
   */
  public static RobotConnection open(
      Robot robot, Consumer<ClientConfig.Builder> settings, Consumer<MockServerConfig.Builder> more)
      throws IOException {
    if (robot.host() != null) {
      return RobotConnection.open(robot, settings);
    }
    ServerType server = Objects.requireNonNull(robot.server(), "a simulated robot has a server");
    MockServer simulation =
        listen(InetAddress.getLoopbackAddress(), 0, cfg -> more.accept(cfg.server(server)));
    try {
      RobotConnection connection =
          RobotConnection.open(robot.at(simulation.host(), simulation.port()), settings);
      return new RobotConnection(robot, connection.client(), simulation);
    } catch (IOException | RuntimeException e) {
      simulation.close();
      throw e;
    }
  }

  /** Returns the simulated controller of a connection; null if the robot is not simulated here. */
  public static @Nullable MockServer simulation(RobotConnection connection) {
    return connection.simulation(MockServer.class).orElse(null);
  }

  /** Starts a mock server that does not keep requests, since no command asks for them. */
  public static MockServer listen(
      InetAddress address, int port, Consumer<MockServerConfig.Builder> more)
      throws CannotListenException {
    try {
      return MockServer.start(
          cfg -> more.accept(cfg.bindAddress(address).port(port).recordedRequests(0)));
    } catch (IOException e) {
      throw new CannotListenException(String.valueOf(e.getMessage()), e);
    }
  }
}
