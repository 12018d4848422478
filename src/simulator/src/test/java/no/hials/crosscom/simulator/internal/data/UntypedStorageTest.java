package no.hials.crosscom.simulator.internal.data;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.catchThrowableOfType;

import java.util.Map;
import no.hials.crosscom.lang.Position;
import no.hials.crosscom.protocol.value.KrlInt;
import no.hials.crosscom.protocol.value.KrlString;
import no.hials.crosscom.protocol.value.KrlValue;
import no.hials.crosscom.simulator.Refusal;
import no.hials.crosscom.simulator.RefusedException;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Variables of unknown type. */
class UntypedStorageTest {
  private final Scope scope = new Scope();

  @BeforeEach
  void declare() throws KrlErrorException {
    scope.declareUntyped("$NEW", new Position("x", 1, 1));
  }

  private void write(String name, String value) throws RefusedException {
    scope.write(VariablePath.parse(name), KrlValue.parse(value), Scope.Writer.PROGRAM);
  }

  private String print(String name) throws RefusedException {
    return scope.print(VariablePath.parse(name));
  }

  private Refusal refusal(String name) {
    RefusedException e = catchThrowableOfType(RefusedException.class, () -> print(name));
    return e.reason();
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '`',
      value = {
        "$NEW | 5 | 5",
        "$NEW | 2.5 | 2.50000",
        "$NEW | TRUE | TRUE",
        "$NEW | #STEP7 | #STEP7",
        "$NEW[] | \"text\" | \"text\"",
        "$NEW[2] | 7 | 7",
        "$NEW[2,3].PART[4] | 7 | 7",
        "$NEW[1,] | \"row\" | \"row\"",
        "$NEW | {X 1,NAME[] \"a\"} | {X 1, NAME[] \"a\"}",
        "$NEW | {MSG_T: VALID TRUE,CODE {N 1}} | {MSG_T: VALID TRUE, CODE {N 1}}",
      })
  void keepTheValueThatIsWritten(String name, String value, String printed)
      throws RefusedException {
    write(name, value);
    assertThat(print(name)).isEqualTo(printed);
    write(name, value);
    assertThat(print(name)).isEqualTo(printed);
  }

  @ParameterizedTest
  @ValueSource(strings = {"$NEW", "$NEW[]", "$NEW[1]", "$NEW.X"})
  void haveNoValueBeforeAWrite(String name) {
    assertThat(refusal(name)).isEqualTo(Refusal.NOT_INITIALISED);
  }

  @Test
  void keepTheOtherPartsInAWrite() throws RefusedException {
    write("$NEW.X", "1");
    write("$NEW", "{Y 2}");
    write("$NEW.z[10]", "10");
    write("$NEW.Z[2]", "3");
    assertThat(print("$NEW")).isEqualTo("{X 1, Y 2, Z[2] 3, Z[10] 10}");
    assertThat(print("$NEW.Z[]")).isEqualTo("3 10 ");
    assertThat(refusal("$NEW.Z[3]")).isEqualTo(Refusal.NOT_INITIALISED);
  }

  @Test
  void takeTheTypeOfTheLastValue() throws RefusedException {
    write("$NEW", "1");
    write("$NEW", "0.5");
    assertThat(print("$NEW")).isEqualTo("0.500000");
    write("$NEW[3]", "#A");
    assertThat(refusal("$NEW.X")).isEqualTo(Refusal.NOT_INITIALISED);
    assertThat(print("$NEW[]")).isEqualTo("#A ");
    write("$NEW[4]", "TRUE");
    assertThat(refusal("$NEW[]")).isEqualTo(Refusal.WHOLE_ARRAY);
    write("$NEW.X", "2");
    assertThat(print("$NEW")).isEqualTo("{X 2}");
  }

  @Test
  void takeMemoryOfTheVariables() throws Exception {
    Scope small = new Scope(20_000);
    small.declareUntyped("$NEW", new Position("x", 1, 1));
    int written = 0;
    RefusedException refused = null;
    for (int i = 1; refused == null; i++) {
      VariablePath element = VariablePath.element("$NEW", i);
      try {
        small.write(element, new KrlInt(i), Scope.Writer.PROGRAM);
        written = i;
      } catch (RefusedException e) {
        refused = e;
      }
    }
    assertThat(refused.getMessage()).contains("at most 20000 bytes of memory");
    assertThat(small.bytes()).isBetween(15_000L, 20_000L);
    assertThat(small.print(VariablePath.element("$NEW", written))).isEqualTo("" + written);
    small.write(VariablePath.of("$NEW"), new KrlString("x"), Scope.Writer.PROGRAM);
    assertThat(small.bytes()).isLessThan(1_000);
  }

  @Test
  void haveALimitedNumberOfParts() throws RefusedException {
    for (int i = 1; i <= UntypedStorage.MAX_PARTS; i++) {
      write("$NEW[" + i + "]", "1");
    }
    RefusedException e =
        catchThrowableOfType(RefusedException.class, () -> write("$NEW[4097]", "1"));
    assertThat(e.reason()).isEqualTo(Refusal.OUT_OF_RANGE);
    write("$NEW[4096]", "2");
  }

  @Test
  void areSavedAsAssignments() throws RefusedException {
    write("$NEW.NAME[]", "\"a\"");
    write("$NEW.LIST[2].X", "0.1");
    String saved = DataListWriter.write("$X", scope, null, Map.of());
    assertThat(saved).contains("\r\n$NEW.NAME[]=\"a\"\r\n$NEW.LIST[2].X=0.1\r\n");
  }
}
