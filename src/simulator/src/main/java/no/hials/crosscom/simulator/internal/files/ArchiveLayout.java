package no.hials.crosscom.simulator.internal.files;

import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.stream.Stream;
import no.hials.crosscom.protocol.value.KrlEncoding;
import org.jspecify.annotations.Nullable;

/**
 * Finds the place on the controller of each file of an archive
 * (docs/reference/simulated-controller.md#archives). An archive can begin at any folder of the
 * controller, can have folders around it, or consist of single files. Case does not matter.
 */
public final class ArchiveLayout {
  private static final Set<String> TOPS = Set.of("R1", "STEU");

  private static final Set<String> KRC = Set.of("KRC");

  /** The folders of R1, each with the files that belong there if they come alone. */
  private static final Set<String> FOLDERS = Set.of("MADA", "PROGRAM", "SYSTEM", "TP");

  private static final String PROGRAMS = "R1/Program/";

  private static final Set<String> OF_SYSTEM =
      Set.of("BAS", "IR_STOPM", "SPS", "MSGLIB", "$CONFIG", "KRL_UTIL");

  /** Whether a file is in R1 or STEU; the others are then not on the controller. */
  private final boolean hasTops;

  /** The folders around the archive; null if no file is in a folder of a controller. */
  private final @Nullable String around;

  /**
   * Recognises the layout.
   *
   * @param paths all paths in the archive
   */
  public ArchiveLayout(List<String> paths) {
    hasTops = paths.stream().anyMatch(path -> folders(path).stream().anyMatch(TOPS::contains));
    around =
        paths.stream().filter(path -> begin(path) >= 0).map(this::around).findFirst().orElse(null);
  }

  /** Returns the index of the first part that is a folder of the controller; -1 without one. */
  private int begin(String path) {
    List<String> folders = folders(path);
    return Stream.of(TOPS, hasTops ? KRC : FOLDERS, hasTops ? FOLDERS : KRC)
        .flatMap(wanted -> folders.stream().filter(wanted::contains).limit(1))
        .findFirst()
        .map(folders::indexOf)
        .orElse(-1);
  }

  private static List<String> folders(String path) {
    List<String> parts = parts(path);
    return parts.subList(0, parts.size() - 1);
  }

  private static List<String> parts(String path) {
    return Arrays.asList(path.toUpperCase(Locale.ROOT).split("/"));
  }

  private String around(String path) {
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
      return around == null ? alone(file) : next(file);
    }
    String[] parts = path.split("/");
    String first = parts[begin].toUpperCase(Locale.ROOT);
    if (KRC.contains(first)) {
      String rest = rest(parts, begin + 1);
      return hasTops || !file.isModule() ? rest : PROGRAMS + rest;
    }
    return TOPS.contains(first) ? rest(parts, begin) : "R1/" + rest(parts, begin);
  }

  private static String rest(String[] parts, int from) {
    return String.join("/", Arrays.asList(parts).subList(from, parts.length));
  }

  /**
   * Returns whether a program or a list is next to R1 and STEU, so that the controller does not
   * have it.
   */
  public boolean isOutside(ArchivedFile file) {
    return hasTops && file.isModule() && begin(file.path()) < 0;
  }

  /** Returns the place of a file that is next to the folders of a controller. */
  private String next(ArchivedFile file) {
    String path = file.path();
    boolean inside = around != null && path.startsWith(around);
    String rest = around != null && inside ? path.substring(around.length()) : path;
    if (hasTops || !file.isModule()) {
      return rest;
    }
    return (inside ? "R1/" : PROGRAMS) + rest;
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
    return upper.equals("AM.INI") ? file.name() : PROGRAMS + file.path();
  }

  /** The machine data of the robot name it (docs/reference/robots.md#machine-data). */
  private static boolean isOfRobot(ArchivedFile file) {
    return KrlEncoding.decode(file.content()).toUpperCase(Locale.ROOT).contains("$TRAFONAME");
  }
}
