package no.hials.crosscom.cli.bridge;

import java.io.IOException;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import no.hials.crosscom.CrossComException;
import no.hials.crosscom.CrossComRefusedException;
import no.hials.crosscom.c3.ControllerFiles;
import no.hials.crosscom.cell.NotSentException;
import no.hials.crosscom.cell.RobotConnection;
import no.hials.crosscom.cli.base.ExitCode;
import no.hials.crosscom.cli.base.WriteOptions;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** {@code file rm NAME...}. */
@Command(
    name = "rm",
    description = "Deletes files on the controller. Asks for confirmation unless --yes is given.",
    footer = {
      "",
      "If a file does not exist, nothing is deleted. If a file cannot be deleted, the remaining"
          + " ones are not tried.",
      "",
      "JSON: one object per file (JSON Lines) with command and name.",
      "",
      "In sh and bash a name with backslashes needs single quotes.",
      "",
      "Examples:",
      "  jopenshowvar file rm /R1/WELD.SRC /R1/WELD.DAT --host 172.31.1.147",
      "  jopenshowvar file rm --recursive --yes 'KRC:\\R1\\PROGRAM\\OLD' --host 172.31.1.147"
    })
final class FileRm extends FileSubcommand {
  @Parameters(arity = "1..*", paramLabel = "NAME", description = "A file on the controller.")
  private List<String> names = List.of();

  @Option(
      names = {"-r", "--recursive"},
      description = "Delete folders with their content, even if it is read-only.")
  private boolean recursive;

  @Option(names = "--force", description = "Delete read-only files, too.")
  private boolean force;

  @Mixin private WriteOptions writeOptions = new WriteOptions();

  @Override
  ExitCode work() throws IOException {
    String what = "delete " + String.join(", ", checked("NAME", names));
    try (RobotConnection controller = open(writeOptions, what)) {
      ControllerFiles files = controller.client().files();
      Set<String> folders = folders(files);
      writeOptions.permission(console()).check(controller, what, reasons(folders));
      for (int i = 0; i < names.size(); i++) {
        try {
          files.delete(names.get(i), force || folders.contains(names.get(i)));
        } catch (CrossComException e) {
          ExitCode code = failed(e);
          hintOfRest("deleted", names.subList(i + 1, names.size()));
          return code;
        }
        String name = names.get(i);
        print("deleted " + name, "command", "rm", "name", name);
      }
    }
    return ExitCode.DONE;
  }

  /** Returns the names that are folders; refuses them without {@code --recursive}. */
  private Set<String> folders(ControllerFiles files) throws IOException {
    Set<String> folders = new LinkedHashSet<>();
    for (String name : names) {
      if (isDeletedAsFolder(files, name)) {
        if (!recursive) {
          throw new NotSentException(
              "did not delete " + name + ": it is a folder, which needs --recursive");
        }
        folders.add(name);
      }
    }
    return folders;
  }

  private static boolean isDeletedAsFolder(ControllerFiles files, String name) throws IOException {
    try {
      return files.getProperties(name).isDirectory();
    } catch (CrossComRefusedException e) {
      // a module has no properties of its own, but can be deleted
      for (String part : List.of(".SRC", ".DAT")) {
        if (files.exists(name + part)) {
          return false;
        }
      }
      throw e;
    }
  }

  private static List<String> reasons(Set<String> folders) {
    return folders.isEmpty()
        ? List.of("deleting cannot be undone")
        : List.of("the content of " + String.join(", ", folders) + " will be deleted, too");
  }
}
