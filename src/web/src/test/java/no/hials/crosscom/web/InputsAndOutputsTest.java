package no.hials.crosscom.web;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import java.io.IOException;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import no.hials.crosscom.CrossComClient;
import no.hials.crosscom.c3.TransferConfig;
import no.hials.crosscom.cell.Robot;
import no.hials.crosscom.cell.RobotConnection;
import no.hials.crosscom.mock.MockServer;
import no.hials.crosscom.protocol.ServerType;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class InputsAndOutputsTest {
  @TempDir private Path folder;
  private TestPages pages;
  private TestSocket socket;

  @BeforeEach
  void start() throws Exception {
    pages = TestPages.start(ServerType.C3_BRIDGE, folder, cfg -> {});
    socket = pages.open(Role.OPERATE);
  }

  @AfterEach
  void stop() throws IOException {
    socket.close();
    pages.close();
  }

  private String setInput(TestSocket from, String... fields) throws InterruptedException {
    String[] all = {"robot", "'mock'", "confirmed", "true", "", "", "", "", "", ""};
    System.arraycopy(fields, 0, all, 4, fields.length);
    return from.call("set-input", Arrays.copyOf(all, 4 + fields.length)).path("error").asText();
  }

  private static String signal(String array, int first, int last, String name) {
    return String.format(
        Locale.ROOT,
        "{\"array\":\"%s\",\"first\":%d,\"last\":%d,\"names\":[\"%s\"]}",
        array,
        first,
        last,
        name);
  }

  @Test
  void signalsNameTheInputsAndOutputs() throws Exception {
    JsonNode answer = socket.call("signals", "robot", "'mock'").path("ok");

    assertThat(answer.path("lengths").path("$OUT").asInt()).isEqualTo(4096);
    assertThat(answer.path("lengths").path("$ANIN").asInt()).isEqualTo(32);
    assertThat(answer.path("signals"))
        .extracting(JsonNode::toString)
        .contains(signal("$OUT", 1012, 1012, "$PERI_RDY"))
        .anySatisfy(
            signal ->
                assertThat(signal)
                    .contains("\"$IN\",\"first\":1025,\"last\":1025,", "$MOVE_ENABLE"));
    assertThat(answer.path("simulated").asBoolean()).isTrue();
  }

  @Test
  void aSimulatedInputIsSetWhenTheRobotIsUnlocked() throws Exception {
    assertThat(setInput(socket, "number", "7", "value", "true"))
        .isEqualTo("did not set $IN[7]: the robot is locked");
    socket.call("lock", "robot", "'mock'", "locked", "false");

    assertThat(setInput(socket, "number", "7", "value", "true")).isEmpty();
    assertThat(pages.controller().variables().get("$IN[7]")).isEqualTo("TRUE");
    assertThat(setInput(socket, "analog", "true", "number", "2", "value", "-0.5")).isEmpty();
    assertThat(pages.controller().variables().get("$ANIN[2]")).isEqualTo("-0.500000");
    assertThat(setInput(socket, "number", "7", "value", "false")).isEmpty();
    assertThat(socket.call("audit").path("ok").path("lines").toString())
        .containsPattern("\\$IN\\[7\\]\\W+before\\W+TRUE\\W+after\\W+FALSE");
    assertThat(setInput(socket, "number", "4097", "value", "true"))
        .isEqualTo("number must be 1 to 4096, is 4097");
    assertThat(socket.call("audit").path("ok").path("lines").toString())
        .contains("set input", "$IN[7]", "the robot is locked", "$ANIN[2]");
  }

  @Test
  void inputsOfOtherControllersAreReadOnlyAndNamedByTheirOwnLists() throws Exception {
    try (MockServer other = MockServer.start(cfg -> cfg.server(ServerType.C3_BRIDGE))) {
      try (CrossComClient client = new CrossComClient(other.host(), other.port())) {
        client
            .files()
            .uploadText(
                """
                DEFDAT CELL PUBLIC
                SIGNAL GRIPPER $OUT[5]
                SIGNAL PART $IN[9] TO $IN[16]
                ENDDAT
                """,
                "KRC:\\R1\\Program\\cell.dat",
                TransferConfig.DEFAULT);
      }
      Robot robot = new Robot("mock", other.host(), other.port(), null, null, null, null);
      try (TestPages real =
              TestPages.start(
                  ServerType.C3_BRIDGE,
                  folder.resolve("real"),
                  cfg -> cfg.robots(List.of(robot)).opener(RobotConnection::openLazily));
          TestSocket events = real.open(Role.VIEW); // a call drops the events before its answer
          TestSocket operator = real.open(Role.OPERATE)) {
        operator.call("lock", "robot", "'mock'", "locked", "false");

        assertThat(setInput(operator, "number", "1", "value", "true"))
            .startsWith("$IN[1] is read-only: the controller takes it from its bus.");
        JsonNode signals = operator.call("signals", "robot", "'mock'").path("ok").path("signals");
        while (!signals.toString().contains("GRIPPER")) { // until the data lists are read
          events.awaitEvent("names");
          signals = operator.call("signals", "robot", "'mock'").path("ok").path("signals");
        }
        assertThat(signals)
            .extracting(JsonNode::toString)
            .contains(signal("$IN", 9, 16, "PART"), signal("$OUT", 5, 5, "GRIPPER"));
      }
    }
  }
}
