package no.hials.crosscom.lang;

import static no.hials.crosscom.lang.Snippets.errors;
import static no.hials.crosscom.lang.Snippets.routine;
import static no.hials.crosscom.lang.Snippets.show;
import static no.hials.crosscom.lang.Snippets.statements;
import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class SplineTest {
  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '~',
      value = {
        "SPTP XP1                | SplineMotion(SPTP, -, XP1, -, [], false, -)",
        "SPTP (A:B) C_SPL        | SplineMotion(SPTP, -, (A GEOMETRIC B), -, [], true, -)",
        "sptp_rel {A1 5} c_spl   | SplineMotion(SPTP_REL, -, {A1 5}, -, [], true, -)",
        "SLIN P WITH $VEL.CP=1   | SplineMotion(SLIN, -, P, -, [AssignmentStatement($VEL.CP, 1)], false, -)",
        "SLIN P WITH $TOOL=T[1], $BASE=B C_SPL | SplineMotion(SLIN, -, P, -,"
            + " [AssignmentStatement($TOOL, T[1]), AssignmentStatement($BASE, B)], true, -)",
        "SLIN P C_SPL WITH A=1   | SplineMotion(SLIN, -, P, -, [AssignmentStatement(A, 1)], true, -)",
        "SLIN_REL {X 1} #TOOL    | SplineMotion(SLIN_REL, -, {X 1}, -, [], false, #TOOL)",
        "SLIN_REL {X 1} WITH A=1 C_SPL #base | SplineMotion(SLIN_REL, -, {X 1}, -,"
            + " [AssignmentStatement(A, 1)], true, #base)",
        "SCIRC P,Q,CA 90 WITH $VEL=SVEL_CP(0.5, , L) C_SPL | SplineMotion(SCIRC, P, Q, 90,"
            + " [AssignmentStatement($VEL, SVEL_CP(0.5, -, L))], true, -)",
        "SLIN P C_DIS            | SplineMotion(SLIN, -, P, -, [], true, -)",
        "SPTP P WITH $APO.CDIS = 200 C_DIS | SplineMotion(SPTP, -, P, -,"
            + " [AssignmentStatement($APO.CDIS, 200)], true, -)",
        "SCIRC P,Q               | SplineMotion(SCIRC, P, Q, -, [], false, -)",
        "SCIRC_REL P,Q,CA -90    | SplineMotion(SCIRC_REL, P, Q, (MINUS 90), [], false, -)",
        "STOP WHEN PATH=50 ONSTART IF A==B | StopOnPath(50, true, (A EQUAL B))",
        "STOP WHEN PATH = -5.5 IF $IN[1] | StopOnPath((MINUS 5.5), false, $IN[1])",
      })
  void readsSingleMotions(String line, String tree) {
    assertThat(show(statements(line))).isEqualTo("[" + tree + "]");
  }

  @Test
  void readsTheLineOfAnInlineForm() {
    assertThat(
            show(
                statements(
                    "SPTP XP1 WITH $VEL_AXIS[1]=SVEL_JOINT(100.0), $TOOL=STOOL2(FP1),"
                        + " $BASE=SBASE(FP1.BASE_NO), $IPO_MODE=SIPO_MODE(FP1.IPO_FRAME),"
                        + " $COLLMON_TOL_PRO[1]=0 C_SPL ; a comment")))
        .isEqualTo(
            "[SplineMotion(SPTP, -, XP1, -,"
                + " [AssignmentStatement($VEL_AXIS[1], SVEL_JOINT(100.0)),"
                + " AssignmentStatement($TOOL, STOOL2(FP1)),"
                + " AssignmentStatement($BASE, SBASE(FP1.BASE_NO)),"
                + " AssignmentStatement($IPO_MODE, SIPO_MODE(FP1.IPO_FRAME)),"
                + " AssignmentStatement($COLLMON_TOL_PRO[1], 0)], true, -)]");
  }

  @Test
  void readsABlock() {
    assertThat(
            show(
                statements(
                    """
                    SPLINE WITH $VEL.CP=0.5
                      ;FOLD SPL P1
                      SPL XP1
                      ;ENDFOLD
                      TIME_BLOCK START
                      SLIN XP2 WITH $ORI_TYPE=#CONSTANT
                      TIME_BLOCK PART=2*N
                      TRIGGER WHEN PATH=5 ONSTART DELAY=-10 DO $OUT[1]=TRUE
                      SCIRC XP3,XP4,CA 90
                      TIME_BLOCK END=1.5
                      CONST_VEL START=10 ONSTART
                      SPL_REL {X 10} #TOOL
                      CONST_VEL END=-10
                      STOP WHEN PATH=0 IF $IN[3]
                      SPL XP5
                    ENDSPLINE C_SPL""")))
        .isEqualTo(
            "[SplineBlock(false, [AssignmentStatement($VEL.CP, 0.5)], ["
                + "SplineMotion(SPL, -, XP1, -, [], false, -), TimeBlock(START, -),"
                + " SplineMotion(SLIN, -, XP2, -,"
                + " [AssignmentStatement($ORI_TYPE, #CONSTANT)], false, -),"
                + " TimeBlock(PART, (2 MULTIPLY N)),"
                + " Trigger(true, 5, true, (MINUS 10), AssignmentStatement($OUT[1], true), -),"
                + " SplineMotion(SCIRC, XP3, XP4, 90, [], false, -), TimeBlock(END, 1.5),"
                + " ConstantVelocity(false, 10, true),"
                + " SplineMotion(SPL_REL, -, {X 10}, -, [], false, #TOOL),"
                + " ConstantVelocity(true, (MINUS 10), false),"
                + " StopOnPath(0, false, $IN[3]),"
                + " SplineMotion(SPL, -, XP5, -, [], false, -)], true)]");
  }

  @Test
  void readsABlockOfPointToPointSegments() {
    assertThat(show(statements("PTP_SPLINE\nSPTP A WITH $ACC_AXIS[1]=50\nSPTP B\nENDSPLINE")))
        .isEqualTo(
            "[SplineBlock(true, [], [SplineMotion(SPTP, -, A, -,"
                + " [AssignmentStatement($ACC_AXIS[1], 50)], false, -),"
                + " SplineMotion(SPTP, -, B, -, [], false, -)], false)]");
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '~',
      value = {
        "SPL A                   | 2:1 SPL is allowed only in a spline block",
        "TIME_BLOCK START        | 2:1 TIME_BLOCK is allowed only in a spline block",
        "CONST_VEL END=5         | 2:1 CONST_VEL is allowed only in a spline block",
        "ENDSPLINE               | 2:1 ENDSPLINE without SPLINE",
        "SLIN A C_VEL            | 2:8 expected C_DIS, C_SPL, WITH or the end of the line, found C_VEL",
        "SLIN A #BASE            | 2:8 expected C_DIS, C_SPL, WITH or the end of the line, found #BASE",
        "SLIN_REL A #WORLD       | 2:12 expected #BASE or #TOOL, found #WORLD",
        "SLIN A WITH             | 2:12 expected a name, found the end of the line",
        "SLIN A WITH B           | 2:14 expected =, found the end of the line",
        "SLIN A WITH B=1 C=2     | 2:17 expected C_DIS, C_SPL, a comma or the end of the line, found C",
        "SCIRC A                 | 2:8 expected a comma, found the end of the line",
        "STOP WHEN DISTANCE=0 IF A | 2:11 expected PATH, found DISTANCE",
        "STOP WHEN PATH=0        | 2:17 expected IF or ONSTART, found the end of the line",
        "SPLINE;SPTP A;ENDSPLINE | 3:1 SPTP is not allowed in a SPLINE",
        "PTP_SPLINE;SLIN A;ENDSPLINE | 3:1 SLIN is not allowed in a PTP_SPLINE",
        "PTP_SPLINE;CONST_VEL START=0;ENDSPLINE | 3:1 CONST_VEL is not allowed in a PTP_SPLINE",
        "SPLINE;A=1;ENDSPLINE    | 3:1 A is not allowed in a spline block",
        "SPLINE;GOTO X;ENDSPLINE;X: | 3:1 GOTO is not allowed in a spline block",
        "SPLINE;IF A THEN;SPL B;ENDIF;ENDSPLINE | 3:1 IF is not allowed in a spline block",
        "SPLINE;SPL A            | 4:1 expected ENDSPLINE of the SPLINE in line 2, found END",
        "PTP_SPLINE;SPTP A       | 4:1 expected ENDSPLINE of the PTP_SPLINE in line 2, found END",
        "SPLINE;TIME_BLOCK END;ENDSPLINE | 3:15 expected =, found the end of the line",
        "SPLINE;CONST_VEL 5;ENDSPLINE | 3:11 expected END or START, found 5",
        "SPLINE;SPL A;ENDSPLINE B | 4:11 expected C_DIS, C_SPL or the end of the line, found B",
      })
  void reportsAMistakeOnceAndLosesTheWholeBlock(String lines, String error) {
    ParseResult result = routine(lines.replace(';', '\n'));

    assertThat(errors(result)).containsExactly(error);
    Routine routine = ((SourceFile) result.file().orElseThrow()).routines().get(0);
    assertThat(show(routine.body().get(0)))
        .isEqualTo("Invalid(" + error.substring(error.indexOf(' ') + 1) + ")");
  }
}
