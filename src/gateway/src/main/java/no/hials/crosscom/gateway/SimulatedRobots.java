package no.hials.crosscom.gateway;

import java.io.IOException;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Objects;
import java.util.function.Consumer;
import no.hials.crosscom.ClientConfig;
import no.hials.crosscom.cell.Robot;
import no.hials.crosscom.cell.RobotConnection;
import no.hials.crosscom.mock.MockServer;
import no.hials.crosscom.protocol.ServerType;
import no.hials.crosscom.protocol.code.OperatingMode;
import no.hials.crosscom.simulator.Controller;
import no.hials.crosscom.simulator.KrlFileException;

/** Robots that are simulated in this process. They run a program that moves them. */
final class SimulatedRobots implements AutoCloseable {
  /** Moves the robot back and forth. */
  private static final String PROGRAM =
      """
      DEF DEMO ( )
        $VEL.CP=0.5
        LOOP
          PTP {A1 -60,A2 -80,A3 95,A4 0,A5 40,A6 0}
          LIN_REL {Z -150}
          WAIT SEC 0.5
          LIN_REL {Z 150}
          PTP {A1 60,A2 -100,A3 110,A4 20,A5 50,A6 90}
          WAIT SEC 1
        ENDLOOP
      END
      """;

  private final Map<String, MockServer> servers = new LinkedHashMap<>();
  private final Map<String, Robot> robots = new LinkedHashMap<>();

  SimulatedRobots(int count) throws IOException {
    try {
      for (int i = 1; i <= count; i++) {
        start("mock" + i);
      }
    } catch (IOException | RuntimeException e) {
      close();
      throw e;
    }
  }

  private void start(String name) throws IOException {
    MockServer server =
        MockServer.start(cfg -> cfg.server(ServerType.C3_BRIDGE).recordedRequests(0));
    servers.put(name, server);
    Controller controller = server.controller();
    try {
      controller.load("demo.src", PROGRAM);
      controller.setMode(OperatingMode.AUT);
      controller.robot().select("DEMO");
      controller.runProgram();
    } catch (KrlFileException e) {
      throw new IllegalStateException(e);
    }
    robots.put(
        name,
        new Robot(name, server.host(), server.port(), null, null, ServerType.C3_BRIDGE, null));
  }

  /** Returns the robots by their names. */
  Map<String, Robot> robots() {
    return robots;
  }

  /** Connects to any robot; a robot with {@code mock = true} in the file is simulated as well. */
  RobotConnection open(Robot robot, Consumer<ClientConfig.Builder> settings) throws IOException {
    if (robot.host() != null) {
      return RobotConnection.openLazily(robot, settings);
    }
    ServerType type = Objects.requireNonNull(robot.server(), "a simulated robot has a server");
    MockServer server = MockServer.start(cfg -> cfg.server(type).recordedRequests(0));
    try {
      RobotConnection connection =
          RobotConnection.openLazily(robot.at(server.host(), server.port()), settings);
      return new RobotConnection(robot, connection.client(), server);
    } catch (IOException | RuntimeException e) {
      server.close();
      throw e;
    }
  }

  @Override
  public void close() {
    servers.values().forEach(MockServer::close);
  }
}
