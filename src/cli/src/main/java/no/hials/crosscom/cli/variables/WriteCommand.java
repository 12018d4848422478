package no.hials.crosscom.cli.variables;

import java.io.IOException;
import no.hials.crosscom.CrossComException;
import no.hials.crosscom.cell.JsonLine;
import no.hials.crosscom.cell.RobotConnection;
import no.hials.crosscom.cli.base.ControllerCommand;
import no.hials.crosscom.cli.base.ExitCode;
import no.hials.crosscom.cli.base.WriteOptions;
import no.hials.crosscom.protocol.value.KrlSyntaxException;
import no.hials.crosscom.protocol.value.KrlValue;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** {@code write NAME VALUE}. */
@Command(
    name = "write",
    description =
        "Writes a variable, and prints NAME = VALUE once the controller has confirmed it. A write can"
            + " move a machine.",
    footer = {
      "",
      "The value is printed as it was sent: the controller confirms that, not what it stored. A"
          + " write is never repeated. If no answer came, it may have been done or not, and the"
          + " message says so: read the variable.",
      "",
      "Before it writes, it reads $MODE_OP. In T1 it goes on; else, or if that cannot be read, it"
          + " asks on a terminal, and without one does not write. With --yes it neither reads nor"
          + " asks. A read-only controller (--read-only, JOPENSHOWVAR_READ_ONLY=true, or"
          + " read-only = true of a robot) is not even connected to.",
      "",
      "JSON: the object that read --json prints, of the value that was sent. With --json a VALUE"
          + " that is no KRL value is wrong usage, and not sent.",
      "",
      "Quoting: a shell replaces $NAME and takes [ ] { } for patterns, so put NAME and VALUE into"
          + " single quotes. The double quotes of a text belong to the value and stand inside"
          + " them:",
      "  sh, bash, zsh          '\"text\"'",
      "  PowerShell before 7.3  '\\\"text\\\"'",
      "  cmd.exe                \"\\\"text\\\"\"",
      "A VALUE that begins with - needs nothing if it is a number, else -- between the options and"
          + " NAME.",
      "",
      "Examples:",
      "  jopenshowvar write '$OV_PRO' 50 --host 172.31.1.147",
      "  jopenshowvar write @cell1 '$OV_PRO' 50 --yes",
      "  jopenshowvar write MYINT -5 --mock",
      "  jopenshowvar write 'MYSTRING[]' '\"hello\"' --mock",
      "  jopenshowvar write MYPOS '{X 100.0,Z -20.5}' --mock"
    })
public final class WriteCommand extends ControllerCommand {
  @Parameters(
      index = "0",
      paramLabel = "NAME",
      description = "A variable, a field of it or an element.")
  private String name = "";

  @Parameters(
      index = "1",
      paramLabel = "VALUE",
      description =
          "What to write, in KRL: 50, -1.5, TRUE, #T1, \"text\" with its double quotes, or an"
              + " aggregate, whose fields that are left out stay as they are: {X 100.0,Z -20.5}")
  private String value = "";

  @Option(names = "--json", order = 5, description = "Print JSON, see below.")
  private boolean json;

  @Mixin private WriteOptions writeOptions = new WriteOptions();

  @Override
  public ExitCode run() throws IOException {
    if (name.isBlank()) {
      throw wrongUsage("NAME is blank; in a shell, names with $ need single quotes: '$OV_PRO'");
    }
    if (value.isBlank()) {
      throw wrongUsage("VALUE is blank; an empty text is '\"\"'");
    }
    String line = json ? JsonLine.of(name, parse()) : name + " = " + value;
    try (RobotConnection controller = open(writeOptions, "write " + name)) {
      controller.client().checkText(name, value);
      writeOptions.permission(console()).check(controller, "write " + name);
      controller.client().writeText(name, value);
    } catch (CrossComException e) {
      console().failure(e, isVerbose());
      return ExitCode.ofFailedWrite(e);
    } catch (IllegalArgumentException e) {
      throw wrongUsage(String.valueOf(e.getMessage()));
    }
    console().print(line);
    return ExitCode.DONE;
  }

  private KrlValue parse() {
    try {
      return KrlValue.parse(value);
    } catch (KrlSyntaxException e) {
      throw wrongUsage("VALUE is not a KRL value: " + e.getMessage());
    }
  }
}
