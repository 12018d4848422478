package no.hials.crosscom.simulator.internal.program;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.tuple;

import java.util.List;
import no.hials.crosscom.protocol.code.ProgramState;
import no.hials.crosscom.protocol.value.KrlBool;
import no.hials.crosscom.protocol.value.KrlInt;
import no.hials.crosscom.simulator.KrlExecutionException;
import no.hials.crosscom.simulator.internal.program.KrlInterpreter.Level;
import org.junit.jupiter.api.Test;

class KrlInterpreterTest {
  private static final String WAITING = "DEF TEST()\nI = I + 1\nWAIT FOR $IN[1]\nI = 0\nEND\n";

  @Test
  void hasNoProgramAtFirst() {
    KrlInterpreter interpreter = new Rig().interpreter;

    assertThat(interpreter.state()).isEqualTo(ProgramState.FREE);
    assertThat(interpreter.program()).isEmpty();
    assertThat(interpreter.levels()).isEmpty();
    assertThat(interpreter.start()).isFalse();
    assertThat(interpreter.stop()).isFalse();
    assertThat(interpreter.reset()).isFalse();
    assertThat(interpreter.cancel()).isFalse();
    assertThat(interpreter.run(100)).isZero();
  }

  @Test
  void goesFromStateToState() {
    Rig rig = new Rig().load(WAITING).select("TEST");
    KrlInterpreter interpreter = rig.interpreter;
    assertThat(interpreter.state()).isEqualTo(ProgramState.RESET);
    assertThat(interpreter.program().map(Program::name)).contains("TEST");
    assertThat(rig.line()).isEqualTo(2);

    assertThat(interpreter.start()).isTrue();
    assertThat(interpreter.state()).isEqualTo(ProgramState.ACTIVE);
    assertThat(interpreter.start()).isFalse();
    assertThat(interpreter.reset()).isFalse();
    assertThat(interpreter.cancel()).isFalse();
    rig.cycle();
    assertThat(rig.line()).isEqualTo(3);

    assertThat(interpreter.stop()).isTrue();
    assertThat(interpreter.state()).isEqualTo(ProgramState.STOP);
    assertThat(interpreter.run(100)).isZero();

    assertThat(interpreter.start()).isTrue();
    rig.set("$IN[1]", "TRUE").cycle();
    assertThat(interpreter.state()).isEqualTo(ProgramState.END);
    assertThat(interpreter.levels()).isEmpty();

    assertThat(interpreter.cancel()).isTrue();
    assertThat(interpreter.state()).isEqualTo(ProgramState.FREE);
    assertThat(interpreter.program()).isEmpty();
  }

  @Test
  void beginsAgainAfterResetAndAfterTheEnd() {
    Rig rig = new Rig().start(WAITING).cycle();
    rig.interpreter.stop();
    assertThat(rig.interpreter.reset()).isTrue();
    assertThat(rig.interpreter.state()).isEqualTo(ProgramState.RESET);

    rig.interpreter.start();
    assertThat(rig.cycle().get("I")).isEqualTo("2");

    rig.set("$IN[1]", "TRUE").cycle();
    assertThat(rig.interpreter.start()).isTrue();
    assertThat(rig.cycle().interpreter.state()).isEqualTo(ProgramState.END);
  }

  @Test
  void selectsNothingWhileAProgramIsActive() throws Exception {
    Rig rig = new Rig().start(WAITING);

    assertThat(rig.interpreter.select(rig.library.program("TEST"), List.of())).isFalse();
  }

  @Test
  void refusesArgumentsThatDoNotSuitTheMainRoutine() throws Exception {
    Rig rig = new Rig().load("DEF TEST(N:IN)\nINT N\nEND\n");
    Program program = rig.library.program("TEST");

    assertThatThrownBy(() -> rig.interpreter.select(program, List.of(new KrlInt(1), new KrlInt(2))))
        .isInstanceOf(KrlExecutionException.class)
        .hasMessage("TEST has 1 parameters, was given 2");
    assertThatThrownBy(() -> rig.interpreter.select(program, List.of(new KrlBool(true))))
        .hasMessage("N: needs INT, was given TRUE");
    assertThat(rig.interpreter.state()).isEqualTo(ProgramState.FREE);
  }

  @Test
  void endsACycleWhenItsInstructionsAreUsedUp() {
    Rig rig = new Rig().start("DEF TEST()\nLOOP\nI = I + 1\nENDLOOP\nEND\n");

    assertThat(rig.interpreter.run(1000)).isEqualTo(1000);
    int turns = Integer.parseInt(rig.get("I"));
    assertThat(turns).isBetween(100, 500);

    rig.interpreter.run(1000);
    assertThat(Integer.parseInt(rig.get("I"))).isEqualTo(2 * turns);
  }

  @Test
  void endsACycleWhenTheProgramWaits() {
    Rig rig = new Rig().start(WAITING);

    assertThat(rig.interpreter.run(1000)).isLessThan(20);
  }

  @Test
  void showsTheCalls() {
    Rig rig =
        new Rig()
            .start("DEF TEST()\n\nSUB()\nEND\nDEF SUB()\nI = 1\nWAIT FOR $IN[1]\nEND\n")
            .cycle();

    assertThat(rig.interpreter.levels())
        .extracting(
            Level::module, Level::routine, level -> level.position().line(), Level::interrupt)
        .containsExactly(tuple("TEST", "SUB", 7, false), tuple("TEST", "TEST", 3, false));
  }

  @Test
  void showsAnActionThatHasJustBegun() {
    Rig rig =
        new Rig()
            .start(
                """
                DEF TEST()
                INTERRUPT DECL 5 WHEN $IN[1] DO I=I+1
                INTERRUPT ON
                WAIT FOR FALSE
                END
                """)
            .cycle()
            .set("$IN[1]", "TRUE");

    rig.interpreter.run(1);

    assertThat(rig.interpreter.levels())
        .extracting(Level::routine, level -> level.position().line(), Level::interrupt)
        .containsExactly(tuple("TEST", 2, true), tuple("TEST", 4, false));
  }

  @Test
  void triesAFailedStatementAgain() {
    Rig rig = new Rig();
    rig.faultIn("I = 1 + ARR[1] * (10 / J)");
    assertThat(rig.line()).isEqualTo(2);

    rig.set("J", "5").set("ARR[1]", "3").interpreter.start();

    assertThat(rig.cycle().get("I")).isEqualTo("7");
  }

  @Test
  void beginsAnewAfterAFaultInADeepCall() {
    Rig rig = new Rig();
    rig.faultOf("DEF TEST()\nI = 5 + DEEP()\nEND\nDEFFCT INT DEEP()\nRETURN 1 / J\nENDFCT\n");

    rig.set("J", "1").interpreter.reset();
    rig.interpreter.start();

    assertThat(rig.cycle().get("I")).isEqualTo("6");
  }

  @Test
  void keepsAProgramThatIsReplacedInTheLibrary() {
    Rig rig = new Rig().start(WAITING).cycle();

    rig.load("DEF TEST()\nI = 100\nEND\n").set("$IN[1]", "TRUE").cycle();

    assertThat(rig.get("I")).isEqualTo("0");
  }
}
