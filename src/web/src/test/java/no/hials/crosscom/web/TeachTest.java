package no.hials.crosscom.web;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import java.io.IOException;
import java.nio.file.Path;
import java.util.HashSet;
import java.util.Set;
import java.util.concurrent.CountDownLatch;
import no.hials.crosscom.cell.RobotConnection;
import no.hials.crosscom.mock.MockServer;
import no.hials.crosscom.protocol.ServerType;
import no.hials.crosscom.protocol.code.OperatingMode;
import no.hials.crosscom.protocol.value.KrlValue;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

class TeachTest {
  @TempDir private Path folder;
  private TestPages pages;
  private TestSocket socket;

  @BeforeEach
  void start() throws Exception {
    pages = TestPages.start(folder);
    socket = pages.open(Role.OPERATE);
  }

  @AfterEach
  void stop() throws IOException {
    socket.close();
    pages.close();
  }

  private void unlock() throws InterruptedException {
    assertThat(socket.call("lock", "robot", "'mock'", "locked", "false").has("ok")).isTrue();
  }

  private JsonNode set(String command, String name, String value) throws InterruptedException {
    return socket.call(command, "robot", "'mock'", name, value, "confirmed", "true");
  }

  private JsonNode bench() throws InterruptedException {
    return socket.call("teach", "robot", "'mock'").path("ok");
  }

  @Test
  void nothingChangesWhileTheRobotIsLocked() throws Exception {
    assertThat(set("teach-mode", "mode", "'AUT'").path("error").asText())
        .isEqualTo("did not set the operating mode: the robot is locked");
    assertThat(set("teach-stop", "pressed", "true").path("error").asText())
        .isEqualTo("did not set the emergency stop: the robot is locked");
    assertThat(set("teach-program", "program", "'actuator'").path("error").asText())
        .isEqualTo("did not set the program: the robot is locked");
    assertThat(pages.controller().controller().mode()).isEqualTo(OperatingMode.T1);
    assertThat(bench().path("emergency_stop").asBoolean()).isFalse();
  }

  @Test
  void theKeyTurnsToEachMode() throws Exception {
    unlock();
    for (OperatingMode mode : OperatingMode.values()) {
      assertThat(set("teach-mode", "mode", "'" + mode.name() + "'").has("ok")).isTrue();
      assertThat(pages.controller().controller().mode()).isEqualTo(mode);
    }
    assertThat(set("teach-mode", "mode", "'T3'").path("error").asText())
        .isEqualTo("mode must be one of [T1, T2, AUT, EXT]");
  }

  @Test
  void aProgramFollowsItsVariableUntilTheEmergencyStop() throws Exception {
    unlock();
    assertThat(set("teach-program", "program", "'actuator'").has("ok")).isTrue();
    assertThat(pages.controller().variables().get("$PRO_NAME1[]")).isEqualTo("\"ACTUATOR\"");
    assertThat(pages.controller().variables().get("$PRO_STATE1")).isEqualTo("#P_ACTIVE");

    assertThat(set("teach-stop", "pressed", "true").has("ok")).isTrue();

    assertThat(bench().path("emergency_stop").asBoolean()).isTrue();
    assertThat(pages.controller().variables().get("$PRO_STATE1")).isEqualTo("#P_STOP");
  }

  @Test
  void startingAProgramEndsFaultsAndTheEmergencyStop() throws Exception {
    unlock();
    set("teach-stop", "pressed", "true");
    setFaults("200", "10", "false");
    assertThat(bench().path("latency_ms").asInt()).isEqualTo(200);
    assertThat(bench().path("lost_percent").asInt()).isEqualTo(10);

    assertThat(set("teach-program", "program", "'ext_move_axis'").has("ok")).isTrue();

    assertThat(bench().path("latency_ms").asInt()).isZero();
    assertThat(bench().path("lost_percent").asInt()).isZero();
    assertThat(bench().path("emergency_stop").asBoolean()).isFalse();
    assertThat(pages.controller().variables().get("$PRO_NAME1[]")).isEqualTo("\"EXT_MOVE_AXIS\"");
  }

  @Test
  void theEmergencyStopStaysPressedAfterAnEarlierStartBehindAWaitingCommand() throws Exception {
    CountDownLatch released = letCommand900WaitForTheRobot();
    String rest = changeOf(socket.clock());
    socket.send("{\"id\":901,\"do\":\"teach-program\",\"program\":\"actuator\"," + rest);
    socket.send("{\"id\":902,\"do\":\"teach-stop\",\"pressed\":true," + rest);
    Set<Integer> open = new HashSet<>(Set.of(900, 901, 902));
    socket.await(
        it -> {
          int id = it.path("id").asInt();
          open.remove(id);
          if (id == 902) {
            released.countDown();
          }
          return open.isEmpty();
        });

    assertThat(bench().path("emergency_stop").asBoolean()).isTrue();
    assertThat(pages.controller().variables().get("$PRO_STATE1")).isEqualTo("#P_STOP");
  }

  @Test
  void aFaultEndsWhileAnotherCommandWaitsForTheRobot() throws Exception {
    CountDownLatch released = letCommand900WaitForTheRobot();

    setFaults("0", "0", "true");
    setFaults("0", "0", "false");

    assertThat(bench().path("silent").asBoolean()).isFalse();
    released.countDown();
    socket.await(it -> it.path("id").asInt() == 900); // not answered before
  }

  /** Returns a latch that lets the robot answer. */
  private CountDownLatch letCommand900WaitForTheRobot() throws InterruptedException {
    unlock();
    CountDownLatch released = new CountDownLatch(1);
    CountDownLatch asked = pages.hold("MYINT", released);
    socket.send("{\"id\":900,\"do\":\"read\",\"robot\":\"mock\",\"name\":\"MYINT\"}");
    asked.await();
    return released;
  }

  private static String changeOf(long clock) {
    return "\"robot\":\"mock\",\"confirmed\":true,\"clock\":" + clock + "}";
  }

  private void setFaults(String latency, String lost, String silent) throws InterruptedException {
    JsonNode answer =
        socket.call(
            "teach-faults",
            "robot",
            "'mock'",
            "latency_ms",
            latency,
            "lost_percent",
            lost,
            "silent",
            silent,
            "confirmed",
            "true");
    assertThat(answer.has("ok")).as("%s", answer).isTrue();
  }

  private void awaitConnection(String state) throws InterruptedException {
    socket.await(
        it ->
            it.path("event").asText().equals("header")
                && it.path("connection").asText().equals(state));
  }

  @Test
  void theHeaderLosesTheConnectionToASilentServerUntilItAnswersAgain() throws Exception {
    unlock();
    awaitConnection("connected");

    setFaults("0", "0", "true");
    awaitConnection("lost");

    setFaults("0", "0", "false"); // needs no answer of the robot's server
    awaitConnection("connected");
  }

  @Test
  void aChangeIsShownToOtherPagesAndLeavesWhatTheyHaveChanged() throws Exception {
    unlock();
    try (TestSocket other = pages.open(Role.OPERATE)) {
      other.call("teach", "robot", "'mock'");
      assertThat(set("teach-faults", "latency_ms", "20").has("ok")).isTrue();
      JsonNode seen = other.awaitEvent("teach");
      assertThat(seen.path("robot").asText()).isEqualTo("mock");
      assertThat(seen.path("latency_ms").asInt()).isEqualTo(20);

      other.call("teach-faults", "robot", "'mock'", "lost_percent", "4", "confirmed", "true");
      other.call("teach-stop", "robot", "'mock'", "pressed", "true", "confirmed", "true");

      socket.await(
          it ->
              it.path("event").asText().equals("teach")
                  && it.path("emergency_stop").asBoolean()
                  && it.path("lost_percent").asInt() == 4
                  && it.path("latency_ms").asInt() == 20
                  && !it.path("silent").asBoolean(true));
    }
  }

  @Test
  void oddFaultsAreRefused() throws Exception {
    unlock();
    assertThat(set("teach-fault", "kind", "'explode'").path("error").asText())
        .isEqualTo("kind must be lose or cut");
    assertThat(set("teach-faults", "latency_ms", "-1").path("error").asText())
        .isEqualTo("latency_ms must be 0 to 5000, is -1");
    assertThat(set("teach-program", "program", "'../x'").path("error").asText())
        .isEqualTo("program must be one of [actuator, ext_move_axis]");
  }

  @Test
  void aLockedRobotIsHeldStillByIncrementsOfZero() throws Exception {
    pages.controller().variables().set("MYAXIS.A1", "1.0");

    assertThat(set("teach-still", "name", "'MYAXIS'").has("ok")).isTrue();
    assertThat(KrlValue.parse(pages.controller().variables().get("MYAXIS.A1")).asDouble()).isZero();
    assertThat(set("teach-still", "name", "'$OV_PRO'").path("error").asText())
        .isEqualTo("name must be one of [MYAXIS, MYPOS]");
  }

  @Test
  void everyChangeIsInTheAuditLog() throws Exception {
    unlock();
    set("teach-mode", "mode", "'AUT'");

    JsonNode last = null;
    for (JsonNode line : socket.call("audit").path("ok").path("lines")) {
      last = line;
    }
    assertThat(String.valueOf(last)).contains("teach", "the operating mode", "AUT", "done");
  }

  @Test
  void theLessonsAreThoseOfTheTutorial() throws Exception {
    JsonNode lessons = socket.call("lessons").path("ok").path("lessons");

    assertThat(lessons).hasSize(10);
    assertThat(lessons.get(0).path("title").asText()).isEqualTo("1 Read a variable");
    for (JsonNode lesson : lessons) {
      JsonNode nodes =
          socket.call("lesson", "name", lesson.path("name").toString()).path("ok").path("nodes");
      assertThat(nodes.get(0).path("kind").asText()).isEqualTo("h2");
      assertThat(nodes.get(0).path("children").get(0).path("text").asText())
          .isEqualTo(lesson.path("title").asText());
    }
    assertThat(socket.call("lesson", "name", "'../../index'").path("error").asText())
        .isEqualTo("there is no such lesson");
  }

  @ParameterizedTest
  @EnumSource(ServerType.class)
  void aRobotOfAnotherProcessHasNothingToTeach(ServerType type) throws Exception {
    try (MockServer server = MockServer.start(cfg -> cfg.server(type));
        TestPages other =
            TestPages.start(
                type,
                folder,
                cfg ->
                    cfg.opener(
                        (one, client) ->
                            RobotConnection.open(one.at(server.host(), server.port()), client)));
        TestSocket operator = other.open(Role.OPERATE)) {
      JsonNode teach = operator.call("teach", "robot", "'mock'");
      assertThat(teach.path("ok").path("simulated").asBoolean(true)).isFalse();
      assertThat(
              operator
                  .call("teach-mode", "robot", "'mock'", "mode", "'AUT'", "confirmed", "true")
                  .path("error")
                  .asText())
          .isEqualTo("this is only for robots that this page simulates (--mock)");
      assertThat(server.controller().mode()).isEqualTo(OperatingMode.T1);
    }
  }
}
