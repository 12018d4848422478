package no.hials.crosscom.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.stream.Stream;
import no.hials.crosscom.cli.base.PseudoTerminal;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;

/** Runs {@code mock} on a terminal. */
@Timeout(120)
@EnabledOnOs(OS.LINUX)
class TerminalIT {
  /** Runs it until a text is there, presses Ctrl-C, and returns the whole output. */
  private static String show(String term, String until, String... options) throws Exception {
    String[] args =
        Stream.concat(Stream.of("mock", "--port", "0", "--no-discovery"), Stream.of(options))
            .toArray(String[]::new);
    PseudoTerminal.Shown shown = PseudoTerminal.run(term, until, PseudoTerminal.CTRL_C, args);
    assertThat(shown.code()).as(shown.text()).isZero();
    return shown.text();
  }

  @Test
  void showsAStatusLineWithoutWrappingAndTakesItAwayOnCtrlC() throws Exception {
    assertThat(show("xterm", "requests 0"))
        .containsPattern(
            "\u001B\\[\\?7l\\d+\\.\\d s \\| T1, no program \\|[^\n]*\u001B\\[K\u001B\\[\\?7h\r")
        .endsWith("\r\u001B[K");
  }

  @Test
  void writesNoControlSequencesOnADumbTerminal() throws Exception {
    assertThat(show("dumb", "T1, no program\r\n")).doesNotContain("\u001B");
  }

  @Test
  void hasNoStatusLineInALog() throws Exception {
    assertThat(show("xterm", "T1, no program\r\n", "--verbose")).doesNotContain("\u001B");
  }
}
