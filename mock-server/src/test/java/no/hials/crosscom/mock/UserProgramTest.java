package no.hials.crosscom.mock;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.time.Duration;
import no.hials.crosscom.mock.junit.KukaController;
import no.hials.crosscom.protocol.MessageType;
import no.hials.crosscom.protocol.PlainResponse;
import no.hials.crosscom.protocol.ServerType;
import no.hials.crosscom.protocol.Tail;
import no.hials.crosscom.protocol.code.OperatingMode;
import no.hials.crosscom.protocol.code.ProgramState;
import no.hials.crosscom.protocol.server.ServerRequest;
import no.hials.crosscom.simulator.Controller;
import no.hials.crosscom.simulator.LoadingMode;
import no.hials.crosscom.simulator.Message;
import org.junit.jupiter.api.Test;

/** Programs in the styles of users, seen by a client of C3 Bridge. */
final class UserProgramTest {
  private static final String PROGRAM =
      """
      &ACCESS RVP
      &REL 7
      &PARAM EDITMASK = *
      DEF pick_parts ( )
      ;FOLD DECLARATIONS
      EXTP SPOT_GUN ( INT :IN, INT :IN )
      INT n, answer
      CHAR line[40]
      DECL STATE_T state
      INT offset
      ;ENDFOLD
      ;FOLD INI
      GLOBAL INTERRUPT DECL 3 WHEN $STOPMESS==TRUE DO IR_STOPM ( )
      INTERRUPT ON 3
      BAS (#INITMOV,0 )
      USERSPOT(#INIT,SDEFAULT)
      USER_GRP(0,GDEFAULT)
      ;ENDFOLD
      $CYCFLAG[1]=(MYINTS[1]>2) AND $FLAG[1]
      $FLAG[1]=TRUE
      FOR n=1 TO 3
        MYINTS[1]=twice(n)/2
      ENDFOR
      WAIT FOR $CYCFLAG[1]
      offset=0
      SWRITE(line[],state,offset,"%d parts, %.1f kg",MYINTS[1],2.5)
      MsgNotify(line[],"Pick",,,12)
      ON_ERROR_PROCEED
      MYINTS[99]=1
      MYINTS[2]=$ERR.NUMBER
      MYSTRING[]=label(3)
      MsgQuit("take %1 out","Pick",7)
      MsgDialog(answer,"go on?",,,"yes","no")
      IF answer==7 THEN
        MYBOOL=TRUE
        spot_gun(1)
      ENDIF
      MYINT=99
      END
      DEFFCT INT twice(a:IN)
      INT a
      RETURN 2*a
      ENDFCT
      DEFFCT CHAR[8] label(number:IN)
      INT number
      RETURN "part"
      ENDFCT
      """;

  @KukaController(server = ServerType.C3_BRIDGE, clock = "stepped")
  private MockServer server;

  private static String read(RawClient client, String name) throws IOException {
    return client.read(name).value();
  }

  @Test
  void runsUntilItReachesARoutineThatIsMissing() throws Exception {
    Controller controller = server.controller();
    assertThat(controller.load("Pick_Parts.src", PROGRAM, LoadingMode.LENIENT).anyRefused())
        .isFalse();
    assertThat(controller.check("PICK_PARTS"))
        .singleElement()
        .asString()
        .contains("no routine spot_gun is known");
    controller.setMode(OperatingMode.AUT);
    controller.robot().select("PICK_PARTS");
    controller.start();
    controller.step(Duration.ofSeconds(1));
    try (RawClient client = new RawClient(server)) {
      assertThat(read(client, "MYINTS[2]") + " " + read(client, "MYSTRING[]"))
          .isEqualTo("1444 \"part\"");
      assertThat(read(client, "$STOPMESS")).isEqualTo("TRUE");
      assertThat(client.exchange(new ServerRequest(1, MessageType.CONFIRM_ALL)))
          .isEqualTo(new PlainResponse(1, MessageType.CONFIRM_ALL, Tail.SUCCESS));
      assertThat(read(client, "$STOPMESS")).isEqualTo("FALSE");
      controller.step(Duration.ofSeconds(1));
      controller.answer(1);
      controller.step(Duration.ofSeconds(1));

      assertThat(read(client, "MYBOOL") + " " + read(client, "MYINT")).isEqualTo("TRUE 0");
      assertThat(read(client, "$ERR.NUMBER")).isEqualTo("9010");
    }
    assertThat(controller.robot().state()).isEqualTo(ProgramState.STOP);
    assertThat(controller.messages())
        .extracting(Message::toString)
        .containsExactly(
            "12 Pick: 3 parts, 2.5 kg",
            "0 Pick: take 7 out",
            "0 go on?",
            "9010 Pick_Parts.src:36:3: no routine spot_gun is known",
            "309 a BCO run is due: the next motion is slow, then it stops");
  }
}
