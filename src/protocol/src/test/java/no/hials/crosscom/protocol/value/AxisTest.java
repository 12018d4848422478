package no.hials.crosscom.protocol.value;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.data.Index.atIndex;

import org.junit.jupiter.api.Test;

final class AxisTest {
  private static final Axis SOME = Axis.of(1, 2, 3, 4, 5, 6);

  @Test
  void countsTheAxesFromZero() {
    for (int index = 0; index < 6; index++) {
      assertThat(SOME.get(index)).isEqualTo(index + 1);
      assertThat(SOME.with(index, 9).toArray()).hasSize(6).contains(9, atIndex(index));
    }
    assertThatExceptionOfType(IndexOutOfBoundsException.class).isThrownBy(() -> SOME.get(6));
    assertThatExceptionOfType(IndexOutOfBoundsException.class).isThrownBy(() -> SOME.with(-1, 0));
  }

  @Test
  void addsAndSubtractsAxisByAxis() {
    Axis other = Axis.of(10, 20, 30, 40, 50, 60);

    assertThat(SOME.plus(other)).isEqualTo(Axis.of(11, 22, 33, 44, 55, 66));
    assertThat(other.minus(SOME)).isEqualTo(Axis.of(9, 18, 27, 36, 45, 54));
  }

  @Test
  void theLargestDifferenceHasNoSign() {
    assertThat(SOME.largestDifference(SOME.with(3, 14).with(4, -15))).isEqualTo(20);
  }

  @Test
  void refusesAnotherNumberOfAxes() {
    assertThatIllegalArgumentException()
        .isThrownBy(() -> Axis.of(1, 2, 3))
        .withMessage("a robot has six axes, found 3");
  }

  @Test
  void refusesWhatIsNotFinite() {
    assertThatIllegalArgumentException()
        .isThrownBy(() -> SOME.with(2, Double.NaN))
        .withMessage("A3 must be finite, is NaN");
  }
}
