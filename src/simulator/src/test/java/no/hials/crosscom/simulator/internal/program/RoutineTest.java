package no.hials.crosscom.simulator.internal.program;

import static org.assertj.core.api.Assertions.assertThat;

import no.hials.crosscom.protocol.value.KrlInt;
import no.hials.crosscom.protocol.value.KrlString;
import org.junit.jupiter.api.Test;

class RoutineTest {

  @Test
  void handsOverByValueAndByReference() {
    Rig rig =
        new Rig()
            .run(
                """
                DEF TEST()
                  I = 1
                  J = 1
                  CHANGE(I,J)
                END
                DEF CHANGE(A:IN,B:OUT)
                  INT A,B
                  A = A + 10
                  B = B + A
                END
                """);

    assertThat(rig.get("I")).isEqualTo("1");
    assertThat(rig.get("J")).isEqualTo("12");
  }

  @Test
  void convertsWhatIsHandedOverByValue() {
    Rig rig =
        new Rig()
            .run(
                """
                DEF TEST()
                  SUB(2.6,3)
                END
                DEF SUB(N:IN,X:IN)
                  INT N
                  REAL X
                  I = N
                  R = X / 2
                END
                """);

    assertThat(rig.get("I")).isEqualTo("3");
    assertThat(rig.get("R")).isEqualTo("1.5");
  }

  @Test
  void refusesAValueOfAnotherType() {
    assertThat(new Rig().faultOf("DEF TEST()\nSUB(TRUE)\nEND\nDEF SUB(N:IN)\nINT N\nI = N\nEND\n"))
        .isEqualTo("1446 line 2: N: needs INT, was given TRUE");
  }

  @Test
  void changesElementsAndComponentsOfTheCaller() {
    Rig rig =
        new Rig()
            .run(
                """
                DEF TEST()
                  INT MINE[3]
                  I = 2
                  SUB(MINE[],ARR[I],PARTS[I],F.X,GRID[,],ROWS[1,])
                  J = MINE[3]
                END
                DEF SUB(A[]:OUT,E:OUT,S:OUT,X:OUT,M[,]:OUT,T[]:OUT)
                  INT A[],E,M[,]
                  DECL PART S
                  REAL X
                  CHAR T[]
                  I = 5
                  A[3] = 7
                  E = 8
                  S.COUNTS[I-4] = 9
                  S.NAME[] = "nut"
                  X = X + 0.5
                  M[2,1] = 11
                  T[] = "row"
                  T[1] = "R"
                END
                """);

    assertThat(rig.get("J")).isEqualTo("7");
    assertThat(rig.get("ARR[2]")).isEqualTo("8");
    assertThat(rig.get("PARTS[2].COUNTS[1]")).isEqualTo("9");
    assertThat(rig.get("PARTS[2].NAME[]")).isEqualTo("\"nut\"");
    assertThat(rig.get("F.X")).isEqualTo("1.5");
    assertThat(rig.get("GRID[2,1]")).isEqualTo("11");
    assertThat(rig.get("ROWS[1,]")).isEqualTo("\"Row\"");
  }

  @Test
  void handsOverReferencesThroughSeveralCalls() {
    Rig rig =
        new Rig()
            .run(
                """
                DEF TEST()
                  OUTER(PARTS[])
                END
                DEF OUTER(P[]:OUT)
                  DECL PART P[]
                  INNER(P[2].COUNTS[])
                END
                DEF INNER(C[]:OUT)
                  INT C[]
                  C[3] = 4
                END
                """);

    assertThat(rig.get("PARTS[2].COUNTS[3]")).isEqualTo("4");
  }

  @Test
  void copiesAnArrayThatIsHandedOverByValue() {
    Rig rig =
        new Rig()
            .run(
                """
                DEF TEST()
                  ARR[1] = 1
                  SUB(ARR[],"abc")
                END
                DEF SUB(A[]:IN,T[]:IN)
                  INT A[]
                  CHAR T[]
                  A[1] = A[1] + 1
                  I = A[1]
                  C = T[3]
                END
                """);

    assertThat(rig.get("ARR[1]")).isEqualTo("1");
    assertThat(rig.get("I")).isEqualTo("2");
    assertThat(rig.get("C")).isEqualTo("\"c\"");
  }

  @Test
  void refusesASignalForAnArray() {
    assertThat(new Rig().faultOf("DEF TEST()\nSUB(NIBBLE)\nEND\nDEF SUB(A[]:IN)\nINT A[]\nEND\n"))
        .startsWith("1446 line 2: NIBBLE");
  }

  @Test
  void namesTheVariableOfTheCallerWhenAReferenceFails() {
    assertThat(
            new Rig().faultOf("DEF TEST()\nSUB(EMPTY)\nEND\nDEF SUB(A:OUT)\nINT A\nI = A\nEND\n"))
        .isEqualTo("1422 line 6: A (EMPTY): has no value yet");
  }

  @Test
  void leavesOmittedArgumentsWithoutAValue() {
    Rig rig =
        new Rig()
            .run(
                """
                DEF TEST()
                  SUB(,)
                END
                DEF SUB(A:IN,B:OUT)
                  INT A,B
                  IF VARSTATE("A") == #DECLARED THEN
                    I = 1
                  ENDIF
                  B = 5
                  J = B
                END
                """);

    assertThat(rig.get("I")).isEqualTo("1");
    assertThat(rig.get("J")).isEqualTo("5");
  }

  @Test
  void givesTheValueOfAFunctionItsType() {
    Rig rig =
        new Rig()
            .run(
                """
                DEF TEST()
                  R = WHOLE(2.6) / 2
                  F = SHIFTED(F)
                END
                DEFFCT INT WHOLE(X:IN)
                  REAL X
                  RETURN X
                ENDFCT
                DEFFCT FRAME SHIFTED(A:IN)
                  FRAME A
                  A.X = A.X + 1
                  RETURN A
                ENDFCT
                """);

    assertThat(rig.get("R")).isEqualTo("1.0");
    assertThat(rig.get("F.X")).isEqualTo("2.0");
  }

  @Test
  void refusesAFunctionValueOfAnotherType() {
    assertThat(
            new Rig()
                .faultOf("DEF TEST()\nI = BAD()\nEND\nDEFFCT INT BAD()\nRETURN TRUE\nENDFCT\n"))
        .isEqualTo("1446 line 5: the value of BAD: needs INT, was given TRUE");
  }

  @Test
  void refusesAFunctionThatEndsWithoutAValue() {
    assertThat(new Rig().faultOf("DEF TEST()\nI = BAD()\nEND\nDEFFCT INT BAD()\nJ = 1\nENDFCT\n"))
        .isEqualTo("9009 line 6: function BAD must end with RETURN and a value");
  }

  @Test
  void callsAFunctionWithoutUsingItsValue() {
    Rig rig =
        new Rig().run("DEF TEST()\nF2()\nI = 1\nEND\nDEFFCT INT F2()\nJ = 1\nRETURN 5\nENDFCT\n");

    assertThat(rig.get("J")).isEqualTo("1");
    assertThat(rig.get("I")).isEqualTo("1");
  }

  @Test
  void callsRoutinesRecursively() {
    Rig rig =
        new Rig()
            .run(
                """
                DEF TEST()
                  I = FACTORIAL(5) + FACTORIAL(3)
                END
                DEFFCT INT FACTORIAL(N:IN)
                  INT N
                  IF N <= 1 THEN
                    RETURN 1
                  ENDIF
                  RETURN N * FACTORIAL(N-1)
                ENDFCT
                """);

    assertThat(rig.get("I")).isEqualTo("126");
  }

  @Test
  void limitsTheDepthOfCalls() {
    assertThat(new Rig().faultOf("DEF TEST()\nTEST()\nEND\n"))
        .isEqualTo("1424 line 2: calls nest at most 256 deep, TEST is one too many");
  }

  @Test
  void returnsFromTheMiddleOfASubprogram() {
    Rig rig = new Rig().run("DEF TEST()\nSUB()\nEND\nDEF SUB()\nI = 1\nRETURN\nI = 2\nEND\n");

    assertThat(rig.get("I")).isEqualTo("1");
  }

  @Test
  void beginsEachCallWithVariablesWithoutValues() {
    assertThat(
            new Rig()
                .faultOf(
                    """
                    DEF TEST()
                    SUB()
                    SUB()
                    END
                    DEF SUB()
                    INT N
                    IF I == 1 THEN
                    J = N
                    ENDIF
                    N = 1
                    I = 1
                    END
                    """))
        .isEqualTo("1422 line 8: N: has no value yet");
  }

  @Test
  void knowsTypesSignalsAndArraysOfARoutine() {
    Rig rig =
        new Rig()
            .run(
                """
                DEF TEST()
                  STRUC PAIR INT A,B[2]
                  ENUM STATE IDLE,BUSY
                  DECL PAIR X
                  DECL STATE S
                  SIGNAL LAMP $OUT[9]
                  SIGNAL DARK FALSE
                  SIGNAL BITS $OUT[10] TO $OUT[12]
                  INT N[LIMIT]
                  X = {A 3}
                  X.B[2] = 4
                  S = #BUSY
                  LAMP = S == #BUSY
                  BITS = 7
                  B = DARK
                  N[7] = X.A + X.B[2]
                  I = N[7]
                END
                """);

    assertThat(rig.get("I")).isEqualTo("7");
    assertThat(rig.get("$OUT[9]")).isEqualTo("TRUE");
    assertThat(rig.get("$OUT[12]")).isEqualTo("TRUE");
    assertThat(rig.get("B")).isEqualTo("FALSE");
  }

  @Test
  void keepsTheVariablesOfADataListFromRunToRun() {
    Rig rig =
        new Rig()
            .load("DEF COUNT()\nN = N + 1\nI = N\nEND\n", "DEFDAT COUNT\nINT N=40\nENDDAT\n")
            .select("count");

    rig.interpreter.start();
    rig.cycle();
    rig.interpreter.start();
    rig.cycle();

    assertThat(rig.get("I")).isEqualTo("42");
    assertThat(rig.library.scope("COUNT")).isPresent();
  }

  @Test
  void callsModulesAndGlobalRoutinesOfOthers() {
    Rig rig =
        new Rig()
            .load(
                """
                DEF TOOLS()
                I = 1
                HELPER()
                END
                GLOBAL DEF SHARED()
                J = 1
                END
                DEF HELPER()
                K = 1
                END
                """);

    rig.run("DEF TEST()\nEXT TOOLS()\nTOOLS()\nSHARED()\nEND\n");

    assertThat(rig.get("I") + rig.get("J") + rig.get("K")).isEqualTo("111");
  }

  @Test
  void prefersTheRoutineOfItsOwnModule() {
    Rig rig = new Rig().load("DEF OTHER()\nEND\nGLOBAL DEF SAME()\nI = 1\nEND\n");

    rig.run("DEF TEST()\nSAME()\nSIN()\nEND\nDEF SAME()\nI = 2\nEND\nDEF SIN()\nJ = 2\nEND\n");

    assertThat(rig.get("I")).isEqualTo("2");
    assertThat(rig.get("J")).isEqualTo("2");
  }

  @Test
  void importsAVariableOfAnotherModule() {
    Rig rig = new Rig().load("DEF STORE()\nEND\n", "DEFDAT STORE PUBLIC\nINT STOCK=12\nENDDAT\n");

    rig.run("DEF TEST()\nIMPORT INT STOCK IS /R1/STORE..STOCK\nI = STOCK\nEND\n");

    assertThat(rig.get("I")).isEqualTo("12");
  }

  @Test
  void givesTheMainRoutineATextAsArgument() {
    Rig rig = new Rig().load("DEF TEST(T[]:IN)\nCHAR T[]\nI = STRLEN(T[])\nEND\n");

    rig.select("TEST", new KrlString("hello")).interpreter.start();

    assertThat(rig.cycle().get("I")).isEqualTo("5");
  }

  @Test
  void givesTheMainRoutineItsArguments() {
    Rig rig = new Rig().load("DEF TEST(A:IN,B:OUT)\nINT A,B\nB = A + 1\nI = B\nEND\n");

    rig.select("TEST", new KrlInt(4)).interpreter.start();

    assertThat(rig.cycle().get("I")).isEqualTo("5");
  }

  /** Such a routine has more statements than stay compiled, and each call replaces them. */
  @Test
  void aLongRoutineCallsItselfInTheMiddleOfAStatement() {
    String call = "  J = J + SUM(N-1)\n  RETURN J\nENDFCT\n";
    Rig rig =
        new Rig()
            .run(
                "DEF TEST()\nK = SUM(3)\nEND\nDEFFCT INT SUM(N:IN)\nINT N,J\n"
                    + "J = N\nIF N==0 THEN\nRETURN 0\nENDIF\n"
                    + "I = I + 1\n".repeat(600)
                    + call);

    assertThat(rig.get("K")).isEqualTo("6");
    assertThat(rig.get("I")).isEqualTo("1800");
  }

  @Test
  void aLoopOfManyStatementsExecutesAllInEachTurn() {
    Rig rig =
        new Rig().run("DEF TEST()\nFOR J=1 TO 3\n" + "I = I + J\n".repeat(600) + "ENDFOR\nEND\n");

    assertThat(rig.get("I")).isEqualTo("3600");
  }
}
