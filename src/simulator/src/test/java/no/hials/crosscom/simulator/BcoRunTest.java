package no.hials.crosscom.simulator;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import no.hials.crosscom.protocol.code.OperatingMode;
import no.hials.crosscom.protocol.code.ProgramState;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;

/** The BCO run, the step modes and the selection of a line. */
class BcoRunTest {
  private static final String TWO_MOTIONS = "PTP {A1 20}\nMYINT=1\nPTP {A1 0}";

  private final Cell cell = new Cell();
  private final Controller controller = cell.controller;

  @BeforeEach
  void simulateBco() {
    controller.simulateBco(true);
  }

  @AfterEach
  void close() {
    controller.close();
  }

  private void start() {
    controller.start();
  }

  private void untilStopped() {
    cell.until(() -> controller.robot().state() != ProgramState.ACTIVE);
  }

  private List<Integer> numbers() {
    return controller.messages().stream().map(Message::number).toList();
  }

  // BCO

  @ParameterizedTest
  @EnumSource(names = {"T1", "T2", "AUT"})
  void theProgramStopsAtTheEndOfItsFirstMotion(OperatingMode mode) throws Exception {
    controller.setMode(mode);
    cell.set("MYINT", "0");
    cell.start(TWO_MOTIONS);
    untilStopped();

    assertThat(controller.robot().state()).isEqualTo(ProgramState.STOP);
    assertThat(controller.standing()).isTrue();
    assertThat(controller.axes().a1()).isEqualTo(20, within(1e-6));
    assertThat(cell.get("MYINT")).isEqualTo("0");
    assertThat(numbers()).containsExactly(1350);
    assertThat(cell.get("$STOPMESS")).isEqualTo("FALSE");

    start();
    untilStopped();

    assertThat(controller.robot().state()).isEqualTo(ProgramState.END);
    assertThat(controller.axes().a1()).isEqualTo(0, within(1e-6));
    assertThat(numbers()).containsExactly(1350);
  }

  @Test
  void inExtThereIsNone() throws Exception {
    controller.setMode(OperatingMode.EXT);
    cell.load(Cell.module("TEST", TWO_MOTIONS));
    controller.robot().select("TEST");
    start();
    untilStopped();

    assertThat(controller.robot().state()).isEqualTo(ProgramState.END);
    assertThat(controller.messages()).isEmpty();
  }

  @Test
  void isShownWhileItIsDueAndWhileItGoesOn() throws Exception {
    cell.load(Cell.module("TEST", TWO_MOTIONS));
    assertThat(cell.get("$ON_PATH")).isEqualTo("TRUE");
    controller.robot().select("TEST");

    assertThat(controller.messages())
        .singleElement()
        .satisfies(it -> assertThat(it.kind()).isEqualTo(Message.Kind.STATUS))
        .satisfies(it -> assertThat(it.number()).isEqualTo(309));
    assertThat(cell.get("$ON_PATH")).isEqualTo("FALSE");
    assertThat(cell.get("$MOVE_BCO")).isEqualTo("FALSE");

    start();
    cell.cycles(5);
    assertThat(cell.get("$MOVE_BCO")).isEqualTo("TRUE");
    assertThat(cell.get("$ON_PATH")).isEqualTo("FALSE");
    assertThat(numbers()).containsExactly(309);

    untilStopped();
    assertThat(cell.get("$MOVE_BCO")).isEqualTo("FALSE");
    assertThat(cell.get("$ON_PATH")).isEqualTo("TRUE");
    assertThat(numbers()).containsExactly(1350);
  }

  @Test
  void isAsSlowAsAMotionInT1AndFollowsTheOverride() throws Exception {
    cell.start("PTP {A1 160}");
    cell.cycles(395);
    assertThat(a1Speed()).isEqualTo(360 * 0.07, within(0.1)); // $RED_T1 is 7 %

    cell.set("$OV_PRO", "50");
    cell.cycles(50);
    assertThat(a1Speed()).isEqualTo(360 * 0.035, within(0.1));
  }

  private double a1Speed() {
    double before = controller.axes().a1();
    cell.cycles(10);
    return (controller.axes().a1() - before) / 0.12;
  }

  @Test
  void theFirstMotionEndsExactlyEvenIfItIsApproximated() throws Exception {
    cell.set("$APO.CPTP", "100");
    cell.start("PTP {A1 20} C_PTP\nPTP {A1 20,A2 -80} C_PTP\nPTP {A1 0}");
    untilStopped();

    assertThat(controller.axes().a1()).isEqualTo(20, within(1e-6));
    assertThat(controller.axes().a2()).isEqualTo(-90, within(1e-6));
  }

  @Test
  void isDueAgainAfterAReset() throws Exception {
    cell.start(TWO_MOTIONS);
    untilStopped();
    controller.robot().reset();

    assertThat(numbers()).containsExactly(1350, 309);
    start();
    untilStopped();
    assertThat(controller.robot().state()).isEqualTo(ProgramState.STOP);
  }

  @Test
  void aStopOnTheWayLeavesTheRestToTheNextStart() throws Exception {
    cell.start(TWO_MOTIONS);
    cell.cycles(5);
    controller.robot().stop();
    cell.untilStanding();
    assertThat(cell.get("$ON_PATH")).isEqualTo("FALSE");

    start();
    untilStopped();

    assertThat(controller.axes().a1()).isEqualTo(20, within(1e-6));
    assertThat(controller.robot().state()).isEqualTo(ProgramState.STOP);
  }

  @Test
  void anInterruptThatDiscardsTheMotionLeavesTheRunDue() throws Exception {
    cell.load(
        """
        DEF TEST()
        GLOBAL INTERRUPT DECL 3 WHEN $IN[1]==TRUE DO STOPS()
        INTERRUPT ON 3
        MOVES()
        PTP {A1 10}
        MYINT=7
        END
        DEF MOVES()
        PTP {A1 90}
        $ADVANCE=0
        END
        DEF STOPS()
        BRAKE
        RESUME
        END
        """);
    cell.set("MYINT", "0");
    controller.robot().select("TEST");
    start();
    cell.cycles(20);
    cell.set("$IN[1]", "TRUE");
    untilStopped();

    assertThat(controller.axes().a1()).isEqualTo(10, within(1e-6));
    assertThat(cell.get("MYINT")).isEqualTo("0");
    assertThat(numbers()).containsExactly(1350);
  }

  @Test
  void runProgramPressesStartAgain() throws Exception {
    cell.load(Cell.module("TEST", TWO_MOTIONS));
    controller.robot().select("TEST");
    controller.runProgram();
    untilStopped();

    assertThat(controller.robot().state()).isEqualTo(ProgramState.END);
    assertThat(numbers()).containsExactly(1350);
  }

  @Test
  void aProgramWithoutMotionsNeedsNone() throws Exception {
    cell.start("MYINT=5");
    untilStopped();

    assertThat(controller.robot().state()).isEqualTo(ProgramState.END);
    assertThat(controller.messages()).isEmpty();
  }

  // step modes

  @ParameterizedTest
  @CsvSource({"$PRO_MODE1", "$PRO_MODE"})
  void mstepStopsAfterEachMotion(String variable) throws Exception {
    controller.simulateBco(false);
    cell.set(variable, "#MSTEP");
    cell.set("MYINT", "0");
    cell.start("PTP {A1 10} C_PTP\nMYINT=1\nPTP {A1 20} C_PTP\nMYINT=2");
    untilStopped();
    assertThat(controller.axes().a1()).isEqualTo(10, within(1e-6));
    assertThat(cell.get("MYINT")).isEqualTo("0");

    start();
    untilStopped();
    assertThat(controller.axes().a1()).isEqualTo(20, within(1e-6));
    assertThat(cell.get("MYINT")).isEqualTo("1");
    assertThat(cell.get("$PRO_MODE1")).isEqualTo("#MSTEP");
    assertThat(cell.get("$PRO_MODE")).isEqualTo("#MSTEP");

    start();
    untilStopped();
    assertThat(controller.robot().state()).isEqualTo(ProgramState.END);
  }

  @Test
  void istepStopsAfterEachLine() throws Exception {
    controller.simulateBco(false);
    cell.set("$PRO_MODE1", "#ISTEP");
    cell.load(
        """
        DEF TEST()
        MYINT=1
        SUB()
        FOR MYINT=1 TO 2
        PTP_REL {A1 5}
        ENDFOR
        LOOP
        MYINT=9
        ENDLOOP
        END
        DEF SUB()
        MYINT=2
        END
        """);
    controller.robot().select("TEST");

    int[] lines = {3, 12, 13, 4, 5, 4, 5, 4, 8, 7, 8, 7};
    assertThat(controller.robot().line()).isEqualTo(2);
    for (int line : lines) {
      start();
      untilStopped();
      assertThat(controller.robot().line()).isEqualTo(line);
      assertThat(controller.standing()).isTrue();
    }
    assertThat(controller.axes().a1()).isEqualTo(10, within(1e-6));
  }

  @Test
  void pstepStopsAfterEachLineButNotInRoutines() throws Exception {
    controller.simulateBco(false);
    cell.set("$PRO_MODE1", "#PSTEP");
    cell.load(
        """
        DEF TEST()
        MYINT=1
        SUB()
        PTP_REL {A1 5}
        MYINT=3
        END
        DEF SUB()
        PTP_REL {A1 5}
        MYINT=2
        PTP_REL {A1 5}
        END
        """);
    controller.robot().select("TEST");

    for (int line : new int[] {3, 4, 5, 6}) {
      start();
      untilStopped();
      assertThat(controller.robot().line()).isEqualTo(line);
      assertThat(cell.get("MYINT")).isEqualTo(line == 3 ? "1" : line == 6 ? "3" : "2");
      assertThat(controller.axes().a1())
          .isEqualTo(line == 3 ? 0 : line == 4 ? 10 : 15, within(1e-6));
    }
  }

  @Test
  void cstepStopsAfterMotionsThatAreNotApproximated() throws Exception {
    controller.simulateBco(false);
    cell.set("$PRO_MODE1", "#CSTEP");
    cell.set("MYINT", "0");
    cell.start(
        "$ADVANCE=3\n$APO.CPTP=50\nPTP {A1 10} C_PTP\nMYINT=1\nPTP {A1 20}\nMYINT=2\n"
            + "PTP {A1 30}\nMYINT=3");
    cell.until(() -> controller.axes().a1() > 1);
    cell.until(controller::standing);
    assertThat(controller.axes().a1()).isEqualTo(20, within(1e-6));
    untilStopped();
    assertThat(cell.get("MYINT")).isEqualTo("1");

    start();
    untilStopped();
    assertThat(controller.axes().a1()).isEqualTo(30, within(1e-6));
    assertThat(cell.get("MYINT")).isEqualTo("2");
  }

  @ParameterizedTest
  @CsvSource({"$PRO_MODE1,#BSTEP", "$PRO_MODE0,#ISTEP"})
  void otherModesAreAcceptedAndRunTheProgram(String variable, String mode) throws Exception {
    controller.simulateBco(false);
    cell.set(variable, mode);
    cell.start("PTP {A1 10}\nPTP {A1 20}");
    untilStopped();

    assertThat(controller.robot().state()).isEqualTo(ProgramState.END);
    assertThat(cell.get(variable)).isEqualTo(mode);
  }

  @Test
  void goRunsOn() throws Exception {
    controller.simulateBco(false);
    cell.set("$PRO_MODE1", "#MSTEP");
    cell.start(TWO_MOTIONS);
    untilStopped();
    cell.set("$PRO_MODE1", "#GO");
    start();
    untilStopped();

    assertThat(controller.robot().state()).isEqualTo(ProgramState.END);
  }

  // the selection of a line

  @Test
  void aProgramGoesOnAtTheSelectedLineAfterABcoRun() throws Exception {
    cell.set("MYINT", "0");
    cell.load(Cell.module("TEST", "PTP {A1 50}\nMYINT=1\n;\nPTP {A1 20}\nPTP {A1 0}"));
    controller.robot().select("TEST");
    controller.robot().selectLine(4);
    assertThat(controller.robot().line()).isEqualTo(5);
    assertThat(numbers()).containsExactly(309);

    start();
    untilStopped();
    assertThat(controller.axes().a1()).isEqualTo(20, within(1e-6));
    assertThat(cell.get("MYINT")).isEqualTo("0");
    assertThat(numbers()).containsExactly(1350);

    start();
    untilStopped();
    assertThat(controller.robot().state()).isEqualTo(ProgramState.END);
  }

  @ParameterizedTest
  @CsvSource({"3, 3", "4, 3", "5, 3", "6, 7", "7, 7"})
  void aLineOfASplineBlockSelectsTheBlock(int line, int selected) throws Exception {
    cell.load(
        Cell.module(
            "TEST",
            "MYINT=1\nPTP_SPLINE\nSPTP {A1 10}\nSPTP {A1 20}\nENDSPLINE\nMYINT=2\nPTP {A1 0}"));
    controller.robot().select("TEST");
    controller.robot().selectLine(line);

    assertThat(controller.robot().line()).isEqualTo(selected);
  }

  @Test
  void theSelectionOfALineOfACallerLeavesTheRoutine() throws Exception {
    cell.load("DEF TEST()\nSUB()\nMYINT=3\nEND\nDEF SUB()\nHALT\nMYINT=2\nEND\n");
    controller.robot().select("TEST");
    start();
    untilStopped();
    assertThat(controller.robot().line()).isEqualTo(7);

    controller.robot().selectLine(3);
    start();
    untilStopped();
    assertThat(cell.get("MYINT")).isEqualTo("3");
  }

  @Test
  void aLineThatCannotBeSelectedChangesNothing() throws Exception {
    cell.load("DEF TEST()\nMYINT=3\nEND\nDEF SUB()\nMYINT=2\nEND\n");
    assertThatThrownBy(() -> controller.robot().selectLine(2))
        .isInstanceOf(IllegalStateException.class)
        .hasMessageContaining("a program must be selected");
    controller.robot().select("TEST");

    assertThatThrownBy(() -> controller.robot().selectLine(5))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessage("line 5 is in no routine that is being executed");
    assertThat(controller.robot().line()).isEqualTo(2);
    assertThat(controller.robot().state()).isEqualTo(ProgramState.RESET);
  }

  @Test
  void aLoopThatDoesNotRunCannotBeContinued() throws Exception {
    cell.start("FOR MYINT=1 TO 3\nMYINTS[1]=1\nENDFOR");
    untilStopped();
    controller.robot().selectLine(3);
    controller.confirmAll();
    controller.robot().reset();
    controller.robot().selectLine(3);
    start();
    untilStopped();

    assertThat(controller.messages())
        .anySatisfy(
            it ->
                assertThat(it.text())
                    .isEqualTo(
                        "test.src:2:1: a FOR or SWITCH cannot be continued after the selection of a"
                            + " line in it"));
  }
}
