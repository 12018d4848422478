package no.hials.crosscom.simulator;

import java.io.IOException;
import java.nio.file.Path;
import java.time.Clock;
import java.util.ArrayList;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import no.hials.crosscom.lang.KrlError;
import no.hials.crosscom.lang.Position;
import no.hials.crosscom.protocol.value.KrlEncoding;
import no.hials.crosscom.simulator.LoadReport.FileReport;
import no.hials.crosscom.simulator.internal.files.ArchiveLayout;
import no.hials.crosscom.simulator.internal.files.ArchiveReader;
import no.hials.crosscom.simulator.internal.files.ArchivedFile;
import no.hials.crosscom.simulator.internal.files.ControllerPath;

/**
 * The files of a controller as its archive has them: data lists, programs and other files. {@link
 * Controller#load(Archive, LoadingMode)} loads them.
 *
 * <p>It is a zip or a folder in any layout (docs/reference/simulated-controller.md#archives):
 * {@code KRC/R1/...}, {@code R1/...}, {@code Program/...}, or files without folders, in any case.
 * The files are read once, into memory: nothing changes the zip or the folder.
 *
 * <p>Immutable.
 */
public final class Archive {
  private static final Pattern SETTING = Pattern.compile("(?m)^\\s*(\\w+)\\s*=[ \\t]*(.*?)\\s*$");

  /** The bytes that clients can add to the files, as in {@link FileTree#inMemory()}. */
  private static final long ROOM = FileTree.DEFAULT_CAPACITY;

  private static final int FILE_COST = 1024;

  private static final String OUTSIDE = "not loaded: it is not in R1 or STEU as other files are";

  /** The files by their places below {@code KRC:\}. */
  private final Map<String, ArchivedFile> files = new TreeMap<>(String.CASE_INSENSITIVE_ORDER);

  /** The files that cannot be used. */
  private final List<FileReport> refused = new ArrayList<>();

  /** The names of the zips and folders of the files, if there are several. */
  private final IdentityHashMap<ArchivedFile, String> origins = new IdentityHashMap<>();

  private Archive(List<Path> places, List<List<ArchivedFile>> contents) {
    for (int i = 0; i < contents.size(); i++) {
      add(contents.get(i), places.size() > 1 ? " of " + places.get(i) : "");
    }
  }

  private void add(List<ArchivedFile> all, String origin) {
    ArchiveLayout layout =
        new ArchiveLayout(
            all.stream().filter(f -> f.refusal() == null).map(ArchivedFile::path).toList());
    for (ArchivedFile file : all) {
      String refusal = file.refusal();
      if (refusal == null && layout.isOutside(file)) {
        refusal = OUTSIDE;
      }
      if (refusal != null) {
        refuse(file, refusal);
        continue;
      }
      origins.put(file, origin);
      ArchivedFile other = files.putIfAbsent(layout.place(file), file);
      if (other != null) {
        refuse(
            file,
            "the file"
                + origin
                + " is not used: the archive has it already, as "
                + other.path()
                + origins.get(other));
      }
    }
  }

  private void refuse(ArchivedFile file, String reason) {
    refused.add(FileReport.refused(file.path(), List.of(problem(file.name(), reason))));
  }

  static KrlError problem(String file, String reason) {
    return new KrlError(new Position(file, 1, 1), reason);
  }

  /**
   * Reads an archive. Files of more than 32 MiB, and all after 128 MiB in total, are left out, as
   * are those with {@code ..} in their path in a zip; the report of loading names them.
   *
   * @param place a zip, a folder, or a single file
   * @return the archive
   * @throws IOException if it cannot be read, or has no program and no data list
   */
  public static Archive open(Path place) throws IOException {
    return open(List.of(place));
  }

  /**
   * Reads several places as one archive, as {@link #open(Path)} does.
   *
   * @param places zips, folders and single files
   * @return the archive
   * @throws IOException if one cannot be read, or none has a program or a data list
   */
  public static Archive open(List<Path> places) throws IOException {
    return new Archive(places, ArchiveReader.read(places));
  }

  /** Returns the files by their places below {@code KRC:\}, ignoring case. */
  Map<String, ArchivedFile> files() {
    return files;
  }

  /** Returns the reports of the files that cannot be used. */
  List<FileReport> refused() {
    return refused;
  }

  /**
   * Lists the programs in {@code KRC:\R1\Program} and its folders.
   *
   * @return the names of their files without {@code .src}, sorted
   */
  public List<String> programs() {
    return files.entrySet().stream()
        .filter(file -> file.getKey().toUpperCase(Locale.ROOT).startsWith("R1/PROGRAM/"))
        .map(file -> file.getValue().name())
        .filter(name -> name.toUpperCase(Locale.ROOT).endsWith(".SRC"))
        .map(name -> name.substring(0, name.length() - ".src".length()))
        .sorted(String.CASE_INSENSITIVE_ORDER)
        .toList();
  }

  /**
   * Returns the description in {@code am.ini}: the robot's name, its serial number, the version of
   * KSS. Which of its settings these are is assumed: the first with a value whose name contains
   * name, serial or version.
   *
   * @return such as {@code name Cell 4, serial 123456, version 8.3}; empty without that file
   */
  public Optional<String> description() {
    ArchivedFile settings = files.get("am.ini");
    if (settings == null) {
      return Optional.empty();
    }
    Map<String, String> found = new TreeMap<>();
    Matcher matcher = SETTING.matcher(KrlEncoding.decode(settings.content()));
    while (matcher.find()) {
      for (String kind : List.of("name", "serial", "version")) {
        if (!matcher.group(2).isEmpty()
            && matcher.group(1).toLowerCase(Locale.ROOT).contains(kind)) {
          found.putIfAbsent(kind, kind + " " + matcher.group(2));
        }
      }
    }
    return found.isEmpty() ? Optional.empty() : Optional.of(String.join(", ", found.values()));
  }

  /**
   * Creates a tree in memory with the files of this archive, byte for byte. Clients change the
   * tree, never the archive. A file whose name a controller cannot have is left out; the report of
   * loading has a warning. The data lists of {@link FileTree#inMemory()} stay where the archive has
   * none.
   *
   * @return a new tree
   */
  public FileTree tree() {
    long bytes = files.values().stream().mapToLong(file -> file.content().length).sum();
    FileTree tree =
        FileTree.inMemory(Clock.systemUTC(), bytes + (long) FILE_COST * files.size() + ROOM);
    files.forEach(
        (place, file) -> {
          try {
            tree.put(fullName(place), file.content());
          } catch (IOException e) {
            // see nameProblem
          }
        });
    return tree;
  }

  /** Returns why clients cannot see a file, which has a name that a controller cannot have. */
  static Optional<String> nameProblem(String place) {
    return ControllerPath.problem(fullName(place))
        .map(problem -> "not among the files of C3 Bridge: " + problem);
  }

  static String fullName(String place) {
    return "KRC:\\" + place.replace('/', '\\');
  }
}
