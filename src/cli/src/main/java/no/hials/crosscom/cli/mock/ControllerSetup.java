package no.hials.crosscom.cli.mock;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import no.hials.crosscom.cell.FileException;
import no.hials.crosscom.cli.base.LoadedFiles;
import no.hials.crosscom.cli.base.LocalFiles;
import no.hials.crosscom.protocol.code.OperatingMode;
import no.hials.crosscom.simulator.Archive;
import no.hials.crosscom.simulator.Controller;
import no.hials.crosscom.simulator.FileTree;
import no.hials.crosscom.simulator.KrlFileException;
import no.hials.crosscom.simulator.ProgramControl;
import org.jspecify.annotations.Nullable;

/**
 * The operator's preparations at the pendant before the robot runs.
 *
 * @param configs data lists
 * @param programs modules, of which the first of each interpreter is selected
 * @param mode the operating mode
 * @param start whether to start the selected programs
 * @param archive the files of a controller, which are loaded already; null for none
 */
record ControllerSetup(
    List<Path> configs,
    List<Path> programs,
    OperatingMode mode,
    boolean start,
    @Nullable Archive archive) {

  private static final String CELL = "CELL";

  private static final String PROGRAMS = "KRC:\\R1\\Program\\";

  /** Returns the error in the names of the files; empty if they are valid. */
  Optional<String> mistake() {
    for (Path file : configs) {
      if (!hasEnding(file, ".dat")) {
        return Optional.of("--config needs a .dat file, is " + file);
      }
    }
    for (Path file : programs) {
      if (!hasEnding(file, ".src") && !isSubmit(file)) {
        return Optional.of("--program needs a .src or .sub file, is " + file);
      }
    }
    return start && programs.isEmpty() && archive == null
        ? Optional.of("--start needs a --program or an --archive")
        : Optional.empty();
  }

  private static boolean hasEnding(Path file, String ending) {
    return file.toString().toLowerCase(Locale.ROOT).endsWith(ending);
  }

  private static boolean isSubmit(Path file) {
    return hasEnding(file, ".sub");
  }

  /**
   * Prepares the controller, and returns lines that report it.
   *
   * @param files gets the results of loading
   */
  List<String> apply(Controller controller, LoadedFiles files) throws FileException {
    List<String> lines = new ArrayList<>();
    for (Path file : configs) {
      lines.add("loaded " + files.load(controller, file) + " from " + file);
    }
    // selected after all are loaded, since one may call another
    Optional<Module> submit = Optional.empty();
    Optional<Module> robot = Optional.empty();
    for (Path file : programs) {
      Module module = new Module(files.loadOrFind(controller, file, archive != null), file);
      lines.add("loaded " + module.name() + " from " + file);
      if (isSubmit(file)) {
        submit = submit.or(() -> Optional.of(module));
      } else {
        robot = robot.or(() -> Optional.of(module));
      }
    }
    files.check(controller);
    if (start && programs.isEmpty() && archive != null) {
      robot = Optional.of(ofArchive(controller, archive.programs()));
    }
    controller.setMode(mode);
    if (submit.isPresent()) {
      controller.submit().cancel(); // that of the archive
      select(controller.submit(), submit.get());
    }
    if (robot.isPresent()) {
      select(controller.robot(), robot.get());
    }
    if (start) {
      lines.addAll(start(controller, submit.isPresent(), robot.isPresent()));
    }
    lines.add(controller.toString());
    return lines;
  }

  /**
   * Puts the programs and their data lists into the tree, so that clients see them.
   *
   * @throws FileException if the tree has another file of that name
   */
  void addPrograms(FileTree files) throws FileException {
    for (Path program : programs) {
      if (archive != null && !Files.exists(program)) {
        continue; // it is there
      }
      Path list = LocalFiles.dataListOf(program);
      if (list != null) {
        add(files, list);
      }
      add(files, program);
    }
  }

  private static void add(FileTree files, Path file) throws FileException {
    String name = PROGRAMS + LocalFiles.name(file);
    try {
      byte[] content = Files.readAllBytes(file);
      if (!files.exists(name)) {
        files.put(name, content);
      } else if (!Arrays.equals(files.get(name), content)) {
        // the folder is the user's: its files must not be replaced here
        throw new IOException(name + " already exists with other content");
      }
    } catch (IOException e) {
      throw FileException.cannot("use", file, e);
    }
  }

  /**
   * A module that was loaded.
   *
   * @param name its name
   * @param file where it came from
   */
  private record Module(String name, Path file) {}

  /** Returns the program of an archive to start: its only one, or that of Automatic External. */
  private static Module ofArchive(Controller controller, List<String> programs)
      throws FileException {
    String only = programs.size() == 1 ? programs.get(0) : CELL;
    for (String known : controller.programs()) {
      if (known.equalsIgnoreCase(only)) {
        return new Module(known, Path.of(known));
      }
    }
    throw new FileException(
        "--start needs a --program: the archive has no cell.src, and in Program "
            + (programs.isEmpty() ? "nothing" : String.join(", ", programs)));
  }

  private static void select(ProgramControl interpreter, Module module) throws FileException {
    try {
      interpreter.select(module.name());
    } catch (KrlFileException e) {
      throw withErrors(module.file() + " cannot be selected:", e);
    }
  }

  private static FileException withErrors(String message, KrlFileException e) {
    return new FileException(message, String.valueOf(e.getMessage()).lines().toList(), e);
  }

  /** Starts the programs; if the robot cannot be started, it stands still, with a message. */
  private List<String> start(Controller controller, boolean submit, boolean robot) {
    if (submit) {
      controller.submit().start();
    }
    try {
      if (robot) {
        controller.runProgram();
      }
      return List.of();
    } catch (IllegalStateException e) {
      // the submit program already runs, or may have stopped with a message
      return List.of("not started: " + e.getMessage());
    }
  }
}
