package no.hials.crosscom.simulator;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

/** The torques, currents and temperatures of the motors, which are invented. */
class MotorLoadTest {
  private final Cell cell = new Cell();

  @AfterEach
  void close() {
    cell.close();
  }

  @Test
  void torqueAndCurrentFollowSpeedAndAcceleration() throws Exception {
    cell.cycles(1);
    assertThat(cell.real("$TORQUE_AXIS_ACT[1]")).isZero();
    assertThat(cell.real("$CURR_ACT[1]")).isZero();

    cell.start("PTP {A1 160}");
    cell.cycles(10);
    assertThat(cell.real("$CURR_ACT[1]")).isGreaterThan(60);
    assertThat(cell.real("$CURR_ACT[2]")).isZero();

    cell.cycles(25);
    assertThat(cell.real("$VEL_AXIS_ACT[1]")).isEqualTo(100, within(1.0));
    assertThat(cell.real("$CURR_ACT[1]")).isEqualTo(20, within(0.5));
    assertThat(cell.real("$TORQUE_AXIS_ACT[1]")).isEqualTo(120, within(3.0));

    cell.untilStanding();
    cell.cycles(2);
    assertThat(cell.real("$TORQUE_AXIS_ACT[1]")).isZero();
  }

  @Test
  void theSignsAreThoseOfTheMotion() throws Exception {
    cell.start("PTP {A1 -160}");
    cell.cycles(35);

    assertThat(cell.real("$CURR_ACT[1]")).isEqualTo(-20, within(0.5));
    assertThat(cell.real("$TORQUE_AXIS_ACT[1]")).isNegative();
  }

  @Test
  void aMotorThatWorksGetsWarmAndCoolsDownAgain() throws Exception {
    int before = Integer.parseInt(cell.get("$MOT_TEMP[1]"));
    int still = Integer.parseInt(cell.get("$MOT_TEMP[2]"));
    cell.start("LOOP\nPTP {A1 20}\nPTP {A1 0}\nENDLOOP");
    cell.seconds(60);
    assertThat(Integer.parseInt(cell.get("$MOT_TEMP[1]"))).isGreaterThan(before + 5);
    assertThat(Integer.parseInt(cell.get("$MOT_TEMP[2]"))).isEqualTo(still);

    cell.controller.robot().stop();
    cell.seconds(600);
    assertThat(Integer.parseInt(cell.get("$MOT_TEMP[1]"))).isEqualTo(before);
  }
}
