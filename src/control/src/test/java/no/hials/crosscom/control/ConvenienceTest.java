package no.hials.crosscom.control;

import static no.hials.crosscom.kinematics.Frames.angle;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;

import java.time.Duration;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import no.hials.crosscom.control.StopReason.StopKind;
import no.hials.crosscom.kinematics.RobotModel;
import no.hials.crosscom.protocol.code.ProgramState;
import no.hials.crosscom.protocol.value.Axis;
import no.hials.crosscom.protocol.value.Frame;
import no.hials.crosscom.protocol.variable.VariableRequest.WriteRequest;
import org.junit.jupiter.api.Test;

/** The classes that write variables for the user: paths, targets and outputs. */
class ConvenienceTest extends ControlTest {
  private static final Safety AUTOMATIC = Safety.create(ControlTest::inAutomatic);
  private static final double MM = 0.01;

  private PathPlayer player() {
    return new PathPlayer(client, AUTOMATIC, time);
  }

  private void assertNothingWritten() {
    assertThat(server.requests()).noneMatch(r -> r.request() instanceof WriteRequest);
  }

  @Test
  void aPathOfAxesIsPlayedToItsEnd() throws Exception {
    run("play_path.src");
    List<Axis> points = new ArrayList<>();
    for (int i = 1; i <= 50; i++) {
      points.add(START.with(0, 20 * Math.sin(i / 8.0)).with(4, 45 + i / 5.0));
    }

    player().playAxes(points, LIMIT);

    assertThat(controller.standing()).isTrue();
    assertThat(controller.axes().largestDifference(points.get(49))).isCloseTo(0, within(0.001));
    assertThat(server.variables().get("JOV_LIMIT")).isEqualTo("0");
    player().playAxes(List.of(START), LIMIT); // a second path
    assertThat(controller.axes().largestDifference(START)).isCloseTo(0, within(0.001));
  }

  @Test
  void aPathOfPositionsIsPlayedToItsEnd() throws Exception {
    run("play_path.src");
    Frame start = position();
    List<Frame> points =
        List.of(
            start,
            Twist.linear(0, 100, 0).move(start, 1),
            Twist.linear(-50, 100, -50).move(start, 1));

    player().playPositions(points, LIMIT);

    assertThat(position().distance(points.get(2))).isCloseTo(0, within(MM));
  }

  @Test
  void aPathWithAPointOutsideTheLimitsIsNotWritten() throws Exception {
    run("play_path.src");

    assertThatExceptionOfType(ControlRefusedException.class)
        .isThrownBy(() -> player().playAxes(List.of(START, START.with(4, 119)), LIMIT))
        .withMessage("A5 must be -115 to 115 degrees (limits minus a margin of 5), would be 119");
    assertThatExceptionOfType(ControlRefusedException.class)
        .isThrownBy(() -> player().playPositions(List.of(Frame.IDENTITY), LIMIT))
        .withMessageContaining("of the workspace must be");
    assertThatIllegalArgumentException()
        .isThrownBy(() -> player().playAxes(Collections.nCopies(51, START), LIMIT))
        .withMessage("a path must have 1 to 50 points, has 51");
    assertThatIllegalArgumentException()
        .isThrownBy(() -> player().playAxes(List.of(START), Duration.ZERO))
        .withMessage("time limit of the motion must be PT0.001S to PT24H, is PT0S");
    assertNothingWritten();
  }

  @Test
  void aPathThatTakesTooLongIsStoppedByTheWatchdog() throws Exception {
    run("play_path.src");
    client.writeText("$OV_PRO", "1");

    assertThatExceptionOfType(ControlRefusedException.class)
        .isThrownBy(() -> player().playAxes(List.of(START.with(0, 90)), Duration.ofSeconds(2)))
        .withMessage("the path must end within PT2S, JOV_RESULT is still 0");

    controller.step(Duration.ofSeconds(2));
    assertThat(controller.robot().state()).isEqualTo(ProgramState.STOP);
    assertThat(controller.axes().a1()).isBetween(0.1, 60.0);
  }

  @Test
  void aTargetIsWrittenIfItIsInsideTheLimits() throws Exception {
    run("follow_axis.src");
    TargetWriter writer = new TargetWriter(client, AUTOMATIC);

    writer.writeAxes("JOV_AXIS", START.with(0, 20));
    controller.step(Duration.ofMillis(120));
    assertThat(controller.stepUntil(controller::standing, LIMIT)).isTrue();
    assertThat(controller.axes().a1()).isCloseTo(20, within(0.001));

    assertThatExceptionOfType(ControlRefusedException.class)
        .isThrownBy(() -> writer.writeAxes("JOV_AXIS", START.with(0, 166)))
        .satisfies(e -> assertThat(e.reason().kind()).isEqualTo(StopKind.AXIS_LIMIT));
    controller.step(Duration.ofSeconds(1));
    assertThat(controller.axes().a1()).isCloseTo(20, within(0.001));
  }

  @Test
  void aPositionIsWrittenIfItIsInsideTheWorkspace() throws Exception {
    run("follow_pos.src");
    TargetWriter writer = new TargetWriter(client, AUTOMATIC);
    Frame target = Twist.linear(0, 0, -100).move(position(), 1);

    writer.writePosition("JOV_POS", target);
    controller.step(Duration.ofMillis(120));
    assertThat(controller.stepUntil(controller::standing, LIMIT)).isTrue();
    assertThat(position().distance(target)).isCloseTo(0, within(MM));

    assertThatExceptionOfType(ControlRefusedException.class)
        .isThrownBy(() -> writer.writePosition("JOV_POS", Twist.linear(0, 0, -300).move(target, 1)))
        .satisfies(e -> assertThat(e.reason().kind()).isEqualTo(StopKind.WORKSPACE));
  }

  @Test
  void outputsAndInputsGoThroughTheSubmitProgram() throws Exception {
    SubmitOutputs outputs = new SubmitOutputs(client);
    outputs.setOutput(3, true);
    server.variables().set("$IN[2]", "TRUE");
    controller.step(Duration.ofMillis(48));

    assertThat(outputs.output(3)).isTrue();
    assertThat(outputs.output(4)).isFalse();
    assertThat(outputs.input(2)).isTrue();
    assertThat(outputs.input(3)).isFalse();
    assertThatIllegalArgumentException()
        .isThrownBy(() -> outputs.setOutput(17, true))
        .withMessage("a signal must be 1 to 16, is 17");
  }

  @Test
  void withoutTheSubmitProgramNoOutputIsSet() {
    controller.submit().stop();

    assertThatExceptionOfType(ControlRefusedException.class)
        .isThrownBy(() -> new SubmitOutputs(client).setOutput(3, true))
        .withMessage("$PRO_STATE0 must be #P_ACTIVE, so that JOV_SPS sets the output, is #P_STOP");
    assertNothingWritten();
  }

  @Test
  void aSubmitProgramThatBeginsDoesNotOverwriteAnOutput() throws Exception {
    server.variables().set("$OUT[4]", "TRUE");
    server.variables().set("JOV_OUT_READY", "FALSE"); // as config.dat declares it
    controller.submit().stop();
    controller.submit().reset();
    controller.submit().start();
    SubmitOutputs outputs = new SubmitOutputs(client);

    assertThatExceptionOfType(ControlRefusedException.class)
        .isThrownBy(() -> outputs.setOutput(3, true))
        .withMessage(
            "JOV_OUT_READY must be TRUE, so that JOV_SPS does not overwrite the output, is FALSE");
    assertNothingWritten();

    while (!client.readText("JOV_OUT_READY").equals("TRUE")) {
      controller.step(Duration.ofMillis(12));
    }
    outputs.setOutput(3, true);
    controller.step(Duration.ofMillis(48));
    assertThat(outputs.output(3)).isTrue();
    assertThat(outputs.output(4)).isTrue();
  }

  @Test
  void aLawWithItsOwnInverseKinematicsFollowsALine() throws Exception {
    run("ext_move_axis.src");
    RobotModel robot = RobotModel.kr6r900sixx();
    DampedLeastSquares solver = new DampedLeastSquares(robot, 0.1);
    Frame start = robot.forward(START);
    Twist along = Twist.linear(0, 20, -10);
    Law law =
        Law.jointVelocity(
            s -> {
              Twist error = Twist.between(robot.forward(s.axes()), along.move(start, s.time()));
              return solver.velocity(s.axes(), along.plus(error.times(2)));
            });

    StopReason reason = runLoop(config(cfg -> cfg.duration(Duration.ofSeconds(4))), law);

    assertThat(reason.kind()).isEqualTo(StopKind.TIME_OVER);
    Frame wanted = along.move(start, 4);
    assertThat(robot.forward(controller.axes()).distance(wanted)).isLessThan(5);
    assertThat(angle(robot.forward(controller.axes()), wanted)).isLessThan(0.5);
  }
}
