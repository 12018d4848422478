package no.hials.crosscom.gateway;

import static java.nio.file.StandardCopyOption.REPLACE_EXISTING;
import static org.assertj.core.api.Assertions.assertThat;

import java.io.FileOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** The arguments of the gateway, and the plan that it prints. */
@Timeout(60)
class GatewayMainTest {
  private static final String ROBOT =
      "[robots.cell1]\nhost = \"192.0.2.1\"\nserver = \"kukavarproxy\"\n";

  private static final String PROMETHEUS = "[prometheus]\naddress = \"127.0.0.1:0\"\n";
  private static final String GROUP = "[groups.all]\nvariables = [\"$OV_PRO\"]\nperiod = \"1s\"\n";

  private final List<Process> processes = new ArrayList<>();
  @TempDir private Path folder;
  private final StringWriter out = new StringWriter();
  private final StringWriter err = new StringWriter();

  private int run(String... args) {
    return GatewayMain.run(new PrintWriter(out), new PrintWriter(err), args);
  }

  private int dryRun(String text, String... more) throws IOException {
    Path file = Files.writeString(folder.resolve("plant.toml"), text);
    String[] args = new String[more.length + 3];
    args[0] = "--dry-run";
    args[1] = "--config";
    args[2] = file.toString();
    System.arraycopy(more, 0, args, 3, more.length);
    return run(args);
  }

  @Test
  void aDryRunPrintsThePlan() throws IOException {
    assertThat(dryRun(ROBOT)).isZero();

    assertThat(out)
        .hasToString(
            "cell1: 7 variables every 100 ms and 1000 ms, 25.0 accesses/s, 13 % load"
                + System.lineSeparator());
  }

  @Test
  void aPlanThatIsTooMuchIsRefused() throws IOException {
    String groups = "[groups.all]\nvariables = [\"$POS_ACT\", \"$AXIS_ACT\"]\nperiod = \"10ms\"\n";

    assertThat(dryRun(ROBOT + groups)).isEqualTo(2);

    assertThat(err.toString())
        .startsWith("jopenshowvar: ")
        .contains(
            "plant.toml:4: cell1: 2 variables every 10 ms, 200.0 accesses/s, 100 % load: at most"
                + " 50 % is allowed ([limits] load)");
  }

  @Test
  void theErrorHasAllRobotsWhosePlanIsTooMuch() throws IOException {
    String groups =
        """
        [robots.cell2]
        host = "192.0.2.2"
        server = "c3"
        [robots.cell3]
        host = "192.0.2.3"
        server = "kukavarproxy"
        [groups.all]
        variables = ["$POS_ACT", "$AXIS_ACT"]
        period = "10ms"
        """;

    assertThat(dryRun(ROBOT + groups)).isEqualTo(2);

    assertThat(err.toString())
        .contains(
            "cell1: 2 variables every 10 ms, 200.0 accesses/s, 100 % load; cell3: 2 variables every"
                + " 10 ms, 200.0 accesses/s, 100 % load: at most 50 %");
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "[plants] | 4: plants: no such key; known: limits, robots, groups, variables, prometheus",
        "[prometheus]\\nport = 1 | 5: prometheus.port: no such key; known: address",
        "[prometheus]\\naddress = \"a/b\" | 5: prometheus.address: must be HOST, HOST:PORT",
        "robots = 1 | 4: robots.cell1.robots: no such key",
        "[x | 4: invalid TOML: ",
      })
  void anErrorInTheFileHasItsLine(String text, String message) throws IOException {
    assertThat(dryRun(ROBOT + text.replace("\\n", "\n") + "\n")).isEqualTo(2);

    assertThat(err.toString()).startsWith("jopenshowvar: ").contains("plant.toml:" + message);
  }

  @Test
  void anOptionAndItsTableExcludeEachOther() throws IOException {
    assertThat(dryRun(ROBOT + "[prometheus]\n", "--prometheus", "127.0.0.1:0")).isEqualTo(2);

    assertThat(err.toString())
        .contains("plant.toml:4: --prometheus and the table prometheus exclude each other");
  }

  @Test
  void wrongUsageAndAMissingFileAreErrors() {
    assertThat(run("--dry-run")).isEqualTo(2);
    assertThat(run("--dry-run", "--mock", "-1")).isEqualTo(2);
    assertThat(run("--mock", "1")).isEqualTo(2);
    assertThat(run("--dry-run", "--config", folder.resolve("none.toml").toString())).isEqualTo(2);

    assertThat(err.toString().lines())
        .containsExactly(
            "jopenshowvar: there is no robot: use --config FILE or --mock N",
            "jopenshowvar: --mock must be 1 to 1000, is -1",
            "jopenshowvar: there is no output: add a table [mqtt], [opcua] or [prometheus]",
            "jopenshowvar: cannot read " + folder.resolve("none.toml") + ": file not found");
  }

  @Test
  void simulatedRobotsNeedNoFile() {
    assertThat(run("--dry-run", "--mock", "2", "--prometheus", "127.0.0.1:0")).isZero();

    assertThat(out.toString())
        .startsWith("mock1: 7 variables every 100 ms and 1000 ms, 11.0 accesses/s, 6 % load")
        .contains("mock2: ");
  }

  /** Starts a gateway of its own, and waits until it runs. */
  private Process start(String text) throws IOException, InterruptedException {
    Path file = Files.writeString(folder.resolve("plant.toml"), text);
    Process gateway =
        new ProcessBuilder(
                Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                "-XX:TieredStopAtLevel=1",
                "-cp",
                System.getProperty("java.class.path"),
                GatewayMain.class.getName(),
                "--mock",
                "1",
                "--config",
                file.toString())
            .redirectErrorStream(true)
            .redirectOutput(folder.resolve("log").toFile())
            .start();
    processes.add(gateway);
    awaitLog("http://127.0.0.1:");
    return gateway;
  }

  /** Waits for a text in the log; the test's timeout is the deadline. */
  private void awaitLog(String text) throws IOException, InterruptedException {
    while (!Files.readString(folder.resolve("log")).contains(text)) {
      if (Thread.interrupted()) {
        throw new InterruptedException("the log has no " + text);
      }
      Thread.onSpinWait();
    }
  }

  private Path pipe() throws Exception {
    Path pipe = folder.resolve("pipe");
    assertThat(new ProcessBuilder("mkfifo", pipe.toString()).start().waitFor()).isZero();
    return pipe;
  }

  @AfterEach
  void endProcesses() {
    processes.forEach(Process::destroyForcibly);
  }

  @Test
  @DisabledOnOs(OS.WINDOWS)
  void aPipeInPlaceOfTheFileIsNotRead() throws Exception {
    Process gateway = start(PROMETHEUS);

    Files.move(pipe(), folder.resolve("plant.toml"), REPLACE_EXISTING);
    awaitLog("plant.toml: it is not a regular file");
    Path changed = Files.writeString(folder.resolve("changed"), PROMETHEUS + GROUP);
    Files.move(changed, folder.resolve("plant.toml"), REPLACE_EXISTING);

    awaitLog("the configuration has changed");
    gateway.destroy();
    gateway.waitFor();
    assertThat(Files.readString(folder.resolve("log"))).containsOnlyOnce("not a regular file");
  }

  @Test
  @DisabledOnOs(OS.WINDOWS)
  void theEndDoesNotWaitForAReadingOfTheConfiguration() throws Exception {
    Path password = Files.writeString(folder.resolve("password.txt"), "secret");
    Process gateway =
        start(
            PROMETHEUS
                + """
                [opcua]
                address = "127.0.0.1:0"
                [opcua.users.anna]
                role = "viewer"
                password-file = "password.txt"
                """);
    Files.move(pipe(), password, REPLACE_EXISTING);

    // opens as soon as the gateway reads it
    try (OutputStream neverEnding = new FileOutputStream(password.toFile())) {
      neverEnding.write('s');
      gateway.destroy();
      gateway.waitFor();
    }

    assertThat(Files.readString(folder.resolve("log"))).doesNotContain("did not end within");
  }
}
