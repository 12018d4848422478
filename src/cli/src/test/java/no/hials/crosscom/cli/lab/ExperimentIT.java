package no.hials.crosscom.cli.lab;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import no.hials.crosscom.cli.base.PseudoTerminal;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;

/** Ends experiments of the jar early. */
@Timeout(120)
@EnabledOnOs(OS.LINUX)
class ExperimentIT {
  @TempDir private Path folder;

  private String[] experiment(String name) {
    return new String[] {
      "experiment", name, "--latency", "none", "--for", "20s", "--csv", "--out", folder.toString()
    };
  }

  @Test
  void showsHowFarItIsAndKeepsWhatItHasAfterCtrlC() throws Exception {
    try (PseudoTerminal terminal =
        PseudoTerminal.start(Map.of(), "exec %s", experiment("position-circle"))) {
      terminal.until("position-circle: starting the robot");
      terminal.until("position-circle: warming up, ").until(" of 2.0 s");
      terminal.until("position-circle: measuring, 1.").until(" of 20.0 s");
      terminal.type(PseudoTerminal.CTRL_C);
      PseudoTerminal.Shown shown = terminal.end();

      assertThat(shown.code()).as(shown.text()).isEqualTo(130);
      assertThat(shown.text())
          .contains("wrote " + folder.resolve("position-circle.png"))
          .contains("position-circle: stopped; the files have what was measured until then")
          .doesNotContain("tracking error");
    }
    assertThat(folder.resolve("position-circle.png")).isNotEmptyFile();
    assertThat(Files.readAllLines(folder.resolve("position-circle.csv"))).hasSizeBetween(10, 2000);
  }

  @Test
  void keepsTheFirstOfTwoLoops() throws Exception {
    try (PseudoTerminal terminal =
        PseudoTerminal.start(Map.of(), "exec %s", experiment("line-dls"))) {
      terminal.until("line-dls: measuring, krc, 1.").type(PseudoTerminal.CTRL_C);

      assertThat(terminal.end().code()).isEqualTo(130);
    }
    assertThat(folder.resolve("line-dls.png")).isNotEmptyFile();
    assertThat(folder.resolve("line-dls-krc-figures.csv")).isNotEmptyFile();
    assertThat(folder.resolve("line-dls-dls.csv")).doesNotExist();
  }

  @Test
  void leavesNoFilesIfNothingWasMeasured() throws Exception {
    try (PseudoTerminal terminal =
        PseudoTerminal.start(Map.of(), "exec %s", experiment("position-circle"))) {
      terminal.until("position-circle: warming up").type(PseudoTerminal.CTRL_C);
      PseudoTerminal.Shown shown = terminal.end();

      assertThat(shown.code()).as(shown.text()).isEqualTo(130);
      assertThat(shown.text()).contains("jopenshowvar: stopped");
    }
    assertThat(folder).isEmptyDirectory();
  }
}
