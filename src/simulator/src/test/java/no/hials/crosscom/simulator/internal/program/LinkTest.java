package no.hials.crosscom.simulator.internal.program;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import no.hials.crosscom.lang.DataList;
import no.hials.crosscom.lang.KrlError;
import no.hials.crosscom.lang.SourceFile;
import no.hials.crosscom.simulator.KrlFileException;
import no.hials.crosscom.simulator.LoadingMode;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class LinkTest {

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '`',
      value = {
        "NOBODY = 1 | 2:1: no variable NOBODY is declared",
        "I = 1 + NOBODY | 2:9: no variable NOBODY is declared",
        "I = ARR[NOBODY] | 2:9: no variable NOBODY is declared",
        "F.W = 1 | 2:1: F: FRAME has no .W",
        "I.X = 1 | 2:1: I: not a structure, has no .X",
        "I[1] = 1 | 2:1: I: not an array, was given index [1]",
        "GRID[1] = 1 | 2:1: GRID: an array of 2 dimensions, was given index [1]",
        "SENSOR.X = 1 | 2:1: SENSOR: a SIGNAL has no parts",
        "NOBODY() | 2:1: no routine NOBODY is known",
        "I = NOBODY(1) | 2:5: no routine NOBODY is known",
        "CHANNEL :A :B I | 2:1: CHANNEL is not supported by this simulation",
        "ANOUT OFF $ANOUT[1] | 2:11: no variable $ANOUT is declared",
        "I = ABS() | 2:5: ABS takes 1 arguments, has 0",
        "I = ABS(,) | 2:5: ABS takes 1 arguments, has 0",
        "B = STRCOMP(TEXT[]) | 2:5: STRCOMP takes 2 to 3 arguments, has 1",
        "I = STRADD(\"a\",\"b\") | 2:12: an argument for an :OUT parameter is a variable",
        "I = IR_STOPM() | 2:5: IR_STOPM is a subprogram and has no value",
        "I = STRLEN(NOBODY[]) | 2:12: no variable NOBODY is declared",
        "PULSE(I,TRUE,1) | 2:1: PULSE takes one output, was given I",
        "PULSE($OUT[],TRUE,1) | 2:1: PULSE takes one output, was given $OUT",
        "PULSE(NIBBLE,TRUE,1) | 2:1: PULSE takes one output, was given NIBBLE",
        "PULSE(SENSOR,TRUE,1) | 2:1: PULSE takes one output, was given SENSOR",
        "PULSE(NOBODY,TRUE,1) | 2:7: no variable NOBODY is declared",
      })
  void refusesAStatement(String statement, String error) {
    assertThat(new Rig().errorsIn(statement)).containsExactly("test.src:" + error);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '`',
      value = {
        "DECL NOTYPE X | 2:13: type NOTYPE is not declared",
        "INT X[] | 2:5: only the dimensions of a parameter are open, not those of X",
        "GLOBAL INT X | 2:1: GLOBAL and CONST are for variables of data lists only",
        "INT X[I] | 2:7: a value here is made of literals",
        "INT X[0] | 2:7: the length of a dimension is 1 or more, is 0",
        "STRUC S NOTYPE X | 2:16: type NOTYPE is not declared",
        "ENUM E A,A | 2:1: ENUM E must have at least one constant and none twice",
        "SIGNAL S $OUT[1] TO $IN[4] | 2:1: a SIGNAL is $OUT[a]",
        "IMPORT INT N IS /R1/NOBODY..N | 2:1: no module NOBODY with a variable N",
      })
  void refusesADeclaration(String declaration, String error) {
    assertThat(new Rig().errorsIn(declaration))
        .singleElement()
        .asString()
        .startsWith("test.src:" + error);
  }

  @Test
  void refusesAVariableThatIsDeclaredTwice() {
    assertThat(new Rig().errorsIn("INT X\nREAL X"))
        .containsExactly("test.src:3:6: X is declared twice");
  }

  @Test
  void checksTheArgumentsOfACall() {
    assertThat(
            new Rig()
                .errorsOf(
                    """
                    DEF TEST()
                      SUB(1,ARR[],1)
                      SUB(1,2)
                      SUB(I+1,I)
                      I = SUB(I,ARR[])
                      SUB(I,5)
                      SUB(NOBODY,NOBODY[])
                    END
                    DEF SUB(A:OUT,B[]:IN)
                      INT A,B[]
                    END
                    """))
        .containsExactly(
            "test.src:2:3: SUB takes 2 arguments, has 3",
            "test.src:3:9: an argument for an array is a variable or a text",
            "test.src:5:7: SUB is a subprogram and has no value",
            "test.src:6:9: an argument for an array is a variable or a text",
            "test.src:7:7: no variable NOBODY is declared",
            "test.src:7:14: no variable NOBODY is declared");
  }

  @Test
  void checksParameters() {
    assertThat(new Rig().errorsOf("DEF TEST(A:IN,A:IN,B:IN,M[,]:IN)\nINT A,M[,]\nEND\n"))
        .containsExactly(
            "test.src:1:15: parameter A is declared twice",
            "test.src:1:20: parameter B has no declaration",
            "test.src:1:25: an array of several dimensions is passed only as :OUT, M is :IN",
            "test.src:2:5: A is declared twice");
  }

  @Test
  void checksTheTypeOfAFunction() {
    assertThat(new Rig().errorsOf("DEF TEST()\nEND\nDEFFCT NOTYPE F2()\nRETURN 1\nENDFCT\n"))
        .containsExactly("test.src:3:1: type NOTYPE is not declared");
  }

  @Test
  void refusesAnInterruptConditionThatCallsARoutine() {
    assertThat(
            new Rig()
                .errorsOf(
                    """
                    DEF TEST()
                    INTERRUPT DECL 4 WHEN SLOW() DO TEST()
                    END
                    DEFFCT BOOL SLOW()
                    RETURN TRUE
                    ENDFCT
                    """))
        .containsExactly("test.src:2:23: the condition of an interrupt must not call SLOW");
  }

  @Test
  void refusesARoutineThatStandsInAModuleTwice() {
    assertThat(new Rig().errorsOf("DEF TEST()\nEND\nDEF SUB()\nEND\nDEF SUB()\nEND\n"))
        .singleElement()
        .asString()
        .contains("SUB");
  }

  @Test
  void selectsNoModuleWithErrorsAndNoneThatCallsOne() throws KrlFileException {
    Rig rig = new Rig();
    rig.errorsOf("DEF BAD()\nNOBODY = 1\nEND\n");
    rig.load("DEF CALLER()\nMIDDLE()\nEND\n").load("DEF MIDDLE()\nBAD()\nEND\n");
    rig.load("DEF GOOD()\nEND\n");

    assertThatThrownBy(() -> rig.library.program("CALLER"))
        .isInstanceOfSatisfying(KrlFileException.class, e -> assertThat(e.errors()).hasSize(1))
        .hasMessage("test.src:2:1: no variable NOBODY is declared");
    assertThat(rig.library.check("CALLER")).isEmpty();
    assertThat(rig.library.program("good").name()).isEqualTo("GOOD");
  }

  @Test
  void refusesAModuleThatIsNotLoaded() {
    Rig rig = new Rig();

    assertThatThrownBy(() -> rig.library.program("GHOST"))
        .hasMessage("GHOST:1:1: no module GHOST is loaded");
    assertThat(rig.library.check("GHOST")).hasSize(1);
    assertThat(rig.library.scope("GHOST")).isEmpty();
  }

  @Test
  void reportsTheErrorsOfADataList() {
    Rig rig = new Rig();
    SourceFile source = (SourceFile) Rig.parse("m.src", "DEF M()\nEND\n");
    DataList data = (DataList) Rig.parse("m.dat", "DEFDAT M\nINT N=TRUE\nENDDAT\n");

    assertThat(rig.library.put(source, data, LoadingMode.STRICT)).hasSize(1);
    assertThat(rig.library.names()).isEmpty();
  }

  @Test
  void replacesAndRemovesDataListsWithoutRoutines() {
    Rig rig = new Rig();
    DataList data = (DataList) Rig.parse("s.dat", "DEFDAT S PUBLIC\nINT N=1\nENDDAT\n");
    rig.load("DEF M()\nI = N\nEND\n", "DEFDAT M\nIMPORT INT N IS /R1/S..N\nENDDAT\n");
    assertThat(rig.library.check("M")).hasSize(1);

    assertThat(rig.library.put(data, LoadingMode.STRICT)).isEmpty();
    assertThat(rig.library.put(data, LoadingMode.STRICT)).isEmpty();
    assertThat(rig.library.names()).containsExactly("M");
    assertThat(rig.library.check("M")).isEmpty();

    assertThat(rig.library.remove("S")).isTrue();
    assertThat(rig.library.remove("S")).isFalse();
    assertThat(rig.library.check("M")).hasSize(1);
  }

  @Test
  void importsAGlobalVariableOfAnotherModule() {
    Rig rig =
        new Rig().load("DEF STORE()\nEND\n", "DEFDAT STORE PUBLIC\nGLOBAL INT STOCK=12\nENDDAT\n");

    assertThat(rig.errorsIn("IMPORT INT STOCK IS /R1/STORE..STOCK\nI = STOCK")).isEmpty();
  }

  @Test
  void replacesAndRemovesModules() throws KrlFileException {
    Rig rig = new Rig().load("DEF M()\nI = 1\nEND\n").load("DEF m()\nI = 2\nEND\n").select("M");
    assertThat(rig.library.names()).containsExactly("m");

    assertThat(rig.library.remove("M")).isTrue();
    assertThat(rig.library.remove("M")).isFalse();
    assertThat(rig.library.names()).isEmpty();

    rig.interpreter.start();
    assertThat(rig.cycle().get("I")).isEqualTo("2");
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '`',
      value = {
        "NOBODY() | 9010 line 3: no routine NOBODY is known",
        "I = NOBODY(1) | 9010 line 3: no routine NOBODY is known",
        "NOBODY = 1 | 9010 line 3: no variable NOBODY is declared",
        "WAIT FOR NOBODY == 1 | 9010 line 3: no variable NOBODY is declared",
        "ARR[NOBODY] = 1 | 9010 line 3: no variable NOBODY is declared",
        "PTP NOBODY | 9010 line 3: no variable NOBODY is declared",
        "PULSE(NOBODY,TRUE,1) | 9010 line 3: no variable NOBODY is declared",
        "INTERRUPT DECL 3 WHEN NOBODY DO SUB() | 9010 line 3: no variable NOBODY is declared",
        "This is not KRL | 9010 line 3: unknown statement This; a type needs DECL before it",
      })
  void stopsALenientProgramWhereItReachesAnError(String statement, String fault) {
    Rig rig = new Rig().loadLeniently("DEF TEST()\nI = 7\n" + statement + "\nI = 8\nEND\n");

    rig.select("TEST").startSelected().cycle();

    assertThat(rig.fault()).isEqualTo(fault);
    assertThat(rig.get("I")).isEqualTo("7");
  }

  @Test
  void reportsAnErrorAtOnePlaceOnce() {
    Rig rig = new Rig().loadLeniently("DEF TEST()\nFOR GHOST=1 TO 3\nENDFOR\nEND\n");

    assertThat(rig.library.check("TEST"))
        .extracting(KrlError::toString)
        .containsExactly("test.src:2:5: no variable GHOST is declared");
  }

  @Test
  void runsALenientProgramThatDoesNotReachItsErrors() {
    Rig rig =
        new Rig()
            .loadLeniently(
                """
                DEF TEST()
                INT N
                DECL NOTYPE X
                INTERRUPT DECL 3 WHEN B DO NOBODY()
                IF FALSE THEN
                  NOBODY(1)
                ENDIF
                FOR N=1 TO 3
                  IF N > 5 THEN
                    X = 1
                  ENDIF
                  I = I + N
                ENDFOR
                SWITCH I
                CASE 1
                  NOBODY(2)
                DEFAULT
                  J = 5
                ENDSWITCH
                GOTO ON
                NOBODY(3)
                ON:
                REPEAT
                  K = 9
                UNTIL NOBODY
                END
                """);

    rig.select("TEST").startSelected().cycle();

    assertThat(rig.fault()).isEqualTo("9010 line 25: no variable NOBODY is declared");
    assertThat(rig.get("I") + rig.get("J") + rig.get("K")).isEqualTo("659");
    assertThat(rig.library.check("TEST")).hasSize(6);
  }

  @Test
  void refusesAStrictModuleThatALenientOneCalls() {
    Rig rig = new Rig().loadLeniently("DEF TEST()\nNOBODY()\nSUB()\nEND\n");
    rig.load("DEF SUB()\nNOBODY()\nEND\n");

    assertThatThrownBy(() -> rig.library.program("TEST"))
        .isInstanceOf(KrlFileException.class)
        .hasMessageContaining("test.src:2:1: no routine NOBODY is known");
  }
}
