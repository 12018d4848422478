package no.hials.crosscom.kinematics;

import static no.hials.crosscom.kinematics.Frames.angle;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Random;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import no.hials.crosscom.protocol.value.Axis;
import no.hials.crosscom.protocol.value.Frame;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

final class RobotTableTest {
  private static final Axis FAR = Axis.of(720, 720, 720, 720, 720, 720);
  private static final int POSES = 60;

  @ParameterizedTest
  @ValueSource(strings = {"KR 210 R2700-2", "kr210r2700-2", " KR210 R2700-2 "})
  void findsARobotInAnyCaseWithOrWithoutBlanks(String name) {
    RobotModel robot = RobotModel.named(name);

    assertThat(robot.name()).isEqualTo("KR 210 R2700-2");
    // the arm stretched upwards
    Frame flange = robot.forward(Axis.of(0, -90, 0, 0, 0, 0));
    assertThat(flange.x()).isEqualTo(330 - 115, within(1e-9));
    assertThat(flange.z()).isEqualTo(645 + 1150 + 1220 + 215, within(1e-9));
    assertThat(robot.maximum(1)).isEqualTo(-5);
    assertThat(robot.maxSpeed(0)).isEqualTo(116.8);
    assertThat(robot.maxAcceleration(0)).isEqualTo(116.8 / 0.3);
  }

  @Test
  void anUnknownNameIsAnsweredByTheNearestOnes() {
    assertThatIllegalArgumentException()
        .isThrownBy(() -> RobotModel.named("KR 210 R2700"))
        .withMessageStartingWith(
            "no robot is named KR 210 R2700, the nearest names are KR 210 R2700-2, ");
    assertThatIllegalArgumentException()
        .isThrownBy(() -> RobotModel.named("kr210"))
        .withMessage(
            "no robot is named kr210, the nearest names are KR 210 R2700-2, KR 210 R3100-2,"
                + " KR 210 R3300-2 K");
  }

  @Test
  void listsEveryNameOnce() {
    assertThat(RobotModel.names()).hasSize(45).doesNotHaveDuplicates().contains("KR 6 R900 sixx");
    assertThat(RobotModel.named("kr6r900sixx")).isSameAs(RobotModel.kr6r900sixx());
  }

  /** A row that was copied to another robot by mistake would make two robots of one arm. */
  @Test
  void noTwoRobotsHaveTheSameNumbers() {
    Map<String, String> names = new HashMap<>();
    for (String name : RobotModel.names()) {
      RobotModel robot = RobotModel.named(name);
      Frame reach = robot.forward(Axis.of(10, -70, 50, 40, 30, 20));
      StringBuilder numbers = new StringBuilder(reach.toString());
      for (int axis = 0; axis < Axis.COUNT; axis++) {
        numbers.append(' ').append(robot.minimum(axis)).append(' ').append(robot.maximum(axis));
        numbers.append(' ').append(robot.maxSpeed(axis));
      }
      assertThat(names.put(numbers.toString(), name)).as("same numbers as " + name).isNull();
    }
  }

  @Test
  void thePageOfTheReferenceHasEveryNumberOfTheTable() throws IOException {
    List<String> page =
        Files.readAllLines(Path.of("../../docs/reference/robots.md")).stream()
            .filter(line -> line.startsWith("| KR "))
            .map(line -> line.substring(2, line.lastIndexOf(" | ")))
            .toList();
    List<String> table;
    try (InputStream file = RobotModel.class.getResourceAsStream("robots.tsv")) {
      table =
          new String(Objects.requireNonNull(file).readAllBytes(), StandardCharsets.UTF_8)
              .lines()
              .filter(line -> line.startsWith("KR "))
              .map(line -> line.split("\t"))
              // b and the signs are the same for all
              .map(row -> columns(row, 0, 1, 2, 4, 5, 6, 7, 9, 10, 11))
              .toList();
    }

    assertThat(page).isEqualTo(table);
  }

  private static String columns(String[] row, int... columns) {
    return Arrays.stream(columns).mapToObj(i -> row[i]).collect(Collectors.joining(" | "));
  }

  static Stream<String> names() {
    return RobotModel.names().stream();
  }

  @ParameterizedTest
  @MethodSource("names")
  void statusAndTurnLeadBackToAxesWithinTheLimitsAndNearThem(String name) throws Exception {
    RobotModel robot = RobotModel.named(name);
    Random random = new Random(name.hashCode());
    for (int i = 0; i < POSES; i++) {
      Axis axes = withinLimits(robot, random);

      Axis found = robot.inverse(robot.forward(axes), robot.status(axes), robot.turn(axes));

      assertThat(found.largestDifference(axes)).as(axes.toString()).isLessThan(1e-5);
    }
  }

  /** Returns axes of which every third is within 0.5 degrees of a limit, away from A5 = 0. */
  private static Axis withinLimits(RobotModel robot, Random random) {
    double[] six = new double[Axis.COUNT];
    for (int axis = 0; axis < six.length; axis++) {
      double low = Math.max(-359, robot.minimum(axis));
      double high = Math.min(359, robot.maximum(axis));
      six[axis] =
          switch (random.nextInt(6)) {
            case 0 -> low + random.nextDouble(0.5);
            case 1 -> high - random.nextDouble(0.5);
            default -> random.nextDouble(low, high);
          };
    }
    Axis axes = Axis.of(six);
    boolean regular = robot.inverse(robot.forward(axes)).size() == 8 && Math.abs(axes.a5()) > 1;
    return regular ? axes : withinLimits(robot, random);
  }

  @ParameterizedTest
  @MethodSource("names")
  void allEightConfigurationsLeadToTheFrameAndBack(String name) throws Exception {
    RobotModel robot = RobotModel.named(name);
    RobotModel free = robot.withLimits(Axis.ZERO.minus(FAR), FAR);
    Random random = new Random(name.hashCode());
    for (int i = 0; i < POSES; i++) {
      Frame flange = robot.forward(withinLimits(robot, random));

      List<Axis> solutions = robot.inverse(flange);

      assertThat(solutions).extracting(robot::status).containsExactly(0, 1, 2, 3, 4, 5, 6, 7);
      for (Axis axes : solutions) {
        Frame back = robot.forward(axes);
        assertThat(back.distance(flange)).isLessThan(1e-6);
        assertThat(angle(back, flange)).isLessThan(1e-6);
        Axis again = free.inverse(back, robot.status(axes), robot.turn(axes));
        assertThat(again.largestDifference(axes)).isLessThan(1e-5);
      }
    }
  }
}
