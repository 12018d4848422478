package no.hials.crosscom.simulator.internal.program;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import no.hials.crosscom.lang.Statement.Approximation;
import no.hials.crosscom.protocol.code.Interpreter;
import no.hials.crosscom.protocol.code.ProgramState;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class MotionTest {

  private static MotionOrder order(String statement) {
    Rig rig = new Rig().start("DEF TEST()\n" + statement + "\nEND\n").cycle();
    assertThat(rig.robot.faults).isEmpty();
    return rig.robot.orders.get(0);
  }

  @Test
  void handsOverTheTargetWithTheValuesOfThatMoment() {
    Rig rig = new Rig().start("DEF TEST()\nF.X = 7\nPTP F\nF.X = 8\nEND\n").cycle();

    MotionOrder order = rig.robot.orders.get(0);
    assertThat(order.target().print())
        .isEqualTo("{FRAME: X 7.00000, Y 2.00000, Z 3.00000, A 0.0, B 0.0, C 0.0}");
    assertThat(order.pointName()).isEqualTo("F");
    assertThat(order.module()).isEqualTo("TEST");
    assertThat(order.position().line()).isEqualTo(3);
    assertThat(rig.get("F.X")).isEqualTo("8.0");
  }

  @ParameterizedTest
  @ValueSource(strings = {"PTP", "LIN", "PTP_REL", "LIN_REL"})
  void handsOverTheKind(String kind) {
    MotionOrder order = order(kind + " {X 1}");

    assertThat(order.kind()).hasToString(kind);
    assertThat(order.pointName()).isEmpty();
    assertThat(order.approximations()).isEmpty();
    assertThat(order.circularAngle()).isEmpty();
    assertThat(order.auxiliary()).isNull();
    assertThat(order.coordinates()).isNull();
  }

  @Test
  void handsOverTheAuxiliaryPointAndTheAngleOfACircle() {
    MotionOrder order = order("CIRC {X I+1},F,CA 90*2 C_DIS");

    assertThat(order.auxiliary()).hasToString("{X 1}");
    assertThat(order.target().get("Y"))
        .hasValueSatisfying(y -> assertThat(y).hasToString("2.00000"));
    assertThat(order.circularAngle()).hasValue(180);
    assertThat(order.approximations()).containsExactly(Approximation.C_DIS);
  }

  @Test
  void handsOverTheCoordinatesOfARelativeMotion() {
    assertThat(order("LIN_REL {Z 5} C_DIS #tool").coordinates()).isEqualTo("TOOL");
  }

  @Test
  void computesTheTarget() {
    assertThat(order("LIN G : F").target().get("X"))
        .hasValueSatisfying(x -> assertThat(x).hasToString("8.00000"));
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "PTP 5 | 1446 line 2: needs a position, was given 5",
        "PTP NOWHERE | 1422 line 2: NOWHERE: has no value yet",
        "CIRC TRUE,F | 1446 line 2: needs a position, was given TRUE",
      })
  void refusesATargetThatIsNone(String statement, String message) {
    assertThat(new Rig().faultIn(statement)).isEqualTo(message);
  }

  @Test
  void stopsWithTheMessageOfARefusedMotion() {
    Rig rig = new Rig();
    rig.robot.refuses = true;

    assertThat(rig.faultIn("I = 1\nPTP F")).isEqualTo("1234 line 3: the target is out of reach");
  }

  @Test
  void canTryARefusedMotionAgain() {
    Rig rig = new Rig();
    rig.robot.refuses = true;
    rig.faultIn("PTP F\nI = 1");
    rig.robot.refuses = false;

    rig.interpreter.start();
    rig.cycle();

    assertThat(rig.robot.orders).hasSize(1);
    assertThat(rig.get("I")).isEqualTo("1");
  }

  // the advance run

  @ParameterizedTest
  @CsvSource({"0, 1, 2", "1, 2, 3", "3, 4, 5", "5, 6, 6"})
  void plansAsManyMotionsAheadAsAllowed(String advance, int first, int second) {
    Rig rig =
        new Rig()
            .set("$ADVANCE", advance)
            .start("DEF TEST()\nFOR I = 1 TO 6\nPTP {A1 I}\nENDFOR\nEND\n")
            .cycles(3);
    assertThat(rig.robot.orders).hasSize(first);

    rig.endMotion().cycle();

    assertThat(rig.robot.orders).hasSize(second);
  }

  @Test
  void staysAtTheMotionThatCannotBePlannedYet() {
    Rig rig =
        new Rig().set("$ADVANCE", "1").start("DEF TEST()\nPTP F\nPTP G\nPTP P\nEND\n").cycles(3);

    assertThat(rig.line()).isEqualTo(4);
  }

  @Test
  void staysAtAMotionUntilItIsDoneWithoutAdvance() {
    Rig rig = new Rig().set("$ADVANCE", "0").start("DEF TEST()\nPTP F\nI = 1\nEND\n").cycles(2);
    assertThat(rig.line()).isEqualTo(2);
    assertThat(rig.get("I")).isEqualTo("0");

    assertThat(rig.endMotion().get("I")).isEqualTo("1");
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "B = $IN[1]",
        "$OUT[1] = TRUE",
        "B = SENSOR",
        "NIBBLE = 1",
        "ARR[$TIMER[1]] = 1",
        "B = NOT (1 == 2 OR $IN[2])",
        "R = ABS($TIMER[1])",
        "F = {X $TIMER[1]}",
        "IF $IN[1] THEN\nENDIF",
        "SWITCH $TIMER[1]\nCASE 5\nENDSWITCH",
        "FOR J = 1 TO $TIMER[1]\nENDFOR",
        "WHILE $IN[1]\nENDWHILE",
        "REPEAT\nUNTIL NOT $IN[1]",
        "SUB($TIMER[1])",
        "LIN {X $TIMER[1]}",
        "PULSE($OUT[1],TRUE,1)",
        "WAIT FOR TRUE",
        "WAIT SEC 0",
        "HALT",
      })
  void waitsForTheMotionAheadOf(String statement) {
    Rig rig =
        new Rig()
            .set("$TIMER[]", "1")
            .start(
                "DEF TEST()\nPTP F\nK = 1\n"
                    + statement
                    + "\nK = 2\nEND\nDEF SUB(N:IN)\nINT N\nEND\n")
            .cycles(2);
    assertThat(rig.get("K")).isEqualTo("1");
    assertThat(rig.line()).isBetween(4, 5);

    rig.endMotion();
    if (rig.interpreter.state() == ProgramState.STOP) {
      rig.interpreter.start();
    }

    assertThat(rig.cycles(2).get("K")).isEqualTo("2");
  }

  @ParameterizedTest
  @ValueSource(strings = {"I = ARR[2] + 1", "B = UNWIRED", "B = $STOPMESS", "MINE = 1\nI = MINE"})
  void doesNotWaitForTheMotionAheadOf(String statement) {
    Rig rig =
        new Rig().start("DEF TEST()\nINT MINE\nPTP F\n" + statement + "\nK = 2\nEND\n").cycle();

    assertThat(rig.get("K")).isEqualTo("2");
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "B = $IN[1]",
        "WAIT FOR TRUE",
        "WAIT SEC 0",
        "PULSE($OUT[1],TRUE,1)",
        "IF $IN[1] THEN\nENDIF",
        "REPEAT\nI = I + 1\nUNTIL NOT $IN[1]",
      })
  void doesNotWaitForTheMotionBehindContinue(String statement) {
    Rig rig =
        new Rig()
            .start(
                "DEF TEST()\nPTP F\nCONTINUE\n" + statement + "\nK = 1\nB = $IN[1]\nK = 2\nEND\n");

    assertThat(rig.cycle().get("K")).isEqualTo("1");
    assertThat(rig.endMotion().get("K")).isEqualTo("2");
  }

  @Test
  void letsContinueHoldForOneStatementOnly() {
    Rig rig =
        new Rig()
            .start("DEF TEST()\nPTP F\nCONTINUE\nIF NOT $IN[1] THEN\n$OUT[1] = TRUE\nENDIF\nEND\n")
            .cycle();
    assertThat(rig.get("$OUT[1]")).isEqualTo("FALSE");

    assertThat(rig.endMotion().get("$OUT[1]")).isEqualTo("TRUE");
  }

  @Test
  void endsWhenTheRobotHasEndedItsMotions() {
    Rig rig = new Rig().start("DEF TEST()\nPTP F\nEND\n").cycles(3);
    assertThat(rig.interpreter.state()).isEqualTo(ProgramState.ACTIVE);
    assertThat(rig.line()).isEqualTo(3);

    rig.endMotion();

    assertThat(rig.interpreter.state()).isEqualTo(ProgramState.END);
  }

  // triggers

  @Test
  void handsOverTriggersWithTheNextMotion() {
    Rig rig =
        new Rig()
            .start(
                """
                DEF TEST()
                  TRIGGER WHEN DISTANCE=0 DELAY=10+10 DO $OUT[1]=TRUE
                  TRIGGER WHEN PATH=-20 DELAY=0 DO SUB() PRIO=-1
                  LIN F
                  LIN G
                END
                DEF SUB()
                END
                """)
            .cycle();

    MotionOrder order = rig.robot.orders.get(0);
    assertThat(order.triggers()).hasSize(2);
    assertThat(order.triggers().get(0).onPath()).isFalse();
    assertThat(order.triggers().get(0).distance()).isZero();
    assertThat(order.triggers().get(0).delayMillis()).isEqualTo(20);
    assertThat(order.triggers().get(1).onPath()).isTrue();
    assertThat(order.triggers().get(1).distance()).isEqualTo(-20);
    assertThat(rig.robot.orders.get(1).triggers()).isEmpty();
  }

  @Test
  void executesTheActionOfATriggerWithTheVariablesOfItsRoutine() {
    Rig rig =
        new Rig()
            .start(
                """
                DEF TEST()
                  INT N
                  N = 5
                  TRIGGER WHEN DISTANCE=1 DELAY=0 DO I=N
                  TRIGGER WHEN DISTANCE=1 DELAY=0 DO PULSE(GRIPPER,TRUE,N)
                  TRIGGER WHEN DISTANCE=1 DELAY=0 DO SUB(N) PRIO=20
                  LIN F
                  N = 6
                END
                DEF SUB(A:OUT)
                  INT A
                  J = A
                END
                """)
            .cycle();

    rig.robot.endMotion().triggers().forEach(rig.interpreter::fire);
    rig.cycle();

    assertThat(rig.get("I")).isEqualTo("6");
    assertThat(rig.get("J")).isEqualTo("6");
    assertThat(rig.robot.log).contains("pulse 6 true 6.0");
    assertThat(rig.interpreter.state()).isEqualTo(ProgramState.END);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "TRIGGER WHEN DISTANCE=2 DELAY=0 DO I=1 | DISTANCE is 0 (start) or 1 (end), is 2.0",
        "TRIGGER WHEN DISTANCE=0 DELAY=0 DO TEST() PRIO=50 | the priority of an interrupt is 1 to"
            + " 39",
      })
  void refusesATriggerThatIsNotPossible(String statement, String message) {
    assertThat(new Rig().faultIn(statement)).startsWith("1422 line 2: " + message);
  }

  // the submit interpreter

  @ParameterizedTest
  @CsvSource({
    "PTP F, a motion",
    "BRAKE, BRAKE",
    "RESUME, RESUME",
    "TRIGGER WHEN DISTANCE=0 DELAY=0 DO I=1, TRIGGER",
  })
  void refusesToMoveInTheSubmitInterpreter(String statement, String what) {
    assertThat(new Rig(Interpreter.SUBMIT).faultIn(statement))
        .isEqualTo("9010 line 2: " + what + " is not allowed in the submit interpreter");
  }

  @Test
  void doesNotWaitForTheRobotInTheSubmitInterpreter() throws Exception {
    Rig rig = new Rig();
    rig.start("DEF TEST()\nPTP F\nEND\n").cycle();
    KrlInterpreter other = new KrlInterpreter(Interpreter.SUBMIT, rig.robot);

    rig.load("DEF SPS()\n$OUT[2] = TRUE\nEND\n");
    other.select(rig.library.program("SPS"), List.of());
    other.start();
    other.run(100);

    assertThat(other.state()).isEqualTo(ProgramState.END);
    assertThat(rig.get("$OUT[2]")).isEqualTo("TRUE");
  }
}
