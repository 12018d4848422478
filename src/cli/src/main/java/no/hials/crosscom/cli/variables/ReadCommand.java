package no.hials.crosscom.cli.variables;

import java.io.IOException;
import java.io.StringWriter;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import no.hials.crosscom.CrossComAccessException;
import no.hials.crosscom.CrossComClient;
import no.hials.crosscom.CrossComException;
import no.hials.crosscom.CrossComValueException;
import no.hials.crosscom.cell.JsonLine;
import no.hials.crosscom.cell.Robot;
import no.hials.crosscom.cell.RobotConnection;
import no.hials.crosscom.cli.base.Console;
import no.hials.crosscom.cli.base.ControllerCommand;
import no.hials.crosscom.cli.base.ExitCode;
import no.hials.crosscom.cli.base.Robots;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** {@code read NAME...}. */
@Command(
    name = "read",
    description = "Reads variables and prints one line NAME = VALUE for each, in the order given.",
    footer = {
      "",
      "If a variable cannot be read, the remaining ones are still read; the exit code is the"
          + " highest of all failures. A lost connection ends the command. VALUE is the text from"
          + " the controller. Control characters are printed as \\x1B, and characters that change"
          + " the direction of text as \\u202E, to a file or pipe as well; --raw prints them.",
      "",
      "Several robots (@NAME @NAME) are read at the same time and printed in the order given."
          + " Each line begins with the robot's name: cell1: $OV_PRO = 100. If a robot fails, the"
          + " others are still printed.",
      "",
      "JSON: one object per line (JSON Lines) with name, type, value and text, which is the text"
          + " from the controller; with several robots also robot. The type is INT, REAL, BOOL, CHAR, CHAR[], ENUM or STRUC; for a whole"
          + " array the type of its elements with []. The value of INT and REAL is a number, of"
          + " BOOL true or false, of an array an array, of STRUC an object with the initialised"
          + " fields, of other types a string. An ENUM begins with #. For STRUC, struc is the"
          + " name of the type, or null. Characters outside ASCII are escaped. A text that is not"
          + " a KRL value has the type UNKNOWN.",
      "",
      "Quoting: a shell replaces $NAME and [ ] patterns, so put names in single quotes, in"
          + " PowerShell too; cmd.exe needs no quotes.",
      "",
      "Examples:",
      "  jopenshowvar read '$POS_ACT' '$OV_PRO' --host 172.31.1.147",
      "  jopenshowvar read '$AXIS_ACT.A1' '$TORQUE_AXIS_ACT[3]' '$MODEL_NAME[]' --mock",
      "  jopenshowvar read '$POS_ACT' --json --mock | jq .value.X",
      "  jopenshowvar read @cell1 @cell2 '$POS_ACT'"
    })
public final class ReadCommand extends ControllerCommand {
  @Parameters(
      arity = "1..*",
      paramLabel = "NAME",
      description =
          "A variable, a field ('$POS_ACT.X'), an element ('$TORQUE_AXIS_ACT[3]'), a whole array"
              + " or a text ('$MODEL_NAME[]'). Case does not matter.")
  private List<String> names = List.of();

  @Option(names = "--json", order = 5, description = "Print JSON, see below.")
  private boolean json;

  @Option(
      names = "--raw",
      order = 5,
      description = "Print the text of the controller without escapes; not for a terminal.")
  private boolean raw;

  @Override
  public ExitCode run() throws IOException {
    checkNames(names);
    if (raw && json) {
      throw wrongUsage("--raw and --json exclude each other");
    }
    List<Robot> targets = targets();
    return targets.size() == 1 ? readAll(targets.get(0)) : readFromEach(targets);
  }

  /** Reads from one controller, and prints each variable as it comes. */
  private ExitCode readAll(Robot target) throws IOException {
    try (RobotConnection controller = Robots.open(target, Robot.ONE_SHOT)) {
      return new Reading(console(), "", "").of(controller.client());
    }
  }

  /** Reads from several controllers at once, and prints the results in their order. */
  private ExitCode readFromEach(List<Robot> targets) {
    ExecutorService threads = Executors.newFixedThreadPool(targets.size());
    try {
      List<CompletableFuture<Printed>> printed = new ArrayList<>();
      for (Robot target : targets) {
        printed.add(CompletableFuture.supplyAsync(() -> readLabelled(target), threads));
      }
      ExitCode result = ExitCode.DONE;
      for (CompletableFuture<Printed> one : printed) {
        Printed lines = one.join();
        console().write(lines.out.toString());
        console().err().print(lines.err);
        console().err().flush();
        result = result.orWorse(lines.result);
      }
      return result;
    } finally {
      threads.shutdown();
    }
  }

  /** The output for one of several controllers. */
  private record Printed(StringWriter out, StringWriter err, ExitCode result) {}

  private Printed readLabelled(Robot target) {
    StringWriter out = new StringWriter();
    StringWriter err = new StringWriter();
    Console console = new Console(out, err, Map.of());
    ExitCode result;
    try (RobotConnection controller = Robots.open(target, Robot.ONE_SHOT)) {
      result = new Reading(console, target.name(), target.label()).of(controller.client());
    } catch (CrossComException e) {
      console.failure(target.label(), e, isVerbose());
      result = ExitCode.of(e);
    } catch (IOException e) {
      // a simulated controller that could not listen
      console.failure(target.label(), e, isVerbose());
      result = ExitCode.NOT_CONNECTED;
    }
    return new Printed(out, err, result);
  }

  /** The reading of all variables from one controller. */
  private final class Reading {
    private final Console console;

    /** The robot's name in JSON and the label of a line; empty if there is only one robot. */
    private final String robot;

    private final String label;

    Reading(Console console, String robot, String label) {
      this.console = console;
      this.robot = robot;
      this.label = label;
    }

    ExitCode of(CrossComClient client) throws IOException {
      ExitCode result = ExitCode.DONE;
      for (int i = 0; i < names.size(); i++) {
        try {
          print(names.get(i), client.readText(names.get(i)));
        } catch (CrossComException e) {
          console.failure(label, e, isVerbose());
          result = result.orWorse(ExitCode.of(e));
          if (endsTheConnection(e)) {
            if (names.size() > 1) {
              // including this one, as not every failure of a connection names the variable
              List<String> left = names.subList(i, names.size());
              console.hint(label + "not read: " + String.join(" ", left));
            }
            break;
          }
        } catch (IllegalArgumentException e) {
          // a name that cannot be sent
          console.failure(label, e, isVerbose());
          result = result.orWorse(ExitCode.USAGE);
        }
      }
      return result;
    }

    private void print(String name, String text) {
      String line = json ? JsonLine.of(robot, name, text) : label + name + " = " + text;
      if (raw) {
        console.write(line + System.lineSeparator());
      } else {
        console.print(line);
      }
    }
  }

  private static boolean endsTheConnection(CrossComException e) {
    return !(e instanceof CrossComAccessException || e instanceof CrossComValueException);
  }
}
