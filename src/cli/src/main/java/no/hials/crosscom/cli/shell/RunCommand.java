package no.hials.crosscom.cli.shell;

import java.io.BufferedReader;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import no.hials.crosscom.cell.FileException;
import no.hials.crosscom.cell.Robot;
import no.hials.crosscom.cell.RobotConnection;
import no.hials.crosscom.cli.base.ControllerCommand;
import no.hials.crosscom.cli.base.ExitCode;
import no.hials.crosscom.cli.base.LocalFiles;
import no.hials.crosscom.cli.base.Robots;
import no.hials.crosscom.cli.base.WriteOptions;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** {@code run FILE}. */
@Command(
    name = "run",
    description =
        "Runs a file of shell commands and stops at the first line that fails. A write can move"
            + " a machine.",
    footer = {
      "",
      "The commands are those of 'jopenshowvar shell'; its command 'help' lists them. All lines"
          + " are checked first: if one has an error, nothing is sent. Error messages begin with"
          + " FILE:LINE. The exit code is that of the failed line.",
      "",
      "On a terminal, the command asks for confirmation before each write. Without a terminal, a"
          + " file with writes needs --yes.",
      "",
      "Examples:",
      "  jopenshowvar run slow.jov --host 172.31.1.147 --yes",
      "  jopenshowvar run slow.jov --dry-run",
      "  printf '$OV_PRO = 10\\nwait 2s\\n$POS_ACT\\n' | jopenshowvar run - --mock --yes"
    })
public final class RunCommand extends ControllerCommand {
  private static final String STDIN = "-";

  @Parameters(index = "0", paramLabel = "FILE", description = "The file (UTF-8), or - for stdin.")
  private String file = "";

  @Option(
      names = "--dry-run",
      order = 5,
      description =
          "Check the file and print its commands without running them. Needs no controller.")
  private boolean dryRun;

  @Mixin private WriteOptions writeOptions = new WriteOptions();

  /** A line of the file that does something. */
  private record Step(String place, ShellLine line) {}

  @Override
  public ExitCode run() throws IOException {
    List<Step> steps = new ArrayList<>();
    if (!parse(lines(), steps)) {
      return ExitCode.USAGE;
    }
    if (dryRun) {
      steps.forEach(step -> console().print(step.place() + step.line()));
      return ExitCode.DONE;
    }
    Robot target = target();
    for (Step step : steps) {
      if (step.line() instanceof ShellLine.Write) {
        writeOptions.permission(console()).checkAskable(target, step.line().toString());
      }
    }
    try (RobotConnection controller = Robots.open(target, Robot.LASTING)) {
      ShellSymbols symbols = new ShellSymbols(controller);
      ShellCommands commands = new ShellCommands(program());
      return run(steps, new ShellSession(console(), controller, writeOptions, symbols, commands));
    }
  }

  private ExitCode run(List<Step> steps, ShellSession session) {
    for (Step step : steps) {
      if (step.line() instanceof ShellLine.Exit) {
        break;
      }
      ExitCode code = session.run(step.place(), step.line(), isVerbose());
      if (code != ExitCode.DONE) {
        return code;
      }
    }
    return ExitCode.DONE;
  }

  private List<String> lines() throws IOException {
    if (file.equals(STDIN)) {
      return new BufferedReader(console().in()).lines().toList();
    }
    Path path = LocalFiles.path(this, file);
    try {
      return Files.readAllLines(path, StandardCharsets.UTF_8);
    } catch (IOException e) {
      throw FileException.cannot("read", path, e);
    }
  }

  /** Prints all errors, and returns whether there are none. */
  private boolean parse(List<String> lines, List<Step> steps) {
    ShellCommands commands = new ShellCommands(program());
    boolean right = true;
    for (int i = 0; i < lines.size(); i++) {
      String place = (file.equals(STDIN) ? "stdin" : file) + ":" + (i + 1) + ": ";
      try {
        ShellLine line = ShellLine.parse(lines.get(i), commands.names());
        if (line instanceof ShellLine.Command command) {
          commands.check(command.words());
        }
        if (!(line instanceof ShellLine.Nothing)) {
          steps.add(new Step(place, line));
        }
      } catch (ShellSyntaxException e) {
        console().error(place + e.getMessage());
        right = false;
      }
    }
    return right;
  }
}
