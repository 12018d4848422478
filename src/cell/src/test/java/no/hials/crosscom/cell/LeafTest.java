package no.hials.crosscom.cell;

import static org.assertj.core.api.Assertions.assertThat;

import no.hials.crosscom.protocol.value.KrlValue;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class LeafTest {

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '`',
      value = {
        "$OV_PRO       | 100                       | $OV_PRO=100",
        "$OV_PRO       | 1.50000                   | $OV_PRO=1.50000",
        "$MODE_OP      | #T1                       | $MODE_OP=#T1",
        "$MODEL_NAME[] | \"KR 6\"                  | $MODEL_NAME[]=KR 6",
        "P             | {FRAME: X 1.0, Y 2.50000} | P.X=1.00000 P.Y=2.50000",
        "P             | {FRAME: }                 | ``",
        "S             | {A {B 1, C TRUE}, D #ON}  | S.A.B=1 S.A.C=TRUE S.D=#ON",
        "S             | {N[] \"a\", M[] 1 2}      | S.N[]=a S.M[1]=1 S.M[2]=2",
        "A[]           | `1.0 2.0 `                | A[1]=1.00000 A[2]=2.00000",
        "A[]           | 1                         | A[1]=1",
        "A[2,]         | `7 8 `                    | A[2,1]=7 A[2,2]=8",
        "A             | `7 8 `                    | A[1]=7 A[2]=8"
      })
  void unfoldsAValueIntoNumbersAndTextsUnderTheNamesThatReadThem(
      String name, String value, String leaves) {
    assertThat(
            Leaf.of(name, KrlValue.parse(value)).stream()
                .map(leaf -> leaf.name() + "=" + leaf.text()))
        .containsExactly(leaves.isEmpty() ? new String[0] : leaves.split(" (?=[A-Z$]+\\W)"));
  }

  @Test
  void keepsTheDigitsOfTheController() {
    assertThat(Leaf.of("R", KrlValue.parse("27.0000057")).get(0).text()).isEqualTo("27.0000057");
  }
}
