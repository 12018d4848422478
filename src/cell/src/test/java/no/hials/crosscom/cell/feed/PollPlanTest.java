package no.hials.crosscom.cell.feed;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import no.hials.crosscom.cell.FileException;
import no.hials.crosscom.cell.TomlTable;
import no.hials.crosscom.protocol.value.KrlInt;
import no.hials.crosscom.protocol.value.KrlSyntaxException;
import no.hials.crosscom.protocol.value.KrlValue;
import org.junit.jupiter.api.Test;

class PollPlanTest {
  private static PollPlan plan(String server, String groups) throws FileException {
    String robot = "[robots.cell1]\nhost = \"192.0.2.1\"\n" + server + "\n";
    TomlTable file = TomlTable.parse(Path.of("plant.toml"), robot + groups);
    return PlantFile.read(file, Map.of()).plans().get(0);
  }

  private static final String FIELDS =
      """
      [groups.fast]
      variables = ["$POS_ACT.X", "$pos_act.Y", "$AXIS_ACT.A1", "$OV_PRO", "$IN[3]"]
      period = "100ms"

      [groups.slow]
      variables = ["$POS_ACT.Z", "$OV_PRO", "$MODE_OP"]
      period = "1s"
      """;

  @Test
  void twoFieldsOfOneStructureAreReadByTheStructure() throws FileException {
    assertThat(plan("", FIELDS).reads())
        .containsExactly(
            Map.entry(
                Duration.ofMillis(100), List.of("$POS_ACT", "$AXIS_ACT.A1", "$OV_PRO", "$IN[3]")),
            Map.entry(Duration.ofSeconds(1), List.of("$POS_ACT.Z", "$MODE_OP")));
  }

  @Test
  void kukavarproxyNeedsAnAccessForEachVariable() throws FileException {
    PollPlan plan = plan("server = \"kukavarproxy\"", FIELDS);

    assertThat(plan.accessesPerSecond()).isCloseTo(42, within(1e-9));
    assertThat(plan.load()).isCloseTo(21, within(1e-9));
    assertThat(plan.text())
        .isEqualTo("cell1: 7 variables every 100 ms and 1000 ms, 42.0 accesses/s, 21 % load");
  }

  @Test
  void c3BridgeNeedsAnAccessForEachPeriod() throws FileException {
    assertThat(plan("server = \"c3\"", FIELDS).accessesPerSecond()).isCloseTo(11, within(1e-9));
  }

  @Test
  void anUnknownServerIsTakenForKukavarproxy() throws FileException {
    assertThat(plan("", FIELDS).text())
        .contains("42.0 accesses/s, 21 % load with KUKAVARPROXY, less with C3 Bridge");
  }

  @Test
  void aVariableTakesItsPartOfTheStructure() throws FileException, KrlSyntaxException {
    PlannedVariable x = plan("", FIELDS).variables().get("$POS_ACT.X");

    assertThat(x.in(KrlValue.parse("{E6POS: X 5,Y 6}"))).contains(new KrlInt(5));
    assertThat(x.in(KrlValue.parse("{E6POS: Y 6}"))).isEmpty();
    assertThat(x.in(KrlValue.parse("7"))).isEmpty();
  }
}
