package no.hials.crosscom.cli;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.StreamSupport;
import no.hials.crosscom.cli.base.CommandTree;
import picocli.AutoComplete;
import picocli.CommandLine;
import picocli.CommandLine.Model.ArgSpec;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Model.OptionSpec;

/** Scripts that complete commands, options, their values, and robots in a shell. */
final class Completion {
  private static final String PROGRAM = "jopenshowvar";

  /** Prints the robots of the configuration file; the same in each shell. */
  private static final String ROBOTS =
      """
      sed -n 's/^[[:space:]]*\\[[[:space:]]*robots\\.["'\\'']\\{0,1\\}\\([A-Za-z0-9_.-]*\\).*/\\1/p'\
      """;

  private Completion() {}

  /** Creates the script for bash, which also works in zsh. */
  static String bash(CommandLine main) {
    return """
        # Completion of jopenshowvar for bash and zsh: source this file in ~/.bashrc or ~/.zshrc.
        """
        + AutoComplete.bash(PROGRAM, main)
        + """

        # @NAME, a robot of the configuration file, before what is made from the commands
        function _jopenshowvar_robots() {
          local file="${JOPENSHOWVAR_CONFIG:-${XDG_CONFIG_HOME:-$HOME/.config}/jopenshowvar/config.toml}"
          [ -r "$file" ] && %s "$file"
        }

        function _jopenshowvar_or_robot() {
          # $2 is what is replaced; in COMP_WORDS an @ may be a word of its own
          local word="$2" before=""
          [ "$COMP_CWORD" -gt 0 ] && before="${COMP_WORDS[COMP_CWORD-1]}"
          if [[ "$word" == @* ]]; then
            COMPREPLY=( $(compgen -P @ -W "$(_jopenshowvar_robots)" -- "${word#@}") )
          elif [[ "$before" == --robot ]]; then
            COMPREPLY=( $(compgen -W "$(_jopenshowvar_robots)" -- "$word") )
          else
            _complete_jopenshowvar
          fi
        }

        complete -F _jopenshowvar_or_robot -o default jopenshowvar
        """
            .formatted(ROBOTS);
  }

  /** Creates the script for fish. */
  static String fish(CommandSpec main) {
    List<String> lines = new ArrayList<>();
    lines.add(
        "# Completion of jopenshowvar for fish: copy this file to ~/.config/fish/completions.");
    lines.add(
        """
        function __jopenshowvar_robots
            set -l folder $HOME/.config
            set -q XDG_CONFIG_HOME; and set folder $XDG_CONFIG_HOME
            set -l file $folder/jopenshowvar/config.toml
            set -q JOPENSHOWVAR_CONFIG; and set file $JOPENSHOWVAR_CONFIG
            test -r "$file"; and %s "$file"
        end
        """
            .formatted(ROBOTS)
            .strip());
    lines.add("complete -c jopenshowvar -f");
    lines.add(
        "complete -c jopenshowvar -n 'string match -q \"@*\" -- (commandline -ct)'"
            + " -a '@(__jopenshowvar_robots)'");
    CommandTree.withAllBelow(main).forEach(command -> fish(command, lines));
    return String.join("\n", lines) + "\n";
  }

  private static void fish(CommandSpec command, List<String> lines) {
    String here = "complete -c jopenshowvar -n " + quoted(condition(command));
    for (CommandLine sub : command.subcommands().values()) {
      CommandSpec spec = sub.getCommandSpec();
      lines.add(here + " -a " + spec.name() + " -d " + sentence(spec.usageMessage().description()));
    }
    for (OptionSpec option : HelpText.options(command)) {
      String names =
          Arrays.stream(option.names())
              .map(
                  name ->
                      name.startsWith("--") ? "-l " + name.substring(2) : "-s " + name.substring(1))
              .collect(Collectors.joining(" "));
      lines.add(here + " " + names + value(option) + " -d " + sentence(option.description()));
    }
    if (HelpText.parameters(command).stream().anyMatch(Completion::isFile)) {
      lines.add(here + " -F");
    }
  }

  /** Returns the place of a command's words: after its name and before its subcommands. */
  private static String condition(CommandSpec command) {
    List<String> conditions = new ArrayList<>();
    for (CommandSpec above = command; above.parent() != null; above = above.parent()) {
      conditions.add(0, "__fish_seen_subcommand_from " + above.name());
    }
    if (!command.subcommands().isEmpty()) {
      conditions.add(
          "not __fish_seen_subcommand_from " + String.join(" ", command.subcommands().keySet()));
    }
    return String.join("; and ", conditions);
  }

  private static String value(OptionSpec option) {
    if (option.arity().max() == 0) {
      return "";
    }
    if (isFile(option)) {
      return " -r -F";
    }
    if (option.longestName().equals("--robot")) {
      return " -x -a '(__jopenshowvar_robots)'";
    }
    return option.completionCandidates() == null
        ? " -x"
        : StreamSupport.stream(option.completionCandidates().spliterator(), false)
            .collect(Collectors.joining(" ", " -x -a '", "'"));
  }

  private static boolean isFile(ArgSpec argument) {
    return Arrays.asList(argument.auxiliaryTypes()).contains(Path.class)
        || argument.type() == Path.class;
  }

  private static String sentence(String... description) {
    return quoted(HelpText.firstSentence(description));
  }

  private static String quoted(String text) {
    return "'" + text.replace("\\", "\\\\").replace("'", "\\'") + "'";
  }
}
