package no.hials.crosscom.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.Writer;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Stream;
import no.hials.crosscom.cli.base.Cli;
import no.hials.crosscom.cli.base.CommandTree;
import no.hials.crosscom.cli.base.Console;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import picocli.CommandLine.Help;
import picocli.CommandLine.Model.ArgSpec;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Model.UsageMessageSpec;

class UsageTest {

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '`',
      value = {
        "raed MYINT --mock                       | unknown command: 'raed'",
        "help raed                               | unknown command: 'raed'",
        "help read MYINT                         | too many arguments: 'MYINT'",
        "read --mock                             | missing required parameter: 'NAME'",
        "read MYINT                              | which controller? give --host HOST, or --mock",
        "read MYINT --host h --mock              | --host and --mock exclude each other",
        "read MYINT --port 7000                  | which controller?",
        "read MYINT --port 7000 --mock           | --port goes with --host",
        "read MYINT --host                       | missing required parameter for option '--host'",
        "read MYINT --host h --port 0            | must be 1 to 65535, is 0",
        "read MYINT --host h --port 65536        | must be 1 to 65535, is 65536",
        "read MYINT --host h --port x            | must be 1 to 65535, is x",
        "read MYINT --mock --timeout 0           | must be 1ms or more, is 0",
        "read MYINT --mock --timeout 3h          | must be like 500, 500ms, 3s or 1m, is 3h",
        "read MYINT --mokc                       | unknown option: '--mokc'",
        "read @ MYINT                            | the name of the robot is missing: @NAME",
        "write MYINT --mock                      | missing required parameter: 'VALUE'",
        "write --mock                            | missing required parameters: 'NAME', 'VALUE'",
        "write MYPOS {X 1} --mock                | too many arguments: '1}'",
        "write MYINT 1 --host h --mock           | --host and --mock exclude each other",
        "mock --port -1                          | must be 0 to 65535, is -1",
        "mock --raw                              | unknown option: '--raw'",
        "mock --archive a.zip --files b --server c3 | --archive and --files exclude each other",
        "krl check                               | missing required parameter: 'PATH'",
        "krl run                                 | missing required parameter: 'FILE.src'",
        "mock MYINT                              | too many arguments: 'MYINT'",
        "mock --discovery 65536                  | must be 0 to 65535, is 65536",
        "mock --discovery 0 --no-discovery       | --discovery and --no-discovery exclude",
        "mock --config a.src                     | --config needs a .dat file, is a.src",
        "mock --program a.dat                    | --program needs a .src or .sub file, is a.dat",
        "mock --start                            | --start needs a --program",
        "mock --config a.dat --start             | --start needs a --program",
        "mock --mode T3                          | must be T1, T2, AUT or EXT, is T3",
        "mock --speed fast                       | must be real, max, or a factor of more than 0",
        "mock --speed 0                          | at most 10000, is 0",
        "mock --speed 10001                      | at most 10000, is 10001",
        "mock --speed stepped                    | must be real, max, or a factor",
        "mock --latency 5x                       | option '--latency': latency must be none, krc4",
        "mock --fault frob                       | option '--fault': fault 'frob', column 1",
        "mock --fault drop --fault drop@x%2      | fault 'drop@x%2', column 8: expected a prob",
        "mock --seed x                           | must be a whole number up to 9223372036854775807",
        "watch A --mock --count 9e9              | must be a whole number up to 9223372036854775807",
        "watch A --mock --period 0               | must be 1ms or more, is 0",
        "bench A --mock --clients 9999999999     | must be a whole number up to 2147483647, is 9",
        "mock --latency 999999999s               | a time up to an hour such as 5ms, is '9999"
      })
  void saysWhatIsWrongAndWhereHelpIs(String arguments, String message) {
    String[] args = arguments.isEmpty() ? new String[0] : arguments.split(" ");

    Cli.Result result = Cli.run(args);

    result
        .failsInLines(2)
        .last()
        .asString()
        .matches("try 'jopenshowvar( (read|write|mock|watch|bench|krl check|krl run))? --help'");
    assertThat(result.errLines().get(0)).startsWith("jopenshowvar: ").contains(message);
  }

  @Test
  void takesABlankNameForAVariableThatAShellReplaced() {
    Cli.run("read", "", "--mock")
        .fails(2)
        .startsWith("jopenshowvar: a name is blank; in a shell")
        .contains("'$");
  }

  @Test
  void doesNotTakeABlankHost() {
    assertThat(Cli.run("read", "MYINT", "--host", "").code()).isEqualTo(2);
    assertThat(Cli.run("mock", "--host", " ").code()).isEqualTo(2);
  }

  @Test
  void givesAHintOnlyWhereItFits() {
    assertThat(Cli.run("read", "--mock").errLines().get(1)).contains("single quotes");
    assertThat(Cli.run("write", "MYINT", "-5x", "--mock").errLines().get(1))
        .isEqualTo("a value that begins with - must be a number, such as -1.5");
    assertThat(Cli.run("experiment").errLines()).hasSize(2);
  }

  @ParameterizedTest
  @CsvSource({
    "raed MYINT, read",
    "wriet MYINT 5, write",
    "recrod, record",
    "exp, experiment",
    "help raed, read",
    "file gte a b, get",
    "program strat, start",
    "ls, file ls",
    "get MYINT, read or file get",
    "set MYINT 5, write",
    "cat /R1/A.SRC, file get",
    "delete /R1/A.SRC, file rm",
    "file delete /R1/A.SRC, file rm",
    "file list, file ls",
    "file upload a /R1/A.SRC, file put",
    "help ls, file ls",
    "program stat, file stat",
    "read MYINT --mokc, --mock",
    "read MYINT --hots=h, --host",
    "write --read MYINT 5, --read-only",
    "read MYINT --tiemout 5s, --timeout"
  })
  void suggestsWhatWasMeant(String arguments, String meant) {
    assertThat(Cli.run(arguments.split(" ")).errLines()).contains("did you mean " + meant + "?");
  }

  @Test
  void doesNotExplainVariablesIfAProgramIsMissing() {
    Cli.run("program", "run", "--mock")
        .fails(2)
        .isEqualTo(
            """
            jopenshowvar: missing required parameter: 'PROGRAM'
            try 'jopenshowvar program run --help'
            """);
  }

  @Test
  void suggestsNothingIfNothingIsNear() {
    assertThat(Cli.run("frobnicate").errLines()).hasSize(2);
    assertThat(Cli.run("info", "--mock", "get").errLines()).hasSize(2);
  }

  @Test
  void printsTheHelpOnStderrWithoutACommand() {
    Cli.Result help = Cli.run("--help");

    assertThat(Cli.run()).isEqualTo(new Cli.Result(2, "", help.out()));
  }

  @ParameterizedTest
  @CsvSource({"help, --help", "help read, read --help", "help file get, file get --help"})
  void printsTheHelpOfACommand(String arguments, String option) {
    assertThat(Cli.run(arguments.split(" "))).isEqualTo(Cli.run(option.split(" ")));
  }

  @Test
  void breaksLinesOnlyBetweenWordsAndAtHyphens() {
    CommandSpec main =
        Main.commandLine(new Console(Writer.nullWriter(), Writer.nullWriter(), Map.of()))
            .getCommandSpec();

    List<String> broken =
        CommandTree.withAllBelow(main)
            .flatMap(
                command -> {
                  String help = command.commandLine().getUsageMessage(Help.Ansi.OFF);
                  Set<String> shown = Set.copyOf(List.of(help.split("\\s+")));
                  return texts(command)
                      .flatMap(text -> Stream.of(text.split("\\s+")))
                      .filter(word -> !word.matches("[\\p{L}(']+(-\\p{L}+)+\\W*"))
                      .filter(word -> !shown.contains(word));
                })
            .toList();

    assertThat(broken).isEmpty();
  }

  private static Stream<String> texts(CommandSpec command) {
    Stream<String[]> arguments = command.args().stream().map(ArgSpec::description);
    UsageMessageSpec usage = command.usageMessage();
    return Stream.concat(arguments, Stream.of(usage.description(), usage.footer()))
        .map(HelpText::paragraph);
  }

  @ParameterizedTest
  @ValueSource(strings = {"read", "write", "mock"})
  void explainsEachCommandOnStdout(String command) {
    Cli.Result result = Cli.run(command, "--help");

    assertThat(result.lines().get(0)).startsWith("Usage: jopenshowvar " + command);
    assertThat(result.out())
        .contains("--host", "--port", "--verbose", "--help", "--version", "Examples:")
        .contains(
            "  0     done",
            "  1     refused by the controller",
            "  2     wrong usage",
            "  3     could not connect",
            "  4     connection lost, timed out or not this protocol",
            "  129   ended by SIGHUP",
            "  130   ended by Ctrl-C (SIGINT)",
            "  143   ended by SIGTERM");
    result.succeeds().allMatch(line -> line.length() <= 80);
  }

  @ParameterizedTest
  @ValueSource(strings = {"read", "write"})
  void explainsQuotingAndJson(String command) {
    assertThat(Cli.run(command, "--help").out())
        .contains("Quoting: a shell replaces $NAME", "JSON: ", "--timeout", "--mock", "--json");
  }

  @Test
  void explainsFaultsInTheFormInWhichTheyAreGiven() {
    assertThat(Cli.run("mock", "--help").out())
        .contains("FAULT is NAME[:ARGUMENT][@REQUESTS][@VARIABLE][%PROBABILITY]:")
        .contains("--fault drop%0.01 --seed 7")
        .contains("  closeAfter%0.01  ");
  }

  @Test
  void listsTheCommandsInItsHelp() {
    Cli.Result result = Cli.run("--help");

    assertThat(result.out()).contains("  read ", "  write ", "  mock ");
    assertThat(result.code()).isZero();
  }

  @ParameterizedTest
  @ValueSource(strings = {"--version", "read --version", "write -V", "mock --version"})
  void hasAVersionOnEveryCommand(String arguments) {
    Cli.run(arguments.split(" ")).succeeds().singleElement().asString().startsWith("jopenshowvar ");
  }
}
