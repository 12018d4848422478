package no.hials.crosscom.cli.bridge;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.stream.Collectors;
import no.hials.crosscom.CrossComException;
import no.hials.crosscom.CrossComRefusedException;
import no.hials.crosscom.c3.ControllerFiles;
import no.hials.crosscom.c3.TransferConfig;
import no.hials.crosscom.c3.Verification;
import no.hials.crosscom.cell.FileException;
import no.hials.crosscom.cell.RemoteName;
import no.hials.crosscom.cell.RobotConnection;
import no.hials.crosscom.cli.base.ExitCode;
import no.hials.crosscom.cli.base.LocalFiles;
import no.hials.crosscom.cli.base.Progress;
import no.hials.crosscom.cli.base.StopSignal;
import no.hials.crosscom.cli.base.WriteOptions;
import no.hials.crosscom.lang.KrlError;
import no.hials.crosscom.lang.KrlParser;
import no.hials.crosscom.protocol.code.Interpreter;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** {@code file put LOCAL... REMOTE}. */
@Command(
    name = "put",
    description =
        "Uploads files to the controller, and reads each file back to verify its content.",
    footer = {
      "",
      "REMOTE is a folder, or the new name of a single file. A name that ends with a slash or"
          + " backslash is a folder; otherwise the command asks the controller whether it is one.",
      "",
      "An existing file is overwritten only after confirmation or with --yes. If an upload"
          + " fails, the controller keeps no part of the file, unless the message says otherwise,"
          + " and the remaining files are not uploaded.",
      "",
      "A program with errors can be uploaded, but --select fails with exit code 1.",
      "",
      "JSON: one object per file (JSON Lines) with command, local, name and size; with --select"
          + " a last one with command, interpreter, program and state.",
      "",
      "In sh and bash a name with backslashes needs single quotes.",
      "",
      "Examples:",
      "  jopenshowvar file put weld.src weld.dat 'KRC:\\R1\\PROGRAM\\' --host 172.31.1.147",
      "  jopenshowvar file put weld.src /R1 --with-dat --select --host 172.31.1.147"
    })
final class FilePut extends FileSubcommand {
  private static final int MAX_ERRORS = 5;

  @Parameters(
      arity = "1..*",
      paramLabel = "LOCAL... REMOTE",
      hideParamSyntax = true,
      description = "The files on this computer, then the folder or file on the controller.")
  private List<String> arguments = List.of();

  @Option(
      names = "--with-dat",
      description =
          "Also transfer the data list (.dat) of each program, if it exists. The data list"
              + " in the case of its program takes precedence.")
  private boolean withDat;

  @Option(names = "--select", description = "Select the uploaded .src without starting it.")
  private boolean select;

  @Mixin private WriteOptions writeOptions = new WriteOptions();

  /**
   * A file to be uploaded.
   *
   * @param local its path on this computer
   * @param dataListOf the program of this data list; null if the user named the file
   */
  private record Source(Path local, @Nullable Path dataListOf) {}

  /**
   * A planned upload.
   *
   * @param local the file
   * @param name the name on the controller
   * @param there whether the name already exists
   */
  private record Job(Path local, String name, boolean there) {}

  @Override
  ExitCode work() throws IOException {
    checkBothGiven("LOCAL and REMOTE", arguments);
    String remote = checked("REMOTE", arguments.get(arguments.size() - 1));
    List<Source> sources = sources();
    Path program = select ? programOf(sources) : null;
    String what =
        "upload "
            + sources.stream()
                .map(each -> each.local().toString())
                .collect(Collectors.joining(", "));
    try (RobotConnection controller = open(writeOptions, what)) {
      ControllerFiles files = controller.client().files();
      List<Job> jobs = jobs(files, sources, remote);
      List<String> reasons =
          jobs.stream().filter(Job::there).map(job -> job.name() + " already exists").toList();
      writeOptions.permission(console()).check(controller, what, reasons);
      ExitCode code =
          transfer("uploaded", jobs, Job::name, (job, stop) -> upload(files, job, stop));
      if (code != ExitCode.DONE) {
        return code;
      }
      for (Job job : jobs) {
        if (job.local().equals(program)) {
          return select(controller, job);
        }
      }
    }
    return ExitCode.DONE;
  }

  /** An existing file is not a cause: the command asks before it overwrites. */
  @Override
  String accessHint() {
    return "likely cause: it is read-only, or belongs to the selected program"
        + " ('jopenshowvar program cancel' ends that)";
  }

  // the files to upload

  private List<Source> sources() throws IOException {
    List<Source> sources = new ArrayList<>();
    for (String argument : arguments.subList(0, arguments.size() - 1)) {
      Path file = LocalFiles.path(this, argument);
      LocalFiles.checkReadable(file);
      Path list = withDat && RemoteName.isProgram(argument) ? LocalFiles.dataListOf(file) : null;
      // a program is loaded together with its data list, so upload the data list first
      if (list != null) {
        sources.add(new Source(list, file));
      }
      sources.add(new Source(file, null));
    }
    return sources;
  }

  private Path programOf(List<Source> sources) {
    List<Path> programs =
        sources.stream()
            .map(Source::local)
            .filter(file -> RemoteName.hasEnding(file.toString(), ".src"))
            .toList();
    if (programs.size() != 1) {
      throw wrongUsage("--select needs one .src file, there are " + programs.size());
    }
    return programs.get(0);
  }

  private List<Job> jobs(ControllerFiles files, List<Source> sources, String remote)
      throws IOException {
    boolean folder = isFolder(files, remote);
    if (!folder && arguments.size() > 2) {
      throw wrongUsage("for several files REMOTE must be a folder, " + remote + " is not");
    }
    List<Job> jobs = new ArrayList<>();
    Set<String> names = new HashSet<>();
    for (Source source : sources) {
      String name = folder ? RemoteName.in(remote, LocalFiles.name(source.local())) : remote;
      if (!folder && source.dataListOf() != null) {
        name = RemoteName.dataListOf(remote);
      }
      if (!names.add(name.toUpperCase(Locale.ROOT))) {
        throw wrongUsage("two files would have the name " + name);
      }
      jobs.add(new Job(source.local(), name, files.exists(name)));
    }
    return jobs;
  }

  // the upload

  private void upload(ControllerFiles files, Job job, StopSignal stop) throws IOException {
    try (Progress progress = progress(job.name(), stop)) {
      TransferConfig config =
          TransferConfig.create(
              cfg ->
                  cfg.overwrite(job.there()).verification(Verification.CONTENT).progress(progress));
      files.upload(job.local(), job.name(), config);
    } catch (CrossComException e) {
      throw e;
    } catch (IOException e) { // of this computer
      throw FileException.cannot("read", job.local(), e);
    }
    print("put", job.local(), job.name());
  }

  private ExitCode select(RobotConnection controller, Job job) throws IOException {
    String program = RemoteName.withoutEnding(krcName(controller.client().files(), job.name()));
    try {
      controller.client().programs().select(program);
    } catch (CrossComRefusedException e) {
      ExitCode code =
          refused(e, "likely cause: the program has errors; it was uploaded, but not selected");
      hintOfErrors(job.local());
      return code;
    }
    ProgramStatus.read(controller.client(), Interpreter.ROBOT).print(this, "select");
    return ExitCode.DONE;
  }

  private static String krcName(ControllerFiles files, String name) throws IOException {
    try {
      return files.getKrcName(name);
    } catch (CrossComRefusedException e) {
      return name;
    }
  }

  /** Prints the errors that this program finds, since the controller reports none. */
  private void hintOfErrors(Path file) throws IOException {
    List<KrlError> errors = KrlParser.parse(file).errors();
    errors.stream().limit(MAX_ERRORS).forEach(error -> console().hint(error.toString()));
    if (errors.size() > MAX_ERRORS) {
      console().hint("and " + (errors.size() - MAX_ERRORS) + " more");
    }
  }
}
