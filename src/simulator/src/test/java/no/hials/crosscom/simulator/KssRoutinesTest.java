package no.hials.crosscom.simulator;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import no.hials.crosscom.protocol.code.ProgramState;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** The routines of KSS on a whole controller. */
class KssRoutinesTest {
  private static final String DATA =
      """
      DEFDAT TEST PUBLIC
      DECL FDAT FP1={TOOL_NO 2,BASE_NO 3,IPO_FRAME #BASE}
      DECL FDAT FP0={TOOL_NO 0,BASE_NO 0,IPO_FRAME #TCP}
      DECL PDAT PP1={VEL 100.0,ACC 40.0,APO_DIST 25.0,APO_MODE #CDIS,GEAR_JERK 75.0}
      DECL PDAT PP2={VEL 100.0,ACC 40.0,APO_DIST 25.0}
      DECL LDAT LP1={VEL 2.0,ACC 100.0,APO_DIST 30.0,AXIS_VEL 60.0,AXIS_ACC 50.0,ORI_TYP #CONSTANT,CIRC_TYP #PATH,GEAR_JERK 50.0}
      GLOBAL REAL R1=0.0
      GLOBAL REAL R2=0.0
      GLOBAL REAL R3=0.0
      GLOBAL BOOL B1=FALSE
      GLOBAL INT I1=0
      GLOBAL INT I2=0
      DECL GLOBAL FRAME F1={X 0.0,Y 0.0,Z 0.0,A 0.0,B 0.0,C 0.0}
      DECL CP C1
      DECL CONT A1
      DECL JERK_STRUC J1
      DECL LOAD L1
      ENDDAT
      """;

  /** A routine in the text of a page: its name, several names, or a call. */
  private static final Pattern ROUTINE = Pattern.compile("`([A-Za-z][\\w. ]*)(?:\\([^`]*)?`");

  private final Cell cell = new Cell();
  private final Controller controller = cell.controller;

  @AfterEach
  void close() {
    cell.close();
  }

  private KssRoutinesTest load(String body) {
    assertThat(controller.load("TEST.DAT", DATA, LoadingMode.LENIENT).problems()).isEmpty();
    controller.load("TEST.SRC", "DEF TEST()\n" + body + "\nEND\n", LoadingMode.LENIENT);
    return this;
  }

  private void start() {
    select("TEST");
    controller.start();
  }

  private void run(String body) {
    load(body).start();
    controller.stepUntil(
        () -> controller.robot().state() != ProgramState.ACTIVE, Duration.ofSeconds(60));
    assertThat(controller.messages()).isEmpty();
    assertThat(controller.robot().state()).isEqualTo(ProgramState.END);
  }

  @Test
  void theHomeCheckSeesAHomePositionOfTheLineBefore() {
    run("$H_POS=$AXIS_ACT\nP00 (#CHK_HOME,#PGNO_GET,DMY[],0 )\nI1=1");

    assertThat(get("I1")).isEqualTo("1");
  }

  private String get(String name) {
    return cell.get(name);
  }

  // functions of inline forms

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "R1=SVEL_JOINT(40.0) | R1 | 40.0000",
        "R1=SVEL_JOINT(400.0) | R1 | 100.000",
        "R1=SVEL_JOINT(40.0) | $VEL_AXIS[6] | 40",
        "R1=SACC_JOINT(PP1) | R1 | 40.0000",
        "R1=SACC_JOINT(PP1) | $ACC_AXIS[2] | 40",
        "R1=SGEAR_JERK(PP1) | R1 | 75.0000",
        "R1=SGEAR_JERK(PP1) | $GEAR_JERK[6] | 75.0000",
        "R1=SGEAR_JERK(PP2) | R1 | 100.000",
        "C1=SVEL_CP(0.5, ,LP1) $R1=C1.CP | R1 | 0.500000",
        "C1=SVEL_CP(5.0, ,LP1) $R1=C1.CP | R1 | 2.00000",
        "C1=SVEL_CP(0.5, ,LP1) $R1=C1.ORI2 | R1 | 200.000",
        "C1=SVEL_CP(0.5, ,LP1) | $VEL_AXIS[1] | 60",
        "C1=SACC_CP(LP1) $R1=C1.CP | R1 | 1.15000",
        "A1=SAPO_PTP(PP1) $R1=A1.CDIS | R1 | 25.0000",
        "$APO=SAPO(LP1) | $APO.CDIS | 30.0000",
        "F1=STOOL2(FP1) | F1.X | 11.0000",
        "F1=STOOL2(FP1) | $ACT_BASE | 3",
        "F1=STOOL(0) | F1.X | 0.0",
        "F1=SBASE(FP1.BASE_NO) | F1.Y | 22.0000",
        "L1=SLOAD(1) $R1=L1.M | R1 | 2.50000",
        "L1=SLOAD(0) $R1=L1.M | R1 | -1.00000",
        "$IPO_MODE=SIPO_MODE(FP0.IPO_FRAME) | $IPO_MODE | #TCP",
        "$ORI_TYPE=SORI_TYP(LP1) | $ORI_TYPE | #CONSTANT",
        "$CIRC_TYPE=SCIRC_TYP(LP1) | $CIRC_TYPE | #PATH",
        "J1=SJERK(LP1) $R1=J1.CP | R1 | 25.0000",
        "$COLLMON_TOL_PRO[1]=USE_CM_PRO_VALUES(0) | $COLLMON_TOL_PRO[1] | 0",
      })
  void hasTheFunctionsOfInlineForms(String statements, String variable, String value) {
    run("TOOL_DATA[2].X=11.0\nBASE_DATA[3].Y=22.0\n" + statements.replace(" $R1", "\nR1"));

    assertThat(get(variable)).isEqualTo(value);
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "SPTP {A1 5} WITH $TOOL=STOOL2(FP1), $BASE=SBASE(FP1.BASE_NO)",
        "SPLINE\nSPL {X 480,Y 30,Z 600} WITH $TOOL=STOOL2(FP1)\nENDSPLINE"
      })
  void aToolSetForOneMotionKeepsItsNumbers(String motion) {
    run("TOOL_DATA[2].X=11.0\nBAS(#INITMOV,0)\nF1=$TOOL\n" + motion + "\nB1=$TOOL.X==F1.X");

    assertThat(get("$ACT_TOOL")).isEqualTo("2");
    assertThat(get("$ACT_BASE")).isEqualTo("3");
    assertThat(get("B1")).isEqualTo("TRUE");
  }

  @ParameterizedTest
  @CsvSource({"TRUE,15.0000,25.0000", "FALSE,11.0000,22.0000"})
  void addsTheCorrectionsOfToolAndBaseWhereTheyAreOn(String on, String x, String y) {
    run(
        """
        TOOL_DATA[2]={X 11.0,Y 0.0,Z 0.0,A 90.0,B 0.0,C 0.0}
        TOOL_CORR[2]={X 0.0,Y -4.0,Z 0.0,A 0.0,B 0.0,C 0.0}
        BASE_DATA[3].Y=22.0
        BASE_CORR[3]={X 0.0,Y 3.0,Z 0.0,A 0.0,B 0.0,C 0.0}
        TOOL_CORR_ON=%s
        BASE_CORR_ON=%s
        F1=STOOL2(FP1)
        R1=F1.X
        F1=SBASE(3)
        R2=F1.Y
        """
            .formatted(on, on));

    assertThat(get("R1")).isEqualTo(x);
    assertThat(get("R2")).isEqualTo(y);
  }

  @Test
  void knowsEveryRoutineThatThePageNames() throws IOException {
    String page = Files.readString(Path.of("../../docs/reference/krl-language.md"));
    Set<String> names = new TreeSet<>();
    for (String heading :
        List.of("Functions", "Routines of KSS", "Messages", "Automatic External")) {
      String section = page.substring(page.indexOf("\n## " + heading + "\n") + 4);
      section = section.substring(0, section.indexOf("\n## "));
      // the functions are in the first line, the others in the first column of a table
      String where = heading.equals("Functions") ? "^`SIN .*" : "^\\|[^|]*";
      Pattern.compile(where, Pattern.MULTILINE)
          .matcher(section)
          .results()
          .flatMap(part -> ROUTINE.matcher(part.group()).results())
          .flatMap(name -> Stream.of(name.group(1).split(" ")))
          .forEach(name -> names.add(name.replace("...", "X")));
    }
    assertThat(names)
        .contains(
            "SIN", "SREAD", "SVEL_JOINT", "SAPO", "SBASE", "TM_X", "EKI_X", "COPEN", "MsgQuit")
        .contains("Get_MsgBuffer", "Set_KrlDlgAnswer", "P00")
        .hasSizeGreaterThan(50)
        .allSatisfy(
            name -> {
              String program = "DEF CALL()\n" + name + "()\nEND\n";
              controller.load("CALL.SRC", program, LoadingMode.LENIENT);
              assertThat(controller.check("CALL").toString()).doesNotContain("is known");
            });
  }

  @Test
  void usesTheBasOfTheArchive() {
    controller.load(
        "BAS.SRC",
        "DEF BAS()\nEND\nGLOBAL DEFFCT REAL SVEL_JOINT(P:IN)\nREAL P\nRETURN P+1.0\nENDFCT\n",
        LoadingMode.LENIENT);

    run("R1=SVEL_JOINT(40.0)\nF1=STOOL(0)");

    assertThat(get("R1")).isEqualTo("41.0000");
  }

  @Test
  void replacesARoutineOfTheArchiveThatDoesNotRunAndReportsIt() {
    controller.load(
        "BAS.SRC",
        """
        DEF BAS(COMMAND:IN,N:IN)
        INT COMMAND,N
        END
        GLOBAL DEFFCT REAL SVEL_JOINT(P:IN)
        REAL P
        HELP()
        RETURN P+1.0
        ENDFCT
        GLOBAL DEFFCT REAL SACC_JOINT(P:IN)
        DECL PDAT P
        RETURN 5.0
        ENDFCT
        DEF HELP()
        R3=NOBODY
        END
        """,
        LoadingMode.LENIENT);

    run("R1=SVEL_JOINT(40.0)\nR2=SACC_JOINT(PP1)");

    assertThat(get("R1") + " " + get("R2")).isEqualTo("40.0000 5.00000");
    assertThat(controller.check("BAS"))
        .extracting(Object::toString)
        .contains(
            "BAS.SRC:4:1: the built-in SVEL_JOINT replaces this routine, which would stop in line"
                + " 14: no variable NOBODY is declared");
  }

  @Test
  void usesABasOfTheArchiveWithErrorsThatAProgramMayNotReach() {
    loadBas(
        """
        CASE #PTP_PARAMS
          IF $ADAP_ACC<>#NONE THEN
            R1=R1+N
            $TORQMON[1]=100
          ELSE
            NOBODY()
          ENDIF
          ON_ERROR_PROCEED
          NOBODY()
        CASE #EX_BASE
          EX_BASE()
        """);

    run("BAS(#PTP_PARAMS,40)");

    assertThat(get("R1") + " " + get("$TORQMON[1]")).isEqualTo("40.0000 100");
    assertThat(controller.check("BAS"))
        .extracting(Object::toString)
        .isNotEmpty()
        .noneMatch(problem -> problem.contains("built-in"));
  }

  @Test
  void replacesABasOfTheArchiveThatStopsInACommand() {
    loadBas("CASE #INITMOV\nEX_BASE()");

    run("$ADVANCE=1\nBAS(#INITMOV,0)");

    assertThat(get("$ADVANCE")).isEqualTo("3");
    assertThat(controller.check("BAS"))
        .extracting(Object::toString)
        .contains(
            "BAS.SRC:1:1: the built-in BAS replaces this routine, which would stop in line 10: no"
                + " routine NOWHERE is known");
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "PDAT REAL ACC, APO_DIST, APO_MODE_T APO_MODE, REAL GEAR_JERK, INT EXAX_IGN | PTP_PARAMS",
        "PDAT REAL VEL,ACC,APO_DIST | PTP_PARAMS",
        "LDAT REAL VEL,ACC,APO_DIST,APO_FAC | CP_PARAMS"
      })
  void takesTheDataOfInlineFormsOfEveryVersion(String struc, String command) {
    load("$APO.CDIS=1.0\n$APO.CPTP=1\nBAS(#" + command + ",1)\nR1=$APO.CDIS\nR2=$APO.CPTP");
    String type = struc.substring(0, 4);
    controller.load(
        "$CONFIG.DAT",
        "DEFDAT $CONFIG\nSTRUC %s\nDECL %s %s_ACT={APO_DIST 17.0}\nENDDAT\n"
            .formatted(struc, type, type),
        LoadingMode.LENIENT);
    start();
    controller.step(Duration.ofMillis(100));

    assertThat(controller.messages()).isEmpty();
    assertThat(get("R1") + " " + get("R2"))
        .isEqualTo(command.equals("CP_PARAMS") ? "17.0000 1.00000" : "1.00000 17.0000");
  }

  @ParameterizedTest
  @CsvSource({
    "DEF_VEL_CP=1.5, $VEL.CP, 1.50000",
    "DEF_VEL_PTP=80, $VEL_AXIS[1], 80",
    "DEF_ACC_CP=2.0, $ACC.CP, 2.00000",
    "DEF_APO_CPTP=40, $APO.CPTP, 40",
    "DEF_APO_CDIS=7.0, $APO.CDIS, 7.00000",
    "DEF_ADVANCE=1, $ADVANCE, 1"
  })
  void initialisesMotionWithTheDefaultsOfTheArchive(String value, String variable, String set) {
    controller.load(
        "$CONFIG.DAT", "DEFDAT $CONFIG\nREAL " + value + "\nENDDAT\n", LoadingMode.LENIENT);

    run("BAS(#INITMOV,0)");

    assertThat(get(variable)).isEqualTo(set);
  }

  private void loadBas(String cases) {
    controller.load(
        "BAS.SRC",
        """
        DEF BAS(COMMAND:IN,N:IN)
        DECL BAS_COMMAND COMMAND
        REAL N
        SWITCH COMMAND
        %s
        ENDSWITCH
        END
        DEF EX_BASE()
        $BASE=NOWHERE(1)
        END
        """
            .formatted(cases.strip()),
        LoadingMode.LENIENT);
  }

  @Test
  void knowsTheOptionsOfKrc2AndTheResultsOfRsi() {
    load(
        """
        DECL RSIERR ERR
        IF ARC20==TRUE THEN
          A20(ARC_INI)
        ENDIF
        IF (A10_OPTION==#ACTIVE) OR H70_OPTION THEN
          HALT
        ENDIF
        ERR=ST_ON()
        IF (I1<>RSIOK) OR (ERR<>#RSIOK) THEN
          HALT
        ENDIF
        """);
    assertThat(controller.check("TEST")).isEmpty();
    start();
    controller.step(Duration.ofMillis(100));

    assertThat(controller.messages())
        .extracting(Message::text)
        .containsExactly("TEST.SRC:9:5: ST_ON: RSI is not simulated");
  }

  @Test
  void knowsTheMessageOfKrc2() {
    assertThat(
            controller
                .load(
                    "M.DAT",
                    "DEFDAT M PUBLIC\nDECL GLOBAL MSG_T EMPTY_MSG={VALID FALSE,RELEASE FALSE,TYP"
                        + " #NOTIFY,MODUL[] \"A\",KEY[] \"B\",PARAM_TYP #VALUE,PARAM[] \"C\""
                        + ",DLG_FORMAT[] \"D\",ANSWER 0}\nENDDAT\n",
                    LoadingMode.STRICT)
                .problems())
        .isEmpty();

    run("$MSG_T=EMPTY_MSG\n$MSG_T.TYP=#QUIT\n$MSG_T.VALID=TRUE\nB1=$MSG_T.VALID");

    assertThat(get("B1")).isEqualTo("TRUE");
    assertThat(controller.check("TEST")).isEmpty();
  }

  @ParameterizedTest
  @CsvSource({
    "B1=$MASTERINGTEST_REQ_INT, B1, FALSE",
    "B1=$MASTERINGTEST_ACTIVE, B1, FALSE",
    "I1=$MASTERINGTEST_GROUP, I1, 0",
    "B1=$MASTERINGTEST_SWITCH_OK, B1, FALSE",
    "B1=$VW_PSPS_STOP, B1, FALSE",
    "B1=$IMPROVED_COLLMON, B1, FALSE",
    "I1=$TORQ_DIFF[12], I1, 0",
    "I1=$TORQ_DIFF2[1], I1, 0",
    "I1=$TORQMON[1], I1, 0",
    "I1=$COLLMON_IDX, I1, 0",
    "I1=$NUM_OUT, I1, 4096",
    "F1=$NULLPOS, F1.X, 0.0",
    "I1=$RAT_MOT_AX[7].N, I1, 0"
  })
  void readsSystemVariablesThatProgramsOfUsersRead(String line, String variable, String value) {
    run(line);

    assertThat(get(variable)).isEqualTo(value);
    assertThat(controller.check("TEST")).isEmpty();
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "BOOL ARC20=TRUE | ARC20 | TRUE",
        "INT RSIOK=7 | RSIOK | 7",
        "DECL A_BOOL_T A10_OPTION=#ACTIVE | A10_OPTION | #ACTIVE"
      })
  void takesTheOptionsOfTheArchive(String line, String variable, String value) {
    LoadReport report =
        controller.load(
            "$CONFIG.DAT", "DEFDAT $CONFIG\n" + line + "\nENDDAT\n", LoadingMode.LENIENT);

    assertThat(report.problems()).isEmpty();
    assertThat(get(variable)).isEqualTo(value);
  }

  // messages

  @Test
  void showsNotificationsOfTheProgram() {
    load("MsgNotify(\"part %1 of %2\",\"Cell\",7,\"blue\",42)\nMsgNotify(\"plain\")").start();
    controller.step(Duration.ofMillis(100));

    assertThat(controller.messages())
        .extracting(m -> m.kind() + " " + m)
        .containsExactly("NOTIFICATION 42 Cell: part 7 of blue", "NOTIFICATION 0 plain");
    assertThat(controller.robot().state()).isEqualTo(ProgramState.END);
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "MsgNotify(\"%1 of %2\", ,-1,\"blue\",-1)",
        "MsgQuit(\"%1 of %2\", ,-1,\"blue\",-1)",
        "MsgState(I1,\"%1 of %2\", ,-1,\"blue\",-1)"
      })
  void showsANumberBelowZero(String message) {
    load(message).start();
    controller.step(Duration.ofMillis(100));

    assertThat(controller.messages()).singleElement().hasToString("-1 -1 of blue");
  }

  @ParameterizedTest
  @ValueSource(strings = {"OUT_SYNC", "OUT_ASYNC", "GROUP"})
  void goesOnAfterACommandOfBasWithoutEffect(String command) {
    load("BAS(#" + command + ",1)\nI1=1").start();
    controller.step(Duration.ofMillis(100));

    assertThat(controller.messages())
        .extracting(m -> m.kind() + " " + m.text())
        .containsExactly("NOTIFICATION BAS(#" + command + ") has no effect in this simulation");
    assertThat(get("I1")).isEqualTo("1");
    assertThat(controller.robot().state()).isEqualTo(ProgramState.END);
  }

  @Test
  void stopsAtABaseOnExternalKinematics() {
    load("BAS(#EX_BASE,2)\nI1=1").start();
    controller.step(Duration.ofMillis(100));

    assertThat(controller.messages())
        .singleElement()
        .asString()
        .endsWith("BAS(#EX_BASE,2): a base on external kinematics is not simulated");
    assertThat(get("I1")).isEqualTo("0");
  }

  @Test
  void countsTheTextOfADialogueAsItsFirstParameter() {
    load("MsgDialog(I1,\"%1|%2\", ,\"blue\",\"left\")").start();
    controller.step(Duration.ofMillis(100));

    assertThat(controller.messages()).singleElement().hasToString("0 blue|");
  }

  @Test
  void waitsUntilAMessageIsConfirmed() {
    load("MsgQuit(\"check the gripper\")\nI1=1").start();
    controller.step(Duration.ofSeconds(5));

    assertThat(get("I1")).isEqualTo("0");
    assertThat(get("$STOPMESS")).isEqualTo("TRUE");
    assertThat(controller.confirmAll()).isEqualTo(1);
    controller.step(Duration.ofMillis(100));
    assertThat(get("I1")).isEqualTo("1");
    assertThat(get("$STOPMESS")).isEqualTo("FALSE");
  }

  @Test
  void waitsForTheAnswerToADialogue() {
    load("MsgDialog(I1,\"which %1?\",\"Cell\",\"part\",\"left\",\"right\")\nI2=1").start();
    controller.step(Duration.ofSeconds(5));

    Message message = controller.messages().get(0);
    assertThat(message.kind()).isEqualTo(Message.Kind.DIALOGUE);
    assertThat(message.text()).isEqualTo("Cell: which part?");
    assertThat(message.keys()).isEqualTo(List.of("left", "right"));
    assertThat(get("I2")).isEqualTo("0");
    assertThatThrownBy(() -> controller.answer(3))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessage("answer: the dialogue has the keys [left, right], was given number 3");
    assertThat(controller.dialogue()).contains(message);
    controller.answer(2);
    controller.step(Duration.ofMillis(100));
    assertThat(controller.dialogue()).isEmpty();
    assertThat(get("I1")).isEqualTo("6");
    assertThat(get("I2")).isEqualTo("1");
    assertThatThrownBy(() -> controller.answer(1))
        .isInstanceOf(IllegalStateException.class)
        .hasMessage("answer: no dialogue is shown");
  }

  @Test
  void answersTheDialogueThatIsMeantAndNoLaterOneWithTheSameText() {
    load("MsgDialog(I1,\"go on?\",,,\"yes\",\"no\")\nMsgDialog(I2,\"go on?\",,,\"yes\",\"no\")")
        .start();
    controller.step(Duration.ofMillis(100));
    Message first = controller.dialogue().orElseThrow();
    controller.answer(first, 1);
    controller.step(Duration.ofMillis(100));
    Message second = controller.dialogue().orElseThrow();

    assertThat(second.text()).isEqualTo(first.text());
    assertThatThrownBy(() -> controller.answer(first, 1))
        .isInstanceOf(IllegalStateException.class)
        .hasMessage("answer: this dialogue is no longer shown");
    assertThat(controller.dialogue()).contains(second);
    controller.answer(second, 2);
    controller.step(Duration.ofMillis(100));
    assertThat(get("I2")).isEqualTo("6");
  }

  @Test
  void clearsStateMessagesOfAProgramThatIsReset() {
    load("""
    MsgState(I1,"loading")
    B1=EXISTS_KRLMSG(I1)
    HALT
    """)
        .start();
    controller.step(Duration.ofMillis(100));

    assertThat(get("B1")).isEqualTo("TRUE");
    controller.load("SECOND.SRC", "DEF SECOND()\nB1=EXISTS_KRLMSG(I1)\nEND\n", LoadingMode.LENIENT);
    controller.robot().cancel();
    select("SECOND");
    controller.start();
    controller.step(Duration.ofMillis(100));
    assertThat(get("B1")).isEqualTo("FALSE");
  }

  @ParameterizedTest
  @CsvSource({"TRUE, FALSE", "FALSE, TRUE"})
  void keepsAMessageAfterAResetIfItsOptionsDo(String cleared, String kept) {
    load("DECL KRLMSGOPT_T O\nO.CLEAR_P_RESET="
            + cleared
            + "\nMsgState(I1,\"loading\", , , , ,O)\nHALT\n")
        .start();
    controller.step(Duration.ofMillis(100));
    controller.robot().reset();

    controller.load("SECOND.SRC", "DEF SECOND()\nB1=EXISTS_KRLMSG(I1)\nEND\n", LoadingMode.LENIENT);
    select("SECOND");
    controller.start();
    controller.step(Duration.ofMillis(100));
    assertThat(get("B1")).isEqualTo(kept);
  }

  @ParameterizedTest
  @CsvSource({"TRUE, FALSE", "FALSE, TRUE"})
  void keepsAMessageAfterABlockSelectionUnlessItsOptionsClearIt(String cleared, String kept) {
    load("DECL KRLMSGOPT_T O\nO.CLEAR_P_SAW="
            + cleared
            + "\nMsgState(I1,\"loading\", , , , ,O)\nHALT\nB1=EXISTS_KRLMSG(I1)\n")
        .start();
    controller.step(Duration.ofMillis(100));
    controller.robot().selectLine(6);
    controller.start();
    controller.step(Duration.ofMillis(100));

    assertThat(controller.robot().state()).isEqualTo(ProgramState.END);
    assertThat(get("B1")).isEqualTo(kept);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "I1=Set_KrlMsg(#NOTIFY,M,P[],O) | TRUE | true",
        "I1=Set_KrlMsg(#NOTIFY,M,P[],O) | FALSE | false",
        "I1=Set_KrlMsg(#NOTIFY,M,P[]) | TRUE | false",
        "MsgNotify(\"seen\", , , , ,O) | TRUE | true",
        "MsgNotify(\"seen\") | TRUE | false",
        "MsgQuit(\"seen\", , , , ,O) | FALSE | false",
        "MsgQuit(\"seen\") | FALSE | true",
      })
  void showsAMessageAtTheEndOfTheMotionIfItsOptionsStopTheAdvanceRun(
      String call, String stop, boolean atEnd) {
    load("DECL KRLMSG_T M\nDECL KRLMSGPAR_T P[3]\nDECL KRLMSGOPT_T O\n"
            + ("M={MODUL[] \"Cell\",NR 5,MSG_TXT[] \"seen\"}\nO.VL_STOP=" + stop + "\n")
            + ("PTP_REL {A1 20}\n" + call + "\n"))
        .start();

    assertThat(
            controller.stepUntil(
                () -> controller.messages().stream().anyMatch(m -> m.text().contains("seen")),
                Duration.ofSeconds(10)))
        .isTrue();
    assertThat(controller.axes().a1() > 19.999).isEqualTo(atEnd);
  }

  private void select(String name) {
    try {
      controller.robot().select(name);
    } catch (KrlFileException e) {
      throw new AssertionError(e);
    }
  }

  @Test
  void listsAndClearsTheMessagesOfTheProgram() {
    load("""
    DECL KRLMSG_T M
    DECL KRLMSGPAR_T P[3]
    DECL MSGBUF_T BUF[5]
    M={MODUL[] "Cell",NR 5,MSG_TXT[] "wait"}
    I1=Set_KrlMsg(#WAITING,M,P[])
    I2=Get_MsgBuffer(BUF[])
    R1=BUF[1].NR
    B1=Clear_KrlMsg(BUF[1].HANDLE)
    R2=Get_MsgBuffer(BUF[])
    """)
        .start();
    controller.step(Duration.ofMillis(100));

    assertThat(controller.messages())
        .extracting(m -> m.kind() + " " + m)
        .containsExactly("STATUS 5 Cell: wait");
    assertThat(get("I2") + " " + get("R1") + " " + get("B1") + " " + get("R2"))
        .isEqualTo("1 5.00000 TRUE 0.0");
  }

  @Test
  void answersADialogueOfTheRobotFromTheProgram() {
    load("""
    DECL KRLMSG_T M
    DECL KRLMSGPAR_T P[3]
    DECL KRLMSGDLGSK_T K[7]
    INT A
    M={MODUL[] "Cell",NR 5,MSG_TXT[] "go on?"}
    K[1]={SK_TYPE #VALUE,SK_TXT[] "yes"}
    I1=Set_KrlDlg(M,P[],K[])
    B1=Set_KrlDlgAnswer(I1,1)
    B1=Exists_KrlDlg(I1,A)
    I2=A
    """)
        .start();
    controller.step(Duration.ofMillis(100));

    assertThat(get("I2") + " " + get("B1")).isEqualTo("1 FALSE");
  }

  @Test
  void showsOneMessageOfALoopUntilABlankOne() {
    load("""
    DECL MSGBUF_T B[10]
    MsgLoop("one")
    MsgLoop("two","Cell")
    I1=Get_MsgBuffer(B[])
    MsgLoop(" ")
    I2=Get_MsgBuffer(B[])
    """)
        .start();
    controller.step(Duration.ofMillis(100));

    assertThat(get("I1") + " " + get("I2") + " " + get("$STOPMESS")).isEqualTo("1 0 FALSE");
    assertThat(controller.robot().state()).isEqualTo(ProgramState.END);
    assertThat(controller.messages()).extracting(Message::text).containsExactly("one", "Cell: two");
  }

  // cycles

  @Test
  void evaluatesTheExpressionOfACyclicFlagInEachCycle() {
    load("""
    INT LIMIT,N
    LIMIT=3
    N=2
    $CYCFLAG[N]=I1>LIMIT
    N=5
    INTERRUPT DECL 3 WHEN $CYCFLAG[2] DO HIT()
    INTERRUPT ON 3
    LIMIT=5
    WAIT FOR FALSE
    """)
        .start();
    controller.load("HIT.SRC", "DEF HIT()\nI2=I2+1\nEND\n", LoadingMode.LENIENT);
    controller.robot().stop();
    start();
    controller.step(Duration.ofMillis(48));
    cell.set("I1", "5");
    controller.step(Duration.ofMillis(48));
    String before = get("$CYCFLAG[2]") + " " + get("I2");
    cell.set("I1", "6");
    controller.step(Duration.ofMillis(48));

    assertThat(before).isEqualTo("FALSE 0");
    assertThat(get("$CYCFLAG[2]") + " " + get("I2")).isEqualTo("TRUE 1");
    controller.robot().cancel();
    cell.set("I1", "0");
    controller.step(Duration.ofMillis(48));
    assertThat(get("$CYCFLAG[2]")).isEqualTo("TRUE");
  }

  @Test
  void refusesARoutineInACyclicFlag() {
    load("$CYCFLAG[1]=F()");
    controller.load("F.SRC", "DEFFCT BOOL F()\nRETURN TRUE\nENDFCT\n", LoadingMode.LENIENT);

    assertThat(controller.check("TEST"))
        .extracting(Object::toString)
        .containsExactly("TEST.SRC:2:13: a cyclic flag must not call F");
  }

  @Test
  void writesAnalogueOutputsInCycles() {
    load("""
    ANOUT ON $ANOUT[1]=R1*2.0 MINIMUM=-0.5 MAXIMUM=0.5
    ANOUT ON $ANOUT[2]=R1 DELAY=0.12
    ANIN ON R2=R1+1.0
    WAIT FOR B1
    ANOUT OFF $ANOUT[1]
    ANIN OFF R2
    WAIT FOR FALSE
    """)
        .start();
    controller.step(Duration.ofMillis(24));
    cell.set("R1", "0.2");
    controller.step(Duration.ofMillis(24));
    assertThat(get("$ANOUT[1]") + " " + get("$ANOUT[2]") + " " + get("R2"))
        .isEqualTo("0.400000 0.0 1.20000");
    cell.set("R1", "0.4");
    controller.step(Duration.ofMillis(24));
    assertThat(get("$ANOUT[1]")).isEqualTo("0.500000");
    controller.step(Duration.ofMillis(120));
    assertThat(get("$ANOUT[2]")).isEqualTo("0.400000");
    cell.set("B1", "TRUE");
    controller.step(Duration.ofMillis(24));
    cell.set("R1", "0.0");
    controller.step(Duration.ofMillis(240));
    assertThat(get("$ANOUT[1]") + " " + get("$ANOUT[2]") + " " + get("R2"))
        .isEqualTo("0.500000 0.0 1.40000");
  }

  @Test
  void delaysAnAnalogueOutputByAMinuteAtMost() {
    load("ANOUT ON $ANOUT[1]=R1 DELAY=60\nI1=1\nANOUT ON $ANOUT[2]=R1 DELAY=60.1").start();
    controller.step(Duration.ofMillis(24));

    assertThat(get("I1")).isEqualTo("1");
    assertThat(controller.messages())
        .extracting(Object::toString)
        .singleElement()
        .asString()
        .startsWith("1422 TEST.SRC:4:")
        .endsWith("a DELAY of ANOUT is at most 60.0 s, was given 60.099998474121094");
  }

  @Test
  void confirmsAMessageFromTheSubmitProgram() throws KrlFileException {
    load("MsgQuit(\"wait\", , , ,77)\nI1=1").start();
    controller.step(Duration.ofMillis(100));
    cell.submit("CONFIRM 77");
    controller.step(Duration.ofMillis(100));

    assertThat(get("I1") + " " + get("$STOPMESS")).isEqualTo("1 FALSE");
  }

  // errors

  @Test
  void setsTheNumberOfACaughtError() {
    run("ON_ERROR_PROCEED\nI1=MYINTS[11]\nI1=$ERR.NUMBER\nON_ERROR_PROCEED\nI2=1\nI2=$ERR.NUMBER");

    assertThat(get("I1") + " " + get("I2")).isEqualTo("1444 0");
  }

  @Test
  void raisesAnErrorInTheCallingRoutine() {
    load("ON_ERROR_PROCEED\nSUB()\nI1=$ERR.NUMBER\nERR_CLEAR($ERR)\nI2=$ERR.NUMBER");
    controller.load(
        "SUB.SRC",
        """
        DEF SUB()
        DECL ERROR_T E
        ON_ERROR_PROCEED
        I1=MYINTS[11]
        E=$ERR
        ERR_RAISE(E)
        I1=99
        END
        """,
        LoadingMode.LENIENT);
    start();
    controller.step(Duration.ofMillis(200));

    assertThat(controller.messages()).isEmpty();
    assertThat(get("I1") + " " + get("I2")).isEqualTo("1444 0");
  }
}
