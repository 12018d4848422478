package no.hials.crosscom.cell.feed;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.stream.Collectors;
import java.util.stream.IntStream;
import no.hials.crosscom.protocol.value.KrlValue;
import org.junit.jupiter.api.Test;

class KnownPartsTest {
  private final KnownParts parts = new KnownParts();

  /** Returns a structure with a number of fields that others do not have. */
  private static String structure(String prefix, int fields, String value) {
    return IntStream.range(0, fields)
        .mapToObj(i -> prefix + i + " " + value)
        .collect(Collectors.joining(", ", "{MYS: ", "}"));
  }

  private String add(String value) {
    return parts.add(KrlValue.parse(value));
  }

  @Test
  void aVariableHasAtMostAThousandFieldsInAllItsReadings() {
    assertThat(add(structure("A", 600, "1"))).isEmpty();

    assertThat(add(structure("B", 401, "1")))
        .isEqualTo("has more than 1000 fields, with those of earlier readings");

    assertThat(add(structure("A", 600, "2"))).isEmpty();
    assertThat(add(structure("C", 400, "1"))).isEmpty();
    assertThat(add(structure("D", 1, "1"))).isNotEmpty();
  }

  @Test
  void structuresInAStructureCountEvenWithoutFields() {
    assertThat(add(structure("A", 1001, "{B: }"))).isNotEmpty();
    assertThat(add(structure("A", 501, "{B: X 1}"))).isNotEmpty();
    assertThat(add(structure("A", 500, "{B: X 1}"))).isEmpty();
  }

  @Test
  void allInputsOfAControllerAreAllowedButNotAnyNumberOfElements() {
    assertThat(add("TRUE ".repeat(8192))).isEmpty();
    assertThat(add("1 ".repeat(10_000))).isEmpty();
    assertThat(add("1 ".repeat(10_001))).isEqualTo("has arrays with more than 10000 elements");
    assertThat(add("{MYS: A[] 1 2}")).isNotEmpty();
  }

  @Test
  void namesHaveAtMost250Characters() {
    String longest = "N".repeat(249);
    assertThat(add("{MYS: " + longest + " 1}")).isEmpty();
    assertThat(add("{MYS: " + longest + "N 1}"))
        .isEqualTo("has a field whose name has more than 250 characters");
  }
}
