package no.hials.crosscom.simulator.internal.program;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Calls as KUKA's library and the programs of users write them. */
class KssCallsTest {

  // arguments

  @Test
  void tellsOmittedArgumentsByVarstate() {
    Rig rig =
        new Rig()
            .run(
                """
                DEF TEST()
                  SUB(1, ,"abc")
                  SUB(,2)
                  SUB()
                END
                DEF SUB(A:IN,B:OUT,T[]:IN,F:IN)
                  INT A,B
                  CHAR T[]
                  FRAME F
                  I=I*10
                  IF VARSTATE("A")==#INITIALIZED THEN
                    I=I+1
                  ENDIF
                  IF VARSTATE("B")==#INITIALIZED THEN
                    I=I+2
                  ENDIF
                  IF VARSTATE("T[]")==#INITIALIZED THEN
                    I=I+4
                  ENDIF
                  IF VARSTATE("F")==#INITIALIZED THEN
                    I=I+8
                  ENDIF
                  J=J*10+STRLEN(T[])
                END
                """);

    assertThat(rig.get("I")).isEqualTo("520");
    assertThat(rig.get("J")).isEqualTo("300");
  }

  @ParameterizedTest
  @CsvSource({":IN", ":OUT"})
  void passesAnArgumentToAParameterOfAnUnknownType(String direction) {
    Rig rig =
        new Rig()
            .loadLeniently(
                """
                DEF TEST()
                  SUB(#RED, 5)
                END
                DEF SUB(A%s,N:IN)
                  DECL NOTYPE A
                  INT N
                  IF A==#RED THEN
                    I = N
                  ENDIF
                END
                """
                    .formatted(direction));

    assertThat(rig.select("TEST").startSelected().cycle().get("I")).isEqualTo("5");
  }

  @Test
  void passesAnExpressionToAnOutParameter() {
    Rig rig =
        new Rig()
            .run(
                """
                DEF TEST()
                  I = 4
                  SUB(I+1, "text")
                END
                DEF SUB(A:OUT,T[]:OUT)
                  INT A
                  CHAR T[]
                  A = A+1
                  J = A
                  K = STRLEN(T[])
                END
                """);

    assertThat(rig.get("I") + rig.get("J") + rig.get("K")).isEqualTo("464");
  }

  @Test
  void returnsArrays() {
    Rig rig =
        new Rig()
            .run(
                """
                DEF TEST()
                  TEXT[] = NAMED(2)
                  ARR[] = THREE(7)
                  J = STRLEN(NAMED(1))
                  SUB(NAMED(1))
                END
                DEFFCT CHAR[8] NAMED(N:IN)
                  INT N
                  IF N==2 THEN
                    RETURN "two"
                  ENDIF
                  RETURN "other"
                ENDFCT
                DEFFCT INT[5] THREE(N:IN)
                  INT N,K,A[5]
                  FOR K=1 TO 5
                    A[K] = N*K
                  ENDFOR
                  RETURN A[]
                ENDFCT
                DEF SUB(T[]:IN)
                  CHAR T[]
                  OTHER[] = T[]
                END
                """);

    assertThat(rig.get("TEXT[]")).isEqualTo("\"two\"");
    assertThat(rig.get("ARR[5]")).isEqualTo("35");
    assertThat(rig.get("J")).isEqualTo("5");
    assertThat(rig.get("OTHER[]")).isEqualTo("\"other\"");
  }

  @Test
  void passesTextsToArraysWhoseHeadOmitsTheBrackets() {
    Rig rig =
        new Rig()
            .run(
                """
                DEF TEST()
                  SUB("CTL")
                END
                DEF SUB(T:IN)
                  CHAR T[]
                  TEXT[] = T[]
                  B = T[2]=="T"
                END
                """);

    assertThat(rig.get("TEXT[]")).isEqualTo("\"CTL\"");
    assertThat(rig.get("B")).isEqualTo("TRUE");
  }

  @Test
  void stopsIfAFunctionReturnsALongerArray() {
    assertThat(
            new Rig()
                .faultOf(
                    "DEF TEST()\nTEXT[] = F()\nEND\nDEFFCT CHAR[2] F()\nRETURN \"abc\"\nENDFCT\n"))
        .contains("line 5: the value of F: holds 2 characters, was given 3");
  }

  // routines that are not there

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "USERSPOT(#INIT,SDEFAULT)",
        "USER_GRP(0,GDEFAULT)",
        "H50(#INIT)",
        "A10(#A)",
        "A20()",
        "GL_MAIN(1, ,2)",
        "TM_SPOT(1)",
        "BASISTECH_PLC_LOOP()",
        "SUBMIT_CYCLE(12,#PRIO_NORMAL)"
      })
  void doesNothingInAHookOfAnInlineForm(String call) {
    assertThat(new Rig().execute(call + "\nI = 1").get("I")).isEqualTo("1");
  }

  @Test
  void callsAHookThatIsLoaded() {
    Rig rig = new Rig().load("DEF H50(N:IN)\nINT N\nI = N\nEND\n");

    assertThat(rig.execute("H50(5)").get("I")).isEqualTo("5");
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "I = RSI_CREATE(\"a.rsi\") | 9010 line 2: RSI_CREATE: RSI is not simulated",
        "RSI_MOVECORR() | 9010 line 2: RSI_MOVECORR: RSI is not simulated",
        "I = ST_ON(NOBODY,0) | 9010 line 2: ST_ON: RSI is not simulated",
        "RET = EKI_Open(\"x\") | 9010 line 2: no variable RET is declared",
        "I = EKI_Open(\"x\") | 9010 line 2: EKI_OPEN: EKI is not simulated",
        "F = EK(F,#EASYS,F) | 9010 line 2: EK: this routine of KSS is not simulated",
        "SYNC(1) | 9010 line 2: SYNC: this routine of KSS is not simulated",
        "I = StrToInt(\"7\") | 9010 line 2: STRTOINT: this routine of KSS is not simulated",
        "COPEN(:SER_1, I) | 1007 line 2: COPEN: channels are not simulated",
        "I = ABS(:SER_1) | 9010 line 2: channels are not simulated",
        "COPEN(I) | 1007 line 2: COPEN: channels are not simulated",
      })
  void stopsAtACallOfAPackageThatIsNotSimulated(String statement, String fault) {
    Rig rig = new Rig().loadLeniently("DEF TEST()\n" + statement + "\nI = 8\nEND\n");

    assertThat(rig.select("TEST").startSelected().cycle().fault()).isEqualTo(fault);
  }

  // ON_ERROR_PROCEED

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "ARR[9] = 1",
        "I = ARR[9] + 1",
        "SUB(ARR[9])",
        "I = F(ARR[9])",
        "PTP NOWHERE",
        "IF ARR[9]==1 THEN;I=99;ENDIF",
        "WHILE ARR[9]==1;I=99;ENDWHILE",
        "SWITCH ARR[9];CASE 1;I=99;ENDSWITCH"
      })
  void proceedsAfterAnErrorOfTheNextStatement(String statement) {
    Rig rig =
        new Rig()
            .run(
                "DEF TEST()\nON_ERROR_PROCEED\n; a comment\n"
                    + statement.replace(';', '\n')
                    + "\nJ = 3\nEND\n"
                    + "DEF SUB(N:IN)\nINT N\nI=99\nEND\n"
                    + "DEFFCT INT F(N:IN)\nINT N\nRETURN N\nENDFCT\n");

    assertThat(rig.get("J")).isEqualTo("3");
    assertThat(rig.get("I")).isEqualTo("0");
    assertThat(rig.robot.errors).hasSize(2).startsWith(0).doesNotHaveDuplicates();
  }

  @Test
  void stopsAtAnErrorOfTheStatementAfterTheNext() {
    assertThat(new Rig().faultIn("ON_ERROR_PROCEED\nI = 1\nARR[9] = 1")).contains(" line 4: ");
  }

  @Test
  void stopsAtAnErrorInTheBodyOfAProtectedCall() {
    assertThat(
            new Rig()
                .faultOf("DEF TEST()\nON_ERROR_PROCEED\nSUB()\nEND\nDEF SUB()\nARR[9]=1\nEND\n"))
        .contains(" line 6: ");
  }

  @Test
  void stopsAtAnErrorInTheBodyOfAProtectedBranch() {
    assertThat(new Rig().faultIn("ON_ERROR_PROCEED\nIF TRUE THEN\nARR[9]=1\nENDIF"))
        .contains(" line 4: ");
  }

  @Test
  void keepsTheErrorNumberAtZeroIfNothingFails() {
    assertThat(new Rig().execute("ON_ERROR_PROCEED\nI = 1").robot.errors).containsExactly(0);
  }

  @Test
  void protectsAStatementInEachTurnOfALoop() {
    Rig rig = new Rig().execute("FOR I=1 TO 3\nON_ERROR_PROCEED\nARR[I+3] = I\nJ = J+1\nENDFOR\n");

    assertThat(rig.get("J") + rig.get("ARR[5]")).isEqualTo("32");
    assertThat(rig.robot.errors).hasSize(4);
  }
}
