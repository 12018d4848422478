package no.hials.crosscom.simulator;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import no.hials.crosscom.protocol.code.OperatingMode;
import no.hials.crosscom.protocol.code.ProgramState;
import org.junit.jupiter.api.Test;

/** Runs what the inline forms of KSS write, as it is copied from a controller. */
class TaughtProgramTest {
  private static final String DATA =
      """
      &ACCESS RVP
      &REL 3
      DEFDAT PICK
      ;FOLD EXTERNAL DECLARATIONS
      EXT BAS (BAS_COMMAND :IN,REAL :IN)
      DECL BASIS_SUGG_T LAST_BASIS={POINT1[] "P2",POINT2[] "P2",CP_PARAMS[] "CPDAT1",CONT[] " "}
      DECL MODULEPARAM_T LAST_TP_PARAMS={PARAMS[] " "}
      ;ENDFOLD
      DECL E6POS XP1={X 445.0,Y 0.0,Z 810.0,A 180.0,B 0.0,C 180.0,S 2,T 2,E1 0.0}
      DECL FDAT FP1={TOOL_NO 1,BASE_NO 0,IPO_FRAME #BASE,POINT2[] " "}
      DECL PDAT PPDAT1={VEL 100.0,ACC 50.0,APO_DIST 100.0}
      DECL E6POS XP2={X 445.0,Y 100.0,Z 810.0,A 180.0,B 0.0,C 180.0,S 2,T 3,E1 0.0}
      DECL FDAT FP2={TOOL_NO 1,BASE_NO 0,IPO_FRAME #BASE,POINT2[] " "}
      DECL LDAT LCPDAT1={VEL 2.0,ACC 50.0,APO_DIST 20.0,APO_FAC 50.0,ORI_TYP #CONSTANT}
      ENDDAT
      """;

  private static final String SOURCE =
      """
      &ACCESS RVP
      DEF PICK ( )
      ;FOLD INI
        BAS (#INITMOV,0 )
      ;ENDFOLD (INI)
      ;FOLD PTP P1 Vel=100 % PDAT1 Tool[1] Base[0];%{PE}
      $BWDSTART=FALSE
      PDAT_ACT=PPDAT1
      FDAT_ACT=FP1
      BAS(#PTP_PARAMS,100)
      PTP XP1
      ;ENDFOLD
      ;FOLD LIN P2 CONT Vel=0.5 m/s CPDAT1 Tool[1] Base[0];%{PE}
      $BWDSTART=FALSE
      LDAT_ACT=LCPDAT1
      FDAT_ACT=FP2
      BAS(#CP_PARAMS,0.5)
      LIN XP2 C_DIS C_DIS
      ;ENDFOLD
      BASE_DATA[3]=$POS_ACT
      END
      """;

  @Test
  void goesToItsPointsWithTheirData() throws Exception {
    try (Controller controller = Cell.stepped(VariableTable.krc4())) {
      controller.load("pick.dat", DATA);
      controller.load("pick.src", SOURCE);
      controller.setMode(OperatingMode.AUT);
      controller.robot().select("PICK");
      controller.robot().start();

      boolean ended =
          controller.stepUntil(
              () -> controller.robot().state() == ProgramState.END, Duration.ofMinutes(1));

      assertThat(controller.messages()).isEmpty();
      assertThat(ended).isTrue();
      VariableTable variables = controller.variables();
      assertThat(variables.get("$POS_ACT.Y")).isEqualTo("100.000");
      assertThat(variables.get("BASE_DATA[3].Y")).isEqualTo("100.000");
      assertThat(variables.get("$VEL.CP")).isEqualTo("0.500000");
      assertThat(variables.get("$ACC.CP")).isEqualTo("1.15000");
      assertThat(variables.get("$APO.CDIS")).isEqualTo("20.0000");
      assertThat(variables.get("$ACC_AXIS[1]")).isEqualTo("50");
      assertThat(variables.get("$ORI_TYPE")).isEqualTo("#CONSTANT");
      assertThat(variables.get("$ACT_TOOL")).isEqualTo("1");
    }
  }

  @Test
  void refusesToLetAProgramWriteWhatTheSystemWrites() throws Exception {
    try (Controller controller = Cell.stepped(VariableTable.krc4())) {
      controller.load("out.src", "DEF OUT ( )\n$OUT[993]=TRUE\nEND\n");
      controller.setMode(OperatingMode.AUT);
      controller.robot().select("OUT");
      controller.robot().start();
      controller.step(Duration.ofMillis(120));

      assertThat(controller.robot().state()).isEqualTo(ProgramState.STOP);
      assertThat(controller.messages()).singleElement().asString().contains("out.src:2");
      assertThat(controller.variables().get("$T1")).isEqualTo("FALSE");
    }
  }

  @Test
  void showsThePositionInTheBaseAndToolOfTheMotionUnderWay() throws Exception {
    String source =
        """
        DEF FRAMES ( )
        BAS(#INITMOV,0)
        PTP {A1 10}
        $BASE={X 100,Y 0,Z 0,A 0,B 0,C 0}
        $TOOL={X 0,Y 0,Z 200,A 0,B 0,C 0}
        PTP {A1 20}
        WAIT SEC 0
        END
        """;
    try (Controller controller = Cell.stepped(VariableTable.krc4())) {
      VariableTable variables = controller.variables();
      controller.load("frames.src", source);
      controller.setMode(OperatingMode.AUT);
      controller.robot().select("FRAMES");
      controller.robot().start();
      controller.step(Duration.ofMillis(72));

      assertThat(variables.get("$BASE.X")).as("the advance run").isEqualTo("100.000");
      assertThat(variables.get("$BASE_C.X")).isEqualTo("0.0");
      assertThat(variables.get("$TOOL_C.Z")).isEqualTo("0.0");
      assertThat(Double.parseDouble(variables.get("$POS_ACT.X"))).isGreaterThan(515);

      controller.stepUntil(() -> controller.axes().a1() > 12, Duration.ofMinutes(1));

      assertThat(variables.get("$BASE_C.X")).isEqualTo("100.000");
      assertThat(variables.get("$TOOL_C.Z")).isEqualTo("200.000");
    }
  }
}
