package no.hials.crosscom.web;

import static java.nio.charset.StandardCharsets.ISO_8859_1;
import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.MissingNode;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Base64;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import no.hials.crosscom.mock.Fault;
import no.hials.crosscom.mock.RecordedRequest;
import no.hials.crosscom.protocol.ServerType;
import no.hials.crosscom.protocol.code.OperatingMode;
import no.hials.crosscom.protocol.program.ProgramRequest.ProgramControlRequest;
import no.hials.crosscom.simulator.Message;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Programs, files and messages, as a page asks for them. */
class ProgramsTest {
  private static final String PROGRAM =
      """
      DEF WORK ( )
        BAS (#INITMOV,0)
        PTP $AXIS_ACT
        LOOP
          WAIT SEC 0.1
        ENDLOOP
      END
      """;

  @TempDir private Path folder;
  private TestPages pages;
  private TestSocket socket;

  @AfterEach
  void stop() throws IOException {
    socket.close();
    pages.close();
  }

  private void start(ServerType server, Role role) throws Exception {
    pages = TestPages.start(server, folder, cfg -> {});
    socket = pages.open(role);
  }

  private void startUnlocked(ServerType server) throws Exception {
    start(server, Role.OPERATE);
    assertThat(socket.call("lock", "robot", "'mock'", "locked", "false").has("ok")).isTrue();
  }

  private void load(String name, String text) throws Exception {
    pages.controller().controller().load(name, text);
  }

  /** Sends a command with fields as {@link TestSocket#call} has them; returns its error, or "". */
  private String change(String command, String... fields) throws InterruptedException {
    String[] all = new String[fields.length + 4];
    System.arraycopy(fields, 0, all, 0, fields.length);
    all[fields.length] = "robot";
    all[fields.length + 1] = "'mock'";
    all[fields.length + 2] = "confirmed";
    all[fields.length + 3] = "true";
    return socket.call(command, all).path("error").asText();
  }

  private String upload(String name, String text, String overwrite) throws InterruptedException {
    String content = Base64.getEncoder().encodeToString(text.getBytes(ISO_8859_1));
    return change(
        "upload",
        "folder",
        "'KRC:\\\\R1\\\\Program'",
        "name",
        "'" + name + "'",
        "content",
        "'" + content + "'",
        "overwrite",
        overwrite);
  }

  private String variable(String name) {
    return pages.controller().variables().get(name);
  }

  private void awaitState(String state) throws InterruptedException {
    socket.await(it -> it.path("robot_state").asText().equals(state));
  }

  private JsonNode lastAudit() throws InterruptedException {
    JsonNode last = null;
    for (JsonNode line : socket.call("audit").path("ok").path("lines")) {
      last = line;
    }
    return last;
  }

  @Test
  void aProgramIsSelectedStartedTwiceStoppedResetAndDeselected() throws Exception {
    startUnlocked(ServerType.C3_BRIDGE);
    load("work.src", PROGRAM);

    assertThat(change("program-select", "name", "'KRC:\\\\R1\\\\Program\\\\work.src'")).isEmpty();
    assertThat(variable("$PRO_NAME1[]")).isEqualTo("\"WORK\"");
    assertThat(change("program-order", "order", "'start'")).isEmpty();
    awaitState("#P_STOP"); // the end of the BCO run
    assertThat(change("program-order", "order", "'start'")).isEmpty();
    awaitState("#P_ACTIVE");
    assertThat(String.valueOf(lastAudit()))
        .contains("start", "the program of the robot interpreter", "done");
    assertThat(change("program-stop")).isEmpty();
    awaitState("#P_STOP");
    assertThat(change("program-order", "order", "'reset'")).isEmpty();
    awaitState("#P_RESET");
    assertThat(change("program-order", "order", "'cancel'")).isEmpty();
    awaitState("#P_FREE");
  }

  @Test
  void theSubmitInterpreterHasItsOwnProgram() throws Exception {
    startUnlocked(ServerType.C3_BRIDGE);
    load("watch.sub", "DEF WATCH ( )\nLOOP\nENDLOOP\nEND\n");
    pages.controller().controller().submit().select("WATCH");

    assertThat(change("program-order", "order", "'start'", "interpreter", "'submit'")).isEmpty();
    assertThat(variable("$PRO_STATE0")).isEqualTo("#P_ACTIVE");
    assertThat(change("program-stop", "interpreter", "'submit'")).isEmpty();
    assertThat(variable("$PRO_STATE0")).isEqualTo("#P_STOP");
    assertThat(change("program-stop", "interpreter", "'third'"))
        .isEqualTo("interpreter must be robot or submit");
  }

  @Test
  void aRefusalNamesItsLikelyCause() throws Exception {
    startUnlocked(ServerType.C3_BRIDGE);

    assertThat(change("program-order", "order", "'start'"))
        .contains("refused", "likely cause: no program is selected");
    assertThat(change("program-select", "name", "'/R1/NONE.SRC'")).contains("likely cause");
    assertThat(change("program-order", "order", "'jump'"))
        .isEqualTo("order must be one of [start, reset, cancel]");
    assertThat(String.valueOf(lastAudit())).contains("select", "/R1/NONE.SRC", "refused");
  }

  @Test
  void aStartWithoutAnAnswerHasAnUnknownOutcomeAndIsNotRepeated() throws Exception {
    startUnlocked(ServerType.C3_BRIDGE);
    load("work.src", PROGRAM);
    pages.controller().controller().robot().select("WORK");
    pages.controller().fault(it -> it.request().toString().contains("START"), Fault.dropAnswer());

    assertThat(change("program-order", "order", "'start'")).contains("the outcome is unknown");

    assertThat(String.valueOf(lastAudit())).contains("start", "the outcome is unknown");
    assertThat(
            pages.controller().requests().stream()
                .filter(it -> it.request().toString().contains("START")))
        .hasSize(1);
  }

  @Test
  void nothingChangesWhileTheRobotIsLocked() throws Exception {
    start(ServerType.C3_BRIDGE, Role.OPERATE);
    load("work.src", PROGRAM);
    pages.controller().controller().robot().select("WORK");

    assertThat(change("program-order", "order", "'start'")).endsWith("the robot is locked");
    assertThat(change("program-select", "name", "'/R1/WORK.SRC'")).endsWith("the robot is locked");
    assertThat(upload("new.src", PROGRAM, "false")).endsWith("the robot is locked");
    assertThat(change("confirm")).endsWith("the robot is locked");
    assertThat(change("answer", "dialogue", "1", "key", "1")).endsWith("the robot is locked");
    assertThat(variable("$PRO_STATE1")).isEqualTo("#P_RESET");
    assertThat(String.valueOf(lastAudit())).contains("answer", "the robot is locked");
  }

  @Test
  void aProgramIsStoppedWhileTheRobotIsLocked() throws Exception {
    startUnlocked(ServerType.C3_BRIDGE);
    load("watch.sub", "DEF WATCH ( )\nLOOP\nENDLOOP\nEND\n");
    pages.controller().controller().submit().select("WATCH");
    assertThat(change("program-order", "order", "'start'", "interpreter", "'submit'")).isEmpty();
    socket.call("lock", "robot", "'mock'", "locked", "true");

    assertThat(change("program-stop", "interpreter", "'submit'")).isEmpty();

    assertThat(variable("$PRO_STATE0")).isEqualTo("#P_STOP");
  }

  @Test
  void aReadOnlyRobotIsNotStopped() throws Exception {
    pages = TestPages.start(ServerType.C3_BRIDGE, folder, cfg -> cfg.readOnly(true));
    socket = pages.open(Role.OPERATE);

    assertThat(change("program-stop")).contains("did not stop", "--read-only");
    assertThat(stops()).isZero();
  }

  private long stops() {
    return pages.controller().requests().stream().filter(ProgramsTest::isStop).count();
  }

  private static boolean isStop(RecordedRequest request) {
    return request.request() instanceof ProgramControlRequest;
  }

  @Test
  void aStopWithoutAnAnswerDelaysNothingElse() throws Exception {
    startUnlocked(ServerType.C3_BRIDGE);
    CountDownLatch released = new CountDownLatch(1);
    pages.controller().fault(ProgramsTest::isStop, Fault.hold(released));
    for (String message :
        List.of(
            "{'id':901,'do':'program-stop','robot':'mock'}",
            "{'id':902,'do':'program-stop','robot':'mock'}",
            "{'id':903,'do':'ping'}",
            "{'id':904,'do':'lock','robot':'mock','locked':true}")) {
      socket.send(message.replace('\'', '"'));
    }

    List<Integer> answers = new ArrayList<>();
    socket.await(
        it -> {
          if (it.path("id").asInt() > 900) {
            answers.add(it.path("id").asInt());
          }
          return answers.size() == 2;
        });
    assertThat(answers).containsExactly(903, 904);
    released.countDown();
    socket.await(
        it -> {
          if (it.path("id").asInt() > 900) {
            assertThat(it.has("ok")).as("%s", it).isTrue();
            answers.add(it.path("id").asInt());
          }
          return answers.size() == 4;
        });
    assertThat(answers).containsExactlyInAnyOrder(903, 904, 901, 902);
    assertThat(stops()).isEqualTo(2);
  }

  @Test
  void aStartThatWasSentBeforeAStopIsRefusedAfterIt() throws Exception {
    startUnlocked(ServerType.C3_BRIDGE);
    load("work.src", PROGRAM);
    pages.controller().controller().robot().select("WORK");
    long before = socket.clock() - 1;
    assertThat(change("program-stop")).isEmpty();

    socket.send(start(before));

    assertThat(socket.await(it -> it.path("id").asInt() == 901).path("error").asText())
        .isEqualTo(
            "did not start the program of the robot interpreter: a program of the robot was stopped"
                + " meanwhile; look at the robot, and try again");
    assertThat(variable("$PRO_STATE1")).isEqualTo("#P_RESET");
    assertThat(change("program-order", "order", "'start'")).isEmpty();
  }

  @Test
  void aStartThatWaitsForTheRobotIsNotSentOnceTheRobotIsLocked() throws Exception {
    CountDownLatch released = new CountDownLatch(1);
    try (TestSocket other = openAfterSelection()) {
      sendStartThatWaits(other, released);

      assertThat(socket.call("lock", "robot", "'mock'", "locked", "true").has("ok")).isTrue();
      assertThat(other.await(it -> it.path("id").asInt() == 901).path("error").asText())
          .isEqualTo("did not start the program of the robot interpreter: the robot is locked");
    }
    released.countDown();

    assertThat(variable("$PRO_STATE1")).isEqualTo("#P_RESET");
    assertThat(stops()).as("all orders").isZero();
  }

  @Test
  void aStartThatWaitsForTheRobotIsNotSentOnceItsPageIsClosed() throws Exception {
    CountDownLatch released = new CountDownLatch(1);
    try (TestSocket other = openAfterSelection()) {
      sendStartThatWaits(other, released);
    }
    awaitNoWaitingOrder();
    released.countDown();

    assertThat(variable("$PRO_STATE1")).isEqualTo("#P_RESET");
    assertThat(stops()).as("all orders").isZero();
    assertThat(String.valueOf(lastAudit())).contains("start", "the page that sent it is gone");
  }

  @Test
  void aStartBehindAReadIsNotSentOnceTheRobotWasLockedAndUnlocked() throws Exception {
    CountDownLatch released = new CountDownLatch(1);
    try (TestSocket other = openAfterSelection()) {
      CountDownLatch asked = pages.hold("MYINT", released);
      long clock = other.clock();
      other.send("{\"id\":900,\"do\":\"read\",\"robot\":\"mock\",\"name\":\"MYINT\"}");
      other.send(start(clock - 1));
      asked.await();

      socket.call("lock", "robot", "'mock'", "locked", "true");
      socket.call("lock", "robot", "'mock'", "locked", "false");
      released.countDown();

      assertThat(other.await(it -> it.path("id").asInt() == 901).path("error").asText())
          .endsWith("the robot was locked meanwhile; look at the robot, and try again");
    }
    assertThat(variable("$PRO_STATE1")).isEqualTo("#P_RESET");
    assertThat(change("program-order", "order", "'start'")).isEmpty();
  }

  @Test
  void aStartThatWaitsForTheRobotIsNotSentOnceItsPageCancelsIt() throws Exception {
    CountDownLatch released = new CountDownLatch(1);
    try (TestSocket other = openAfterSelection()) {
      sendStartThatWaits(other, released);

      other.send("{\"id\":902,\"do\":\"withdraw\"}");

      assertThat(other.await(it -> it.path("id").asInt() == 901).path("error").asText())
          .endsWith(": it was cancelled on the page");
      released.countDown();
      assertThat(variable("$PRO_STATE1")).isEqualTo("#P_RESET");
      assertThat(
              other
                  .call("program-order", "robot", "'mock'", "order", "'start'", "confirmed", "true")
                  .has("ok"))
          .as("a later start")
          .isTrue();
    }
  }

  @Test
  void aStartThatWaitsForTheRobotIsNotSentOnceItIsTooOld() throws Exception {
    CountDownLatch released = new CountDownLatch(1);
    try (TestSocket other = openAfterSelection()) {
      CountDownLatch asked = pages.hold("MYINT", released);
      socket.send("{\"id\":900,\"do\":\"read\",\"robot\":\"mock\",\"name\":\"MYINT\"}");
      asked.await();

      other.send(start(Math.max(0, other.clock() - 3000)));

      assertThat(other.await(it -> it.path("id").asInt() == 901).path("error").asText())
          .endsWith(": it waited too long for the connection to the robot");
    }
    released.countDown();

    assertThat(variable("$PRO_STATE1")).isEqualTo("#P_RESET");
    assertThat(stops()).as("all orders").isZero();
  }

  private static String start(long clock) {
    return String.format(
        "{\"id\":901,\"do\":\"program-order\",\"robot\":\"mock\",\"order\":\"start\","
            + "\"confirmed\":true,\"clock\":%d}",
        clock);
  }

  private TestSocket openAfterSelection() throws Exception {
    startUnlocked(ServerType.C3_BRIDGE);
    load("work.src", PROGRAM);
    pages.controller().controller().robot().select("WORK");
    return pages.open(Role.OPERATE);
  }

  /** Sends a start while the robot does not answer a read, and returns once it waits for that. */
  private void sendStartThatWaits(TestSocket other, CountDownLatch released) throws Exception {
    CountDownLatch asked = pages.hold("MYINT", released);
    socket.send("{\"id\":900,\"do\":\"read\",\"robot\":\"mock\",\"name\":\"MYINT\"}");
    asked.await();
    other.send(start(other.clock() - 1));
    while (!isOrderWaiting()) {
      Thread.onSpinWait();
    }
  }

  private static void awaitNoWaitingOrder() {
    while (isOrderWaiting()) {
      Thread.onSpinWait();
    }
  }

  private static boolean isOrderWaiting() {
    return Thread.getAllStackTraces().entrySet().stream()
        .filter(it -> it.getKey().getState() != Thread.State.RUNNABLE)
        .flatMap(it -> Arrays.stream(it.getValue()))
        .anyMatch(
            it ->
                it.getClassName().endsWith(".PageProgramCommands")
                    && it.getMethodName().equals("order"));
  }

  @Test
  void aFailedStopSaysWhetherItWasSent() throws Exception {
    startUnlocked(ServerType.C3_BRIDGE);
    socket.await(it -> it.path("connection").asText().equals("connected"));
    pages.controller().refuseConnections();
    pages.controller().disconnectClients();
    socket.await(it -> it.path("connection").asText().equals("lost"));
    assertThat(change("program-stop")).startsWith("the stop was not sent: ");

    pages.controller().acceptConnections();
    socket.await(it -> it.path("connection").asText().equals("connected"));
    pages.controller().fault(ProgramsTest::isStop, Fault.dropAnswer());

    assertThat(change("program-stop")).startsWith("the stop was sent, but not answered: ");
  }

  @Test
  void nothingIsDoneWithoutAConfirmation() throws Exception {
    startUnlocked(ServerType.C3_BRIDGE);
    load("work.src", PROGRAM);
    pages.controller().controller().robot().select("WORK");

    JsonNode answer = socket.call("program-order", "robot", "'mock'", "order", "'start'");

    assertThat(answer.path("error").asText()).endsWith("not confirmed");
    assertThat(variable("$PRO_STATE1")).isEqualTo("#P_RESET");
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "program-select",
        "program-order",
        "program-stop",
        "upload",
        "upload-check",
        "confirm",
        "answer",
        "set-input"
      })
  void aViewerMayNotChangeAnything(String command) throws Exception {
    start(ServerType.C3_BRIDGE, Role.VIEW);

    assertThat(change(command))
        .isEqualTo("this needs the role OPERATE; this browser may only VIEW");
  }

  @Test
  void kukavarproxyNamesWhatItCannotDo() throws Exception {
    startUnlocked(ServerType.KUKAVARPROXY);

    JsonNode answer = socket.call("programs", "robot", "'mock'").path("ok");
    assertThat(answer.path("bridge").asBoolean(true)).isFalse();
    assertThat(change("program-order", "order", "'start'")).contains("needs C3 Bridge");
    assertThat(change("program-select", "name", "'/R1/WORK.SRC'")).contains("needs C3 Bridge");
    assertThat(change("program-files", "folder", "'KRC:\\\\R1'")).contains("needs C3 Bridge");
    assertThat(upload("new.src", PROGRAM, "false")).contains("needs C3 Bridge");
  }

  @Test
  void theTextOfAModuleIsThatOfItsFile() throws Exception {
    startUnlocked(ServerType.C3_BRIDGE);
    String hostile = "DEF EVIL ( )\n; <img src=x onerror=alert(1)>\u00e4\nEND\n";
    load("evil.src", hostile);

    JsonNode answer =
        socket.call("program-text", "robot", "'mock'", "name", "'/R1/EVIL.SRC'").path("ok");

    assertThat(answer.path("text").asText()).isEqualToNormalizingNewlines(hostile);
    assertThat(change("program-text", "name", "'/R1/NONE.SRC'"))
        .isEqualTo("the files of the controller have no /R1/NONE.SRC");
    assertThat(change("program-text", "name", "'KRC:\\\\R1\\\\..\\\\x.src'"))
        .isEqualTo("name is not a name on a controller");
  }

  @Test
  void aFolderListsItsProgramsAndFolders() throws Exception {
    start(ServerType.C3_BRIDGE, Role.VIEW);
    load("work.src", PROGRAM);

    JsonNode root =
        socket.call("program-files", "robot", "'mock'", "folder", "'KRC:\\\\R1'").path("ok");
    assertThat(root.path("items").findValuesAsText("name")).contains("Program", "System");
    JsonNode items =
        socket
            .call("program-files", "robot", "'mock'", "folder", "'KRC:\\\\R1\\\\Program'")
            .path("ok")
            .path("items");
    assertThat(items.findValuesAsText("path")).containsExactly("KRC:\\R1\\Program\\WORK.src");
  }

  @Test
  void anUploadIsCheckedStoredAndOnlyReplacedOnRequest() throws Exception {
    startUnlocked(ServerType.C3_BRIDGE);

    assertThat(upload("new.src", PROGRAM, "false")).isEmpty();
    assertThat(String.valueOf(lastAudit()))
        .contains("upload", "new.src", PROGRAM.length() + " bytes", "done");
    assertThat(upload("new.src", "DEF NEW ( )\nEND\n", "false")).contains("exists");
    JsonNode text = socket.call("program-text", "robot", "'mock'", "name", "'/R1/NEW.SRC'");
    assertThat(text.path("ok").path("text").asText()).isEqualTo(PROGRAM);
    assertThat(upload("new.src", "DEF NEW ( )\nEND\n", "true")).isEmpty();
    text = socket.call("program-text", "robot", "'mock'", "name", "'/R1/NEW.SRC'");
    assertThat(text.path("ok").path("text").asText()).isEqualTo("DEF NEW ( )\nEND\n");
  }

  @ParameterizedTest
  @ValueSource(strings = {"../x.src", "x.exe", "x", "1.src", ".src", "a b.src", "x.src\\\\y.src"})
  void aNameThatIsNotOfKrlIsNotUploaded(String name) throws Exception {
    startUnlocked(ServerType.C3_BRIDGE);

    assertThat(upload(name, PROGRAM, "true")).contains("a file of KRL has a name of at most 24");
  }

  @Test
  void aFileThatIsTooLargeIsNotUploaded() throws Exception {
    startUnlocked(ServerType.C3_BRIDGE);

    assertThat(upload("large.src", "x".repeat(181 * 1024), "true"))
        .contains("content must have at most");
    assertThat(upload("large.src", ";".repeat(180 * 1024), "true")).isEmpty();
  }

  @Test
  void errorsOfAFileAreShownBeforeItIsUploaded() throws Exception {
    startUnlocked(ServerType.C3_BRIDGE);
    String content =
        Base64.getEncoder().encodeToString("DEF BAD ( )\nIF TRUE\nEND\n".getBytes(ISO_8859_1));

    JsonNode answer =
        socket
            .call(
                "upload-check",
                "robot",
                "'mock'",
                "folder",
                "'/R1'",
                "name",
                "'bad.src'",
                "content",
                "'" + content + "'")
            .path("ok");

    assertThat(answer.path("errors").asInt()).isPositive();
    assertThat(answer.path("first").get(0).asText()).startsWith("bad.src:2:");
    assertThat(answer.path("exists").asBoolean(true)).isFalse();
  }

  @Test
  void messagesAreShownAndConfirmed() throws Exception {
    startUnlocked(ServerType.C3_BRIDGE);
    pages.controller().controller().emergencyStop(true);
    pages.controller().controller().emergencyStop(false);

    JsonNode messages = socket.call("messages", "robot", "'mock'").path("ok");
    assertThat(messages.path("known").asBoolean()).isTrue();
    assertThat(messages.path("messages").get(0).path("text").asText()).isEqualTo("emergency stop");
    assertThat(variable("$STOPMESS")).isEqualTo("TRUE");
    assertThat(change("confirm")).isEmpty();
    assertThat(variable("$STOPMESS")).isEqualTo("FALSE");
    assertThat(String.valueOf(lastAudit())).contains("confirm", "all messages", "done");
  }

  @Test
  void theSimulatedControllerConfirmsForKukavarproxy() throws Exception {
    startUnlocked(ServerType.KUKAVARPROXY);
    pages.controller().controller().emergencyStop(true);
    pages.controller().controller().emergencyStop(false);

    assertThat(change("confirm")).isEmpty();

    assertThat(variable("$STOPMESS")).isEqualTo("FALSE");
  }

  @Test
  void onlyTheDialogueThatIsShownIsAnswered() throws Exception {
    startUnlocked(ServerType.C3_BRIDGE);
    load(
        "ask.src",
        """
        DEF ASK ( )
        DECL INT A
        MsgDialog(A,"which <b>part</b>?","Cell",,"left","right")
        MsgDialog(A,"which <b>part</b>?","Cell",,"left","right")
        MsgNotify("done")
        END
        """);
    pages.controller().controller().setMode(OperatingMode.AUT);
    pages.controller().controller().robot().select("ASK");
    pages.controller().controller().start();
    JsonNode first = awaitDialogueAfter("0");
    assertThat(first.path("text").asText()).isEqualTo("Cell: which <b>part</b>?");
    assertThat(first.path("keys").toString()).isEqualTo("[\"left\",\"right\"]");
    String handle = first.path("handle").asText();

    assertThat(change("answer", "dialogue", "1000", "key", "1"))
        .isEqualTo("this dialogue is no longer shown");
    assertThat(change("answer", "dialogue", handle, "key", "5")).contains("was given number 5");
    assertThat(change("answer", "dialogue", handle, "key", "2")).isEmpty();
    JsonNode second = awaitDialogueAfter(handle);
    assertThat(change("answer", "dialogue", handle, "key", "1"))
        .isEqualTo("this dialogue is no longer shown");
    assertThat(awaitDialogueAfter(handle)).isEqualTo(second);
    assertThat(change("answer", "dialogue", second.path("handle").asText(), "key", "2")).isEmpty();

    awaitState("#P_END");
    assertThat(pages.controller().controller().messages())
        .extracting(Message::text)
        .contains("done");
    assertThat(socket.call("audit").path("ok").path("lines").toString())
        .contains("2 right", "a dialogue");
  }

  private JsonNode awaitDialogueAfter(String handle) throws InterruptedException {
    JsonNode dialogue = MissingNode.getInstance();
    while (dialogue.isMissingNode() || dialogue.path("handle").asText().equals(handle)) {
      dialogue = socket.call("messages", "robot", "'mock'").path("ok").path("dialogue");
    }
    return dialogue;
  }
}
