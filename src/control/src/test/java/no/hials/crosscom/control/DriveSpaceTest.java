package no.hials.crosscom.control;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import no.hials.crosscom.control.input.Input;
import org.junit.jupiter.api.Test;

class DriveSpaceTest {
  @Test
  void severalDeflectionsAtOnceAreNoFasterThanOne() {
    Input all = new Input(List.of(1.0, -1.0, 1.0, 1.0, 1.0, 1.0), List.of(), true, 0);
    Input half = new Input(List.of(0.5, 0.0, 0.0, 0.0, 0.0, -0.5), List.of(), true, 0);

    Twist twist = DriveSpace.twist(all, 30, 6);
    assertThat(twist.speed()).isCloseTo(30, within(1e-9));
    assertThat(twist.rotationSpeed()).isCloseTo(6, within(1e-9));
    assertThat(DriveSpace.twist(half, 30, 6)).isEqualTo(new Twist(15, 0, 0, -3, 0, 0));
  }
}
