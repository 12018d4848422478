package no.hials.crosscom.cli.variables;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.time.Duration;
import java.time.Instant;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import no.hials.crosscom.ConnectionEvent;
import no.hials.crosscom.Sample;
import no.hials.crosscom.Sample.Reading;
import no.hials.crosscom.Sample.ReadingStatus;
import no.hials.crosscom.cell.Robot;
import no.hials.crosscom.cell.SampledRobot;
import no.hials.crosscom.cell.Sampling;
import no.hials.crosscom.cli.base.Robots;
import no.hials.crosscom.mock.MockServer;
import no.hials.crosscom.mock.junit.KukaController;
import no.hials.crosscom.protocol.ServerType;
import no.hials.crosscom.protocol.value.KrlValue;
import org.jline.utils.AttributedString;
import org.jline.utils.AttributedStyle;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

class WatchTableTest {
  @KukaController private MockServer server;
  private SampledRobot robot;
  private WatchTable table;

  private static Sampling sampling() throws IOException {
    Sampling.SamplingPlan plan =
        new Sampling.SamplingPlan(List.of("MYINT"), Duration.ofSeconds(1), null, 1);
    return Sampling.open(plan, List.of(), Robots::open);
  }

  @BeforeEach
  void start() throws IOException {
    Robot target =
        new Robot("", server.host(), server.port(), null, null, ServerType.KUKAVARPROXY, null);
    robot = new SampledRobot(target, Robots::open, sampling());
    robot.readFirst(List.of("MYINT", "MYFRAME"));
    table = new WatchTable(List.of(robot));
  }

  @AfterEach
  void stop() throws IOException {
    robot.close();
  }

  private void add(Instant time, Map<String, Reading> readings) {
    Sample sample = new Sample(1, time, Duration.ofMillis(2), readings, Set.of(), 0, 0);
    robot.count(sample);
    table.add(robot, sample);
  }

  private static Reading reading(String value) {
    return new Reading(
        KrlValue.parse(value), null, ReadingStatus.FRESH, Instant.EPOCH, Duration.ZERO);
  }

  /** Adds a sample of now. */
  private void add(String myInt, String myFrame) {
    Map<String, Reading> readings = new LinkedHashMap<>();
    readings.put("MYINT", reading(myInt));
    readings.put("MYFRAME", reading(myFrame));
    add(Instant.now(), readings);
  }

  private List<String> lines(int columns, int rows) {
    return table.lines(columns, rows, false).stream().map(AttributedString::toString).toList();
  }

  @Test
  void hasARowForEachNumberAndALineOfHowItGoes() {
    add("5", "{X 1.5, Y 2.5}");

    assertThat(table.text())
        .hasSize(6)
        .satisfiesExactly(
            line -> assertThat(line).matches("NAME +VALUE +CHANGE +AGE"),
            line -> assertThat(line).matches("MYINT +5 +\\d\\.\\d s"),
            line -> assertThat(line).matches("MYFRAME.X +1.50000 +\\d\\.\\d s"),
            line -> assertThat(line).matches("MYFRAME.Y +2.50000 +\\d\\.\\d s"),
            line -> assertThat(line).isEmpty(),
            line -> assertThat(line).startsWith("1 sample, access 2.0 ms (at most 2.0), missed 0"));
    assertThat(table.text())
        .filteredOn(line -> line.endsWith(" s"))
        .extracting(String::length)
        .containsOnly(36);
  }

  @Test
  void showsByHowMuchANumberChangedInTheControllersDigits() {
    add("5", "{X 27.0000057, Y 1.0}");
    add("-2", "{X 27.1000042, Y 1.0}");

    assertThat(table.text().get(1)).matches("MYINT +-2 +-7 +\\d\\.\\d s");
    assertThat(table.text().get(2)).matches("MYFRAME.X +27.1000042 +\\+0.0999985 +\\d\\.\\d s");
    assertThat(table.text().get(3)).matches("MYFRAME.Y +1.00000 +\\d\\.\\d s");
  }

  @Test
  void showsWhatATextWasBefore() {
    add("#T1", "{X 1.0}");
    add("#AUT", "{X 1.0}");

    assertThat(table.text().get(1)).matches("MYINT +#AUT +from #T1 +\\d\\.\\d s");
  }

  @Test
  void showsWhyAVariableCannotBeReadAndNoOldValues() {
    add("5", "{X 1.5}");
    Map<String, Reading> readings = new LinkedHashMap<>();
    readings.put(
        "MYINT",
        new Reading(
            null,
            robot.readFirst(List.of("NOPE")).get(0),
            ReadingStatus.FAILED,
            Instant.EPOCH,
            Duration.ZERO));
    readings.put("MYFRAME", reading("{X 1.5}"));
    add(Instant.now(), readings);

    assertThat(table.text().get(1)).matches("MYINT +the controller refused to read NOPE.*");

    add("6", "{X 1.5}");

    assertThat(table.text().get(1)).matches("MYINT +6 +\\d\\.\\d s");
  }

  @Test
  void showsFieldsOnlyWhileTheyAreInitialised() {
    add("5", "{X 1.5, Y 1.0}");
    add("5", "{Y 1.0, Z 2.0}");

    assertThat(String.join("\n", table.text())).contains("MYFRAME.Z").doesNotContain("MYFRAME.X");
  }

  @Test
  void cutsOffWhatTheTerminalHasNoRoomFor() {
    add("5", "{X 1.5, Y 2.5, Z 3.5}");

    assertThat(lines(12, 5))
        .hasSize(5)
        .allMatch(line -> line.length() <= 12)
        .startsWith("NAME        ")
        .contains("... 3 more")
        .last()
        .isEqualTo("1 sample, ac");
    assertThat(lines(80, 1)).hasSize(1);
  }

  private void add(ConnectionEvent.ConnectionChange change, Instant time) {
    ConnectionEvent event =
        new ConnectionEvent(change, time, ConnectionEvent.ChangeReason.NONE, null);
    robot.count(event);
    table.connectionChanged(robot, event);
  }

  @Test
  void marksEachRowAndSaysSinceWhenWhileTheConnectionIsLost() {
    add("5", "{X 1.5}");
    add(ConnectionEvent.ConnectionChange.LOST, Instant.parse("2026-01-02T03:04:05Z"));

    assertThat(table.text())
        .satisfiesExactly(
            line ->
                assertThat(line)
                    .startsWith("not connected since 2026-01-02T")
                    .endsWith(": the connection is lost"),
            line -> assertThat(line).startsWith("NAME "),
            line -> assertThat(line).matches("MYINT +5 +lost"),
            line -> assertThat(line).matches("MYFRAME.X +1.50000 +lost"),
            line -> assertThat(line).isEmpty(),
            line -> assertThat(line).startsWith("1 sample"));
    assertThat(table.lines(80, 24, true).subList(2, 4))
        .allMatch(line -> line.styleAt(0).equals(AttributedStyle.DEFAULT.faint()));

    add(ConnectionEvent.ConnectionChange.RECONNECTED, Instant.now());
    add("6", "{X 1.5}");

    assertThat(table.text().get(1)).matches("MYINT +6 +\\+1 +\\d\\.\\d s");
    assertThat(table.text()).last().asString().endsWith("reconnects 1");
  }

  @Test
  void marksOnlyTheRowsOfTheRobotWhoseConnectionIsLost() throws IOException {
    Robot target =
        new Robot("cell1", server.host(), server.port(), null, null, ServerType.KUKAVARPROXY, null);
    try (SampledRobot unnamed = robot;
        SampledRobot named = new SampledRobot(target, Robots::open, sampling())) {
      named.readFirst(List.of("MYINT"));
      table = new WatchTable(List.of(unnamed, named));
      add("5", "{X 1.5}");
      robot = named;
      add("5", "{X 1.5}");
      add(ConnectionEvent.ConnectionChange.LOST, Instant.now());

      assertThat(table.text())
          .anyMatch(line -> line.startsWith("cell1: not connected since "))
          .anyMatch(line -> line.matches("cell1:MYINT .* lost"))
          .anyMatch(line -> line.matches("MYINT .* s"));
    }
  }

  @Test
  void hasColoursOnlyIfTheyAreWanted() {
    add("5", "{X 1.5}");
    add("6", "{X 1.5}");

    assertThat(table.lines(80, 24, true).get(1).toAnsi()).contains("\u001b[");
    assertThat(table.lines(80, 24, false)).allMatch(line -> !line.toAnsi().contains("\u001b["));
  }

  @Test
  void labelsTheRowsOfARobotThatHasAName() throws IOException {
    Robot target =
        new Robot("cell1", server.host(), server.port(), null, null, ServerType.KUKAVARPROXY, null);
    try (SampledRobot unnamed = robot;
        SampledRobot named = new SampledRobot(target, Robots::open, sampling())) {
      table = new WatchTable(List.of(unnamed, named));
      robot = named;
      add("5", "{X 1.5}");

      assertThat(table.text())
          .anyMatch(line -> line.startsWith("cell1:MYINT "))
          .anyMatch(line -> line.startsWith("cell1:MYFRAME.X "))
          .last()
          .asString()
          .startsWith("cell1: 1 sample, ");
    }
  }
}
