package no.hials.crosscom.simulator.internal.program;

import static org.assertj.core.api.Assertions.assertThat;

import no.hials.crosscom.protocol.code.ProgramState;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class ControlFlowTest {

  @ParameterizedTest
  @CsvSource({"TRUE, 1", "FALSE, 2"})
  void takesOneBranchOfIf(String condition, String expected) {
    Rig rig = new Rig().execute("IF " + condition + " THEN\nI = 1\nELSE\nI = 2\nENDIF\nJ = I");

    assertThat(rig.get("J")).isEqualTo(expected);
  }

  @Test
  void stopsAtALineThatCouldNotBeParsed() {
    Rig rig = new Rig().loadLeniently("DEF TEST()\nI = 1\nGRIPPER OPEN\nI = 2\nEND\n");
    rig.select("TEST");
    rig.interpreter.start();
    rig.cycle();

    assertThat(rig.fault())
        .isEqualTo("9010 line 3: unknown statement GRIPPER; a type needs DECL before it");
    assertThat(rig.get("I")).isEqualTo("1");
  }

  @Test
  void skipsAnIfWithoutElse() {
    assertThat(new Rig().execute("IF 1 > 2 THEN\nI = 1\nENDIF").get("I")).isEqualTo("0");
  }

  @ParameterizedTest
  @CsvSource({"1, 10", "2, 20", "3, 20", "4, 99"})
  void takesTheCaseOfAnInt(String selector, String expected) {
    Rig rig =
        new Rig()
            .set("J", selector)
            .execute(
                "SWITCH J\nCASE 1\nI = 10\nCASE 2,3\nI = 20\nDEFAULT\nI = 99\nENDSWITCH\nK = I");

    assertThat(rig.get("K")).isEqualTo(expected);
  }

  @Test
  void takesTheCaseOfACharOrAnEnumConstant() {
    Rig rig =
        new Rig()
            .execute(
                """
                SWITCH C
                CASE "x"
                  I = 1
                ENDSWITCH
                SWITCH COL
                CASE #GREEN
                  J = 1
                CASE #RED
                  J = 2
                ENDSWITCH
                """);

    assertThat(rig.get("I")).isEqualTo("1");
    assertThat(rig.get("J")).isEqualTo("2");
  }

  @Test
  void goesOnBehindASwitchWithoutAMatch() {
    assertThat(new Rig().execute("SWITCH 5\nCASE 1\nI = 1\nENDSWITCH\nJ = 1").get("J"))
        .isEqualTo("1");
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "1 TO 3 | 3 | 4",
        "3 TO 1 | 0 | 3",
        "3 TO 1 STEP -1 | 3 | 0",
        "1 TO 3 STEP -1 | 0 | 1",
        "1 TO 10 STEP 4 | 3 | 13",
        "-1 TO -1 | 1 | 0",
      })
  void countsFromTheFirstToTheLastValue(String range, String turns, String counter) {
    Rig rig = new Rig().execute("FOR J = " + range + "\nI = I + 1\nENDFOR");

    assertThat(rig.get("I")).isEqualTo(turns);
    assertThat(rig.get("J")).isEqualTo(counter);
  }

  @Test
  void keepsTheRangeOfAForThatItHadAtTheStart() {
    Rig rig = new Rig().set("K", "3").execute("FOR J = 1 TO K\nK = 100\nI = I + 1\nENDFOR");

    assertThat(rig.get("I")).isEqualTo("3");
  }

  @Test
  void nestsLoopsOfOneKind() {
    Rig rig = new Rig().execute("FOR J = 1 TO 3\nFOR ARR[1] = 1 TO J\nI = I + 1\nENDFOR\nENDFOR");

    assertThat(rig.get("I")).isEqualTo("6");
  }

  @Test
  void refusesAStepOfZero() {
    assertThat(new Rig().faultIn("FOR J = 1 TO 3 STEP 0\nI = 1\nENDFOR"))
        .isEqualTo("1422 line 2: the STEP of FOR must not be 0");
  }

  @Test
  void refusesACounterBeyondAnInt() {
    assertThat(new Rig().faultIn("FOR J = 2147483647 TO 2147483647\nI = 1\nENDFOR"))
        .startsWith("9006 line 2");
  }

  @Test
  void repeatsWhileAConditionIsTrue() {
    assertThat(new Rig().execute("WHILE I < 3\nI = I + 1\nENDWHILE").get("I")).isEqualTo("3");
    assertThat(new Rig().execute("WHILE I > 3\nI = I + 1\nENDWHILE").get("I")).isEqualTo("0");
  }

  @Test
  void repeatsUntilAConditionIsTrue() {
    assertThat(new Rig().execute("REPEAT\nI = I + 1\nUNTIL I >= 3").get("I")).isEqualTo("3");
    assertThat(new Rig().execute("REPEAT\nI = I + 1\nUNTIL TRUE").get("I")).isEqualTo("1");
  }

  @Test
  void leavesTheInnermostLoopByExit() {
    Rig rig =
        new Rig()
            .execute(
                """
                LOOP
                  J = J + 1
                  WHILE TRUE
                    EXIT
                  ENDWHILE
                  REPEAT
                    EXIT
                  UNTIL FALSE
                  FOR K = 1 TO 5
                    IF K == 2 THEN
                      EXIT
                    ENDIF
                  ENDFOR
                  IF J == 3 THEN
                    EXIT
                  ENDIF
                ENDLOOP
                """);

    assertThat(rig.get("J")).isEqualTo("3");
    assertThat(rig.get("K")).isEqualTo("2");
  }

  @Test
  void jumpsForwardsAndBackwards() {
    Rig rig =
        new Rig()
            .execute(
                """
                GOTO FIRST
                I = 100
                AGAIN:
                I = I + 1
                IF I < 3 THEN
                  GOTO AGAIN
                ENDIF
                GOTO LAST
                FIRST:
                GOTO AGAIN
                LAST:
                """);

    assertThat(rig.get("I")).isEqualTo("3");
  }

  @Test
  void waitsUntilAConditionIsTrue() {
    Rig rig = new Rig().start("DEF TEST()\nI = 1\nWAIT FOR $IN[1]\nI = 2\nEND\n").cycles(3);
    assertThat(rig.get("I")).isEqualTo("1");
    assertThat(rig.line()).isEqualTo(3);

    rig.set("$IN[1]", "TRUE").cycle();

    assertThat(rig.get("I")).isEqualTo("2");
  }

  @Test
  void waitsForAConditionWithAFunctionThatWaitsItself() {
    Rig rig =
        new Rig()
            .start(
                """
                DEF TEST()
                  WAIT FOR READY()
                  I = 1
                END
                DEFFCT BOOL READY()
                  WAIT SEC 0.024
                  J = J + 1
                  RETURN J == 2
                ENDFCT
                """)
            .cycles(5);
    assertThat(rig.get("J")).isEqualTo("1");

    rig.cycles(2);

    assertThat(rig.get("I")).isEqualTo("1");
  }

  @Test
  void waitsForATime() {
    Rig rig = new Rig().start("DEF TEST()\nWAIT SEC 0.036\nI = 1\nEND\n").cycles(3);
    assertThat(rig.get("I")).isEqualTo("0");

    assertThat(rig.cycle().get("I")).isEqualTo("1");
  }

  @Test
  void waitsForATimeBeyondAnyClock() {
    Rig rig = new Rig().start("DEF TEST()\nWAIT SEC 3.0E38\nI = 1\nEND\n").cycles(3);

    assertThat(rig.get("I")).isEqualTo("0");
  }

  @Test
  void doesNotWaitForATimeThatIsOver() {
    assertThat(new Rig().execute("WAIT SEC -1\nI = 1").get("I")).isEqualTo("1");
  }

  @Test
  void stopsAtHaltAndGoesOn() {
    Rig rig = new Rig().start("DEF TEST()\nI = 1\nHALT\nI = 2\nEND\n").cycle();
    assertThat(rig.interpreter.state()).isEqualTo(ProgramState.STOP);
    assertThat(rig.get("I")).isEqualTo("1");
    assertThat(rig.line()).isEqualTo(4);

    rig.interpreter.start();
    rig.cycle();

    assertThat(rig.get("I")).isEqualTo("2");
    assertThat(rig.interpreter.state()).isEqualTo(ProgramState.END);
  }

  @Test
  void pulsesOutputs() {
    Rig rig = new Rig().execute("I = 2\nPULSE($OUT[I],TRUE,0.5)\nPULSE(GRIPPER,NOT TRUE,1)");

    assertThat(rig.robot.log).containsExactly("pulse 2 true 0.5", "pulse 6 false 1.0");
  }
}
