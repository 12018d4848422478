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
import no.hials.crosscom.c3.ControllerFiles;
import no.hials.crosscom.c3.TransferConfig;
import no.hials.crosscom.cell.NotSentException;
import no.hials.crosscom.cell.RemoteName;
import no.hials.crosscom.cell.Robot;
import no.hials.crosscom.cell.RobotConnection;
import no.hials.crosscom.cell.WritePermission;
import no.hials.crosscom.cell.recording.OutputException;
import no.hials.crosscom.cli.base.ExitCode;
import no.hials.crosscom.cli.base.LocalFiles;
import no.hials.crosscom.cli.base.Progress;
import no.hials.crosscom.cli.base.Robots;
import no.hials.crosscom.cli.base.StopSignal;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** {@code file get REMOTE... LOCAL}. */
@Command(
    name = "get",
    description = "Downloads files from the controller.",
    footer = {
      "",
      "LOCAL is an existing folder, such as . for the current one, or the new name of a single"
          + " file.",
      "",
      "An existing local file is overwritten only after confirmation or with --yes. Each file is"
          + " first written as NAME.RANDOM.part and renamed when it is complete. Of a symbolic"
          + " link, the file that it points to is overwritten; devices, pipes and links to nothing"
          + " are refused.",
      "",
      "JSON: one object per file (JSON Lines) with command, local, name and size.",
      "",
      "In sh and bash a name with backslashes needs single quotes.",
      "",
      "Examples:",
      "  jopenshowvar file get /R1/WELD.SRC . --with-dat --host 172.31.1.147",
      "  jopenshowvar file get 'KRC:\\R1\\System\\$config.dat' mine.dat --mock"
    })
final class FileGet extends FileSubcommand {
  @Parameters(
      arity = "1..*",
      paramLabel = "REMOTE... LOCAL",
      hideParamSyntax = true,
      description = "The files on the controller, then the folder or file on this computer.")
  private List<String> arguments = List.of();

  @Option(
      names = "--with-dat",
      description = "Also transfer the data list (.dat) of each program, if it exists.")
  private boolean withDat;

  @Option(
      names = {"-y", "--yes"},
      order = 5,
      description = "Overwrite local files without asking.")
  private boolean yes;

  /**
   * A planned download.
   *
   * @param name the file on the controller
   * @param local the file on this computer
   */
  private record Job(String name, Path local) {
    boolean isThere() {
      return java.nio.file.Files.exists(local);
    }
  }

  @Override
  ExitCode work() throws IOException {
    checkBothGiven("REMOTE and LOCAL", arguments);
    List<String> names = checked("REMOTE", arguments.subList(0, arguments.size() - 1));
    Path place = place(names.size());
    Robot target = target();
    try (RobotConnection controller =
        Robots.open(target, yes ? Robot.ONE_SHOT : cfg -> cfg.reconnect(false))) {
      ControllerFiles files = controller.client().files();
      List<Job> jobs = jobs(files, names, place);
      ask(target, jobs);
      return transfer("downloaded", jobs, Job::name, (job, stop) -> download(files, job, stop));
    }
  }

  private Path place(int count) {
    String text = arguments.get(arguments.size() - 1);
    Path place = LocalFiles.path(this, text);
    boolean folder = java.nio.file.Files.isDirectory(place);
    if (!folder && count > 1) {
      throw wrongUsage("for several files LOCAL must be an existing folder, is " + place);
    }
    if (!folder && LocalFiles.endsLikeFolder(text)) {
      throw new OutputException(
          text, new IOException("there is no folder " + place.toAbsolutePath()));
    }
    if (!folder) {
      LocalFiles.checkFolderOf(place);
    }
    return place;
  }

  private List<Job> jobs(ControllerFiles files, List<String> names, Path place) throws IOException {
    boolean folder = java.nio.file.Files.isDirectory(place);
    List<Job> jobs = new ArrayList<>();
    for (String name : names) {
      Path local = folder ? place.resolve(LocalFiles.path(this, RemoteName.last(name))) : place;
      jobs.add(new Job(name, local));
      String list = RemoteName.dataListOf(name);
      if (withDat && RemoteName.isProgram(name) && files.exists(list)) {
        String localList = RemoteName.dataListOf(LocalFiles.name(local));
        jobs.add(new Job(list, local.resolveSibling(localList)));
      }
    }
    Set<String> locals = new HashSet<>();
    for (Job job : jobs) {
      // whatever the case: it does not count everywhere
      if (!locals.add(job.local().toString().toUpperCase(Locale.ROOT))) {
        throw wrongUsage("two files would have the name " + job.local());
      }
      if (java.nio.file.Files.isDirectory(job.local())) {
        throw wrongUsage(job.local() + " is a folder");
      }
    }
    return jobs;
  }

  private void ask(Robot target, List<Job> jobs) throws NotSentException {
    String there =
        jobs.stream()
            .filter(Job::isThere)
            .map(job -> job.local() + " already exists")
            .collect(Collectors.joining(", "));
    if (!yes && !there.isEmpty()) {
      new WritePermission(false, false, console()).confirm(target.label(), "overwrite it", there);
    }
  }

  private void download(ControllerFiles files, Job job, StopSignal stop) throws IOException {
    try (Progress progress = progress(job.name(), stop)) {
      TransferConfig config =
          TransferConfig.create(cfg -> cfg.overwrite(job.isThere()).progress(progress));
      files.download(job.name(), job.local(), config);
    } catch (CrossComException e) {
      throw e;
    } catch (IOException e) { // of this computer
      throw new OutputException(job.local().toString(), e);
    }
    print("get", job.local(), job.name());
  }
}
