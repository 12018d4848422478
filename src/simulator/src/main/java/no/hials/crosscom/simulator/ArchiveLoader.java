package no.hials.crosscom.simulator;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Objects;
import java.util.Set;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.FutureTask;
import java.util.function.Function;
import no.hials.crosscom.lang.KrlError;
import no.hials.crosscom.lang.KrlParser;
import no.hials.crosscom.lang.ParseResult;
import no.hials.crosscom.protocol.value.KrlEncoding;
import no.hials.crosscom.simulator.LoadReport.FileReport;
import no.hials.crosscom.simulator.LoadReport.Outcome;
import no.hials.crosscom.simulator.internal.data.DataListLoader;
import no.hials.crosscom.simulator.internal.files.ArchivedFile;
import org.jspecify.annotations.Nullable;

/**
 * Loads the programs and data lists of an archive in this order
 * (docs/reference/simulated-controller.md#archives): the lists of the controller, those of STEU
 * first, so that those of R1 take effect; the lists of modules; the programs.
 *
 * <p>A daemon thread parses files while others are loaded, and ends when all are parsed.
 */
final class ArchiveLoader {
  /** The largest file that is parsed before it is needed. */
  private static final int MAX_EARLY = 1 << 20;

  private final Archive archive;
  private final ModuleLoader loader;
  private final LoadingMode mode;

  /** The reports by the places of the files, in the order of loading. */
  private final Map<String, FileReport> reports = new LinkedHashMap<>();

  /** The trees of the files by their places, in the order of loading. */
  private final Map<String, FutureTask<ParseResult>> trees = new LinkedHashMap<>();

  /** The names of the loaded modules, by the places of their files. */
  private final Map<String, String> modules = new LinkedHashMap<>();

  /** The places of the files whose name or module another file has, which is loaded. */
  private final Set<String> replaced = new HashSet<>();

  ArchiveLoader(Archive archive, ModuleLoader loader, LoadingMode mode) {
    this.archive = archive;
    this.loader = loader;
    this.mode = mode;
  }

  /** The steps of loading, in their order. */
  private enum Step {
    CABINET,
    GLOBALS,
    ROBOT,
    LISTS,
    PROGRAMS
  }

  private static Step step(String place) {
    String upper = place.toUpperCase(Locale.ROOT);
    if (!upper.endsWith(".DAT")) {
      return Step.PROGRAMS;
    }
    if (!upper.contains("/$")) {
      return Step.LISTS;
    }
    if (!upper.startsWith("R1/")) {
      return Step.CABINET;
    }
    return upper.endsWith("/$CONFIG.DAT") ? Step.GLOBALS : Step.ROBOT;
  }

  /** Returns whether a file is a program or a list that the controller uses. */
  private static boolean isUsed(Map.Entry<String, ArchivedFile> file) {
    String place = file.getKey().toUpperCase(Locale.ROOT);
    return file.getValue().isModule()
        && (place.startsWith("R1/") || (place.contains("/$") && place.endsWith(".DAT")));
  }

  /** Returns a text for sorting, which puts the files of a folder before its folders. */
  private static String beforeFolders(String place) {
    return new StringBuilder(place).insert(place.lastIndexOf('/') + 1, '\0').toString();
  }

  /** Loads all files; their linking comes last, because each may use any other. */
  void load() {
    List<String> places =
        archive.files().entrySet().stream()
            .filter(ArchiveLoader::isUsed)
            .map(Map.Entry::getKey)
            // of several files of one name the first is used, as in the file tree
            .sorted(
                Comparator.comparing(ArchiveLoader::step)
                    .thenComparing(place -> !place.toUpperCase(Locale.ROOT).contains("R1/PROGRAM/"))
                    .thenComparing(ArchiveLoader::beforeFolders, String.CASE_INSENSITIVE_ORDER))
            .toList();
    parse(places);
    Map<String, String> first = new HashMap<>();
    places.forEach(place -> first.putIfAbsent(name(place), place));
    Map<String, String> owners = new HashMap<>();
    for (String place : places) {
      String other = Objects.requireNonNull(first.get(name(place)));
      String owner = other.equals(place) ? owner(place, first, owners) : place;
      if (!other.equals(place)) {
        replace(place, "another file of this name is loaded: ", other);
      } else if (!owner.equals(place)) {
        replace(place, "another file has its module " + module(place) + ", and is loaded: ", owner);
      } else {
        load(place);
      }
    }
    // a list may use a type of a list that comes later
    for (String place : List.copyOf(reports.keySet())) {
      FileReport before = report(place);
      if (step(place) == Step.LISTS && !replaced.contains(place) && !before.problems().isEmpty()) {
        load(place);
        if (report(place).problems().size() > before.problems().size()) {
          put(place, before);
        } else {
          warn(place, before.problems().stream().filter(DataListLoader::isReplacement).toList());
        }
      }
    }
    checkNames();
  }

  private void replace(String place, String reason, String other) {
    replaced.add(place);
    refuse(place, reason + file(other).path());
  }

  private void refuse(String place, String reason) {
    ArchivedFile file = file(place);
    put(place, FileReport.refused(file.path(), List.of(Archive.problem(file.name(), reason))));
  }

  /**
   * Returns the place of the file whose module is loaded: of several files with one module, as
   * copies are, that with its name, else the first.
   *
   * @param first the places of the files by their names
   * @param owners the places of the modules, to which that of this file is added
   */
  private String owner(String place, Map<String, String> first, Map<String, String> owners) {
    String module = module(place);
    if (module == null || module.startsWith("$")) {
      return place;
    }
    String key = module + place.substring(place.lastIndexOf('.')).toUpperCase(Locale.ROOT);
    String named = first.getOrDefault(key, place);
    return !named.equals(place) && module.equals(module(named))
        ? named
        : owners.computeIfAbsent(key, same -> place);
  }

  /** Returns the name of a module in upper case; null if the file is not KRL. */
  private @Nullable String module(String place) {
    try {
      return parsed(place).file().map(file -> file.name().toUpperCase(Locale.ROOT)).orElse(null);
    } catch (KrlFileException | RuntimeException | VirtualMachineError e) {
      return null; // see load
    }
  }

  /** Begins to parse the files in a thread of its own, which ends when all are parsed. */
  private void parse(List<String> places) {
    for (String place : places) {
      ArchivedFile file = file(place);
      trees.put(place, new FutureTask<>(() -> parse(file)));
    }
    // two large files at once could fill the memory
    List<FutureTask<ParseResult>> early =
        places.stream()
            .filter(place -> file(place).content().length <= MAX_EARLY)
            .map(this::tree)
            .toList();
    Thread thread = new Thread(() -> early.forEach(FutureTask::run), "simulator-archive-parser");
    thread.setDaemon(true);
    thread.start();
  }

  private FutureTask<ParseResult> tree(String place) {
    return Objects.requireNonNull(trees.get(place));
  }

  /** Returns the name that must be unique: of a list of the controller, with STEU or R1. */
  private static String name(String place) {
    String upper = place.toUpperCase(Locale.ROOT);
    String file = upper.substring(upper.lastIndexOf('/') + 1);
    return file.startsWith("$") ? upper.substring(0, upper.indexOf('/') + 1) + file : file;
  }

  private ArchivedFile file(String place) {
    return Objects.requireNonNull(archive.files().get(place));
  }

  private FileReport report(String place) {
    return Objects.requireNonNull(reports.get(place));
  }

  private void put(String place, FileReport report) {
    reports.put(place, report);
  }

  private void load(String place) {
    ArchivedFile file = file(place);
    try {
      ModuleLoader.Loaded loaded = loader.take(file.name(), parsed(place), mode);
      put(place, named(file, loaded.report().files().get(0)));
      if (loaded.module() != null) {
        modules.put(place, loaded.module().name());
      }
    } catch (KrlFileException e) {
      put(place, FileReport.refused(file.path(), e.errors()));
    } catch (RuntimeException | VirtualMachineError e) {
      refuse(place, "the file cannot be loaded: " + e);
    }
  }

  /** Adds the files that clients cannot see. */
  private void checkNames() {
    archive
        .files()
        .forEach(
            (place, file) ->
                Archive.nameProblem(place)
                    .map(problem -> Archive.problem(file.name(), problem))
                    .ifPresent(problem -> warn(place, List.of(problem))));
  }

  private ParseResult parsed(String place) throws KrlFileException {
    FutureTask<ParseResult> tree = tree(place);
    tree.run(); // here, unless the other thread has begun
    try {
      return tree.get();
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      return parse(file(place));
    } catch (ExecutionException e) {
      return parse(file(place)); // fails here, too
    }
  }

  private static ParseResult parse(ArchivedFile file) throws KrlFileException {
    ModuleLoader.checkLength(file.name(), file.content().length, ModuleLoader.MAX_LENGTH);
    return KrlParser.parse(file.name(), KrlEncoding.decode(file.content()));
  }

  private static FileReport named(ArchivedFile file, FileReport report) {
    return new FileReport(file.path(), report.module(), report.outcome(), report.problems());
  }

  /** Adds what a check of each program finds: routines and variables that are missing. */
  void check(Function<String, List<KrlError>> checker) {
    modules.forEach(
        (place, module) -> {
          if (step(place) == Step.PROGRAMS) {
            warn(place, checker.apply(module));
          }
        });
  }

  private void warn(String place, List<KrlError> problems) {
    FileReport before =
        reports.getOrDefault(place, FileReport.loaded(file(place).path(), "", List.of()));
    if (!problems.isEmpty()) {
      List<KrlError> all = new ArrayList<>(before.problems());
      all.addAll(problems);
      boolean refused = before.outcome() == Outcome.REFUSED;
      put(
          place,
          new FileReport(
              before.path(), before.module(), refused ? Outcome.REFUSED : Outcome.WARNINGS, all));
    }
  }

  /** Starts the submit program that a controller starts. */
  void start(ProgramControl submit) {
    modules.forEach(
        (place, module) -> {
          if (place.toUpperCase(Locale.ROOT).endsWith("/SPS.SUB")) {
            start(submit, place, module);
          }
        });
  }

  private void start(ProgramControl submit, String place, String module) {
    try {
      submit.select(module);
      submit.start();
    } catch (KrlFileException | IllegalStateException e) {
      // its errors are among the warnings already
      String reason = "the submit interpreter cannot start it";
      warn(place, List.of(Archive.problem(file(place).name(), reason)));
    }
  }

  /** Returns the loaded modules by the full names of their files in capital letters. */
  Map<String, String> modules() {
    Map<String, String> names = new HashMap<>();
    modules.forEach(
        (place, name) -> names.put(Archive.fullName(place).toUpperCase(Locale.ROOT), name));
    return names;
  }

  LoadReport report() {
    List<FileReport> all = new ArrayList<>(archive.refused());
    all.addAll(reports.values());
    return new LoadReport(all);
  }
}
