package no.hials.crosscom.cli.base;

import java.io.IOException;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import no.hials.crosscom.cell.FileException;
import no.hials.crosscom.cell.JsonLine;
import no.hials.crosscom.lang.KrlError;
import no.hials.crosscom.simulator.Archive;
import no.hials.crosscom.simulator.Controller;
import no.hials.crosscom.simulator.KrlFileException;
import no.hials.crosscom.simulator.LoadReport;
import no.hials.crosscom.simulator.LoadReport.FileReport;
import no.hials.crosscom.simulator.LoadReport.Outcome;
import no.hials.crosscom.simulator.LoadingMode;

/** Loads files into a simulated controller, and prints what was loaded of each. */
public final class LoadedFiles {
  /** The number of problems shown of a file that is not KRL at all. */
  private static final int SHOWN = 20;

  private final LoadingMode mode;
  private final List<FileReport> reports = new ArrayList<>();

  /** The reports of programs that were loaded one by one. */
  private final List<FileReport> single = new ArrayList<>();

  public LoadedFiles(boolean strict) {
    this.mode = strict ? LoadingMode.STRICT : LoadingMode.LENIENT;
  }

  public LoadingMode mode() {
    return mode;
  }

  /** Reads an archive; in the order of the arguments if there are several places. */
  public static Archive open(List<Path> places) throws FileException {
    try {
      return Archive.open(places);
    } catch (FileSystemException e) {
      throw FileException.cannot("read", Path.of(e.getFile()), e);
    } catch (IOException e) {
      throw FileException.cannot("read", places.get(0), e);
    }
  }

  /**
   * Adds the reports of an archive.
   *
   * @throws FileException if the mode is strict and a file was refused
   */
  public void add(LoadReport report) throws FileException {
    reports.addAll(report.files());
    if (mode == LoadingMode.STRICT && report.anyRefused()) {
      List<String> details =
          report.files().stream()
              .filter(file -> file.outcome() == Outcome.REFUSED)
              .flatMap(file -> problems(file).stream())
              .toList();
      throw new FileException(
          "the archive has files with errors:", details, new KrlFileException(report.problems()));
    }
  }

  /**
   * Loads a file, and the data list next to a program.
   *
   * @return the name of the module
   * @throws FileException if it cannot be read, or was refused
   */
  public String load(Controller controller, Path file) throws FileException {
    LoadReport report;
    try {
      report = controller.load(file, mode);
    } catch (IOException e) {
      throw FileException.cannot("read", file, e);
    }
    FileReport loaded = report.files().get(0);
    if (loaded.module().isEmpty()) {
      throw cannotLoad(file, report.problems());
    }
    reports.addAll(report.files());
    if (!LocalFiles.name(file).toLowerCase(Locale.ROOT).endsWith(".dat")) {
      single.add(loaded);
    }
    return loaded.module();
  }

  /**
   * Loads a program, or finds it among the loaded ones if there is no such file here.
   *
   * @param archive whether an archive was loaded
   * @return the name of the module
   */
  public String loadOrFind(Controller controller, Path file, boolean archive) throws FileException {
    if (archive && !Files.exists(file)) {
      List<FileReport> named = reports.stream().filter(each -> isNamed(each, file)).toList();
      Optional<FileReport> used = named.stream().filter(each -> !each.module().isEmpty()).findAny();
      if (used.isPresent()) {
        return used.get().module();
      }
      if (!named.isEmpty()) {
        throw cannotLoad(file, named.get(0).problems());
      }
      String name = LocalFiles.name(file).replaceFirst("\\.\\w+$", "");
      for (String known : controller.programs()) {
        if (known.equalsIgnoreCase(name)) {
          return known;
        }
      }
    }
    return load(controller, file);
  }

  private static boolean isNamed(FileReport loaded, Path file) {
    String path = loaded.path();
    return path.substring(path.lastIndexOf('/') + 1).equalsIgnoreCase(LocalFiles.name(file));
  }

  private static FileException cannotLoad(Path file, List<KrlError> problems) {
    KrlFileException reason = new KrlFileException(problems);
    return new FileException(
        "cannot load " + file + ":", String.valueOf(reason.getMessage()).lines().toList(), reason);
  }

  /** Adds the names that are missing to the reports of single programs, after all were loaded. */
  public void check(Controller controller) {
    reports.replaceAll(file -> single.contains(file) ? checked(controller, file) : file);
  }

  private static FileReport checked(Controller controller, FileReport file) {
    List<KrlError> missing = controller.check(file.module());
    if (missing.isEmpty()) {
      return file;
    }
    List<KrlError> all = new ArrayList<>(file.problems());
    all.addAll(missing);
    return new FileReport(file.path(), file.module(), Outcome.WARNINGS, all);
  }

  public List<FileReport> reports() {
    return reports;
  }

  /** Returns a line for each file, with its problems below. */
  public List<String> lines() {
    List<String> lines = new ArrayList<>();
    for (FileReport file : reports) {
      lines.add(line(file));
      shown(file).forEach(problem -> lines.add("  " + problem));
    }
    return lines;
  }

  /** Returns the first problems of a file, and the number of the others. */
  private static List<String> shown(FileReport file) {
    List<String> shown = new ArrayList<>(problems(file));
    int rest = shown.size() - SHOWN;
    if (rest > 0) {
      shown.subList(SHOWN, shown.size()).clear();
      shown.add(file.path() + ": " + rest + " more; krl check shows all");
    }
    return shown;
  }

  /** Returns a line for each problem that is shown. */
  public List<String> warnings() {
    return reports.stream()
        .flatMap(file -> shown(file).stream())
        .map(problem -> "warning: " + problem)
        .toList();
  }

  private static String line(FileReport file) {
    int count = file.problems().size();
    return switch (file.outcome()) {
      case LOADED -> "loaded " + file.path();
      case WARNINGS ->
          "loaded with " + count + (count == 1 ? " warning " : " warnings ") + file.path();
      case REFUSED -> "refused " + file.path();
    };
  }

  /** Returns the problems of a file with their places in it. */
  public static List<String> problems(FileReport file) {
    return file.problems().stream()
        .map(
            problem ->
                file.path()
                    + ":"
                    + problem.position().line()
                    + ":"
                    + problem.position().column()
                    + ": "
                    + problem.message())
        .toList();
  }

  /** Returns the result of a file as a line of JSON. */
  public static String json(FileReport file) {
    return JsonLine.object(
        json -> {
          json.writeStringField("file", file.path());
          json.writeStringField("outcome", file.outcome().name().toLowerCase(Locale.ROOT));
          json.writeArrayFieldStart("problems");
          for (KrlError problem : file.problems()) {
            json.writeStartObject();
            json.writeNumberField("line", problem.position().line());
            json.writeNumberField("column", problem.position().column());
            json.writeStringField("message", problem.message());
            json.writeEndObject();
          }
          json.writeEndArray();
        });
  }
}
