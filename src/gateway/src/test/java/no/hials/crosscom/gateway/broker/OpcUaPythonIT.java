package no.hials.crosscom.gateway.broker;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import no.hials.crosscom.cell.RobotConnection;
import no.hials.crosscom.cell.TomlTable;
import no.hials.crosscom.gateway.Gateway;
import no.hials.crosscom.gateway.GatewayConfig;
import no.hials.crosscom.gateway.OutputKind;
import no.hials.crosscom.gateway.internal.opcua.OpcUaKind;
import no.hials.crosscom.mock.MockServer;
import no.hials.crosscom.mock.junit.KukaController;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Assumptions;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/** The example in Python, with the client asyncua, against the OPC UA server. */
@Timeout(120)
class OpcUaPythonIT {
  private static final List<OutputKind<?>> KINDS = List.of(new OpcUaKind());
  private static final Path SCRIPT = Path.of("../../examples/python/opcua_robots.py");

  @KukaController private MockServer robot;
  @TempDir private Path folder;

  private Gateway gateway;
  private String url;

  @BeforeEach
  void start() throws Exception {
    if (python("-c", "import asyncua").code() != 0) {
      System.out.println("skipped: python3 with asyncua is not there (pip install asyncua)");
      Assumptions.abort("python3 with asyncua is not there");
    }
    int port;
    try (ServerSocket socket = new ServerSocket(0, 1, InetAddress.getLoopbackAddress())) {
      port = socket.getLocalPort();
    }
    url = "opc.tcp://127.0.0.1:" + port;
    Files.writeString(folder.resolve("anna.txt"), "of anna");
    String text =
        """
        [robots.cell1]
        host = "%s:%d"

        [groups.all]
        variables = ["$OV_PRO", "$AXIS_ACT", "$MODE_OP"]
        period = "50ms"

        [variables."$OV_PRO"]
        range = [0, 100]
        write = true

        [opcua]
        address = "127.0.0.1:%d"

        [opcua.users.anna]
        role = "operator"
        password-file = "anna.txt"
        """
            .formatted(robot.host(), robot.port(), port);
    robot.variables().set("$AXIS_ACT", "{A1 10.5,A2 -90,A3 90,A4 0,A5 0,A6 0}");
    TomlTable root = TomlTable.parse(folder.resolve("plant.toml"), text);
    gateway =
        Gateway.start(
            GatewayConfig.read(root, folder, Map.of(), KINDS), KINDS, RobotConnection::openLazily);
  }

  @AfterEach
  void close() {
    if (gateway != null) {
      gateway.close();
    }
  }

  private record Ended(int code, String output) {}

  private static Ended python(String... arguments) throws IOException, InterruptedException {
    List<String> command = new ArrayList<>(List.of("python3"));
    command.addAll(List.of(arguments));
    Process process;
    try {
      process = new ProcessBuilder(command).redirectErrorStream(true).start();
    } catch (IOException e) {
      return new Ended(-1, String.valueOf(e.getMessage()));
    }
    String output = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
    assertThat(process.waitFor(60, TimeUnit.SECONDS)).isTrue();
    return new Ended(process.exitValue(), output);
  }

  /** Runs the example until the first reading of the robot has come. */
  private String example(String... user) throws IOException, InterruptedException {
    List<String> arguments = new ArrayList<>(List.of(SCRIPT.toString(), url));
    arguments.addAll(List.of(user));
    Ended ended;
    do {
      ended = python(arguments.toArray(String[]::new));
    } while (ended.output().contains("BadWaitingForInitialData"));
    return ended.output();
  }

  @Test
  void anAnonymousClientFindsTheRobotByTypeAndReadsButDoesNotWrite() throws Exception {
    assertThat(example())
        .contains(
            "cell1 mode 1 axes 10.5 -90.0 90.0 0.0 0.0 0.0",
            "override 100",
            "not written: BadUserAccessDenied");
    assertThat(robot.variables().get("$OV_PRO")).isEqualTo("100");
  }

  @Test
  void anOperatorWritesAndSeesTheChange() throws Exception {
    assertThat(example("anna", "of anna")).contains("override is now 50");
    assertThat(robot.variables().get("$OV_PRO")).isEqualTo("50");
  }

  @Test
  void aWrongPasswordIsRefused() throws Exception {
    assertThat(example("anna", "of vera")).contains("BadUserAccessDenied");
  }
}
