package no.hials.crosscom.simulator;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import no.hials.crosscom.kinematics.Frames;
import no.hials.crosscom.kinematics.RobotModel;
import no.hials.crosscom.protocol.code.OperatingMode;
import no.hials.crosscom.protocol.code.ProgramState;
import no.hials.crosscom.protocol.value.Frame;
import no.hials.crosscom.protocol.value.KrlStruct;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/**
 * A linear unit along X of the world, 500 mm above the floor, on which the robot stands, and a
 * rotary axis that carries nothing.
 */
final class ExternalAxesTest {
  private static final double CYCLE = 0.012;
  private static final double SPEED = 1000;
  private static final double ACCELERATION = SPEED / 0.3;
  private static final String HOME = "PTP {A1 0,A2 -90,A3 90,A4 0,A5 45,A6 0,E1 0,E2 0}";

  private Cell cell;

  /** The positions after a cycle. */
  private record Sample(double e1, double e2, Frame world, boolean standing) {}

  @BeforeEach
  void createTheUnit() {
    VariableTable table = VariableTable.krc4();
    table.set("$EX_KIN", "{ET1 #ERSYS}");
    table.set("$ET1_AX", "{TR_A1 #E1,TR_A2 #NONE,TR_A3 #NONE}");
    // Z of its frame is X of the world, and the robot stands upright
    table.set("$ET1_TA1KR", "{X 0,Y 0,Z 500,A 0,B 90,C 0}");
    table.set("$ET1_TFLA3", "{X 0,Y 0,Z 0,A 0,B -90,C 0}");
    table.set("$EX_AX_NUM", "2");
    axis(table, 7, 1, -500, 3000, 18);
    axis(table, 8, 3, -90, 90, 180);
    cell = new Cell(Cell.stepped(table));
  }

  private static void axis(
      VariableTable table, int axis, int type, int minimum, int maximum, int ratio) {
    table.set("$AXIS_TYPE[" + axis + "]", "" + type);
    table.set("$SOFTN_END[" + axis + "]", minimum + ".0");
    table.set("$SOFTP_END[" + axis + "]", maximum + ".0");
    // 1000 mm/s and 100 degrees/s
    table.set("$VEL_AXIS_MA[" + axis + "]", "3000.0");
    table.set("$RAT_MOT_AX[" + axis + "]", "{N " + ratio + ",D 1}");
  }

  @AfterEach
  void close() {
    cell.close();
  }

  /** Runs statements to their end and returns the positions after each cycle. */
  private List<Sample> sample(String body) throws Exception {
    cell.start(body);
    List<Sample> samples = new ArrayList<>();
    while (cell.controller.robot().state() == ProgramState.ACTIVE) {
      samples.add(now());
      cell.cycles(1);
    }
    samples.add(now());
    assertThat(cell.controller.messages()).isEmpty();
    return samples;
  }

  private Sample now() {
    double e1 = cell.component("$AXIS_ACT", "E1");
    Frame flange = RobotModel.kr6r900sixx().forward(cell.controller.axes());
    Frame world = Frames.product(new Frame(e1, 0, 500, 0, 0, 0), flange);
    return new Sample(e1, cell.component("$AXIS_ACT", "E2"), world, cell.controller.standing());
  }

  private static void assertLimits(List<Sample> samples) {
    double before = 0;
    for (int i = 1; i < samples.size(); i++) {
      double speed = (samples.get(i).e1() - samples.get(i - 1).e1()) / CYCLE;
      assertThat(Math.abs(speed)).isLessThan(SPEED * 1.001);
      assertThat(Math.abs(speed - before) / CYCLE).isLessThan(ACCELERATION * 1.03);
      before = speed;
    }
  }

  @Test
  void jogsItsAxesByTheNumbersAfterA6() throws Exception {
    cell.controller.setMode(OperatingMode.T1);
    cell.set("$OV_JOG", "100");
    cell.controller.jog(JogCoordinates.AXIS, 7, true);
    cell.cycles(100);
    double before = now().e1();
    cell.cycles(100);
    assertThat(now().e1() - before).isEqualTo(84, within(0.1)); // 7 % of 1000 mm/s for 1.2 s

    cell.controller.releaseJog();
    cell.untilStanding();
    cell.controller.jog(JogCoordinates.AXIS, 8, false);
    cell.cycles(1);
    cell.untilStanding();
    assertThat(now().e2()).isEqualTo(-90, within(1e-6));
    assertThatThrownBy(() -> cell.controller.jog(JogCoordinates.AXIS, 9, true))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessage("jog: the number of the axis must be 1 to 8, is 9");
    assertThatThrownBy(() -> cell.controller.jog(JogCoordinates.BASE, 7, true))
        .hasMessage("jog: the number of the axis must be 1 to 6, is 7");
  }

  @Test
  void externalAxesStartAndEndWithTheRobot() throws Exception {
    cell.run(HOME);
    List<Sample> samples = sample("PTP {A1 90,E1 1500,E2 60}");

    assertLimits(samples);
    Sample end = samples.get(samples.size() - 1);
    assertThat(end.e1()).isEqualTo(1500);
    assertThat(end.e2()).isEqualTo(60);
    assertThat(cell.controller.axes().a1()).isEqualTo(90);
    for (Sample at : samples) {
      assertThat(at.e2()).isEqualTo(at.e1() * 60 / 1500, within(1e-3));
    }
    // 1.5 s at full speed and 0.3 s for its ramps, which A1 alone would not take
    assertThat(samples.stream().filter(at -> !at.standing()).count() * CYCLE)
        .isEqualTo(1.8, within(0.03));
  }

  @Test
  void theRootOfTheRobotFollowsTheUnit() throws Exception {
    cell.run(HOME);
    double before = cell.component("$POS_ACT", "X");
    cell.run("PTP {E1 -400}");

    assertThat(cell.get("$ROBROOT_C"))
        .isEqualTo("{FRAME: X -400.000, Y 0.0, Z 500.000, A 0.0, B 0.0, C 0.0}");
    assertThat(cell.component("$POS_ACT", "X")).isEqualTo(before - 400, within(1e-3));
    assertThat(cell.component("$POS_ACT", "Z")).isEqualTo(833.431 + 500, within(1e-3));
    assertThat(cell.component("$POS_ACT", "E1")).isEqualTo(-400);
    assertThat(cell.get("$AXIS_FOR.E1")).isEqualTo("-400.000");
    assertThat(cell.get("$AXIS_BACK.E1")).isEqualTo("0.0");
  }

  /** A block in the world; the unit moves between its points, which are 40 mm or more apart. */
  private static String block(int e1, int e2, int e3, int e4) {
    return "$VEL.CP=0.2\nSPLINE\n"
        + ("SPL {X 540,Y 40,Z 1340,E1 " + e1 + "}\n")
        + ("SLIN {X 540,Y 120,Z 1340,E1 " + e2 + "}\n")
        + ("SPL {X 500,Y 160,Z 1300,E1 " + e3 + "}\n")
        + ("SPL {X 440,Y 160,Z 1320,E1 " + e4 + "}\n")
        + "ENDSPLINE";
  }

  /** Returns the number of the nearest line between two samples. */
  private static int lineAt(List<Sample> path, Frame position) {
    int nearest = 1;
    for (int i = 1; i < path.size(); i++) {
      if (detour(path, i, position) < detour(path, nearest, position)) {
        nearest = i;
      }
    }
    return nearest;
  }

  /** Returns how much longer a line between two samples is over a position, mm. */
  private static double detour(List<Sample> path, int line, Frame position) {
    Frame from = path.get(line - 1).world();
    Frame to = path.get(line).world();
    return position.distance(from) + position.distance(to) - from.distance(to);
  }

  @Test
  void aSplineBlockHasOnePathInTheWorldWhateverTheUnitDoes() throws Exception {
    cell.run(HOME);
    List<Sample> still = sample(block(0, 0, 0, 0));
    cell.run(HOME);
    List<Sample> moved = sample(block(60, 200, 150, -100));

    assertLimits(moved);
    for (Sample at : moved) {
      assertThat(detour(still, lineAt(still, at.world()), at.world())).isLessThan(0.02);
      boolean straight = at.world().y() > 41 && at.world().y() < 119 && at.world().x() > 539;
      assertThat(straight ? Math.abs(at.world().x() - 540) : 0).isLessThan(1e-3);
    }
    assertThat(moved).anyMatch(at -> at.world().y() > 60 && at.world().y() < 100);
  }

  @Test
  void theUnitIsAtItsValuesAtThePointsOfASplineBlock() throws Exception {
    cell.run(HOME);
    List<Sample> samples = sample(block(60, 200, 150, -100));

    assertThat(unitAt(samples, new Frame(540, 40, 1340, 0, 0, 0))).isEqualTo(60, within(1.0));
    assertThat(unitAt(samples, new Frame(540, 120, 1340, 0, 0, 0))).isEqualTo(200, within(1.0));
    assertThat(unitAt(samples, new Frame(500, 160, 1300, 0, 0, 0))).isEqualTo(150, within(1.0));
    assertThat(samples.get(samples.size() - 1).e1()).isEqualTo(-100, within(1e-6));
  }

  /** Returns the position of the unit when the robot is at a point, between two cycles. */
  private static double unitAt(List<Sample> samples, Frame point) {
    int line = lineAt(samples, point);
    assertThat(detour(samples, line, point)).as("the robot passes the point").isLessThan(0.02);
    Sample from = samples.get(line - 1);
    Sample to = samples.get(line);
    double length = Math.max(1e-9, from.world().distance(to.world()));
    double part = Math.min(1, point.distance(from.world()) / length);
    return from.e1() + part * (to.e1() - from.e1());
  }

  @Test
  void aPtpSplineEndsWithItsExternalAxesAtTheSameTime() throws Exception {
    cell.run(HOME);
    List<Sample> samples =
        sample("PTP_SPLINE\nSPTP {A1 20,E1 300,E2 10}\nSPTP {A1 30,E1 700,E2 40}\nENDSPLINE");

    assertLimits(samples);
    Sample end = samples.get(samples.size() - 1);
    assertThat(end.e1()).isEqualTo(700);
    assertThat(end.e2()).isEqualTo(40);
    assertThat(samples)
        .as("passes the point in between with all axes")
        .anyMatch(at -> Math.abs(at.e1() - 300) < 15 && Math.abs(at.e2() - 10) < 1.5);
  }

  @Test
  void theSpeedOfExternalAxesIsInPercentOfTheirHighest() throws Exception {
    cell.run(HOME);
    cell.start("$VEL_EXTAX[1]=50\nPTP {E1 2000}");
    cell.cycles(60);

    assertThat(cell.real("$VEL_AXIS_ACT[7]")).isEqualTo(50, within(0.01));
    // m/s, seen from the world
    assertThat(cell.real("$VEL_ACT")).isEqualTo(0.5, within(1e-4));
  }

  @Test
  void aLineIsStraightInTheWorldWhileTheUnitMoves() throws Exception {
    cell.run(HOME);
    Frame from = now().world();
    List<Sample> samples = sample("$VEL.CP=0.4\nLIN_REL {X 900,Y 200,Z -100,E1 700}");

    assertLimits(samples);
    for (Sample at : samples) {
      double part = (at.world().x() - from.x()) / 900;
      assertThat(at.world().y() - from.y()).isEqualTo(200 * part, within(1e-3));
      assertThat(at.world().z() - from.z()).isEqualTo(-100 * part, within(1e-3));
      assertThat(at.e1()).isEqualTo(700 * part, within(2e-3));
      assertThat(Frames.angle(at.world(), from)).isLessThan(1e-4);
    }
    assertThat(samples.get(samples.size() - 1).e1()).isEqualTo(700);
    Sample one = samples.get(samples.size() / 2);
    Sample next = samples.get(samples.size() / 2 + 1);
    assertThat(one.world().distance(next.world()) / CYCLE).isEqualTo(400, within(0.1));
  }

  @Test
  void theTcpStaysInTheWorldWhileTheUnitMovesBelowIt() throws Exception {
    cell.run(HOME);
    Frame from = now().world();
    List<Sample> samples = sample("$VEL.CP=0.4\nLIN_REL {E1 -200}");

    assertLimits(samples);
    assertThat(samples.get(samples.size() - 1).e1()).isEqualTo(-200);
    assertThat(samples).allSatisfy(at -> assertThat(at.world().distance(from)).isLessThan(1e-3));
  }

  @Test
  void aCircleIsRoundInTheWorldWhileTheUnitMoves() throws Exception {
    cell.run(HOME);
    Frame from = now().world();
    List<Sample> samples = sample("CIRC_REL {X 150,Y 150},{X 300,Y 0,E1 250}");

    assertThat(samples.get(samples.size() - 1).e1()).isEqualTo(250);
    Frame centre = new Frame(from.x() + 150, from.y(), from.z(), 0, 0, 0);
    assertThat(samples)
        .allSatisfy(at -> assertThat(at.world().distance(centre)).isEqualTo(150, within(1e-3)));
  }

  @Test
  void aBlendIsSmoothInTheWorldWhileTheUnitMoves() throws Exception {
    cell.run(HOME);
    List<Sample> samples =
        sample("$VEL.CP=0.3\n$APO.CDIS=100\nLIN_REL {X 300,E1 300} C_DIS\nLIN_REL {Y 300,E1 100}");

    assertLimits(samples);
    Sample end = samples.get(samples.size() - 1);
    assertThat(end.e1()).isEqualTo(400);
    assertThat(end.world().x() - samples.get(0).world().x()).isEqualTo(300, within(1e-3));
    assertThat(end.world().y() - samples.get(0).world().y()).isEqualTo(300, within(1e-3));
    for (int i = 1; i < samples.size(); i++) {
      assertThat(samples.get(i).world().distance(samples.get(i - 1).world()))
          .isLessThan(300 * CYCLE * 1.01);
    }
  }

  @Test
  void aCartesianTargetOfPtpIsInTheWorld() throws Exception {
    cell.run(HOME);
    cell.run("PTP {X 1500,Y 100,Z 1200,A 180,B 45,C 180,S 2,T 3,E1 1000}");

    Frame world = now().world();
    assertThat(world.distance(new Frame(1500, 100, 1200, 0, 0, 0))).isLessThan(1e-3);
    assertThat(cell.component("$POS_ACT", "X")).isEqualTo(1500, within(1e-3));
  }

  @Test
  void anExternalAxisThatIsHeldSlowsDownWithinItsAcceleration() throws Exception {
    cell.run(HOME);
    cell.start("PTP {E1 2000}");
    List<Sample> samples = new ArrayList<>();
    for (int i = 0; i < 150; i++) {
      if (i == 60) {
        cell.controller.robot().stop();
      }
      samples.add(now());
      cell.cycles(1);
    }

    assertLimits(samples);
    assertThat(cell.controller.standing()).isTrue();
    assertThat(now().e1()).isBetween(500.0, 1500.0);
    cell.controller.start();
    cell.runToTheEnd();
    assertThat(now().e1()).isEqualTo(2000);
  }

  @Test
  void theUnitIsSlowInT1() throws Exception {
    cell.run(HOME);
    cell.controller.setMode(OperatingMode.T1);
    cell.set("$RED_T1", "100");
    cell.start("PTP {E1 500}");
    cell.cycles(50);

    // $SPEED_LIMIT_TEACH_MODE
    assertThat(cell.real("$VEL_ACT")).isEqualTo(0.22, within(1e-3));
  }

  @Test
  void theUnitStartsAtXhomeToo() throws Exception {
    cell.controller.load(
        "$config.dat",
        "DEFDAT $CONFIG PUBLIC\nDECL E6AXIS XHOME={A1 5.0,A2 -90.0,A3 90.0,A4 0.0,A5 30.0,A6 0.0,"
            + "E1 300.0,E2 0.0}\nENDDAT\n");

    assertThat(now().e1()).isEqualTo(300);
    assertThat(cell.get("$ROBROOT_C.X")).isEqualTo("300.000");
  }

  @Test
  void aTargetBeyondALimitIsRefused() throws Exception {
    cell.run(HOME);
    cell.start("PTP {E1 3001}");
    cell.cycles(5);

    assertThat(cell.message())
        .isEqualTo("1211 test.src:2:1: E1 must be at most 3000.000, would be 3001.000");
    assertThat(now().e1()).isZero();
  }

  @Test
  void anEndlessAxisHasNoLimits() throws Exception {
    cell.set("$AXIS_TYPE[8]", "5");
    cell.run("PTP {E2 720}");

    assertThat(now().e2()).isEqualTo(720);
  }

  @Test
  void theMachineDataOfAUnitAreKnown() {
    Controller controller = Cell.stepped(VariableTable.krc4());
    LoadReport report =
        controller.load(
            "$MACHINE.DAT",
            """
            DEFDAT $MACHINE PUBLIC
            $EX_AX_NUM=1
            $ET1_TA1KR={X 0.0,Y 0.0,Z 500.0,A 0.0,B 90.0,C 0.0}
            $ET1_TFLA3={X 0.0,Y 0.0,Z 0.0,A 0.0,B -90.0,C 0.0}
            $EX_KIN={ET1 #ERSYS,ET2 #NONE,ET3 #NONE,ET4 #NONE,ET5 #NONE,ET6 #NONE}
            $ET1_AX={TR_A1 #E1,TR_A2 #NONE,TR_A3 #NONE}
            $ERSYSROOT={X 0.0,Y 100.0,Z 0.0,A 0.0,B 0.0,C 0.0}
            $AXIS_TYPE[7]=1
            ENDDAT
            """,
            LoadingMode.LENIENT);

    assertThat(report.problems()).isEmpty();
    assertThat(controller.variables().get("$ROBROOT_C.Y")).isEqualTo("100.000");
    controller.close();
  }

  @Test
  void anAxisThatDoesNotExistStaysAtZero() throws Exception {
    cell.run("PTP {A1 10,E3 100}");

    assertThat(cell.get("$AXIS_ACT.E3")).isEqualTo("0.0");
  }

  @Test
  void anotherExternalAxisLeavesTheRootWhereItIs() throws Exception {
    cell.set("$EX_KIN.ET1", "#EASYS");
    cell.run("PTP {A1 10,E1 100}");

    assertThat(cell.get("$AXIS_ACT.E1")).isEqualTo("100.000");
    assertThat(cell.get("$ROBROOT_C.X")).isEqualTo("0.0");
    assertThat(cell.component("$POS_ACT", "Z")).isEqualTo(890, within(1e-3));
  }

  @Test
  void forwardAndInverseKnowTheUnit() throws Exception {
    cell.run(HOME);
    cell.startModule(
        "TEST",
        """
        DEF TEST()
        DECL E6AXIS AX
        DECL E6POS P
        INT I
        AX={A1 10,A2 -90,A3 90,A4 0,A5 45,A6 0,E1 800}
        P=FORWARD(AX,I)
        AX=INVERSE(P,AX,I)
        PTP AX
        END
        """);
    cell.runToTheEnd();

    assertThat(cell.controller.axes().a1()).isEqualTo(10, within(1e-3));
    assertThat(now().e1()).isEqualTo(800);
  }

  @Test
  void aSuspendedMotionGoesBackWithTheExternalAxes() throws Exception {
    cell.run(HOME);
    KrlStruct home = (KrlStruct) cell.controller.variables().value("$AXIS_ACT");
    cell.startModule(
        "TEST",
        """
        DEF TEST()
        INTERRUPT DECL 4 WHEN $FLAG[1] DO AWAY()
        INTERRUPT ON 4
        PTP {E1 2000}
        END
        DEF AWAY()
        BRAKE
        PTP {A1 20,E1 100}
        END
        """);
    cell.cycles(60);
    cell.set("$FLAG[1]", "TRUE");
    List<Sample> samples = new ArrayList<>();
    while (cell.controller.robot().state() == ProgramState.ACTIVE) {
      samples.add(now());
      cell.cycles(1);
    }

    assertThat(samples).anySatisfy(at -> assertThat(at.e1()).isEqualTo(100, within(1e-6)));
    assertThat(now().e1()).isEqualTo(2000);
    assertThat(cell.controller.axes().a1()).isEqualTo(home.get("A1").orElseThrow().asDouble());
  }
}
