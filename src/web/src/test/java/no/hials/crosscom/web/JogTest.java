package no.hials.crosscom.web;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import com.fasterxml.jackson.databind.JsonNode;
import java.io.IOException;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import java.util.function.Predicate;
import no.hials.crosscom.mock.Fault;
import no.hials.crosscom.mock.RecordedRequest;
import no.hials.crosscom.protocol.ServerType;
import no.hials.crosscom.protocol.code.OperatingMode;
import no.hials.crosscom.simulator.Controller;
import no.hials.crosscom.simulator.KrlPrograms;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Jogging over real sockets, with a simulated robot that runs the programs of {@code krl}. */
@Timeout(60)
class JogTest {
  private static final String SILENCE = "no beat for 150 ms";

  @TempDir private Path folder;
  private final List<AutoCloseable> opened = new ArrayList<>();
  private TestPages pages;
  private long holds;

  @AfterEach
  void stop() throws Exception {
    for (AutoCloseable one : opened) {
      one.close();
    }
    pages.close();
  }

  // the robot

  /** The computer of a test may pause at any time. */
  private static WebConfig.Builder patient(WebConfig.Builder cfg) {
    return cfg.jogMaxDelay(Duration.ofSeconds(2));
  }

  private void start(ServerType type, String program) throws IOException {
    pages = TestPages.start(type, folder, JogTest::patient);
    KrlPrograms.start(controller(), KrlPrograms.START, program);
  }

  private void start() throws IOException {
    start(ServerType.C3_BRIDGE, "actuator");
  }

  /** Starts a robot that is not simulated by the server of the page. */
  private void startReal(OperatingMode mode, boolean jogInAuto) throws IOException {
    pages =
        TestPages.startRemote(
            ServerType.C3_BRIDGE, folder, cfg -> patient(cfg).jogInAuto(jogInAuto));
    KrlPrograms.start(controller(), KrlPrograms.START, "actuator");
    if (mode != controller().mode()) {
      controller().setMode(mode);
      controller().runProgram(); // the change of the mode has stopped it
    }
  }

  private Controller controller() {
    return pages.controller().controller();
  }

  private String variable(String name) {
    return pages.controller().variables().get(name);
  }

  // the pages

  /** Opens a page that watches the robot and has unlocked it. */
  private TestSocket open(Role role) throws Exception {
    TestSocket socket = pages.open(role);
    opened.add(socket);
    socket.call(
        "watch",
        "robot",
        "'mock'",
        "list",
        "'jog'",
        "names",
        "['MYPOS','MYAXIS','$POS_ACT','$AXIS_ACT']",
        "period",
        "50");
    if (role != Role.VIEW) {
      socket.call("lock", "robot", "'mock'", "locked", "false");
    }
    return socket;
  }

  private static JsonNode jog(TestSocket socket, String command, String... fields)
      throws InterruptedException {
    String[] all = new String[fields.length + 2];
    all[0] = "robot";
    all[1] = "'mock'";
    System.arraycopy(fields, 0, all, 2, fields.length);
    return socket.call("jog-" + command, all);
  }

  private static JsonNode begin(TestSocket socket, String space) throws InterruptedException {
    return jog(socket, "open", "space", "'" + space + "'", "confirmed", "true");
  }

  private static String error(JsonNode answer) {
    return answer.path("error").asText();
  }

  private static void assertDone(JsonNode answer) {
    assertThat(answer.has("ok")).as(answer.toString()).isTrue();
  }

  private static double number(JsonNode samples, String variable, String field) {
    return samples.path("values").path(variable).path("value").path(field).asDouble(Double.NaN);
  }

  /** A button that a test holds. */
  private final class Held {
    final TestSocket socket;
    final String[] press;
    long id;
    long beat;
    long mark;

    /** Whether an answer has said that the robot moves. */
    boolean moved;

    /** Presses it; the fields are those of the press. */
    Held(TestSocket socket, String... press) throws InterruptedException {
      this.socket = socket;
      this.press = press;
      again();
    }

    private void again() throws InterruptedException {
      id = ++holds;
      String[] fields = new String[press.length + 2];
      fields[0] = "hold";
      fields[1] = "" + id;
      System.arraycopy(press, 0, fields, 2, press.length);
      mark = jog(socket, "press", fields).path("ok").path("mark").asLong(-1);
      assertThat(mark).isNotNegative();
      beat = 0;
    }

    JsonNode beat() throws InterruptedException {
      JsonNode answer =
          jog(socket, "beat", "hold", "" + id, "beat", "" + ++beat, "mark", "" + mark);
      mark = answer.path("ok").path("mark").asLong(mark);
      moved |= answer.path("ok").path("moving").asBoolean();
      return answer;
    }

    /** Holds it until the samples are as they should be. */
    JsonNode until(Predicate<JsonNode> condition) throws InterruptedException {
      while (true) {
        // a computer that pauses for 150 ms ends the hold, as it must
        if (error(beat()).endsWith(SILENCE)) {
          again();
          beat();
        }
        JsonNode samples = socket.awaitSamples("jog");
        if (condition.test(samples)) {
          return samples;
        }
      }
    }

    void release() throws InterruptedException {
      assertDone(jog(socket, "release", "hold", "" + id));
    }
  }

  private Held hold(TestSocket socket, int direction, boolean positive) throws Exception {
    return new Held(
        socket,
        "direction",
        "" + direction,
        "positive",
        "" + positive,
        "percent",
        "50",
        "step",
        "0");
  }

  /** Holds X+ until the robot has moved. */
  private Held moveAlongX(TestSocket socket) throws Exception {
    double begin = number(socket.awaitSamples("jog"), "$POS_ACT", "X");
    Held held = hold(socket, 0, true);
    held.until(it -> held.moved && number(it, "$POS_ACT", "X") > begin + 3);
    return held;
  }

  /** Waits until the robot was told to stand and stands, and looks whether it stays there. */
  private void assertStands(TestSocket observer) throws Exception {
    observer.await(
        it ->
            it.path("list").asText().equals("jog")
                && sum(it, "MYPOS", "XYZABC", "") == 0
                && controller().standing());
    double place = number(observer.awaitSamples("jog"), "$POS_ACT", "X");
    for (int i = 0; i < 5; i++) {
      assertThat(number(observer.awaitSamples("jog"), "$POS_ACT", "X"))
          .isCloseTo(place, within(1e-3));
    }
  }

  private static double sum(JsonNode samples, String variable, String fields, String prefix) {
    return fields
        .chars()
        .mapToDouble(it -> Math.abs(number(samples, variable, prefix + (char) it)))
        .sum();
  }

  private List<JsonNode> audit(TestSocket socket, String what) throws InterruptedException {
    List<JsonNode> found = new ArrayList<>();
    for (JsonNode line : socket.call("audit").path("ok").path("lines")) {
      JsonNode entry = TestSocket.json(line.textValue());
      if (entry.path("what").asText().equals(what)) {
        found.add(entry);
      }
    }
    return found;
  }

  // motion and its ends

  @ParameterizedTest
  @EnumSource(ServerType.class)
  void theRobotMovesWhileAButtonIsHeldAndStandsAfterTheRelease(ServerType type) throws Exception {
    start(type, "actuator");
    TestSocket socket = open(Role.JOG);
    assertDone(begin(socket, "base"));
    Held held = moveAlongX(socket);

    held.release();

    assertStands(socket);
    assertThat(error(held.beat())).isEqualTo("the hold is over: released");
    assertThat(variable("JOV_LIMIT")).isEqualTo("500");
    assertThat(variable("$PRO_STATE1")).isEqualTo("#P_ACTIVE");

    assertDone(jog(socket, "close"));
    assertThat(jog(socket, "here").path("ok").path("owner").asBoolean()).isFalse();
    socket.await(it -> it.has("list") && variable("JOV_LIMIT").equals("0"));
  }

  @ParameterizedTest
  @EnumSource(ServerType.class)
  void theAxesMoveToo(ServerType type) throws Exception {
    start(type, "ext_move_axis");
    TestSocket socket = open(Role.JOG);
    assertDone(begin(socket, "joints"));
    double begin = number(socket.awaitSamples("jog"), "$AXIS_ACT", "A1");

    Held held = hold(socket, 0, false);
    held.until(it -> number(it, "$AXIS_ACT", "A1") < begin - 2);
    held.release();

    socket.await(it -> it.has("list") && sum(it, "MYAXIS", "123456", "A") == 0);
  }

  @Test
  void theToolMovesAlongItsOwnAxes() throws Exception {
    start();
    TestSocket socket = open(Role.JOG);
    assertDone(begin(socket, "tool"));
    JsonNode first = socket.awaitSamples("jog");

    Held held = hold(socket, 0, true);
    // at the start, X of the tool is turned by 180 and 45 degrees
    held.until(it -> number(it, "$POS_ACT", "X") < number(first, "$POS_ACT", "X") - 3);
    JsonNode last =
        held.until(it -> number(it, "$POS_ACT", "Z") < number(first, "$POS_ACT", "Z") - 3);
    held.release();

    assertThat(number(last, "$POS_ACT", "Y"))
        .isCloseTo(number(first, "$POS_ACT", "Y"), within(0.5));
  }

  @Test
  void silenceStopsTheRobotAndLateBeatsDoNotMoveIt() throws Exception {
    start();
    TestSocket socket = open(Role.JOG);
    assertDone(begin(socket, "base"));
    Held held = moveAlongX(socket);

    assertStands(socket); // meanwhile there is no beat

    assertThat(error(held.beat())).isEqualTo("the hold is over: no beat for 150 ms");
    assertStands(socket);
    moveAlongX(socket).release(); // a new press does
  }

  @Test
  void aClosedSocketStopsTheRobotAndFreesIt() throws Exception {
    start();
    TestSocket observer = open(Role.JOG);
    TestSocket socket = open(Role.JOG);
    assertDone(begin(socket, "base"));
    moveAlongX(socket);

    socket.close();

    assertStands(observer);
    observer.await(
        it -> it.path("event").asText().equals("header") && variable("JOV_LIMIT").equals("0"));
    assertDone(begin(observer, "base"));
  }

  @Test
  void lockingStopsTheRobot() throws Exception {
    start();
    TestSocket observer = open(Role.OPERATE);
    TestSocket socket = open(Role.JOG);
    assertDone(begin(socket, "base"));
    Held held = moveAlongX(socket);

    observer.call("lock", "robot", "'mock'", "locked", "true");

    assertStands(observer);
    socket.await(it -> it.path("reason").asText().equals("the robot was locked"));
    assertThat(error(held.beat())).isEqualTo("the robot was locked");
    assertThat(error(begin(socket, "base")))
        .isEqualTo("did not jog the robot: the robot is locked");
  }

  @Test
  void joggingThatBeginsWritesNothingOnceTheRobotIsLocked() throws Exception {
    start();
    TestSocket observer = open(Role.OPERATE);
    TestSocket socket = open(Role.JOG);
    CountDownLatch released = new CountDownLatch(1);
    CountDownLatch asked = pages.hold("JOV_SEEN", released);
    socket.send(
        String.format(
            "{\"id\":901,\"do\":\"jog-open\",\"robot\":\"mock\",\"space\":\"base\","
                + "\"confirmed\":true,\"clock\":%d}",
            socket.clock()));
    asked.await();

    observer.call("lock", "robot", "'mock'", "locked", "true");
    released.countDown();

    assertThat(error(socket.await(it -> it.path("id").asInt() == 901)))
        .isEqualTo("did not jog: the robot was locked");
    assertThat(pages.controller().requests()).noneMatch(RecordedRequest::isWrite);
  }

  @Test
  void aChangedModeStopsTheRobot() throws Exception {
    start();
    TestSocket socket = open(Role.JOG);
    assertDone(begin(socket, "base"));
    moveAlongX(socket);

    controller().setMode(OperatingMode.T1);

    socket.await(
        it ->
            it.path("reason").asText().startsWith("$MODE_OP must be one of [AUT], is #T1")
                || it.path("reason").asText().startsWith("$PRO_STATE1 must be #P_ACTIVE"));
    assertStands(socket);
  }

  @Test
  void theEndOfTheServerStopsTheRobot() throws Exception {
    pages =
        TestPages.startRemote(ServerType.C3_BRIDGE, folder, cfg -> patient(cfg).jogInAuto(true));
    KrlPrograms.start(controller(), KrlPrograms.START, "actuator");
    TestSocket socket = open(Role.JOG);
    assertDone(begin(socket, "base"));
    moveAlongX(socket);

    pages.web().close();

    assertThat(variable("MYPOS")).contains("X 0.0,");
    assertThat(variable("JOV_LIMIT")).isEqualTo("0");
  }

  @Test
  void aLostControllerIsStoppedByItsWatchdog() throws Exception {
    start();
    TestSocket socket = open(Role.JOG);
    assertDone(begin(socket, "base"));
    moveAlongX(socket);

    pages.controller().refuseConnections();
    pages.controller().disconnectClients();

    socket.await(it -> it.path("reason").asText().contains("the watchdog must stop it"));
    socket.await(
        it ->
            it.path("event").asText().equals("header")
                && variable("$PRO_STATE1").equals("#P_STOP")
                && controller().standing());
    assertThat(variable("JOV_TIMEOUT")).isEqualTo("TRUE");
  }

  @ParameterizedTest
  @CsvSource({"0, 0.1", "1, 1", "2, 10", "3, 1"})
  void aStepEndsAtItsDistance(int direction, double step) throws Exception {
    start();
    TestSocket socket = open(Role.JOG);
    assertDone(begin(socket, "base"));
    String field = "XYZABC".substring(direction, direction + 1);
    double begin;
    String end;
    do {
      begin = number(socket.awaitSamples("jog"), "$POS_ACT", field);
      end = holdToItsEnd(socket, direction, step);
    } while (end.endsWith(SILENCE)); // this computer has paused

    assertThat(end).isEqualTo("the hold is over: the step is done");
    assertStands(socket);
    double moved = begin - number(socket.awaitSamples("jog"), "$POS_ACT", field);
    assertThat((moved + 540) % 360 - 180)
        .isCloseTo(step, within(0.05 + 0.3 * step)); // a pause is a longer step
  }

  private String holdToItsEnd(TestSocket socket, int direction, double step) throws Exception {
    Held held =
        new Held(
            socket,
            "direction",
            "" + direction,
            "positive",
            "false",
            "percent",
            "25",
            "step",
            "" + step);
    String end = "";
    while (end.isEmpty()) {
      end = error(held.beat());
      socket.awaitSamples("jog");
    }
    return end;
  }

  @Test
  void aStepEndsAtTheReleaseToo() throws Exception {
    start();
    TestSocket socket = open(Role.JOG);
    assertDone(begin(socket, "base"));
    double begin = number(socket.awaitSamples("jog"), "$POS_ACT", "X");
    Held held =
        new Held(socket, "direction", "0", "positive", "true", "percent", "10", "step", "10");
    held.until(it -> number(it, "$POS_ACT", "X") > begin + 0.5);

    held.release();

    assertStands(socket);
    assertThat(number(socket.awaitSamples("jog"), "$POS_ACT", "X")).isLessThan(begin + 9);
  }

  // who may

  @Test
  void othersCannotMoveIt() throws Exception {
    start();
    TestSocket owner = open(Role.JOG);
    TestSocket other = open(Role.JOG);
    assertDone(begin(owner, "base"));
    other.await(it -> it.path("owner").path("name").asText().equals("browser 1"));

    assertThat(error(begin(other, "base")))
        .isEqualTo("browser 1 jogs this robot: ask to take over");
    assertThat(
            error(
                jog(
                    other,
                    "press",
                    "hold",
                    "1",
                    "direction",
                    "0",
                    "positive",
                    "true",
                    "percent",
                    "10",
                    "step",
                    "0")))
        .isEqualTo("this page does not jog the robot");
    Held held = moveAlongX(owner);
    assertThat(error(jog(other, "beat", "hold", "" + held.id, "beat", "9", "mark", "0")))
        .isEqualTo("this page does not jog the robot");
    assertThat(error(jog(other, "release", "hold", "" + held.id)))
        .isEqualTo("this page does not jog the robot");
    jog(other, "close"); // not its own
    held.release();
    moveAlongX(owner).release();
  }

  @Test
  void theOwnerIsAskedAndGivesItAfterTheRobotHasStopped() throws Exception {
    start();
    TestSocket owner = open(Role.JOG);
    TestSocket other = open(Role.JOG);
    assertDone(begin(owner, "base"));
    Held held = moveAlongX(owner);

    assertDone(jog(other, "ask"));
    JsonNode question = owner.await(it -> it.path("asker").has("id"));
    assertThat(question.path("asker").path("name").asText()).isEqualTo("browser 2");
    assertThat(question.path("answer_ms").asInt()).isBetween(1, 10_000);
    held.until(it -> true); // asking stops nothing
    String to = question.path("asker").path("id").asText();
    assertDone(jog(owner, "answer", "to", to, "yes", "true"));

    assertThat(error(held.beat())).isEqualTo("this page does not jog the robot");
    assertStands(other);
    assertDone(begin(other, "base"));
    moveAlongX(other).release();
  }

  @Test
  void theOwnerRefuses() throws Exception {
    start();
    TestSocket owner = open(Role.JOG);
    TestSocket other = open(Role.JOG);
    assertDone(begin(owner, "base"));
    assertDone(jog(other, "ask"));
    String to = owner.await(it -> it.path("asker").has("id")).path("asker").path("id").asText();

    assertThat(error(jog(other, "answer", "to", to, "yes", "true")))
        .isEqualTo("only the page that jogs the robot can hand it over");
    assertDone(jog(owner, "answer", "to", to, "yes", "false"));

    other.await(it -> it.path("owner").has("id") && it.path("asker").isNull());
    assertThat(error(begin(other, "base"))).contains("ask to take over");
    moveAlongX(owner).release();
  }

  @Test
  void anOwnerWhoIsGoneLosesTheRobotToWhoAsked() throws Exception {
    start();
    TestSocket owner = open(Role.JOG);
    TestSocket other = open(Role.JOG);
    assertDone(begin(owner, "base"));
    assertDone(jog(other, "ask"));

    owner.close();

    JsonNode after = other.await(it -> it.path("owner").path("name").asText().equals("browser 2"));
    assertThat(after.path("asker").isNull()).isTrue();
    assertDone(begin(other, "base"));
  }

  @ParameterizedTest
  @CsvSource({"VIEW, open", "OPERATE, open", "OPERATE, press", "VIEW, beat", "OPERATE, ask"})
  void otherRolesMayNot(Role role, String command) throws Exception {
    start();
    TestSocket socket = open(role);

    assertThat(error(jog(socket, command)))
        .isEqualTo("this needs the role JOG; this browser may only " + role);
  }

  @Test
  void aReadOnlyPageMayNot() throws Exception {
    pages =
        TestPages.start(ServerType.C3_BRIDGE, folder, cfg -> cfg.readOnly(true).jogInAuto(true));
    KrlPrograms.start(controller(), KrlPrograms.START, "actuator");

    assertThat(error(begin(open(Role.JOG), "base"))).contains("did not jog the robot: --read-only");
  }

  // when it may

  @Test
  void aRealRobotHasToBeInT1() throws Exception {
    startReal(OperatingMode.AUT, false);
    TestSocket socket = open(Role.JOG);

    assertThat(error(begin(socket, "base")))
        .isEqualTo(
            "$MODE_OP must be #T1, is #AUT; other modes need the option --jog-in-auto of the"
                + " page's server");
    assertThat(variable("JOV_LIMIT")).isEqualTo("0");
  }

  @ParameterizedTest
  @CsvSource({"T1, false", "AUT, true"})
  void aRealRobotMovesInT1AndWithTheOptionInAuto(OperatingMode mode, boolean inAuto)
      throws Exception {
    startReal(mode, inAuto);
    TestSocket socket = open(Role.JOG);

    assertDone(begin(socket, "base"));

    moveAlongX(socket).release();
    assertStands(socket);
  }

  @Test
  void thePersonHasToConfirm() throws Exception {
    startReal(OperatingMode.AUT, true);

    assertThat(error(jog(open(Role.JOG), "open", "space", "'base'")))
        .endsWith("did not jog the robot: not confirmed");
  }

  @Test
  void withoutTheWatchdogItIsRefused() throws Exception {
    start();
    controller().submit().stop();
    TestSocket socket = open(Role.JOG);

    assertThat(error(begin(socket, "base")))
        .startsWith("the watchdog does not see the heartbeat: JOV_SEEN must become")
        .endsWith("JOV_SPS does not run");
    assertThat(error(jog(socket, "beat", "hold", "1", "beat", "1", "mark", "0")))
        .startsWith("the watchdog does not see the heartbeat");
  }

  @Test
  void withoutAProgramItIsRefused() throws Exception {
    pages = TestPages.start(folder);

    assertThat(error(begin(open(Role.JOG), "joints")))
        .isEqualTo(
            "$PRO_STATE1 must be #P_ACTIVE, is #P_FREE; select and start EXT_MOVE_AXIS"
                + " (krl/ext_move_axis.src)");
  }

  @ParameterizedTest
  @ValueSource(strings = {"base", "tool"})
  void theProgramHasToFollowTheVariable(String space) throws Exception {
    start(ServerType.C3_BRIDGE, "ext_move_axis");

    assertThat(error(begin(open(Role.JOG), space)))
        .isEqualTo(
            "$PRO_NAME1[] must be ACTUATOR, is EXT_MOVE_AXIS; select and start ACTUATOR"
                + " (krl/actuator.src)");
  }

  @Test
  void theProgramHasToRun() throws Exception {
    start();
    controller().robot().stop();

    assertThat(error(begin(open(Role.JOG), "base")))
        .isEqualTo(
            "$PRO_STATE1 must be #P_ACTIVE, is #P_STOP; select and start ACTUATOR"
                + " (krl/actuator.src)");
  }

  @Test
  void anotherDriverIsNoticed() throws Exception {
    start();
    TestSocket socket = open(Role.JOG);
    pages.controller().variables().set("JOV_LIMIT", "10000");
    Thread other =
        new Thread(
            () -> {
              for (int i = 1; !Thread.currentThread().isInterrupted(); i++) {
                pages.controller().variables().set("JOV_HEARTBEAT", "" + i);
              }
            });
    other.start();

    JsonNode answer = begin(socket, "base");
    other.interrupt();
    other.join();

    assertThat(error(answer)).startsWith("JOV_HEARTBEAT must not change before the start");
  }

  @ParameterizedTest
  @CsvSource({"0,X of the workspace must be", "2,A5 must be at least 10 degrees from 0"})
  void theLimitsOfTheLoopApply(String direction, String limit) throws Exception {
    start();
    TestSocket socket = open(Role.JOG);
    assertDone(begin(socket, "base"));
    Held held =
        new Held(
            socket, "direction", direction, "positive", "false", "percent", "100", "step", "0");

    String end = "";
    while (end.isEmpty()) {
      end = error(held.beat());
      if (end.endsWith(SILENCE)) {
        held.again();
        end = "";
      }
      socket.awaitSamples("jog");
    }

    assertThat(end).startsWith(limit);
    assertStands(socket);
  }

  // hostile pages

  @Test
  void oddMessagesAreRefused() throws Exception {
    start();
    TestSocket socket = open(Role.JOG);
    assertThat(error(begin(socket, "world"))).isEqualTo("space must be base, tool or joints");
    assertThat(error(jog(socket, "press"))).isEqualTo("this page does not jog the robot");
    assertDone(begin(socket, "base"));

    assertThat(error(press(socket, "1", "6", "true", "50", "0")))
        .isEqualTo("direction must be 0 to 5, is 6");
    assertThat(error(press(socket, "1", "0.5", "true", "50", "0")))
        .isEqualTo("direction must be a whole number, is 0.5");
    assertThat(error(press(socket, "1", "0", "true", "101", "0")))
        .isEqualTo("percent must be 1 to 100, is 101");
    assertThat(error(press(socket, "1", "0", "true", "50", "1000")))
        .isEqualTo("step must be 0 to 10, is 1000");
    assertThat(error(press(socket, "1", "0", "'yes'", "50", "0")))
        .isEqualTo("positive must be true or false");
    assertThat(error(press(socket, "1e300", "0", "true", "50", "0"))).startsWith("hold must be");
    assertThat(error(press(socket, "'1'", "0", "true", "50", "0")))
        .isEqualTo("hold must be a number");
    assertThat(error(jog(socket, "beat", "hold", "1", "beat", "-1", "mark", "0")))
        .startsWith("beat must be");
    assertThat(error(jog(socket, "release", "hold", "null"))).isEqualTo("hold must be a number");
    assertThat(error(jog(socket, "answer", "to", "77", "yes", "true")))
        .isEqualTo("the question is over");
    assertThat(error(socket.call("jog-press", "robot", "'other'")))
        .isEqualTo("the page has no such robot");
    assertStands(socket);
  }

  private static JsonNode press(
      TestSocket socket,
      String hold,
      String direction,
      String positive,
      String percent,
      String step)
      throws InterruptedException {
    return jog(
        socket,
        "press",
        "hold",
        hold,
        "direction",
        direction,
        "positive",
        positive,
        "percent",
        percent,
        "step",
        step);
  }

  @Test
  void beatsWithAWrongMarkMoveNothing() throws Exception {
    start();
    TestSocket socket = open(Role.JOG);
    assertDone(begin(socket, "base"));
    assertDone(press(socket, "1", "0", "true", "50", "0"));

    String end = "";
    for (int i = 1; end.isEmpty(); i++) {
      end = error(jog(socket, "beat", "hold", "1", "beat", "" + i, "mark", "9000000"));
      socket.awaitSamples("jog");
    }

    assertThat(end).isEqualTo("the hold is over: no beat for 150 ms");
    assertThat(pages.controller().requests())
        .noneMatch(it -> it.toString().contains("MYPOS") && it.toString().contains("X 0.6"));
    assertStands(socket);
  }

  // the record

  @Test
  void everyJogIsInTheAuditLog() throws Exception {
    start();
    TestSocket socket = open(Role.JOG);
    assertDone(begin(socket, "base"));
    moveAlongX(socket).release();
    socket.await(
        it ->
            it.path("event").asText().equals("audit")
                && it.path("line").asText().contains("\"what\":\"jog\""));

    JsonNode line = audit(socket, "jog").get(audit(socket, "jog").size() - 1);

    assertThat(line.path("who").asText()).isEqualTo("browser 1");
    assertThat(line.path("robot").asText()).isEqualTo("mock");
    assertThat(line.path("name").asText()).isEqualTo("X+");
    assertThat(line.path("before").asText()).matches("\\{X [-\\d.]+,Y .*}");
    assertThat(x(line.path("after").asText())).isGreaterThan(x(line.path("before").asText()));
    assertThat(line.path("result").asText()).isEqualTo("released");
    assertThat(audit(socket, "jog-open").get(0).path("name").asText()).isEqualTo("base");
  }

  @Test
  void aPositionThatCannotBeReadAfterwardsIsNotInTheAuditLog() throws Exception {
    start();
    TestSocket socket = open(Role.JOG);
    assertDone(begin(socket, "base"));
    moveAlongX(socket);

    pages.controller().fault(it -> true, Fault.drop());
    JsonNode event =
        socket.await(
            it ->
                it.path("event").asText().equals("audit")
                    && it.path("line").asText().contains("\"what\":\"jog\""));

    JsonNode line = TestSocket.json(event.path("line").asText());
    assertThat(line.path("before").asText()).startsWith("{X ");
    assertThat(line.path("after").asText()).isEmpty();
  }

  /** Returns X of a position, which has a type if it is the text of the controller. */
  private static double x(String position) {
    return Double.parseDouble(position.replaceFirst("^\\{(\\w+: )?X ", "").split(",", 2)[0]);
  }
}
