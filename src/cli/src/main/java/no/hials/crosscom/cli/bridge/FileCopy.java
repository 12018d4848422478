package no.hials.crosscom.cli.bridge;

import java.io.IOException;
import java.util.List;
import no.hials.crosscom.c3.ControllerFiles;
import no.hials.crosscom.cell.RemoteName;
import no.hials.crosscom.cell.RobotConnection;
import no.hials.crosscom.cli.base.ExitCode;
import no.hials.crosscom.cli.base.WriteOptions;
import no.hials.crosscom.protocol.code.CopyFlag;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Parameters;

/** {@code file cp} and {@code file mv}. */
@Command(
    footerHeading = "%n",
    footer = {
      "If TARGET is a folder, or ends with a slash or backslash, the file keeps its name. An"
          + " existing file is overwritten only after confirmation or with --yes.",
      "",
      "JSON: one object with command, source and name.",
      "",
      "In sh and bash a name with backslashes needs single quotes.",
      "",
      "Examples:",
      "  jopenshowvar file cp /R1/WELD.SRC /R1/WELD2.SRC --host 172.31.1.147",
      "  jopenshowvar file mv 'KRC:\\R1\\PROGRAM\\A.SRC' 'KRC:\\R1\\PROGRAM\\OLD\\' --host"
          + " 172.31.1.147"
    })
final class FileCopy extends FileSubcommand {
  @Parameters(index = "0", paramLabel = "SOURCE", description = "A file on the controller.")
  private String source = "";

  @Parameters(
      index = "1",
      paramLabel = "TARGET",
      description = "The new name on the controller," + " or a folder.")
  private String destination = "";

  @Mixin private WriteOptions writeOptions = new WriteOptions();

  private final String command;
  private final String verb;
  private final Copy copy;

  /** Sends the command. */
  @FunctionalInterface
  interface Copy {
    void send(ControllerFiles files, String from, String to, CopyFlag... flags) throws IOException;
  }

  FileCopy(String command, String verb, Copy copy) {
    this.command = command;
    this.verb = verb;
    this.copy = copy;
  }

  @Override
  ExitCode work() throws IOException {
    checked("SOURCE", source);
    checked("TARGET", destination);
    String what = verb + " " + source + " to " + destination;
    try (RobotConnection controller = open(writeOptions, what)) {
      ControllerFiles files = controller.client().files();
      String name =
          isFolder(files, destination)
              ? RemoteName.in(destination, RemoteName.last(source))
              : destination;
      boolean there = files.exists(name);
      writeOptions
          .permission(console())
          .check(controller, what, there ? List.of(name + " already exists") : List.of());
      copy.send(files, source, name, there ? new CopyFlag[] {CopyFlag.OVERWRITE} : new CopyFlag[0]);
      String line = source + " -> " + name;
      print(line, "command", command, "source", source, "name", name);
    }
    return ExitCode.DONE;
  }
}
