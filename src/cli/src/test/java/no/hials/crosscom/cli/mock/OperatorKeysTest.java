package no.hials.crosscom.cli.mock;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.StringReader;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import no.hials.crosscom.cli.base.MessageFeed;
import no.hials.crosscom.mock.MockServer;
import no.hials.crosscom.mock.junit.KukaController;
import no.hials.crosscom.protocol.code.OperatingMode;
import no.hials.crosscom.simulator.Controller;
import org.junit.jupiter.api.Test;

class OperatorKeysTest {
  @KukaController(clock = "stepped")
  private MockServer server;

  private final List<String> hints = new ArrayList<>();

  private Controller start(String statement) throws Exception {
    Controller controller = server.controller();
    controller.load("TEST.SRC", "DEF TEST()\n" + statement + "\nMYBOOL=TRUE\nEND\n");
    controller.setMode(OperatingMode.AUT);
    controller.robot().select("TEST");
    controller.start();
    controller.step(Duration.ofMillis(100));
    return controller;
  }

  private void type(String text) throws Exception {
    // a StringReader is always ready, and at its end returns -1
    try (StringReader in = new StringReader(text)) {
      new OperatorKeys(in, server.controller(), hints::add).poll();
    }
    server.controller().step(Duration.ofMillis(100));
  }

  @Test
  void answersADialogue() throws Exception {
    Controller controller = start("MsgDialog(MYINT,\"which?\", , ,\"left\",\"right\")");

    assertThat(MessageFeed.text(controller.messages().get(0)))
        .isEqualTo("0 which? [1 left, 2 right]");
    type("right\n3\n2\n");
    assertThat(server.variables().get("MYINT")).isEqualTo("6");
    assertThat(hints)
        .containsExactly(
            "type the number of a key, or only Enter to confirm; was 'right'",
            "answer: the dialogue has the keys [left, right], was given number 3");
  }

  @Test
  void confirmsMessagesByAnEmptyLine() throws Exception {
    start("MsgQuit(\"wait\")");

    type("\n");
    assertThat(server.variables().get("MYBOOL")).isEqualTo("TRUE");
    assertThat(hints).containsExactly("confirmed messages: 1");
  }

  @Test
  void keepsALineThatIsNotComplete() throws Exception {
    start("MsgQuit(\"wait\")");

    type("1");
    assertThat(hints).isEmpty();
  }
}
