package no.hials.crosscom.simulator.internal.files;

import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import no.hials.crosscom.lang.KrlEncoding;
import org.jspecify.annotations.Nullable;

/**
 * Finds the place on the controller of each file of an archive
 * (docs/reference/simulated-controller.md#archives). An archive can begin at any folder of the
 * controller, can have folders around it, or consist of single files. Case does not matter.
 */
public final class ArchiveLayout {
  private static final Set<String> TOPS = Set.of("R1", "STEU");

  /** The folders of R1, each with the files that belong there if they come alone. */
  private static final Set<String> FOLDERS = Set.of("MADA", "PROGRAM", "SYSTEM", "TP");

  private static final Set<String> OF_SYSTEM =
      Set.of("BAS", "IR_STOPM", "SPS", "MSGLIB", "$CONFIG", "KRL_UTIL");

  /** The folders around the archive; null if no file is in a folder of a controller. */
  private final @Nullable String around;

  /**
   * Recognises the layout.
   *
   * @param paths all paths in the archive
   */
  public ArchiveLayout(List<String> paths) {
    around =
        paths.stream()
            .filter(path -> begin(path) >= 0)
            .map(ArchiveLayout::around)
            .findFirst()
            .orElse(null);
  }

  /** Returns the index of the first part that is a folder of the controller; -1 without one. */
  private static int begin(String path) {
    List<String> parts = parts(path);
    List<String> folders = parts.subList(0, parts.size() - 1);
    return folders.stream()
        .filter(TOPS::contains)
        .findFirst()
        .or(() -> folders.stream().filter("KRC"::equals).findFirst())
        .or(() -> folders.stream().filter(FOLDERS::contains).findFirst())
        .map(folders::indexOf)
        .orElse(-1);
  }

  private static List<String> parts(String path) {
    return Arrays.asList(path.toUpperCase(Locale.ROOT).split("/"));
  }

  private static String around(String path) {
    List<String> before = parts(path).subList(0, begin(path));
    int length = String.join("/", before).length();
    boolean inKrc = !before.isEmpty() && before.get(before.size() - 1).equals("KRC");
    return path.substring(0, inKrc ? length - "KRC".length() : length == 0 ? 0 : length + 1);
  }

  /**
   * Returns the place of a file.
   *
   * @return its path below {@code KRC:\}, with slashes
   */
  public String place(ArchivedFile file) {
    String path = file.path();
    int begin = begin(path);
    if (begin < 0) {
      return around == null ? alone(file) : withoutFolders(path);
    }
    String[] parts = path.split("/");
    String first = parts[begin].toUpperCase(Locale.ROOT);
    if (first.equals("KRC")) {
      return rest(parts, begin + 1);
    }
    return TOPS.contains(first) ? rest(parts, begin) : "R1/" + rest(parts, begin);
  }

  private static String rest(String[] parts, int from) {
    return String.join("/", Arrays.asList(parts).subList(from, parts.length));
  }

  private String withoutFolders(String path) {
    return around != null && path.startsWith(around) ? path.substring(around.length()) : path;
  }

  private static String alone(ArchivedFile file) {
    String upper = file.name().toUpperCase(Locale.ROOT);
    int dot = upper.lastIndexOf('.');
    String module = file.isModule() ? upper.substring(0, dot) : "";
    if (OF_SYSTEM.contains(module)) {
      return "R1/System/" + file.name();
    }
    if (module.equals("CELL")) {
      return "R1/" + file.name();
    }
    if (module.equals("$ROBCOR") || (module.equals("$MACHINE") && isOfRobot(file))) {
      return "R1/Mada/" + file.name();
    }
    if (module.startsWith("$") && upper.endsWith(".DAT")) {
      return "STEU/Mada/" + file.name();
    }
    return upper.equals("AM.INI") ? file.name() : "R1/Program/" + file.path();
  }

  /** The machine data of the robot name it (docs/reference/robots.md#machine-data). */
  private static boolean isOfRobot(ArchivedFile file) {
    return KrlEncoding.decode(file.content()).toUpperCase(Locale.ROOT).contains("$TRAFONAME");
  }
}
