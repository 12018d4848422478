package no.hials.crosscom.cli;

import java.io.IOException;
import java.util.List;
import no.hials.crosscom.CrossComAccessException;
import no.hials.crosscom.CrossComClient;
import no.hials.crosscom.CrossComException;
import no.hials.crosscom.CrossComValueException;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** {@code read NAME...}. */
@Command(
    name = "read",
    description = {
      "Reads variables and prints a line NAME = VALUE for each, in the order given, the value as"
          + " the controller prints it."
    },
    footer = {
      "",
      "If a variable cannot be read, the others still are; the exit code is that of the gravest"
          + " failure, which is the highest. A lost connection ends the command. Control characters"
          + " in a value are printed as \\x0A, so that a line is a variable.",
      "",
      "JSON: one object a line (JSON Lines), with name, type and value. The type is INT, REAL,"
          + " BOOL, CHAR, CHAR[], ENUM or STRUC, or that of the elements with [] for a whole array."
          + " INT and REAL are numbers, BOOL is true or false, the others are strings, an ENUM with"
          + " its #; an array is an array; a STRUC is an object of its initialised fields under the"
          + " names that the controller prints, and struc is the name of its type, or null."
          + " Characters beyond ASCII are escaped. What is no KRL value is a string, its type"
          + " UNKNOWN.",
      "",
      "Quoting: a shell replaces $NAME and takes [ ] for a pattern, so put names into single"
          + " quotes, in PowerShell too; cmd.exe needs none.",
      "",
      "Examples:",
      "  jopenshowvar read '$POS_ACT' '$OV_PRO' --host 172.31.1.147",
      "  jopenshowvar read '$AXIS_ACT.A1' '$TORQUE_AXIS_ACT[3]' '$MODEL_NAME[]' --mock",
      "  jopenshowvar read '$POS_ACT' --json --mock | jq .value.X"
    })
final class ReadCommand extends ConsoleCommand {
  @Parameters(
      arity = "1..*",
      paramLabel = "NAME",
      description =
          "A variable, a field of it ('$POS_ACT.X'), an element ('$TORQUE_AXIS_ACT[3]'), a whole"
              + " array or a text ('$MODEL_NAME[]'). Upper or lower case.")
  private List<String> names = List.of();

  @Option(names = "--json", order = 5, description = "Print JSON, see below.")
  private boolean json;

  @Mixin private ControllerOptions controllerOptions = new ControllerOptions();

  ReadCommand(Console console) {
    super(console);
  }

  @Override
  ExitCode run() throws IOException {
    for (String name : names) {
      if (name.isBlank()) {
        throw wrongUsage("a name is blank; in a shell, names with $ need single quotes: '$OV_PRO'");
      }
    }
    ExitCode result = ExitCode.DONE;
    try (Controller controller = controllerOptions.open(this)) {
      for (int i = 0; i < names.size(); i++) {
        try {
          console().print(read(controller.client(), names.get(i)));
        } catch (CrossComException e) {
          console().failure(e, isVerbose());
          result = result.orGraver(ExitCode.ofFailedRead(e));
          if (endsTheConnection(e)) {
            List<String> left = names.subList(i + 1, names.size());
            if (!left.isEmpty()) {
              console().hint("not read: " + String.join(" ", left));
            }
            break;
          }
        } catch (IllegalArgumentException e) {
          // a name that cannot be sent
          console().failure(e, isVerbose());
          result = result.orGraver(ExitCode.USAGE);
        }
      }
    }
    return result;
  }

  private String read(CrossComClient client, String name) throws IOException {
    String text = client.readText(name);
    return json ? JsonLine.of(name, text) : name + " = " + printable(text);
  }

  /** Keeps a value on its line, and its characters from steering the terminal. */
  private static String printable(String text) {
    StringBuilder line = new StringBuilder();
    for (int i = 0; i < text.length(); i++) {
      char c = text.charAt(i);
      if (Character.isISOControl(c)) {
        line.append(String.format("\\x%02X", (int) c));
      } else {
        line.append(c);
      }
    }
    return line.toString();
  }

  private static boolean endsTheConnection(CrossComException e) {
    return !(e instanceof CrossComAccessException || e instanceof CrossComValueException);
  }
}
