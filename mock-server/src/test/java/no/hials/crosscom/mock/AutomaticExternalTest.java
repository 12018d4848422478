package no.hials.crosscom.mock;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.time.Duration;
import no.hials.crosscom.mock.junit.KukaController;
import no.hials.crosscom.protocol.ServerType;
import no.hials.crosscom.protocol.code.OperatingMode;
import no.hials.crosscom.protocol.code.ProgramState;
import no.hials.crosscom.simulator.Controller;
import no.hials.crosscom.simulator.LoadingMode;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** A PLC that starts programs by their numbers: sets inputs, and reads over the network. */
final class AutomaticExternalTest {
  private static final String WIRING =
      """
      DEFDAT $MACHINE PUBLIC
      SIGNAL $DRIVES_ON $IN[21]
      SIGNAL $DRIVES_OFF $IN[22]
      SIGNAL $MOVE_ENABLE $IN[23]
      SIGNAL $EXT_START $IN[24]
      SIGNAL $CONF_MESS $IN[25]
      ENDDAT
      """;
  private static final String CONFIG =
      """
      DEFDAT $CONFIG PUBLIC
      INT PGNO_TYPE=1
      INT PGNO_FBIT=1
      INT PGNO_LENGTH=8
      INT PGNO_PARITY=9
      INT PGNO_REQ=33
      INT PGNO_VALID=10
      INT APPL_RUN=-34
      ENDDAT
      """;
  private static final String CELL =
      """
      DEF CELL ( )
      P00 (#INIT_EXT,#PGNO_GET,DMY[],0 )
      LOOP
        P00 (#EXT_PGNO,#PGNO_GET,DMY[],0 )
        SWITCH PGNO
        CASE 5
          P00 (#EXT_PGNO,#PGNO_ACKN,DMY[],0 )
          MYINT = MYINT + 100
          WAIT SEC 0.5
        DEFAULT
          P00 (#EXT_PGNO,#PGNO_FAULT,DMY[],0 )
        ENDSWITCH
      ENDLOOP
      END
      """;

  @KukaController(server = ServerType.KUKAVARPROXY, clock = "stepped")
  private MockServer server;

  private Controller controller;

  @BeforeEach
  void start() throws Exception {
    controller = server.controller();
    controller.load("$machine.dat", WIRING, LoadingMode.LENIENT);
    controller.load("$config.dat", CONFIG, LoadingMode.LENIENT);
    controller.load("cell.src", CELL, LoadingMode.LENIENT);
    controller.setMode(OperatingMode.EXT);
    controller.robot().select("CELL");
  }

  private void input(int number, boolean value) {
    server.variables().set("$IN[" + number + "]", value ? "TRUE" : "FALSE");
    cycles();
  }

  private void cycles() {
    controller.step(Duration.ofMillis(60));
  }

  private void pulse(int number) {
    input(number, true);
    input(number, false);
  }

  private String read(RawClient plc, String name) throws IOException {
    return plc.read(name).value();
  }

  private void number(int number, boolean parity) {
    for (int bit = 0; bit < 8; bit++) {
      input(1 + bit, (number >> bit & 1) == 1);
    }
    input(9, parity);
  }

  private void enable() {
    input(22, true);
    input(23, true);
  }

  @Test
  void startsProgramsByTheirNumbers() throws Exception {
    try (RawClient plc = new RawClient(server)) {
      enable();
      pulse(21);
      assertThat(read(plc, "$PERI_RDY")).isEqualTo("TRUE");
      assertThat(read(plc, "$I_O_ACTCONF")).isEqualTo("TRUE");
      pulse(24);
      assertThat(read(plc, "$PRO_ACT")).isEqualTo("TRUE");
      assertThat(read(plc, "$OUT[33]") + read(plc, "$OUT[34]")).isEqualTo("TRUETRUE");

      number(5, false);
      input(10, true);
      assertThat(read(plc, "$OUT[33]") + read(plc, "$OUT[34]")).isEqualTo("FALSEFALSE");
      assertThat(read(plc, "MYINT") + " " + read(plc, "PGNO")).isEqualTo("100 5");
      input(10, false);
      controller.step(Duration.ofSeconds(1));
      assertThat(read(plc, "$OUT[33]") + read(plc, "$OUT[34]")).isEqualTo("TRUETRUE");
    }
  }

  @Test
  void waitsForAConfirmationAfterAWrongNumber() throws Exception {
    try (RawClient plc = new RawClient(server)) {
      enable();
      pulse(21);
      pulse(24);
      number(5, true);
      input(10, true);
      assertThat(read(plc, "PGNO_ERROR")).isEqualTo("1");
      number(6, false);
      input(10, false);
      controller.step(Duration.ofSeconds(1));
      input(10, true);

      assertThat(read(plc, "$STOPMESS")).isEqualTo("TRUE");
      assertThat(controller.messages())
          .extracting(Object::toString)
          .containsExactly("0 P00: the program number is not valid");
      pulse(25);
      assertThat(read(plc, "$STOPMESS")).isEqualTo("FALSE");
      assertThat(controller.robot().state()).isEqualTo(ProgramState.ACTIVE);
    }
  }

  @Test
  void switchesTheDrivesOff() throws Exception {
    try (RawClient plc = new RawClient(server)) {
      cycles();
      assertThat(read(plc, "$PERI_RDY")).isEqualTo("FALSE");
      pulse(24);
      assertThat(controller.messages())
          .extracting(Object::toString)
          .containsExactly("9109 $EXT_START: start: the drives are off");
      enable();
      pulse(21);
      pulse(24);
      input(23, false);

      assertThat(read(plc, "$PERI_RDY") + read(plc, "$PRO_ACT")).isEqualTo("FALSEFALSE");
    }
  }
}
