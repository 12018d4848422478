package no.hials.crosscom.lab.experiment;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

class ShapeTest {
  private static final double STEP = 1e-6;

  @ParameterizedTest
  @EnumSource
  void beginsAtTheOriginAndComesBackThere(Shape shape) {
    int laps = shape == Shape.SINUSOID ? 2 : 1;

    assertThat(shape.at(0)).isEqualTo(new Shape.Point(0, 0));
    assertThat(shape.at(laps).u()).isCloseTo(0, within(1e-9));
    assertThat(shape.at(laps).v()).isCloseTo(0, within(1e-9));
  }

  @ParameterizedTest
  @EnumSource
  void goesOnAsItsVelocitySays(Shape shape) {
    // not at the corners of the square, nor where the sinusoid turns round
    for (double part : new double[] {0.1, 0.3, 0.6, 0.9, 1.1, 1.9, 2.3}) {
      Shape.Point before = shape.at(part - STEP);
      Shape.Point after = shape.at(part + STEP);
      Shape.Point velocity = shape.velocity(part);

      assertThat((after.u() - before.u()) / (2 * STEP)).isCloseTo(velocity.u(), within(1e-4));
      assertThat((after.v() - before.v()) / (2 * STEP)).isCloseTo(velocity.v(), within(1e-4));
    }
  }
}
