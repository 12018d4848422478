package no.hials.crosscom.cli.variables;

import java.io.IOException;
import no.hials.crosscom.CrossComException;
import no.hials.crosscom.cell.JsonLine;
import no.hials.crosscom.cell.RobotConnection;
import no.hials.crosscom.cell.ValueText;
import no.hials.crosscom.cell.WriteAnswer;
import no.hials.crosscom.cell.WritePermission;
import no.hials.crosscom.cli.base.ControllerCommand;
import no.hials.crosscom.cli.base.ExitCode;
import no.hials.crosscom.cli.base.WriteOptions;
import no.hials.crosscom.protocol.value.KrlValue;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** {@code write NAME VALUE}. */
@Command(
    name = "write",
    description =
        "Writes a variable and prints NAME = VALUE when the controller has confirmed it. A write"
            + " can move a machine.",
    footer = {
      "",
      "A VALUE that is not a KRL value is not sent. VALUE is printed as it was sent; the stored"
          + " value can differ. If the answer has another value, the command prints both to stderr"
          + " and ends with exit code 1. A write is never repeated. If no answer arrives, the"
          + " variable may or may not have been written: read it.",
      "",
      "The command first reads $MODE_OP. On a terminal, it asks for confirmation. Without a"
          + " terminal, it writes in T1; in other modes, or if $MODE_OP cannot be read, it does not"
          + " write. With --yes it does not read $MODE_OP and does not ask. If the controller is"
          + " read-only (--read-only, JOPENSHOWVAR_READ_ONLY=true, or read-only = true of a robot),"
          + " the command does not connect.",
      "",
      "JSON: an object as from 'read --json', with the value that was sent.",
      "",
      "Quoting: a shell replaces $NAME and patterns with [ ] or { }, so put NAME and VALUE in"
          + " single quotes. A text also needs its own double quotes:",
      "  sh, bash, zsh          '\"text\"'",
      "  PowerShell before 7.3  '\\\"text\\\"'",
      "  cmd.exe                \"\\\"text\\\"\"",
      "",
      "Examples:",
      "  jopenshowvar write '$OV_PRO' 50 --host 172.31.1.147",
      "  jopenshowvar write @cell1 '$OV_PRO' 50 --yes",
      "  jopenshowvar write MYINT -5 --mock",
      "  jopenshowvar write 'MYSTRING[]' '\"hello\"' --mock",
      "  jopenshowvar write MYPOS '{X 100.0,Z 20.5}' --mock"
    })
public final class WriteCommand extends ControllerCommand {
  @Parameters(index = "0", paramLabel = "NAME", description = "A variable, a field or an element.")
  private String name = "";

  @Parameters(
      index = "1",
      paramLabel = "VALUE",
      description =
          "The KRL value: 50, -1.5, TRUE, #T1, \"text\" with its double quotes, or an aggregate"
              + " such as {X 100.0,Z 20.5}, whose omitted fields stay unchanged.")
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
    KrlValue parsed = parse();
    String change = name + " = " + value;
    String line = json ? JsonLine.of("", name, parsed, value) : change;
    try (RobotConnection controller = open(writeOptions, "write " + name)) {
      controller.client().checkText(name, value);
      checkPermission(controller);
      String answer = controller.client().writeText(name, value);
      WriteAnswer.check(name, value, answer);
    } catch (CrossComException e) {
      console().failure(e, isVerbose());
      return ExitCode.of(e);
    } catch (IllegalArgumentException e) {
      throw wrongUsage(String.valueOf(e.getMessage()));
    }
    console().printChange(change, line);
    return ExitCode.DONE;
  }

  /** Asks on a terminal in every mode, where a line is quickly typed. */
  private void checkPermission(RobotConnection controller) throws IOException {
    WritePermission permission = writeOptions.permission(console());
    if (console().isInteractive()) {
      permission.checkEach(controller, "write " + name);
    } else {
      permission.check(controller, "write " + name);
    }
  }

  private KrlValue parse() {
    try {
      return ValueText.parse(name, value, "'");
    } catch (IllegalArgumentException e) {
      throw wrongUsage("VALUE " + e.getMessage());
    }
  }
}
