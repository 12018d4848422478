package no.hials.crosscom.cli.mock;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import no.hials.crosscom.cli.base.Cli;
import no.hials.crosscom.cli.base.RunningMock;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** {@code mock} with C3 Bridge and its files. */
@Timeout(60)
class MockFilesTest {
  @TempDir private Path dir;

  private String file(String name, String... lines) throws Exception {
    return Files.write(dir.resolve(name), List.of(lines), StandardCharsets.ISO_8859_1).toString();
  }

  private static RunningMock bridge(String... options) throws InterruptedException {
    return new RunningMock(
        Stream.concat(Stream.of("--server", "c3", "--no-discovery"), Stream.of(options))
            .toArray(String[]::new));
  }

  @Test
  void showsItsProgramsAmongItsFilesAndLetsThemBeSelected() throws Exception {
    String program = file("waits.src", "DEF WAITS ( )", "  WAIT FOR $IN[1]", "END");
    file("waits.dat", "DEFDAT WAITS", "ENDDAT");
    String other = file("other.src", "DEF OTHER ( )", "  WAIT FOR $IN[1]", "END");
    try (RunningMock mock = bridge("--program", program, "--program", other)) {
      assertThat(mock.run("file ls", "KRC:\\R1\\Program", "--json").lines())
          .extracting(line -> line.replaceAll(".*\"name\":\"([^\"]*)\".*", "$1"))
          .containsExactly("OTHER.src", "WAITS.dat", "WAITS.src");

      assertThat(mock.run("program select", "/R1/OTHER").lines())
          .containsExactly("robot: OTHER #P_RESET");
      assertThat(mock.run("program run", "/R1/WAITS").lines())
          .containsExactly("robot: WAITS #P_ACTIVE");
    }
  }

  @Test
  void servesAFolderInWhichClientsChangeFiles() throws Exception {
    Path krc = Files.createDirectory(dir.resolve("krc"));
    String local = file("note.txt", "hello");
    try (RunningMock mock = bridge("--files", krc.toString())) {
      assertThat(mock.run("file put", local, "KRC:\\R1\\TP\\").code()).isZero();
    }
    assertThat(krc.resolve("R1/TP/note.txt")).hasSameBinaryContentAs(Path.of(local));
  }

  @Test
  void doesNotReplaceAnotherProgramOfTheFolder() throws Exception {
    Path programs = Files.createDirectories(dir.resolve("krc/R1/Program"));
    Files.writeString(programs.resolve("waits.src"), "another one");
    String program = file("waits.src", "DEF WAITS ( )", "  WAIT FOR $IN[1]", "END");

    Cli.Result result =
        Cli.run(
            "mock",
            "--server",
            "c3",
            "--port",
            "0",
            "--no-discovery",
            "--files",
            dir.resolve("krc").toString(),
            "--program",
            program);

    result
        .failsInLines(2)
        .containsExactly(
            "jopenshowvar: cannot use "
                + program
                + ": KRC:\\R1\\Program\\waits.src already exists with other content");
    assertThat(programs.resolve("waits.src")).hasContent("another one");
  }

  @Test
  void refusesAFolderThatDoesNotExistUnlessItMayCreateIt() throws Exception {
    Path krc = dir.resolve("new/krc");

    Cli.run("mock", "--server", "c3", "--port", "0", "--files", krc.toString())
        .failsInLines(2)
        .containsExactly(
            "jopenshowvar: cannot use " + krc + ": the folder does not exist; --create creates it");
    assertThat(krc).doesNotExist();

    try (RunningMock mock = bridge("--files", krc.toString(), "--create")) {
      assertThat(mock.run("file put", file("note.txt", "hello"), "KRC:\\R1\\TP\\").code()).isZero();
    }
    assertThat(krc.resolve("R1/TP/note.txt")).exists();
  }

  @Test
  void refusesAFileAsItsFolder() throws Exception {
    String file = file("krc", "");

    Cli.run("mock", "--server", "c3", "--port", "0", "--files", file, "--create")
        .failsInLines(2)
        .singleElement()
        .asString()
        .startsWith("jopenshowvar: cannot use " + file + ": ");
  }

  @Test
  void answersWhoLooksForItInBothModes() throws Exception {
    try (RunningMock mock =
        new RunningMock("--server", "c3", "--discovery", "0", "--standard-discovery", "0")) {
      String legacy = mock.nextLine();
      String standard = mock.nextLine();
      assertThat(legacy).startsWith("discovery on 127.0.0.1:");
      assertThat(standard).startsWith("standard discovery on 127.0.0.1:");

      String ports = standard.replaceAll(".*:", "") + "," + legacy.replaceAll(".*:", "") + ",0";
      Cli.Result found =
          Cli.run("discover", "--address", "127.0.0.1", "--timeout", "200ms", "--ports", ports);
      assertThat(found.lines()).hasSize(2).last().asString().contains("C3 Bridge");
    }
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "--server foo | must be kukavarproxy or c3, is foo",
        "--files . | --files needs --server c3",
        "--standard-discovery 0 | --standard-discovery needs --server c3",
        "--server c3 --standard-discovery 0 --no-discovery | exclude each other"
      })
  void saysWhatIsWrongWithTheUsage(String options, String message) {
    Cli.Result result = Cli.run(("mock --port 0 " + options).split(" "));

    assertThat(result.errLines().get(0)).contains(message);
    assertThat(result.code()).isEqualTo(2);
  }
}
