package no.hials.crosscom.web.internal.jog;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import no.hials.crosscom.control.DriveSpace;
import no.hials.crosscom.control.State;
import no.hials.crosscom.control.input.Input;
import no.hials.crosscom.protocol.value.Axis;
import no.hials.crosscom.protocol.value.Frame;
import org.junit.jupiter.api.Test;

class JogStepTest {
  private static final double FULL_SPEED = 100;

  private static State at(double z, double incrementFactor) {
    return new State(0, 0.02, Axis.ZERO, new Frame(0, 0, z, 0, 0, 0), incrementFactor, Input.NONE);
  }

  private static JogStep step(double speed, double step) {
    return new JogStep(DriveSpace.BASE, new Press(1, 2, true, speed, step), at(500, 1));
  }

  @Test
  void theIncrementsAtTheEndOfAStepHaveTheSameLengthWithALowOverride() {
    JogStep step = step(1, 1);

    double full = step.deflection(at(500.5, 1), FULL_SPEED);
    double low = step.deflection(at(500.5, 0.3), FULL_SPEED);

    assertThat(full).isEqualTo(0.05, within(1e-9));
    assertThat(low * 0.3).isEqualTo(full, within(1e-9));
  }

  @Test
  void aStepIsNotFasterThanThePress() {
    JogStep step = step(0.2, 10);

    assertThat(step.deflection(at(501, 0.3), FULL_SPEED)).isEqualTo(0.2);
    assertThat(step.deflection(at(501, 0), FULL_SPEED)).isEqualTo(0.2);
  }

  @Test
  void aStepEndsWhereItsDistanceIsPassed() {
    JogStep step = step(1, 1);

    assertThat(step.deflection(at(501, 1), FULL_SPEED)).isZero();
    assertThat(step.deflection(at(501.2, 0), FULL_SPEED)).isZero();
  }
}
