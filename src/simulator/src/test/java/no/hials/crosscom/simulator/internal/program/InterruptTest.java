package no.hials.crosscom.simulator.internal.program;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.tuple;

import no.hials.crosscom.protocol.code.ProgramState;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class InterruptTest {
  /** A program that waits, with an interrupt that counts in I. */
  private static final String COUNTING =
      """
      DEF TEST()
        INTERRUPT DECL 10 WHEN $IN[1] DO COUNT()
        INTERRUPT ON 10
        WAIT FOR $IN[16]
        %s
        WAIT FOR $IN[15]
      END
      DEF COUNT()
        I = I + 1
      END
      """;

  private static Rig waiting(String program) {
    return new Rig().start(program).cycle();
  }

  @Test
  void executesARoutineAtTheRisingEdgeOfACondition() {
    Rig rig = waiting(COUNTING.formatted(""));

    rig.set("$IN[1]", "TRUE").cycles(3);
    assertThat(rig.get("I")).isEqualTo("1");

    rig.set("$IN[1]", "FALSE").cycle();
    rig.set("$IN[1]", "TRUE").cycle();
    assertThat(rig.get("I")).isEqualTo("2");
    assertThat(rig.line()).isEqualTo(4);
  }

  @ParameterizedTest
  @ValueSource(ints = {254, 255})
  void limitsTheDepthOfCallsInAnInterruptAsWell(int depth) {
    Rig rig =
        waiting(
            """
            DEF TEST()
              INTERRUPT DECL 10 WHEN $IN[1] DO COUNT()
              INTERRUPT ON 10
              DEEPER(%d)
            END
            DEF DEEPER(N:IN)
              INT N
              IF N > 1 THEN
                DEEPER(N - 1)
              ENDIF
              WAIT FOR $IN[16]
            END
            DEF COUNT()
              COUNT()
            END
            """
                .formatted(depth));

    rig.set("$IN[1]", "TRUE").cycle();

    assertThat(rig.fault())
        .contains("1424 line ", ": calls nest at most 256 deep, COUNT is one too many");
  }

  @Test
  void takesNoEdgeFromAConditionThatIsTrueAlready() {
    Rig rig = new Rig().set("$IN[1]", "TRUE").start(COUNTING.formatted("")).cycles(3);

    assertThat(rig.get("I")).isEqualTo("0");
  }

  @Test
  void ignoresEdgesWhenTurnedOff() {
    Rig rig = waiting(COUNTING.formatted("INTERRUPT OFF 10"));

    rig.set("$IN[16]", "TRUE").cycle().set("$IN[1]", "TRUE").cycles(2);

    assertThat(rig.get("I")).isEqualTo("0");
  }

  @Test
  void keepsAnEdgeInMindWhileDisabled() {
    Rig rig =
        waiting(
            COUNTING.formatted(
                "INTERRUPT DISABLE\nWAIT FOR $IN[14]\nINTERRUPT ENABLE 10\nINTERRUPT ON 10"));
    rig.set("$IN[16]", "TRUE").cycle().set("$IN[1]", "TRUE").cycles(2);
    assertThat(rig.get("I")).isEqualTo("0");

    rig.set("$IN[14]", "TRUE").cycles(2);

    assertThat(rig.get("I")).isEqualTo("1");
  }

  @Test
  void forgetsTheInterruptsOfARoutineThatHasEnded() {
    Rig rig =
        waiting(
            """
            DEF TEST()
              SUB()
              WAIT FOR $IN[16]
            END
            DEF SUB()
              INTERRUPT DECL 10 WHEN $IN[1] DO COUNT(1)
              GLOBAL INTERRUPT DECL 11 WHEN $IN[1] DO COUNT(10)
              INTERRUPT ON
            END
            DEF COUNT(N:IN)
              INT N
              I = I + N
            END
            """);

    rig.set("$IN[1]", "TRUE").cycle();

    assertThat(rig.get("I")).isEqualTo("10");
  }

  @Test
  void executesAssignmentsAndPulses() {
    Rig rig =
        waiting(
            """
            DEF TEST()
              INT N
              INTERRUPT DECL 10 WHEN $IN[1] DO N=N+1
              INTERRUPT DECL 11 WHEN $IN[1] DO PULSE($OUT[2],TRUE,0.5)
              N = 1
              INTERRUPT ON
              WAIT FOR N > 1
              I = N
            END
            """);

    rig.set("$IN[1]", "TRUE").cycle();

    assertThat(rig.get("I")).isEqualTo("2");
    assertThat(rig.robot.log).containsExactly("pulse 2 true 0.5");
  }

  @Test
  void letsTheHigherPriorityInterruptTheLower() {
    Rig rig =
        waiting(
            """
            DEF TEST()
              INTERRUPT DECL 20 WHEN $IN[1] DO LOW()
              INTERRUPT DECL 10 WHEN $IN[2] DO HIGH()
              INTERRUPT DECL 30 WHEN $IN[3] DO LOWEST()
              INTERRUPT ON
              WAIT FOR $IN[16]
            END
            DEF LOW()
              ARR[1] = 1
              WAIT FOR $IN[15]
              ARR[1] = 2
            END
            DEF HIGH()
              ARR[2] = 1
            END
            DEF LOWEST()
              ARR[3] = ARR[1]
            END
            """);

    rig.set("$IN[1]", "TRUE").cycle();
    rig.set("$IN[2]", "TRUE").set("$IN[3]", "TRUE").cycle();
    assertThat(rig.get("ARR[]").strip()).isEqualTo("1 1 0 0 0");
    assertThat(rig.interpreter.levels())
        .extracting(KrlInterpreter.Level::routine, KrlInterpreter.Level::interrupt)
        .containsExactly(tuple("LOW", true), tuple("TEST", false));

    rig.set("$IN[15]", "TRUE").cycle();
    assertThat(rig.get("ARR[]").strip()).isEqualTo("2 1 2 0 0");
  }

  @Test
  void executesTheMoreUrgentOfSeveralFirst() {
    Rig rig =
        waiting(
            """
            DEF TEST()
              INTERRUPT DECL 20 WHEN $IN[1] DO NOTE(2)
              INTERRUPT DECL 10 WHEN $IN[1] DO NOTE(1)
              INTERRUPT ON
              TRIGGER WHEN DISTANCE=1 DELAY=0 DO NOTE(3) PRIO=15
              TRIGGER WHEN DISTANCE=1 DELAY=0 DO NOTE(4) PRIO=-1
              TRIGGER WHEN DISTANCE=1 DELAY=0 DO NOTE(5) PRIO=5
              LIN F
              WAIT FOR $IN[16]
            END
            DEF NOTE(N:IN)
              INT N
              I = I + 1
              ARR[I] = N
            END
            """);

    rig.robot.endMotion().triggers().forEach(rig.interpreter::fire);
    rig.set("$IN[1]", "TRUE").cycle();

    assertThat(rig.get("ARR[]").strip()).isEqualTo("5 1 3 2 4");
  }

  @Test
  void interruptsAnExpressionInItsMidst() {
    Rig rig =
        waiting(
            """
            DEF TEST()
              INTERRUPT DECL 10 WHEN $IN[1] DO COUNT()
              INTERRUPT ON 10
              I = 100 + SLOW() * 2
            END
            DEFFCT INT SLOW()
              WAIT FOR J == 1
              RETURN 5
            ENDFCT
            DEF COUNT()
              J = J + 1
            END
            """);

    rig.set("$IN[1]", "TRUE").cycle();

    assertThat(rig.get("I")).isEqualTo("110");
  }

  // motion

  /** A program that moves in a subprogram, with an interrupt whose routine is given. */
  private static Rig moving(String routine) {
    return waiting(
        """
        DEF TEST()
          INTERRUPT DECL 10 WHEN $IN[1] DO STOPPING()
          INTERRUPT ON 10
          SEARCH()
          K = 1
          LIN G
        END
        DEF SEARCH()
          INTERRUPT DECL 12 WHEN $IN[2] DO STOPPING()
          LIN F
          WAIT SEC 0
          J = 1
        END
        DEF STOPPING()
        """
            + routine
            + "\nEND\n");
  }

  @Test
  void letsTheMotionGoOnWhileTheRoutineRuns() {
    Rig rig = moving("$OUT[1] = TRUE\nI = 1\nWAIT SEC 0.012\nI = 2");

    rig.set("$IN[1]", "TRUE").cycle();
    assertThat(rig.get("I")).isEqualTo("1");
    assertThat(rig.cycle().get("I")).isEqualTo("2");
    assertThat(rig.robot.motionFinished()).isFalse();
    assertThat(rig.robot.log).hasSize(1);

    rig.endMotion();
    assertThat(rig.get("K")).isEqualTo("1");
  }

  @ParameterizedTest
  @CsvSource({"BRAKE, hold", "BRAKE F, hold hard"})
  void brakesAndLetsTheMotionGoOnAtTheEnd(String statement, String logged) {
    Rig rig = moving(statement + "\nBRAKE\nWAIT FOR $IN[3]\nI = 1");

    rig.set("$IN[1]", "TRUE").cycles(2);
    assertThat(rig.robot.log).endsWith(logged);
    assertThat(rig.robot.motionFinished()).isTrue();

    rig.set("$IN[3]", "TRUE").cycle();
    assertThat(rig.robot.log).endsWith(logged, "release");
    assertThat(rig.robot.motionFinished()).isFalse();
    assertThat(rig.get("J")).isEqualTo("0");
  }

  @Test
  void executesMotionsOfTheRoutineBeforeTheInterruptedOneGoesOn() {
    Rig rig = moving("LIN {X 1}\nI = 1");

    rig.set("$IN[1]", "TRUE").cycle();
    assertThat(rig.robot.log.subList(1, 3)).containsExactly("hold", "LIN {X 1}");
    assertThat(rig.get("I")).isEqualTo("1");

    rig.cycles(2);
    assertThat(rig.robot.log).doesNotContain("release");

    rig.endMotion();
    assertThat(rig.robot.log).endsWith("release");
  }

  @Test
  void haltsInTheRoutineAndGoesOn() {
    Rig rig = moving("BRAKE\nHALT\nI = 1");

    rig.set("$IN[1]", "TRUE").cycle();
    assertThat(rig.interpreter.state()).isEqualTo(ProgramState.STOP);

    rig.interpreter.start();
    rig.cycle();
    assertThat(rig.get("I")).isEqualTo("1");
    assertThat(rig.robot.log).endsWith("release");
  }

  @Test
  void cancelsTheInterruptedSubprogramByResume() {
    Rig rig = moving("BRAKE\nI = 1\nRESUME\nI = 2");

    rig.set("$IN[1]", "TRUE").cycle();

    assertThat(rig.robot.log.subList(1, 4))
        .containsExactly("hold", "discard 1", "LIN {X 10.0,Y 0.0,Z 0.0,A 90.0,B 0.0,C 0.0}");
    assertThat(rig.get("I")).isEqualTo("1");
    assertThat(rig.get("J")).isEqualTo("0");
    assertThat(rig.get("K")).isEqualTo("1");

    rig.cycle();
    rig.endMotion();
    assertThat(rig.interpreter.state()).isEqualTo(ProgramState.END);
  }

  @Test
  void cancelsInterruptsThatAreBeingExecutedByResume() {
    Rig rig =
        waiting(
            """
            DEF TEST()
              INTERRUPT DECL 10 WHEN $IN[1] DO LEAVE()
              INTERRUPT DECL 20 WHEN $IN[2] DO LONG()
              INTERRUPT ON
              SUB()
              I = 1
            END
            DEF SUB()
              LIN F
              WAIT FOR FALSE
            END
            DEF LONG()
              BRAKE
              WAIT FOR FALSE
            END
            DEF LEAVE()
              RESUME
            END
            """);

    rig.set("$IN[2]", "TRUE").cycle().set("$IN[1]", "TRUE").cycle();

    assertThat(rig.robot.log).endsWith("hold", "discard 1");
    assertThat(rig.get("I")).isEqualTo("1");
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "RESUME | 9010 line 2: RESUME is allowed in the routine of an interrupt only",
        "BRAKE | 9010 line 2: BRAKE is allowed in the routine of an interrupt only",
        "INTERRUPT ON 7 | 1430 line 2: no interrupt with priority 7 is declared here",
        "INTERRUPT DECL 0 WHEN $IN[1] DO I=1 | 1422 line 2: the priority of an interrupt is 1 to"
            + " 39",
        "INTERRUPT DECL 40 WHEN $IN[1] DO I=1 | 1422 line 2: the priority of an interrupt is 1 to",
        "INTERRUPT DECL 129 WHEN $IN[1] DO I=1 | 1422 line 2: the priority of an interrupt is 1",
      })
  void refusesAStatementThatIsNotPossible(String statement, String message) {
    assertThat(new Rig().faultIn(statement)).startsWith(message);
  }

  @ParameterizedTest
  @CsvSource({"1", "39", "81", "128"})
  void takesThePrioritiesThatTheSystemDoesNotUse(int priority) {
    new Rig().execute("INTERRUPT DECL " + priority + " WHEN $IN[1] DO I=1");
  }

  @Test
  void refusesResumeInTheLevelOfTheDeclaration() {
    Rig rig =
        waiting(
            """
            DEF TEST()
              INTERRUPT DECL 10 WHEN $IN[1] DO LEAVE()
              INTERRUPT ON
              WAIT FOR FALSE
            END
            DEF LEAVE()
              RESUME
            END
            """);

    rig.set("$IN[1]", "TRUE").cycle();

    assertThat(rig.fault()).startsWith("9010 line 7: RESUME cancels a subprogram called by");
  }

  @Test
  void stopsWithThePlaceOfAConditionThatHasNoValue() {
    Rig rig =
        waiting(
            """
            DEF TEST()
              INTERRUPT DECL 10 WHEN EMPTY == J DO I=1
              EMPTY = 1
              INTERRUPT ON
              EMPTY = EMPTY + 1
              WAIT FOR $IN[16]
            END
            """);
    rig.globals.remove("EMPTY");

    rig.cycle();

    assertThat(rig.fault()).startsWith("1446 line 2: EMPTY: no variable EMPTY");
    assertThat(rig.line()).isEqualTo(6);
  }

  @Test
  void stopsWithThePlaceOfAConditionThatIsTurnedOn() {
    assertThat(new Rig().faultIn("INTERRUPT DECL 9 WHEN EMPTY==1 DO I=1\nI=1\nINTERRUPT ON 9"))
        .isEqualTo("1422 line 2: EMPTY: has no value yet");
  }

  @Test
  void callsTheRoutineOfTheBaseTechnologyWhenAStopMessageComes() {
    Rig rig =
        waiting(
            """
            DEF TEST()
              GLOBAL INTERRUPT DECL 3 WHEN $STOPMESS==TRUE DO IR_STOPM()
              INTERRUPT ON 3
              WAIT FOR $IN[16]
            END
            """);

    rig.set("$STOPMESS", "TRUE").cycles(2).set("$IN[16]", "TRUE").cycle();

    assertThat(rig.interpreter.state()).isEqualTo(ProgramState.END);
  }
}
