package no.hials.crosscom.cli;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assumptions.assumeThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class CompletionTest {
  private static final Path BASH = Path.of("/bin/bash");
  private static final Path FISH = Path.of("/usr/bin/fish");

  @TempDir private Path dir;

  @BeforeEach
  void writeConfiguration() throws IOException {
    Files.writeString(
        dir.resolve("config.toml"),
        """
        default = "cell1"
        [robots.cell1]
        host = "172.31.1.147"
        [ robots."cell-2" ]
        mock = true
        """);
  }

  private List<String> run(String... command) throws IOException, InterruptedException {
    ProcessBuilder builder = new ProcessBuilder(command).redirectErrorStream(true);
    builder.environment().put("JOPENSHOWVAR_CONFIG", dir.resolve("config.toml").toString());
    Process process = builder.start();
    List<String> lines = process.inputReader().lines().toList();
    assertThat(process.waitFor()).as(lines.toString()).isZero();
    return lines;
  }

  private List<String> inBash(String words) throws IOException, InterruptedException {
    assumeThat(Files.isExecutable(BASH)).isTrue();
    Path script = dir.resolve("completion.bash");
    Files.writeString(script, Completion.bash(Documents.commands()));
    return run(
        BASH.toString(),
        "-c",
        """
        source "$0"
        COMP_WORDS=(${1//@/@ }); [[ $1 == *' ' ]] && COMP_WORDS+=('')
        COMP_CWORD=$(( ${#COMP_WORDS[@]} - 1 ))
        COMP_LINE=$1; COMP_POINT=${#1}
        _jopenshowvar_or_robot jopenshowvar "${1##* }"
        printf '%s\\n' "${COMPREPLY[@]}"
        """,
        script.toString(),
        words);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "jopenshowvar re                 | read",
        "jopenshowvar read --ti          | --timeout",
        "jopenshowvar mock --no          | --no-discovery",
        "jopenshowvar mock --mode A      | AUT",
        "jopenshowvar read --server k    | kukavarproxy",
        "jopenshowvar read @cell1        | @cell1",
        "jopenshowvar read @cell-        | @cell-2",
        "jopenshowvar read --robot cell- | cell-2"
      })
  void completesInBash(String words, String candidate) throws Exception {
    assertThat(inBash(words)).contains(candidate);
  }

  @Test
  void givesAllRobotsBehindTheAtSign() throws Exception {
    assertThat(inBash("jopenshowvar read @")).containsExactly("@cell1", "@cell-2");
  }

  @Test
  void isAScriptForFish() throws Exception {
    assumeThat(Files.isExecutable(FISH)).isTrue();
    Path script = dir.resolve("jopenshowvar.fish");
    Files.writeString(script, Completion.fish(Documents.commands().getCommandSpec()));

    assertThat(
            run(
                FISH.toString(),
                "-c",
                "source " + script + "; complete -C 'jopenshowvar read --ti'"))
        .anyMatch(line -> line.startsWith("--timeout"));
  }

  @Test
  void saysOfEachCommandInFishWhatItIsAndWhereItsOptionsBelong() {
    assertThat(Completion.fish(Documents.commands().getCommandSpec()).lines())
        .contains(
            "complete -c jopenshowvar -n '__fish_seen_subcommand_from mock' -l config -r -F"
                + " -d 'Load a data list, such as $CONFIG.DAT.'")
        .anyMatch(
            line -> line.matches(".* -n 'not __fish_seen_subcommand_from .*' -a read -d '.*'"));
  }
}
