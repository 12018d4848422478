package no.hials.crosscom.examples;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.time.Duration;
import no.hials.crosscom.CrossComClient;
import no.hials.crosscom.KRL.KRLBool;
import no.hials.crosscom.KRL.KRLInt;
import no.hials.crosscom.KRL.structs.KRLE6Axis;
import no.hials.crosscom.KRL.structs.KRLE6Pos;
import no.hials.crosscom.KRL.structs.KRLPos;
import no.hials.crosscom.mock.MockServer;
import no.hials.crosscom.protocol.code.OperatingMode;
import no.hials.crosscom.protocol.code.ProgramState;
import no.hials.crosscom.protocol.value.Axis;
import no.hials.crosscom.simulator.Controller;
import no.hials.crosscom.simulator.SimulationClock;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Runs the programs of {@code krl} in the simulated controller, driven by a client. */
class KrlProgramsTest {
  private static final Path KRL = Path.of("..", "krl");
  private static final Duration LIMIT = Duration.ofMinutes(2);
  private static final double MM = 0.01;
  private static final double DEGREES = 0.001;

  private MockServer server;
  private Controller controller;
  private CrossComClient client;

  @BeforeEach
  void start() throws Exception {
    server = MockServer.start(cfg -> cfg.clock(SimulationClock.stepped()).bco(false));
    controller = server.controller();
    controller.load(KRL.resolve("config.dat"));
    controller.setMode(OperatingMode.AUT);
    // not with A5 at 0, where a straight path would pass a singularity
    controller.place(Axis.of(0, -90, 90, 0, 45, 0));
    client = new CrossComClient(server.host(), server.port());
  }

  @AfterEach
  void stop() throws IOException {
    client.close();
    server.close();
  }

  private void run(String file) throws Exception {
    controller.robot().select(controller.load(KRL.resolve(file)));
    controller.robot().start();
    controller.step(Duration.ofMillis(120));
    assertThat(controller.robot().state()).isEqualTo(ProgramState.ACTIVE);
    assertThat(controller.messages()).isEmpty();
  }

  private int readInt(String name) {
    try {
      KRLInt variable = new KRLInt(name);
      client.readVariable(variable);
      return variable.intValue();
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  private void writeInt(String name, int value) throws IOException {
    client.writeText(name, String.valueOf(value));
  }

  private boolean stopped() {
    try {
      KRLBool variable = new KRLBool("$ROB_STOPPED");
      client.readVariable(variable);
      return variable.booleanValue();
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  private void write(String assignment) throws IOException {
    int sign = assignment.indexOf('=');
    client.writeText(assignment.substring(0, sign), assignment.substring(sign + 1));
  }

  private KRLE6Pos position() throws IOException {
    KRLE6Pos position = new KRLE6Pos("$POS_ACT");
    client.readVariable(position);
    return position;
  }

  private double[] axes() throws IOException {
    return client.readJointAngles();
  }

  /** Lets the loop plan ten more steps, and then stops it with zeros. */
  private int tenSteps(String increment, String zeros) throws IOException {
    int before = readInt("JOV_STEPS");
    write(increment);
    assertThat(controller.stepUntil(() -> readInt("JOV_STEPS") >= before + 10, LIMIT)).isTrue();
    write(zeros);
    int steps = readInt("JOV_STEPS") - before;
    assertThat(controller.stepUntil(this::stopped, LIMIT)).isTrue();
    return steps;
  }

  @Test
  void actuatorMovesByTenIncrementsAndStandsStillByZeros() throws Exception {
    run("actuator.src");
    KRLE6Pos start = position();

    int steps = tenSteps("MYPOS={X -2,Y 1,Z 0.5}", "MYPOS={X 0,Y 0,Z 0,A 0,B 0,C 0}");

    assertThat(steps).isEqualTo(10);
    KRLE6Pos end = position();
    assertThat(end.getX()).isCloseTo(start.getX() - 20, within(MM));
    assertThat(end.getY()).isCloseTo(start.getY() + 10, within(MM));
    assertThat(end.getZ()).isCloseTo(start.getZ() + 5, within(MM));

    int stood = readInt("JOV_STEPS");
    controller.step(Duration.ofSeconds(1));
    assertThat(position().getX()).isEqualTo(end.getX());
    assertThat(readInt("JOV_STEPS")).isGreaterThan(stood);
    assertThat(client.readText("$PRO_STATE1")).isEqualTo("#P_ACTIVE");
  }

  @Test
  void extMoveAxisMovesByTenIncrementsAndStandsStillByZeros() throws Exception {
    run("ext_move_axis.src");
    double[] start = axes();

    int steps =
        tenSteps(
            "MYAXIS={A1 0.5,A2 0.25,A3 -0.25,A6 -1}", "MYAXIS={A1 0,A2 0,A3 0,A4 0,A5 0,A6 0}");

    assertThat(steps).isEqualTo(10);
    double[] end = axes();
    double[] increment = {0.5, 0.25, -0.25, 0, 0, -1};
    for (int i = 0; i < increment.length; i++) {
      assertThat(end[i]).isCloseTo(start[i] + 10 * increment[i], within(DEGREES));
    }
    controller.step(Duration.ofSeconds(1));
    assertThat(axes()).isEqualTo(end);
  }

  @Test
  void followPosGoesWhereTheClientSaysAndNowhereBefore() throws Exception {
    KRLE6Pos start = position();
    run("follow_pos.src");
    controller.step(Duration.ofSeconds(1));
    assertThat(position().getX()).isCloseTo(start.getX(), within(MM));

    client.writeText("JOV_POS", "{X 500,Y 100,Z 850}");
    controller.step(Duration.ofMillis(100));
    assertThat(controller.stepUntil(this::stopped, LIMIT)).isTrue();

    KRLE6Pos end = position();
    assertThat(end.getX()).isCloseTo(500, within(MM));
    assertThat(end.getY()).isCloseTo(100, within(MM));
    assertThat(end.getZ()).isCloseTo(850, within(MM));
  }

  @Test
  void followAxisGoesWhereTheClientSaysAndNowhereBefore() throws Exception {
    double[] start = axes();
    run("follow_axis.src");
    controller.step(Duration.ofSeconds(1));
    assertThat(axes()).isEqualTo(start);

    client.writeText("JOV_AXIS", "{A1 20,A5 30}");
    controller.step(Duration.ofMillis(100));
    assertThat(controller.stepUntil(this::stopped, LIMIT)).isTrue();

    assertThat(axes()[0]).isCloseTo(20, within(DEGREES));
    assertThat(axes()[1]).isCloseTo(-90, within(DEGREES));
    assertThat(axes()[4]).isCloseTo(30, within(DEGREES));
  }

  @Test
  void playPathPlaysFiftyPointsOfAxes() throws Exception {
    run("play_path.src");
    for (int i = 1; i <= 50; i++) {
      KRLE6Axis point = new KRLE6Axis("JOV_PATH_AXIS[" + i + "]");
      point.setA1(20 * Math.sin(i / 8.0));
      point.setA2(-90);
      point.setA3(90 + i / 5.0);
      client.writeVariable(point);
    }
    writeInt("JOV_COUNT", 50);
    writeInt("JOV_COMMAND", 1);
    controller.step(Duration.ofMillis(24));

    assertThat(readInt("JOV_COMMAND")).isZero();
    assertThat(controller.stepUntil(() -> readInt("JOV_RESULT") == 1, LIMIT)).isTrue();

    assertThat(readInt("JOV_INDEX")).isEqualTo(50);
    assertThat(stopped()).isTrue();
    assertThat(axes()[0]).isCloseTo(20 * Math.sin(50 / 8.0), within(DEGREES));
    assertThat(axes()[2]).isCloseTo(100, within(DEGREES));
  }

  @Test
  void playPathPlaysFiftyPositions() throws Exception {
    run("play_path.src");
    KRLE6Pos start = position();
    for (int i = 1; i <= 50; i++) {
      double angle = 2 * Math.PI * (i - 1) / 49;
      KRLPos point = new KRLPos("JOV_PATH_POS[" + i + "]");
      point.setX(start.getX() - 50 + 50 * Math.cos(angle)).setY(50 * Math.sin(angle));
      point.setZ(start.getZ() - 2 * (i - 1));
      point.setA(start.getA()).setB(start.getB()).setC(start.getC());
      // of the first point, the robot's position; LIN to the others ignores them
      point.setS(start.getS());
      point.setT(start.getT());
      client.writeVariable(point);
    }
    writeInt("JOV_COUNT", 50);
    writeInt("JOV_COMMAND", 2);
    controller.step(Duration.ofMillis(24));

    assertThat(controller.stepUntil(() -> readInt("JOV_RESULT") == 1, LIMIT)).isTrue();

    KRLE6Pos end = position();
    assertThat(end.getX()).isCloseTo(start.getX(), within(MM));
    assertThat(end.getY()).isCloseTo(0, within(MM));
    assertThat(end.getZ()).isCloseTo(start.getZ() - 98, within(MM));
  }

  @Test
  void playPathRefusesAWrongCount() throws Exception {
    run("play_path.src");
    writeInt("JOV_COUNT", 51);
    writeInt("JOV_COMMAND", 1);
    controller.step(Duration.ofMillis(120));

    assertThat(readInt("JOV_RESULT")).isEqualTo(2);
    assertThat(stopped()).isTrue();
  }

  @Test
  void playPathIsReadyWhenItSaysSoAndForgetsWhatWasWrittenBefore() throws Exception {
    writeInt("JOV_RESULT", 1);
    writeInt("JOV_COUNT", 0);
    writeInt("JOV_COMMAND", 1);
    run("play_path.src");

    assertThat(readInt("JOV_RESULT")).isEqualTo(3);
    assertThat(readInt("JOV_COMMAND")).isZero();
  }

  private void runSubmit() throws Exception {
    controller.submit().select(controller.load(KRL.resolve("jov_sps.sub")));
    controller.submit().start();
    controller.step(Duration.ofMillis(24));
    assertThat(controller.submit().state()).isEqualTo(ProgramState.ACTIVE);
  }

  @Test
  void theWatchdogStopsTheRobotWhenTheHeartbeatStops() throws Exception {
    runSubmit();
    run("ext_move_axis.src");
    writeInt("JOV_LIMIT", 200);
    client.writeText("MYAXIS", "{A1 0.5}");
    for (int beat = 1; beat <= 10; beat++) {
      writeInt("JOV_HEARTBEAT", beat);
      controller.step(Duration.ofMillis(96));
    }
    assertThat(stopped()).isFalse();
    assertThat(controller.robot().state()).isEqualTo(ProgramState.ACTIVE);

    controller.step(Duration.ofSeconds(1));

    assertThat(stopped()).isTrue();
    assertThat(client.readText("JOV_TIMEOUT")).isEqualTo("TRUE");
    assertThat(client.readText("$PRO_STATE1")).isEqualTo("#P_STOP");
    double[] stoodAt = axes();
    controller.step(Duration.ofSeconds(5));
    assertThat(axes()).isEqualTo(stoodAt);

    // the client is back: the program continues only when it is started, and moves nothing
    writeInt("JOV_HEARTBEAT", 11);
    controller.step(Duration.ofMillis(24));
    controller.robot().start();
    for (int beat = 12; beat <= 20; beat++) {
      writeInt("JOV_HEARTBEAT", beat);
      controller.step(Duration.ofMillis(96));
    }
    assertThat(controller.robot().state()).isEqualTo(ProgramState.ACTIVE);
    client.writeText("MYAXIS", "{A1 0.5}");
    writeInt("JOV_HEARTBEAT", 21);
    controller.step(Duration.ofMillis(96));
    assertThat(axes()[0]).isGreaterThan(stoodAt[0]);
  }

  @ParameterizedTest
  @CsvSource({
    "actuator.src, MYPOS, {Z -2}",
    "ext_move_axis.src, MYAXIS, {A1 0.5}",
    "follow_pos.src, JOV_POS, {Z 850}",
    "follow_axis.src, JOV_AXIS, {A1 20}"
  })
  void withoutAHeartbeatNoProgramMovesWhoeverStartsIt(String file, String variable, String value)
      throws Exception {
    runSubmit();
    writeInt("JOV_LIMIT", 200);
    controller.step(Duration.ofMillis(500));
    assertThat(client.readText("JOV_TIMEOUT")).isEqualTo("TRUE");
    run(file);
    assertMovesOnlyWithHeartbeat(variable, value);

    controller.step(Duration.ofSeconds(1));
    assertThat(client.readText("$PRO_STATE1")).isEqualTo("#P_STOP");
    controller.robot().start();
    assertMovesOnlyWithHeartbeat(variable, value);
  }

  private void assertMovesOnlyWithHeartbeat(String variable, String value) throws IOException {
    double[] stoodAt = axes();
    client.writeText(variable, value);
    controller.step(Duration.ofSeconds(1));
    assertThat(axes()).isEqualTo(stoodAt);

    writeInt("JOV_HEARTBEAT", readInt("JOV_HEARTBEAT") + 1);
    controller.step(Duration.ofMillis(96));
    client.writeText(variable, value);
    controller.step(Duration.ofMillis(96));
    assertThat(axes()).isNotEqualTo(stoodAt);
  }

  @Test
  void theSubmitProgramSwitchesNoOutputAsItBeginsAndSaysWhenItHasThem() throws Exception {
    server.variables().set("$OUT[3]", "TRUE");
    assertThat(client.readText("JOV_OUT_READY")).isEqualTo("FALSE");

    runSubmit();

    assertThat(client.readText("JOV_OUT_READY")).isEqualTo("TRUE");
    assertThat(client.readText("JOV_OUT[3]")).isEqualTo("TRUE");
    assertThat(client.readText("$OUT[3]")).isEqualTo("TRUE");
    assertThat(client.readText("$OUT[4]")).isEqualTo("FALSE");
  }

  @Test
  void theSubmitProgramCopiesOutputsAndInputs() throws Exception {
    runSubmit();
    client.writeText("JOV_OUT[3]", "TRUE");
    server.variables().set("$IN[2]", "TRUE");
    controller.step(Duration.ofMillis(48));

    assertThat(client.readText("$OUT[3]")).isEqualTo("TRUE");
    assertThat(client.readText("JOV_IN[2]")).isEqualTo("TRUE");
    assertThat(client.readText("JOV_IN[3]")).isEqualTo("FALSE");
  }
}
