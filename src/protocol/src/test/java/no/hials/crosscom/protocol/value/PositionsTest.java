package no.hials.crosscom.protocol.value;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.assertThatNullPointerException;

import org.junit.jupiter.api.Test;

final class PositionsTest {
  private static final E6Pos E6POS = new E6Pos(1, 2, 3, 4, 5, 6, 2, 34, 7, 8, 9, 10, 11, 12);

  @Test
  void aPositionHasItsParts() {
    assertThat(E6POS.pos()).isEqualTo(new Pos(1, 2, 3, 4, 5, 6, 2, 34));
    assertThat(E6POS.frame()).isEqualTo(new Frame(1, 2, 3, 4, 5, 6));
    assertThat(E6POS.pos().frame()).isEqualTo(E6POS.frame());
    assertThat(new E6Axis(1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12).axis())
        .isEqualTo(new Axis(1, 2, 3, 4, 5, 6));
  }

  @Test
  void minusZeroIsZeroAsOnTheController() {
    assertThat(new Frame(-0.0, 0, 0, 0, 0, -0.0)).isEqualTo(Frame.IDENTITY);
    assertThat(new Axis(0, -0.0, 0, 0, 0, 0)).isEqualTo(Axis.ZERO);
    assertThat(new Load(-0.0, Frame.IDENTITY, new Load.Inertia(0, 0, -0.0)))
        .isEqualTo(new Load(0, Frame.IDENTITY, new Load.Inertia(0, 0, 0)));
  }

  @Test
  void refusesNumbersThatNoControllerHas() {
    assertThatIllegalArgumentException()
        .isThrownBy(() -> new Pos(0, 0, 0, 0, Double.NaN, 0, 2, 0))
        .withMessage("B must be finite, is NaN");
    assertThatIllegalArgumentException()
        .isThrownBy(() -> new E6Pos(0, 0, 0, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 1 / 0.0))
        .withMessage("E6 must be finite, is Infinity");
    assertThatIllegalArgumentException()
        .isThrownBy(() -> new E6Axis(0, 0, -1 / 0.0, 0, 0, 0, 0, 0, 0, 0, 0, 0))
        .withMessage("A3 must be finite, is -Infinity");
    assertThatNullPointerException().isThrownBy(() -> new Load(1, Frame.IDENTITY, null));
  }
}
