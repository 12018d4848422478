package no.hials.crosscom.simulator.internal.program;

import static org.assertj.core.api.Assertions.assertThat;

import no.hials.crosscom.lang.DataList;
import no.hials.crosscom.simulator.LoadingMode;
import no.hials.crosscom.simulator.internal.data.DataListLoader;
import no.hials.crosscom.simulator.internal.data.Scope;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class BasTest {
  private static final String VARIABLES =
      """
      DEFDAT $MOTION PUBLIC
      DECL CP $VEL
      DECL CP $ACC
      DECL APO $APO
      INT $VEL_AXIS[12]
      INT $ACC_AXIS[12]
      REAL $GEAR_JERK[12]
      DECL ORI $ORI_TYPE=#CONSTANT
      ENUM CIRC_T BASE,PATH
      DECL CIRC_T $CIRC_TYPE=#PATH
      DECL IPO_M $IPO_MODE=#TCP
      INT $ACT_EX_AX
      INT $ACT_BASE
      INT $ACT_TOOL
      FRAME $BASE
      FRAME $TOOL
      FRAME $WORLD={X 0.0,Y 0.0,Z 0.0,A 0.0,B 0.0,C 0.0}
      FRAME $NULLFRAME={X 0.0,Y 0.0,Z 0.0,A 0.0,B 0.0,C 0.0}
      DECL LOAD $LOAD
      FRAME TOOL_DATA[2]
      FRAME BASE_DATA[2]
      DECL LOAD LOAD_DATA[2]
      TOOL_DATA[1]={X 1.0,Y 0.0,Z 0.0,A 0.0,B 0.0,C 0.0}
      TOOL_DATA[2]={X 2.0,Y 0.0,Z 0.0,A 0.0,B 0.0,C 0.0}
      BASE_DATA[2]={X 20.0,Y 0.0,Z 0.0,A 0.0,B 0.0,C 0.0}
      LOAD_DATA[1]={M 1.5}
      LOAD_DATA[2]={M 2.5}
      DECL FDAT FDAT_ACT={TOOL_NO 2,BASE_NO 2,IPO_FRAME #TCP}
      DECL PDAT PDAT_ACT={VEL 80.0,ACC 60.0,APO_DIST 40.0,APO_MODE #CPTP}
      ENDDAT
      """;

  private static Rig rig() {
    Rig rig = new Rig();
    DataListLoader.load(
        (DataList) Rig.parse("motion.dat", VARIABLES),
        new Scope(rig.globals),
        rig.globals,
        LoadingMode.STRICT,
        error -> {
          throw new AssertionError(error.toString());
        });
    return rig;
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "$VEL | {CP 2.0,ORI1 200.0,ORI2 200.0}",
        "$ACC | {CP 2.3,ORI1 100.0,ORI2 100.0}",
        "$APO | {CVEL 100,CPTP 50,CDIS 3.0,CORI 5.0}",
        "$VEL_AXIS[6] | 100",
        "$ACC_AXIS[1] | 100",
        "$GEAR_JERK[1] | 100.0",
        "$ADVANCE | 3",
        "$ORI_TYPE | #VAR",
        "$CIRC_TYPE | #BASE",
        "$IPO_MODE | #BASE",
        "$ACT_EX_AX | -1",
        "$ACT_BASE | 0",
        "$ACT_TOOL | 1",
        "$TOOL.X | 1.0",
        "$BASE.X | 0.0",
        "$LOAD.M | 1.5",
      })
  void initialisesMotion(String variable, String expected) {
    Rig rig = rig().set("$ADVANCE", "0");

    assertThat(rig.execute("BAS(#INITMOV,0)").get(variable)).isEqualTo(expected);
  }

  @ParameterizedTest
  @CsvSource({
    "'ACC_CP,1.5', $ACC.CP, 1.5",
    "'ACC_GLUE,1.5', $ACC.CP, 1.5",
    "'EX_BASE,0', $ACT_EX_AX, -1",
    "'VEL_CP,0.5', $VEL.CP, 0.5",
    "'ACC_PTP,30', $ACC_AXIS[6], 30",
    "'VEL_PTP,20', $VEL_AXIS[1], 20",
    "'TOOL,2', $TOOL.X, 2.0",
    "'TOOL,0', $TOOL.X, 0.0",
    "'BASE,2', $BASE.X, 20.0",
    "'BASE,0.5', $ACT_BASE, 1",
    "FRAMES, $ACT_BASE, 2",
    "FRAMES, $IPO_MODE, #TCP",
    "PTP_DAT, $ACC_AXIS[2], 60",
    "PTP_DAT, $APO.CPTP, 40",
    "'PTP_PARAMS,100', $VEL_AXIS[2], 100",
    "'PTP_PARAMS,100', $ACT_TOOL, 2",
    "'CP_PARAMS,0.25', $VEL.CP, 0.25",
  })
  void setsWhatACommandIsFor(String command, String variable, String expected) {
    assertThat(rig().execute("BAS(#" + command + ")").get(variable)).isEqualTo(expected);
  }

  @Test
  void takesTheApproximationDistanceInMillimetres() {
    Rig rig = rig().set("PDAT_ACT.APO_MODE", "#CDIS");

    assertThat(rig.execute("BAS(#PTP_DAT)").get("$APO.CDIS")).isEqualTo("40.0");
  }

  @Test
  void letsAModuleOfThatNameTakeItsPlace() {
    Rig rig = new Rig().load("DEF BAS(A:IN,B:IN)\nREAL A,B\nR = A + B\nEND\n");

    assertThat(rig.execute("BAS(1,2)").get("R")).isEqualTo("3.0");
  }
}
