package no.hials.crosscom.cli.lab;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Stream;
import no.hials.crosscom.cli.base.Cli;
import no.hials.crosscom.lab.experiment.Experiment;
import no.hials.crosscom.lab.plot.Pictures;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;

/** The experiments, shortened: what takes the controller no time is over soon. */
class ExperimentCommandTest {
  @TempDir private Path folder;

  private Cli.Result experiment(String... args) {
    return Cli.run(args(args));
  }

  private String[] args(String... args) {
    return Stream.concat(
            Stream.of("experiment", "--latency", "none", "--out", folder.toString()),
            Arrays.stream(args))
        .toArray(String[]::new);
  }

  private Path file(String name) {
    return folder.resolve(name);
  }

  /** The cycles of a CSV file, and what its columns are called. */
  private record Cycles(List<String> names, List<double[]> rows) {
    static Cycles read(Path csv) throws IOException {
      List<String> lines = Files.readAllLines(csv);
      List<double[]> rows = new ArrayList<>();
      for (String line : lines.subList(1, lines.size())) {
        rows.add(Arrays.stream(line.split(",", -1)).mapToDouble(Double::parseDouble).toArray());
      }
      return new Cycles(List.of(lines.get(0).split(",", -1)), rows);
    }

    double last(String name) {
      return rows.get(rows.size() - 1)[names.indexOf(name)];
    }

    double first(String name) {
      return rows.get(0)[names.indexOf(name)];
    }

    double largestDifference(String one, String other) {
      return rows.stream()
          .mapToDouble(row -> Math.abs(row[names.indexOf(one)] - row[names.indexOf(other)]))
          .max()
          .orElseThrow();
    }
  }

  static Stream<String> figures() {
    return Experiment.all().stream()
        .map(Experiment::name)
        .filter(name -> name.matches(".*-(sinusoid|square|circle)"));
  }

  @Test
  void listsTheExperiments() {
    Cli.run("experiment", "list")
        .succeeds()
        .hasSize(14)
        .contains(
            "position-circle          A circle by the position of the tool: ACTUATOR and MYPOS.");
  }

  @ParameterizedTest
  @MethodSource("figures")
  void theRobotDrawsTheFigure(String name) throws IOException {
    experiment(name, "--for", "400ms", "--lap", "6s", "--csv", "--size", "640x720")
        .succeeds()
        .last()
        .isEqualTo("wrote " + file(name + ".png"));
    BufferedImage picture = Pictures.png(file(name + ".png"));
    assertThat(picture.getWidth()).isEqualTo(640);
    assertThat(picture.getHeight()).isEqualTo(720);
    assertThat(Files.readAllLines(file(name + "-figures.csv"))).contains("name,value");
    Cycles cycles = Cycles.read(file(name + ".csv"));
    boolean joint = name.startsWith("joint-");
    String right = joint ? "A1" : "Y";
    assertThat(cycles.last("actual_" + right) - cycles.first("actual_" + right))
        .isBetween(joint ? 0.1 : 0.5, joint ? 5.0 : 25);
    for (String each : joint ? List.of("A1", "A2", "A3") : List.of("X", "Y", "Z")) {
      assertThat(cycles.largestDifference("desired_" + each, "actual_" + each))
          .isLessThan(joint ? 4 : 25);
    }
  }

  @Test
  void aLineIsFollowedByBothKinematics() throws IOException {
    experiment("line-dls", "--for", "400ms", "--csv", "--format", "svg")
        .succeeds()
        .anyMatch(line -> line.startsWith("deviation, krc, max: "))
        .anyMatch(line -> line.startsWith("deviation, dls, max: "));
    assertThat(Pictures.texts(file("line-dls.svg")))
        .startsWith("line-dls: two kinematics, dt = 20 ms, simulated robot, latency none")
        .contains("deviation from the line", "damped least squares", "A6 [°] over time [s]");
    Cycles krc = Cycles.read(file("line-dls-krc.csv"));
    Cycles own = Cycles.read(file("line-dls-dls.csv"));
    assertThat(krc.last("actual_Y") - krc.first("actual_Y")).isBetween(1.0, 12.0);
    assertThat(krc.last("actual_Z") - krc.first("actual_Z")).isBetween(-0.1, 0.1);
    assertThat(own.first("actual_A1") - own.last("actual_A1")).isBetween(0.1, 1.5);
  }

  @Test
  void theLongRunSaysWhoseFaultMissedCyclesAre() throws IOException {
    experiment("endurance", "--for", "500ms", "--csv")
        .succeeds()
        .anyMatch(line -> line.matches("missed, the accesses left .*: \\d+"))
        .anyMatch(line -> line.matches("missed, garbage collection: \\d+"))
        .anyMatch(line -> line.matches("missed, anything else: \\d+"))
        .anyMatch(line -> line.matches("garbage collections, longest: \\d+\\.\\d\\d ms"));
    assertThat(Files.readAllLines(file("endurance-figures.csv")))
        .anyMatch(line -> line.matches("missed,\\d+"))
        .anyMatch(line -> line.matches("\"missed, garbage collection\",\\d+"))
        .anyMatch(line -> line.matches("\"garbage collections, longest \\[ms\\]\",[\\d.]+"));
  }

  @Test
  void printsALineForEachPhaseIfVerbose() {
    Cli.Result result = experiment("line-dls", "--for", "200ms", "--verbose");

    assertThat(result.err().lines())
        .contains(
            "jopenshowvar: line-dls: starting the robot, krc",
            "jopenshowvar: line-dls: warming up, krc, 0.0 s",
            "jopenshowvar: line-dls: measuring, krc, 0.2 s",
            "jopenshowvar: line-dls: measuring, dls, 0.2 s");
  }

  @Test
  void aRobotThatWasStoppedIsNoSuccess() {
    Cli.Result result = experiment("position-circle", "--for", "2s", "--lap", "1s");

    assertThat(result.code()).isEqualTo(1);
    assertThat(result.err())
        .contains("position-circle: the robot was stopped: the speed of path must be at most");
    assertThat(file("position-circle.png")).exists();
  }

  @Test
  void aRunOfOneCycleShowsNothing() {
    Cli.Result result = experiment("position-circle", "--for", "10ms");

    assertThat(result.err())
        .contains("position-circle: a run must have at least 2 cycles, had 1 in 10 ms");
    assertThat(result.code()).isEqualTo(1);
    assertThat(file("position-circle.png")).doesNotExist();
  }

  @Test
  void allFilesAreThereAlsoIfNobodyReadsWhatItPrints() throws IOException {
    int code = Cli.runUnread(args("line-dls", "--for", "200ms", "--csv"));

    assertThat(code).isEqualTo(74);
    assertThat(file("line-dls.png")).isNotEmptyFile();
    assertThat(file("line-dls-krc.csv")).isNotEmptyFile();
    assertThat(file("line-dls-dls-figures.csv")).isNotEmptyFile();
  }

  @Test
  void aFileIsNoFolder() throws IOException {
    Path occupied = Files.writeString(file("a"), "mine");

    Cli.run("experiment", "position-circle", "--out", occupied.toString())
        .fails(74)
        .contains("could not write " + occupied + ": it is not a folder");
    assertThat(occupied).hasContent("mine");
  }

  @Test
  void nothingIsWrittenOver() throws IOException {
    Files.writeString(file("line-dls-dls.csv"), "mine");

    experiment("line-dls", "--csv")
        .fails(2)
        .contains("line-dls-dls.csv already exists; --yes overwrites it");
    assertThat(file("line-dls.png")).doesNotExist();
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "position-circle list          | list excludes other names",
        "position-triangle             | unknown experiment: position-triangle",
        "position-circle --period 3ms  | --period must be 4ms to 1s, is 3ms",
        "position-circle --step 2s     | --step must be 4ms to 1s, is 2000ms",
        "position-circle --format gif  | --format must be png or svg, is gif",
        "position-circle --latency x   | latency must be none, krc4, krc4-2014 or a time",
      })
  void wrongUsageIsNamed(String args, String message) {
    Cli.run(("experiment " + args).split(" ")).fails(2).contains(message);
  }
}
