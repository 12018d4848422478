package no.hials.crosscom.cell;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class CatalogueTest {
  private static List<SignalWires> signals(String... declarations) {
    return Catalogue.of("DEFDAT CELL PUBLIC\n" + String.join("\n", declarations) + "\nENDDAT\n")
        .signals();
  }

  @Test
  void signalsAreListedByArrayAndNumber() {
    assertThat(
            signals(
                "SIGNAL Part $out[9] TO $OUT[16]",
                "SIGNAL GRIPPER $OUT[9]",
                "SIGNAL DOOR $IN[10]",
                "SIGNAL CODE $OUT[2] TO $OUT[2]"))
        .containsExactly(
            new SignalWires("$IN", 10, 10, List.of("DOOR")),
            new SignalWires("$OUT", 2, 2, List.of("CODE")),
            new SignalWires("$OUT", 9, 9, List.of("GRIPPER")),
            new SignalWires("$OUT", 9, 16, List.of("Part")));
  }

  @Test
  void signalsOfTheSameElementsShareAnEntry() {
    assertThat(signals("SIGNAL OPEN $OUT[5]", "SIGNAL GRIPPER $OUT[5]", "SIGNAL OPEN $OUT[5]"))
        .containsExactly(new SignalWires("$OUT", 5, 5, List.of("GRIPPER", "OPEN")));
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "SIGNAL S FALSE",
        "SIGNAL S $OUT",
        "SIGNAL S $OUT[N]",
        "SIGNAL S $OUT[1,2]",
        "SIGNAL S A.B[1]",
        "SIGNAL S $OUT[1] TO $OUT[N]",
        "SIGNAL S $OUT[1] TO $IN[8]",
        "SIGNAL S $OUT[8] TO $OUT[1]"
      })
  void signalsWithoutNumbersOfOneArrayAreLeftOut(String declaration) {
    assertThat(signals(declaration, "SIGNAL GRIPPER $OUT[5]"))
        .containsExactly(new SignalWires("$OUT", 5, 5, List.of("GRIPPER")));
  }
}
