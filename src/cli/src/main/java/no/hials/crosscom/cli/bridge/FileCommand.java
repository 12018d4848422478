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
      "Names on the controller are KRC:\\R1\\PROGRAM\\X.SRC or short /R1/X.SRC, in any case. In sh and"
          + " bash a name with backslashes needs single quotes, or the shell takes them away:"
          + " 'KRC:\\R1\\PROGRAM\\X.SRC'. PowerShell and cmd.exe need none; Git Bash on Windows makes"
          + " another name of one that begins with /.",
      "",
      "Examples:",
      "  jopenshowvar file ls 'KRC:\\R1\\PROGRAM' --host 172.31.1.147",
      "  jopenshowvar file put weld.src 'KRC:\\R1\\PROGRAM\\' --host 172.31.1.147",
      "  jopenshowvar file get /R1/WELD.SRC . --host 172.31.1.147",
      "",
      "'jopenshowvar file COMMAND --help' tells more, and the exit codes."
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
