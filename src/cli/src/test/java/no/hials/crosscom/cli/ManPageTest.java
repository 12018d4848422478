package no.hials.crosscom.cli;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assumptions.assumeThat;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import no.hials.crosscom.cli.base.CommandTree;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import picocli.CommandLine.Model.CommandSpec;

class ManPageTest {
  private static final Path GROFF = Path.of("/usr/bin/groff");

  @TempDir private Path dir;

  @Test
  void keepsLinesThatWouldBeMacros() {
    CommandSpec command = CommandSpec.create().name("x");
    command.usageMessage().description(".SH is text", "", "  'quoted' \\x0A a-b");

    assertThat(ManPage.of(command, "1"))
        .contains("\n\\&.SH is text\n", "\n\\&\\(aqquoted\\(aq \\ex0A a\\-b\n");
  }

  @Test
  void isAPageOfEachCommandThatGroffSetsWithoutWarning() throws Exception {
    assumeThat(Files.isExecutable(GROFF)).isTrue();
    for (CommandSpec command :
        CommandTree.withAllBelow(Documents.commands().getCommandSpec()).toList()) {
      Path page = dir.resolve(ManPage.name(command) + ".1");
      Files.writeString(page, ManPage.of(command, "1.0"));

      Process groff =
          new ProcessBuilder(GROFF.toString(), "-man", "-Tutf8", "-ww", page.toString())
              .redirectErrorStream(true)
              .start();
      List<String> lines = groff.inputReader().lines().toList();

      assertThat(groff.waitFor()).isZero();
      assertThat(lines)
          .noneMatch(line -> line.contains(": warning"))
          .anyMatch(line -> line.contains(ManPage.name(command)));
    }
  }
}
