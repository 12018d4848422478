package no.hials.crosscom.cell.feed;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import no.hials.crosscom.cell.FileException;
import no.hials.crosscom.cell.TomlTable;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class PlantFileTest {
  private static final String ROBOT = "[robots.cell1]\nhost = \"192.0.2.1\"\n";

  private static Plant read(String text) throws FileException {
    return PlantFile.read(TomlTable.parse(Path.of("plant.toml"), text), Map.of());
  }

  @Test
  void readsGroupsAndSettings() throws FileException {
    Plant plant =
        read(
            ROBOT
                + """
                [limits]
                access-time = "8ms"
                load = 20

                [groups.motion]
                robots = ["cell1"]
                variables = ["$POS_ACT", "MYREAL"]
                period = "250ms"
                on-change = true
                dead-band = 0.05

                [variables.MYREAL]
                unit = "bar"
                range = [-1, 1.5]
                write = true
                dead-band = 1
                """);

    assertThat(plant.accessTime()).isEqualTo(Duration.ofMillis(8));
    assertThat(plant.maxLoad()).isEqualTo(20);
    assertThat(plant.groups())
        .containsExactly(
            new Group(
                "motion",
                List.of("cell1"),
                List.of("$POS_ACT", "MYREAL"),
                Duration.ofMillis(250),
                true,
                0.05));
    assertThat(plant.settings("myreal"))
        .isEqualTo(new VariableSettings("MYREAL", "bar", 1.0, new Range(-1, 1.5), List.of(), true));
  }

  @Test
  void aPlantWithoutGroupsHasTheDefaultOnes() throws FileException {
    assertThat(read(ROBOT).groups()).isEqualTo(PlantFile.DEFAULT_GROUPS);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "[groups.a]\\nvariables = [\"A\"] | 3: groups.a: a group needs a period",
        "[groups.a]\\nperiod = 100 | 3: groups.a.variables: name at least one variable",
        "[groups.a]\\n"
            + "variables = \"A\"\\n"
            + "period = 1 | 4: groups.a.variables: must be a list of texts in quotes",
        "[groups.a]\\nvariables = [\"A\", 1]\\nperiod = 1 | 4: groups.a.variables: must be a list",
        "[groups.a]\\n"
            + "variables = [\"A\", \"a\"]\\n"
            + "period = 1 | 4: groups.a.variables: a variable can",
        "[groups.a]\\nvariables = [\"A\"]\\nperiod = \"x\" | 5: groups.a.period: must be like 500",
        "[groups.a]\\nvariables = [\"A\"]\\nperiod = 0 | 5: groups.a.period: must be 1ms or more",
        "[groups.a]\\nvariables = [\"A\"]\\nperiod = \"2000min\" | 5: groups.a.period: must be at",
        "[groups.a]\\nvariables = [\"A\"]\\nperiod = 1\\ndead-band = -1 | 6: groups.a.dead-band",
        "[groups.a]\\nrobots = [\"b\"]\\nperiod = 1 | 4: groups.a.robots: no robot is named b",
        "[groups.a]\\nrobots = []\\nperiod = 1 | 4: groups.a.robots: name at least one robot",
        "[groups.a]\\nvars = 1 | 4: groups.a.vars: no such key; known: robots, variables",
        "[variables.A]\\nwrite = true | 4: variables.A.write: needs the range of the numbers",
        "[variables.A]\\nrange = [1] | 4: variables.A.range: must be two numbers",
        "[variables.A]\\nrange = [2, 1] | 4: variables.A.range: must be two numbers, the lower one",
        "[variables.A]\\n"
            + "range = [nan, 1] | 4: variables.A.range: must be two numbers, the lower one",
        "[variables.A]\\nvalues = ['\"B\"'] | 4: variables.A.values: must be texts without a double",
        "[groups.a]\\n"
            + "variables = [\"A\"]\\n"
            + "period = 1\\n"
            + "dead-band = 1 | 6: groups.a.dead-band: needs on-change = true",
        "[variables.A]\\n[variables.a] | variables.a: the variable is there twice",
        "[limits]\\nload = 0 | 4: limits.load: must be more than 0 and at most 100 %, is 0",
        "[limits]\\nload = \"5\" | 4: limits.load: must be a number, without quotes",
      })
  void saysWhereTheFileIsWrong(String text, String message) {
    assertThatThrownBy(() -> read(ROBOT + text.replace("\\n", "\n") + "\n"))
        .isInstanceOf(FileException.class)
        .hasMessageStartingWith("plant.toml")
        .hasMessageContaining(message);
  }

  @Test
  void aPlantNeedsARobot() {
    assertThatThrownBy(() -> read(""))
        .hasMessage("plant.toml: there is no robot: add a table [robots.NAME]");
  }
}
