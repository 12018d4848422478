package no.hials.crosscom.simulator;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.function.BooleanSupplier;
import no.hials.crosscom.kinematics.RobotModel;
import no.hials.crosscom.protocol.code.ProgramState;
import no.hials.crosscom.protocol.value.Frame;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/**
 * An interrupt brakes the robot in the middle of a spline block. What it then does is compared with
 * the positions of the block without an interrupt.
 */
class SplineInterruptTest {
  private static final Frame START = RobotModel.kr6r900sixx().forward(Cell.START);
  private static final String BLOCK =
      "SPLINE\nSPL "
          + point(0, 40, 10)
          + "\nSLIN "
          + point(-20, 80, 20)
          + "\nSPL "
          + point(-60, 90, 0)
          + "\nSCIRC "
          + point(-80, 60, 0)
          + ","
          + point(-60, 30, 0)
          + "\nENDSPLINE\n";
  private static final String INTERRUPT =
      "INTERRUPT DECL 1 WHEN $FLAG[1] DO IR1()\nINTERRUPT ON 1\n";

  /** How far a position between two cycles is from the straight line between them, mm. */
  private static final double BEND = 0.01;

  private final Cell cell = new Cell();
  private List<Frame> whole = List.of();

  private static String point(double x, double y, double z) {
    return "{X " + (START.x() + x) + ",Y " + (START.y() + y) + ",Z " + (START.z() + z) + "}";
  }

  @BeforeEach
  void rideWithoutInterrupt() throws KrlFileException {
    whole = ride("", BLOCK, "");
    cell.controller.place(Cell.START);
  }

  @AfterEach
  void close() {
    cell.close();
  }

  private void start(String declarations, String body, String routine) throws KrlFileException {
    cell.startModule(
        "TEST",
        Cell.module("TEST", "$VEL.CP=0.1\n$ADVANCE=3\n" + declarations + "SUB()\nPTP_REL {A6 5}")
            + Cell.module("SUB", body + "WAIT SEC 0\nMYBOOL=TRUE")
            + Cell.module("IR1", routine));
  }

  private List<Frame> ride(String declarations, String body, String routine)
      throws KrlFileException {
    start(declarations, body, routine);
    List<Frame> samples = rideUntil(() -> cell.get("MYBOOL").equals("TRUE"));
    cell.set("MYBOOL", "FALSE");
    cell.runToTheEnd();
    return samples;
  }

  private Frame now() {
    return RobotModel.kr6r900sixx().forward(cell.controller.axes());
  }

  private List<Frame> rideUntil(BooleanSupplier done) {
    List<Frame> samples = new ArrayList<>();
    samples.add(now());
    while (!done.getAsBoolean()) {
      assertThat(cell.controller.robot().state()).isEqualTo(ProgramState.ACTIVE);
      cell.cycles(1);
      samples.add(now());
    }
    return samples;
  }

  /** Raises the interrupt in the arc, away from all points, and waits until the robot stands. */
  private List<Frame> brakeInTheArc() {
    List<Frame> samples = rideUntil(() -> now().y() < START.y() + 85 && now().x() < START.x() - 65);
    cell.set("$FLAG[1]", "TRUE");
    samples.addAll(rideUntil(cell.controller::standing));
    assertThat(now().y()).isBetween(START.y() + 62, START.y() + 85);
    return samples;
  }

  /** Returns the number of the nearest line between two cycles of the whole ride. */
  private int lineAt(Frame position) {
    int nearest = 1;
    for (int i = 1; i < whole.size(); i++) {
      if (distance(i, position) < distance(nearest, position)) {
        nearest = i;
      }
    }
    return nearest;
  }

  /** Returns how much longer the way from one end of a line to the other is over a position. */
  private double distance(int line, Frame position) {
    Frame from = whole.get(line - 1);
    Frame to = whole.get(line);
    return position.distance(from) + position.distance(to) - from.distance(to);
  }

  /** Positions are on the path of the whole ride, one after the other. */
  private void assertFollowThePath(List<Frame> positions) {
    int last = 1;
    for (Frame position : positions) {
      int line = lineAt(position);
      assertThat(distance(line, position)).isLessThan(BEND);
      assertThat(line).isGreaterThanOrEqualTo(last);
      last = line;
    }
  }

  @Test
  void theRobotBrakesOnThePathAndContinuesOnIt() throws Exception {
    start(INTERRUPT, BLOCK, "BRAKE\nMYINT=1\nWAIT FOR $FLAG[2]");
    List<Frame> positions = brakeInTheArc();
    cell.cycles(20);
    assertThat(cell.get("MYINT")).isEqualTo("1");
    assertThat(now()).isEqualTo(positions.get(positions.size() - 1));

    cell.set("$FLAG[2]", "TRUE");
    positions.addAll(rideUntil(() -> cell.get("MYBOOL").equals("TRUE")));
    cell.runToTheEnd();

    assertFollowThePath(positions);
    assertThat(positions.get(positions.size() - 1).distance(whole.get(whole.size() - 1)))
        .isLessThan(1e-6);
  }

  @Test
  void theRobotReturnsToThePathAfterAMotionOfTheInterrupt() throws Exception {
    start(INTERRUPT, BLOCK, "BRAKE\nLIN_REL {Z 30}\nWAIT SEC 0\nMYINT=1");
    List<Frame> positions = brakeInTheArc();
    Frame left = now();
    List<Frame> away = rideUntil(() -> cell.get("MYINT").equals("1"));
    assertThat(away).anyMatch(position -> position.z() - left.z() > 29.9);

    rideUntil(() -> now().distance(left) < 1e-3);
    positions.addAll(rideUntil(() -> cell.get("MYBOOL").equals("TRUE")));
    cell.runToTheEnd();

    assertFollowThePath(positions);
  }

  @Test
  void resumeLeavesTheBlockWhereTheRobotStands() throws Exception {
    start(INTERRUPT, BLOCK, "BRAKE\nRESUME");
    List<Frame> positions = brakeInTheArc();
    double[] left = cell.controller.axes().toArray();
    cell.runToTheEnd();

    assertFollowThePath(positions);
    assertThat(cell.get("MYBOOL")).isEqualTo("FALSE");
    double[] end = cell.controller.axes().toArray();
    left[5] += 5;
    for (int axis = 0; axis < left.length; axis++) {
      assertThat(Math.abs(end[axis] - left[axis])).isLessThan(1e-3);
    }
  }
}
