package no.hials.crosscom.cli.bridge;

import no.hials.crosscom.c3.ControllerFiles;
import no.hials.crosscom.cli.base.VersionProvider;
import picocli.CommandLine;
import picocli.CommandLine.Command;

/** {@code file}, which only has commands. */
@Command(
    name = "file",
    mixinStandardHelpOptions = true,
    versionProvider = VersionProvider.class,
    synopsisSubcommandLabel = "COMMAND",
    description =
        "Lists, uploads, downloads and deletes the files of the controller, through C3 Bridge.",
    footer = {
      "",
      "A name on the controller is KRC:\\R1\\PROGRAM\\X.SRC or, in short form, /R1/X.SRC. Case"
          + " does not matter. In sh and bash, a name with backslashes needs single quotes:"
          + " 'KRC:\\R1\\PROGRAM\\X.SRC'. PowerShell and cmd.exe need none. Git Bash on Windows"
          + " changes names that begin with /; use the other form there.",
      "",
      "Examples:",
      "  jopenshowvar file ls 'KRC:\\R1\\PROGRAM' --host 172.31.1.147",
      "  jopenshowvar file put weld.src 'KRC:\\R1\\PROGRAM\\' --host 172.31.1.147",
      "  jopenshowvar file get /R1/WELD.SRC . --host 172.31.1.147",
      "",
      "See 'jopenshowvar file COMMAND --help' for options and exit codes."
    })
public final class FileCommand {
  private FileCommand() {}

  /** Creates the command with its subcommands. */
  public static CommandLine commandLine() {
    CommandLine file =
        new CommandLine(new FileCommand())
            .addSubcommand(new FileLs())
            .addSubcommand(new FileStat())
            .addSubcommand(new FileGet())
            .addSubcommand(new FilePut());
    ProgramCommands.add(
        file,
        "cp",
        "Copies a file on the controller.",
        new FileCopy("cp", "copy", ControllerFiles::copy));
    ProgramCommands.add(
        file,
        "mv",
        "Moves or renames a file on the controller.",
        new FileCopy("mv", "move", ControllerFiles::move));
    return file.addSubcommand(new FileRm());
  }
}
