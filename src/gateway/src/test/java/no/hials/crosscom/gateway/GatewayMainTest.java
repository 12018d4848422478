package no.hials.crosscom.gateway;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** The arguments of the gateway, and the plan that it prints. */
@Timeout(60)
class GatewayMainTest {
  private static final String ROBOT =
      "[robots.cell1]\nhost = \"192.0.2.1\"\nserver = \"kukavarproxy\"\n";

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
}
