package no.hials.crosscom.cli.shell;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class ShellTerminalTest {
  @Test
  void keepsTheHistoryInTheFolderOfXdg(@TempDir Path folder) {
    assertThat(ShellTerminal.history(folder.toString()))
        .isEqualTo(folder.resolve("jopenshowvar").resolve("history"));
  }

  @Test
  void ignoresARelativeFolderOfXdg() {
    assertThat(ShellTerminal.history("state")).isAbsolute().isEqualTo(ShellTerminal.history(null));
  }
}
