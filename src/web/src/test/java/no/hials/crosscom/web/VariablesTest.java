package no.hials.crosscom.web;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import java.nio.file.Path;
import java.util.Optional;
import no.hials.crosscom.CrossComClient;
import no.hials.crosscom.c3.TransferConfig;
import no.hials.crosscom.cell.RobotConnection;
import no.hials.crosscom.mock.Fault;
import no.hials.crosscom.mock.MockServer;
import no.hials.crosscom.mock.RecordedRequest;
import no.hials.crosscom.protocol.ServerType;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class VariablesTest {
  @TempDir private Path folder;

  private static JsonNode describe(TestSocket socket, String name) throws InterruptedException {
    return socket.call("describe", "robot", "'mock'", "name", "'" + name + "'").path("ok");
  }

  private static String check(TestSocket socket, String name, String value)
      throws InterruptedException {
    return socket
        .call("check", "robot", "'mock'", "name", "'" + name + "'", "value", "'" + value + "'")
        .path("error")
        .asText();
  }

  @Test
  void aDescriptionHasTheRangeOrTheConstantsOfTheType() throws Exception {
    try (TestPages pages = TestPages.start(folder);
        TestSocket socket = pages.open(Role.VIEW)) {
      assertThat(describe(socket, "$OV_PRO").path("range").asText())
          .isEqualTo("-2147483648 to 2147483647");
      assertThat(describe(socket, "$POS_ACT.X").path("range").asText())
          .isEqualTo("-3.4E+38 to 3.4E+38, about 7 digits");
      assertThat(describe(socket, "$MODE_OP").path("range").asText()).isEmpty();
      assertThat(describe(socket, "$MODE_OP").path("constants").toString()).contains("#T1", "#AUT");
    }
  }

  @Test
  void aValueIsCheckedWithoutBeingWritten() throws Exception {
    try (TestPages pages = TestPages.start(folder);
        TestSocket socket = pages.open(Role.OPERATE)) {
      assertThat(check(socket, "$OV_PRO", "50")).isEmpty();
      assertThat(check(socket, "$OV_PRO", "{X 1")).contains("$OV_PRO");
      assertThat(pages.controller().variables().get("$OV_PRO")).isEqualTo("100");
    }
  }

  @ParameterizedTest
  @CsvSource({
    "$OV_PRO, 1.5, INT",
    "$OV_PRO, TRUE, INT",
    "$OV_PRO, '\\\"x\\\"', INT",
    "MYREAL, FALSE, REAL",
    "$OUT[1], 1, BOOL",
    "MYPOS.X, #T1, REAL"
  })
  void aValueOfAnotherTypeIsRefused(String name, String value, String type) throws Exception {
    try (TestPages pages = TestPages.start(folder);
        TestSocket socket = pages.open(Role.OPERATE)) {
      assertThat(check(socket, name, value))
          .isEqualTo(
              "the value for " + (name + " must be " + type + ", is ") + value.replace("\\", ""));
    }
  }

  @ParameterizedTest
  @CsvSource({
    "MYREAL, 1",
    "$OUT[1], TRUE",
    "MYPOS, {X 1}",
    "MYSTRING[], '\\\"5\\\"'",
    "NOT_KNOWN, 1.5"
  })
  void aValueThatCanBeOfTheTypeIsAccepted(String name, String value) throws Exception {
    try (TestPages pages = TestPages.start(folder);
        TestSocket socket = pages.open(Role.OPERATE)) {
      assertThat(check(socket, name, value)).isEmpty();
    }
  }

  @ParameterizedTest
  @CsvSource({"false, nothing was written", "true, the outcome is unknown"})
  void aFailedWriteSaysWhetherItMayHaveBeenDone(boolean atWrite, String words) throws Exception {
    try (TestPages pages = TestPages.start(folder);
        TestSocket socket = pages.open(Role.OPERATE)) {
      socket.call("lock", "robot", "'mock'", "locked", "false");
      pages
          .controller()
          .fault(it -> it.names().contains("$OV_JOG") && it.isWrite() == atWrite, Fault.drop());

      assertThat(write(socket, "$OV_JOG", "50")).contains("; " + words);

      assertThat(pages.controller().requests().stream().anyMatch(RecordedRequest::isWrite))
          .isEqualTo(atWrite);
    }
  }

  @Test
  void aWriteIsRefusedIfTheRobotIsLockedWhileItsOldValueIsRead() throws Exception {
    try (TestPages pages = TestPages.start(folder);
        TestSocket other = pages.open(Role.OPERATE);
        TestSocket socket = pages.open(Role.OPERATE)) {
      socket.call("lock", "robot", "'mock'", "locked", "false");
      pages
          .controller()
          .faults(
              request -> {
                if (request.names().contains("$OV_JOG") && !request.isWrite()) {
                  lock(other);
                }
                return Optional.empty();
              });

      assertThat(write(socket, "$OV_JOG", "50")).endsWith("the robot is locked");

      assertThat(pages.controller().requests().stream().noneMatch(RecordedRequest::isWrite))
          .isTrue();
    }
  }

  private static void lock(TestSocket socket) {
    try {
      socket.call("lock", "robot", "'mock'", "locked", "true");
    } catch (InterruptedException e) {
      throw new AssertionError(e);
    }
  }

  private static String write(TestSocket socket, String name, String value)
      throws InterruptedException {
    return socket
        .call(
            "write",
            "robot",
            "'mock'",
            "name",
            "'" + name + "'",
            "value",
            "'" + value + "'",
            "confirmed",
            "true")
        .path("error")
        .asText();
  }

  @Test
  void variablesOfTheControllersDataListsAreFound() throws Exception {
    try (MockServer server = MockServer.start(cfg -> cfg.server(ServerType.C3_BRIDGE))) {
      try (CrossComClient client = new CrossComClient(server.host(), server.port())) {
        client
            .files()
            .uploadText(
                "DEFDAT GRIPPER PUBLIC\nDECL GLOBAL REAL JAW_WIDTH=12.5\nENDDAT\n",
                "KRC:\\R1\\Program\\gripper.dat",
                TransferConfig.DEFAULT);
      }
      try (TestPages pages =
              TestPages.start(
                  ServerType.C3_BRIDGE,
                  folder,
                  cfg ->
                      cfg.opener(
                          (one, client) ->
                              RobotConnection.open(one.at(server.host(), server.port()), client)));
          TestSocket events = pages.open(Role.VIEW); // a call drops the events before its answer
          TestSocket socket = pages.open(Role.VIEW)) {
        JsonNode found = searchJawWidth(socket);
        if (found.path("loading").asBoolean()) {
          assertThat(found.path("total").asInt()).isZero();
          events.awaitEvent("names");
          found = searchJawWidth(socket);
        }
        assertThat(found.path("loading").asBoolean()).isFalse();
        assertThat(found.path("total").asInt()).isEqualTo(1);
        assertThat(found.path("found").get(0).path("type").asText()).isEqualTo("REAL");
        assertThat(found.path("found").get(0).path("origin").asText())
            .isEqualTo("KRC:\\R1\\Program\\gripper.dat");
      }
    }
  }

  @ParameterizedTest
  @CsvSource({"$axis_act ro, true", "$axis_act rw, false", "$ACC_AXIS[], true"})
  void theSearchKnowsTheAccessAndTheNameAsThePageShowsIt(String text, boolean found)
      throws Exception {
    try (TestPages pages = TestPages.start(folder);
        TestSocket socket = pages.open(Role.VIEW)) {
      JsonNode answer =
          socket.call("search", "robot", "'mock'", "text", "'" + text + "'", "limit", "5");
      assertThat(answer.path("ok").path("total").asInt() > 0).isEqualTo(found);
    }
  }

  private static JsonNode searchJawWidth(TestSocket socket) throws InterruptedException {
    return socket.call("search", "robot", "'mock'", "text", "'jaw_width'", "limit", "5").path("ok");
  }
}
