package no.hials.crosscom.examples;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.time.Duration;
import no.hials.crosscom.CrossComAccessException;
import no.hials.crosscom.CrossComClient;
import no.hials.crosscom.mock.MockServer;
import no.hials.crosscom.mock.junit.KukaController;
import no.hials.crosscom.protocol.code.OperatingMode;
import no.hials.crosscom.simulator.Controller;
import org.junit.jupiter.api.Test;

class JogTheRobotTest {
  @KukaController(
      dataLists = "../krl/config.dat",
      programs = {"../krl/ext_move_axis.src", "../krl/jov_sps.sub"},
      start = "EXT_MOVE_AXIS",
      submit = "JOV_SPS",
      mode = OperatingMode.AUT,
      clock = "stepped")
  private MockServer robot;

  @Test
  void theRobotTurnsWhileTheIncrementIsNotZero() throws Exception {
    Controller controller = robot.controller();
    controller.step(Duration.ofMillis(120)); // until the program is in its loop
    try (CrossComClient client = new CrossComClient(robot.host(), robot.port())) {
      client.writeText("MYAXIS", "{A1 0.5}");
      controller.step(Duration.ofSeconds(1));
      assertThat(controller.standing()).isFalse();

      client.writeText("MYAXIS", "{A1 0.0}");
      assertThat(controller.stepUntil(controller::standing, Duration.ofSeconds(10))).isTrue();
      double steps = controller.axes().a1() / 0.5;
      assertThat(steps).isGreaterThan(10).isCloseTo(Math.rint(steps), within(0.001));
    }
  }

  @Test
  void aRefusalIsAnExceptionThatNamesTheVariable(
      @KukaController(faults = "failure@$OV_PRO", latency = "krc4") MockServer refusing)
      throws Exception {
    try (CrossComClient client = new CrossComClient(refusing.host(), refusing.port())) {
      assertThatThrownBy(() -> client.writeText("$OV_PRO", "50"))
          .isInstanceOf(CrossComAccessException.class)
          .hasMessageContaining("$OV_PRO");
    }
  }
}
