package no.hials.crosscom.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.StringWriter;
import java.io.Writer;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import no.hials.crosscom.cli.base.Cli;
import no.hials.crosscom.cli.base.Console;
import no.hials.crosscom.mock.MockServer;
import no.hials.crosscom.mock.junit.KukaController;
import no.hials.crosscom.protocol.ServerType;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** A file that cannot be written is exit code 74 in each command. */
class UnwritableFileTest {
  /** Takes no byte, like a full disk. */
  private static final String FULL = "/dev/full";

  @TempDir private Path dir;

  @KukaController(server = ServerType.C3_BRIDGE)
  private MockServer server;

  /** Returns a file in a folder that does not exist. */
  private String missing(String name) {
    return dir.resolve("none").resolve(name).toString();
  }

  @Test
  void record() {
    Cli.runOn(server, "record", "MYINT", "--count", "1", "--out", missing("a.csv"))
        .fails(74)
        .startsWith("jopenshowvar: could not write ")
        .contains("there is no folder");
    Cli.runOn(server, "record", "MYINT", "--count", "1", "--yes", "--out", dir.toString())
        .fails(74)
        .contains("it is a folder");
  }

  @Test
  @EnabledOnOs(OS.LINUX)
  void recordOnAFullDisk() {
    Cli.runOn(server, "record", "MYINT", "--count", "1", "--out", FULL)
        .fails(74)
        .startsWith("jopenshowvar: could not write ");
  }

  @Test
  @EnabledOnOs(OS.LINUX)
  void plot() throws IOException {
    Path csv = dir.resolve("run.csv");
    assertThat(Cli.runOn(server, "record", "MYINT", "--count", "3", "--out", csv.toString()).code())
        .isZero();

    Cli.run("plot", csv.toString(), "MYINT", "--out", missing("a.svg"))
        .fails(74)
        .contains("there is no folder");
    Cli.run("plot", csv.toString(), "MYINT", "--out", "/proc/a.svg")
        .fails(74)
        .startsWith("jopenshowvar: could not write /proc/a.svg: no such folder, or");
  }

  @Test
  @EnabledOnOs(OS.LINUX)
  void bench() {
    Cli.runOn(server, "bench", "MYINT", "--count", "10", "--out", missing("a.csv"))
        .fails(74)
        .contains("there is no folder");
    assertThat(Cli.runOn(server, "bench", "MYINT", "--count", "10", "--out", FULL).code())
        .isEqualTo(74);
  }

  @Test
  void fileGet() throws IOException {
    server.files().put("KRC:\\R1\\Program\\a.src", "DEF A()\nEND\n");

    Cli.runOn(server, "file get", "/R1/a.src", missing("a.src"))
        .fails(74)
        .contains("there is no folder");
  }

  @Test
  @EnabledOnOs(OS.LINUX)
  void fileGetInAFolderThatTakesNoFiles() throws IOException {
    server.files().put("KRC:\\R1\\Program\\a.src", "DEF A()\nEND\n");

    Cli.runOn(server, "file get", "/R1/a.src", "/proc/a.src")
        .fails(74)
        .startsWith("jopenshowvar: could not write /proc/a.src");
  }

  @Test
  void experiment() throws IOException {
    Path file = Files.createFile(dir.resolve("file"));

    Cli.run("experiment", "line-dls", "--out", file.resolve("folder").toString())
        .fails(74)
        .startsWith("jopenshowvar: could not write " + file);
  }

  @Test
  void drive() {
    Cli.run("drive", "--mock", "--record", missing("a.csv"))
        .fails(74)
        .contains("there is no folder");
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "write|MYINT 5 --yes|MYINT = 5",
        "write|MYINT 5 --yes --json|MYINT = 5",
        "run|{lines} --yes|MYINT = 5",
        "file put|{lines} /R1/ --yes|{lines} -> /R1/lines, 10 bytes",
        "file rm|/R1/a.src --yes|deleted /R1/a.src",
        "confirm|--yes|all messages confirmed",
        "program stop|--yes|robot: no program #P_FREE"
      })
  @EnabledOnOs(OS.LINUX)
  void stdoutOfAChange(String command, String arguments, String change) throws IOException {
    String lines = Files.writeString(dir.resolve("lines"), "MYINT = 5\n").toString();
    server.files().put("KRC:\\R1\\Program\\a.src", "DEF A()\nEND\n");
    String place = command.equals("run") ? lines + ":1: " : "";

    assertThat(
            onAFullDisk(
                Cli.argsOn(server, command, arguments.replace("{lines}", lines).split(" "))))
        .isEqualTo(
            "jopenshowvar: %sdone: %s; could not write the output: No space left on device%n"
                .formatted(place, change.replace("{lines}", lines)));
  }

  @ParameterizedTest
  @ValueSource(strings = {"--help", "--version", "read --help", "vars torque"})
  @EnabledOnOs(OS.LINUX)
  void stdout(String arguments) throws IOException {
    assertThat(onAFullDisk(arguments.split(" ")))
        .startsWith("jopenshowvar: could not write the output: ");
  }

  /** Runs a command whose stdout takes no byte; returns its stderr. */
  private static String onAFullDisk(String... arguments) throws IOException {
    StringWriter err = new StringWriter();
    try (Writer full = Files.newBufferedWriter(Path.of(FULL))) {
      int code = Main.run(arguments, new Console(full, err, Map.of()));

      assertThat(code).isEqualTo(74);
    } catch (IOException e) {
      // closing flushes what could not be written
    }
    return err.toString();
  }
}
