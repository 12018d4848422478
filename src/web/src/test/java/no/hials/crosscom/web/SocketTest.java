package no.hials.crosscom.web;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Random;
import java.util.concurrent.atomic.AtomicBoolean;
import no.hials.crosscom.cell.Robot;
import no.hials.crosscom.mock.Fault;
import no.hials.crosscom.mock.MockServer;
import no.hials.crosscom.protocol.ServerType;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;

class SocketTest {
  @TempDir private Path folder;
  private TestPages pages;

  @BeforeEach
  void start() throws IOException {
    pages = TestPages.start(folder);
  }

  @AfterEach
  void stop() throws IOException {
    pages.close();
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "",
        "x",
        "{",
        "[]",
        "1",
        "null",
        "{}",
        "{\"do\": 1}",
        "{\"do\": \"no\"}",
        "{\"id\": {}, \"do\": \"watch\"}",
        "{\"do\": \"search\", \"robot\": \"mock\", \"text\": 1}"
      })
  void aWrongMessageIsAnsweredWithAnError(String text) throws Exception {
    try (TestSocket socket = pages.open(Role.VIEW)) {
      socket.send(text);

      assertThat(socket.await(it -> it.has("id")).path("error").asText()).isNotEmpty();
      assertThat(socket.call("ping").has("ok")).isTrue();
    }
  }

  @Test
  void deepMessagesAreRefused() throws Exception {
    try (TestSocket socket = pages.open(Role.VIEW)) {
      socket.send("[".repeat(100_000));

      assertThat(socket.await(it -> it.has("id")).path("error").asText()).isNotEmpty();
    }
  }

  @Test
  void anOversizedMessageEndsTheSocket() throws Exception {
    try (TestSocket socket = pages.open(Role.VIEW)) {
      socket.begin("x".repeat(300_000));

      assertThat(socket.closeCode()).isEqualTo(1009);
    }
  }

  @Test
  void aFloodOfMessagesEndsTheSocketAndNoOtherOne() throws Exception {
    Random random = new Random(1);
    try (TestSocket other = pages.open(Role.VIEW);
        TestSocket socket = pages.open(Role.VIEW)) {
      try {
        for (int i = 0; i < 10_000; i++) {
          socket.send("{\"id\":" + i + ",\"do\":\"" + random.nextInt() + "\"}");
        }
      } catch (RuntimeException e) {
        // it is closed meanwhile
      }

      assertThat(socket.closeCode()).isIn(1008, 1006);
      assertThat(other.call("ping").has("ok")).isTrue();
    }
  }

  @Test
  void aViewerChangesNothing() throws Exception {
    try (TestSocket socket = pages.open(Role.VIEW)) {
      assertThat(socket.call("lock", "robot", "'mock'", "locked", "false").path("error").asText())
          .isEqualTo("this needs the role OPERATE; this browser may only VIEW");
      assertThat(write(socket, "50").path("error").asText())
          .isEqualTo("this needs the role OPERATE; this browser may only VIEW");
      assertThat(pages.controller().variables().get("$OV_PRO")).isEqualTo("100");
    }
  }

  private static JsonNode write(TestSocket socket, String value) throws InterruptedException {
    return socket.call(
        "write",
        "robot",
        "'mock'",
        "name",
        "'$OV_PRO'",
        "value",
        "'" + value + "'",
        "confirmed",
        "true");
  }

  @ParameterizedTest
  @EnumSource(ServerType.class)
  void anOperatorWritesAfterUnlockingTheRobot(ServerType type) throws Exception {
    try (TestPages own = TestPages.start(type, folder, cfg -> {});
        TestSocket socket = own.open(Role.OPERATE)) {
      assertThat(write(socket, "50").path("error").asText())
          .isEqualTo("did not write $OV_PRO: the robot is locked");

      socket.call("lock", "robot", "'mock'", "locked", "false");

      assertThat(write(socket, "50").path("ok").path("text").asText()).isEqualTo("50");
      assertThat(own.controller().variables().get("$OV_PRO")).isEqualTo("50");
    }
  }

  @Test
  void aWriteNeedsAConfirmation() throws Exception {
    try (TestSocket socket = pages.open(Role.OPERATE)) {
      socket.call("lock", "robot", "'mock'", "locked", "false");

      assertThat(
              socket
                  .call("write", "robot", "'mock'", "name", "'$OV_PRO'", "value", "'50'")
                  .path("error")
                  .asText())
          .endsWith("not confirmed");
    }
  }

  @Test
  void aLockWithoutItsNewStateLeavesTheRobotLocked() throws Exception {
    try (TestSocket socket = pages.open(Role.OPERATE)) {
      assertThat(socket.call("lock", "robot", "'mock'").path("error").asText())
          .isEqualTo("locked must be true or false");
      assertThat(write(socket, "50").path("error").asText()).endsWith("the robot is locked");
    }
  }

  @Test
  void readOnlyWinsOverAllRoles() throws Exception {
    try (TestPages own = TestPages.start(ServerType.C3_BRIDGE, folder, cfg -> cfg.readOnly(true));
        TestSocket socket = own.open(Role.JOG)) {
      assertThat(socket.call("lock", "robot", "'mock'", "locked", "false").path("error").asText())
          .contains("--read-only");
      assertThat(write(socket, "50").path("error").asText()).contains("--read-only");
    }
  }

  @Test
  void aReadOnlyRobotIsExplainedWithoutTheFolderOfTheConfiguration() throws Exception {
    String reason = "read-only = true in /home/somebody/config.toml:3";
    Robot robot = new Robot("mock", null, 0, null, reason, ServerType.C3_BRIDGE, null);
    try (TestPages own =
            TestPages.start(ServerType.C3_BRIDGE, folder, cfg -> cfg.robots(List.of(robot)));
        TestSocket socket = own.open(Role.OPERATE)) {
      assertThat(socket.awaitEvent("header").path("lock").path("read_only_by").asText())
          .isEqualTo("read-only = true in config.toml:3");
      assertThat(write(socket, "50").path("error").asText())
          .endsWith(": read-only = true in config.toml:3");
    }
  }

  @Test
  void everyWriteIsAnAuditLineAlsoARefusedOne() throws Exception {
    try (TestSocket socket = pages.open(Role.OPERATE)) {
      write(socket, "40");
      socket.call("lock", "robot", "'mock'", "locked", "false");
      write(socket, "50");

      assertThat(folder.resolve("audit.jsonl"))
          .content()
          .containsSubsequence(
              "\"name\":\"$OV_PRO\"",
              "\"after\":\"40\"",
              "is locked",
              "\"what\":\"unlock\"",
              "\"after\":\"50\"",
              "\"result\":\"done\"");
    }
  }

  @Test
  void theHeaderShowsTheStateOfTheRobot() throws Exception {
    try (TestSocket socket = pages.open(Role.VIEW)) {
      JsonNode header =
          socket.await(
              it ->
                  it.path("event").asText().equals("header")
                      && !it.path("server").asText().isEmpty());

      assertThat(header.path("mode").asText()).isEqualTo("#T1");
      assertThat(header.path("override").asText()).isEqualTo("100");
      assertThat(header.path("connection").asText()).isEqualTo("connected");
      assertThat(header.path("lock").path("open").asBoolean()).isFalse();
    }
  }

  @Test
  void aWriteThatCannotBeReadAfterwardsIsCalledWritten() throws Exception {
    try (TestSocket socket = pages.open(Role.OPERATE)) {
      socket.call("lock", "robot", "'mock'", "locked", "false");
      AtomicBoolean written = new AtomicBoolean();
      pages
          .controller()
          .fault(
              request -> {
                boolean after = written.get();
                written.compareAndSet(false, request.isWrite());
                return after && request.names().contains("MYSTRING[]");
              },
              Fault.closeBefore());

      JsonNode answer =
          socket.call(
              "write",
              "robot",
              "'mock'",
              "name",
              "'MYSTRING[]'",
              "value",
              "'\\\"abc\\\"'",
              "confirmed",
              "true");

      assertThat(answer.path("error").asText())
          .startsWith("MYSTRING[] was written, but could not be read afterwards: ");
      assertThat(pages.controller().variables().get("MYSTRING[]")).isEqualTo("\"abc\"");
    }
  }

  @Test
  void theAuditLogHasTheValueThatTheControllerHadBefore() throws Exception {
    try (TestSocket socket = pages.open(Role.OPERATE)) {
      socket.call("lock", "robot", "'mock'", "locked", "false");
      pages.controller().variables().set("MYINT", "41");

      write(socket, "MYINT", "42");

      assertThat(socket.call("audit").path("ok").path("lines"))
          .map(JsonNode::textValue)
          .last()
          .asString()
          .contains("\"before\":\"41\",\"after\":\"42\"");
    }
  }

  @Test
  void allPagesShowWhileTheAuditLogCannotBeWritten() throws Exception {
    Path file = folder.resolve("audit.jsonl");
    try (TestSocket other = pages.open(Role.VIEW);
        TestSocket socket = pages.open(Role.OPERATE)) {
      Files.delete(file); // it has the arrivals of the browsers
      Files.createDirectory(file); // takes no line
      socket.call("lock", "robot", "'mock'", "locked", "false");

      write(socket, "MYINT", "42");
      assertThat(pages.controller().variables().get("MYINT")).isEqualTo("42");
      JsonNode header = other.await(it -> !it.path("audit_failure").asText().isEmpty());
      assertThat(header.path("audit_failure").asText()).contains("directory");

      Files.delete(file);
      socket.call("lock", "robot", "'mock'", "locked", "true");
      other.await(it -> it.has("audit_failure") && it.path("audit_failure").asText().isEmpty());
      assertThat(Files.readString(file)).contains("\"2 lines are missing before this one: ");
    }
  }

  @Test
  void theRobotIsLockedAtOnceAndAWriteThatWaitedTooLongIsNotDone() throws Exception {
    try (TestSocket socket = pages.open(Role.OPERATE)) {
      socket.call("lock", "robot", "'mock'", "locked", "false");
      pages.controller().variables().set("MYINT", "41");
      pages
          .controller()
          .fault(request -> request.names().contains("MYREAL"), Fault.drop()); // for 3 s and 3 s

      for (String message :
          List.of(
              "{'id':900,'do':'read','robot':'mock','name':'MYREAL'}",
              "{'id':901,'do':'read','robot':'mock','name':'MYREAL'}",
              "{'id':902,'do':'write','robot':'mock','name':'MYINT','value':'42','confirmed':true,'clock':"
                  + socket.clock()
                  + "}",
              "{'id':903,'do':'lock','robot':'mock','locked':true}")) {
        socket.send(message.replace('\'', '"'));
      }

      assertThat(socket.await(it -> it.path("id").asInt() >= 900).path("id").asInt())
          .isEqualTo(903);
      assertThat(socket.await(it -> it.path("id").asInt() == 902).path("error").asText())
          .isEqualTo("not done: it waited too long, in the network or behind other commands");
      assertThat(pages.controller().variables().get("MYINT")).isEqualTo("41");
    }
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "'clock':-10000 | not done: it waited too long, in the network or behind other commands",
        "'clock':'now' | clock must be that of an answer",
        "'clock':-1 | not done: it waited too long, in the network or behind other commands",
        "'clock':4611686018427387904 | clock must be that of an answer",
        "'clock':99999999999999999999 | clock must be that of an answer",
        "'name':'MYINT' | clock must be that of an answer"
      })
  void aChangeThatIsNotNewIsNotMade(String clock, String reason) throws Exception {
    try (TestSocket socket = pages.open(Role.OPERATE)) {
      socket.call("lock", "robot", "'mock'", "locked", "false");
      for (String change :
          List.of(
              "'do':'write','name':'MYINT','value':'42','confirmed':true",
              "'do':'lock','locked':false")) {
        String message = "{'id':900,'robot':'mock'," + change + "," + clock + "}";
        socket.send(message.replace('\'', '"'));

        assertThat(socket.await(it -> it.path("id").asInt() == 900).path("error").asText())
            .isEqualTo(reason);
      }
      assertThat(pages.controller().variables().get("MYINT")).isNotEqualTo("42");
    }
  }

  private static void write(TestSocket socket, String name, String value)
      throws InterruptedException {
    JsonNode answer =
        socket.call(
            "write",
            "robot",
            "'mock'",
            "name",
            "'" + name + "'",
            "value",
            "'" + value + "'",
            "confirmed",
            "true");
    assertThat(answer.has("ok")).as("%s", answer).isTrue();
  }

  @Test
  void anotherServerBehindTheAddressIsNamed() throws Exception {
    try (TestPages remote =
            TestPages.startRemote(ServerType.C3_BRIDGE, folder.resolve("remote"), cfg -> {});
        TestSocket socket = remote.open(Role.VIEW)) {
      socket.await(it -> it.path("server").asText().startsWith("C3 Bridge"));
      int port = remote.controller().port();
      remote.controller().close();

      try (MockServer other =
          MockServer.start(cfg -> cfg.port(port).server(ServerType.KUKAVARPROXY))) {
        socket.await(it -> it.path("server").asText().equals("KUKAVARPROXY"));
        assertThat(other.port()).isEqualTo(port);
      }
    }
  }

  @Test
  void aLostControllerIsReported() throws Exception {
    try (TestSocket socket = pages.open(Role.VIEW)) {
      socket.await(it -> it.path("connection").asText().equals("connected"));

      pages.controller().refuseConnections();
      pages.controller().disconnectClients();

      JsonNode lost = socket.await(it -> it.path("connection").asText().equals("lost"));
      assertThat(lost.path("reason").asText())
          .isNotEmpty()
          .doesNotContain("the next attempt is in");
      assertThat(lost.path("mode").asText()).isEqualTo("#T1");
    }
  }

  @Test
  void aValueThatIsMarkupArrivesAsText() throws Exception {
    String markup = "\"<script>alert(1)</script>\"";
    pages.controller().variables().set("MYSTRING[]", markup);
    try (TestSocket socket = pages.open(Role.VIEW)) {
      watch(socket, "list", "'MYSTRING[]'", 50);

      assertThat(
              socket.awaitSamples("list").path("values").path("MYSTRING[]").path("value").asText())
          .isEqualTo("<script>alert(1)</script>");
    }
  }

  private static void watch(TestSocket socket, String list, String names, int period)
      throws InterruptedException {
    socket.call(
        "watch",
        "robot",
        "'mock'",
        "list",
        "'" + list + "'",
        "names",
        "[" + names + "]",
        "period",
        "" + period);
  }
}
