package no.hials.crosscom.simulator.internal.files;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;

/**
 * The path of an item that may exist or not. Its names are safe on every file system: no {@code
 * ..}, no device of Windows, no character with a meaning to a shell or a drive.
 *
 * @param names the names from {@code KRC:\} downwards; none for {@code KRC:\} itself
 */
public record ControllerPath(List<String> names) {
  /** {@code KRC:\} itself. */
  public static final ControllerPath ROOT = new ControllerPath(List.of());

  private static final String DRIVE = "KRC:";

  /** The limit of Windows without the NUL at the end; assumed for a KR C4. */
  private static final int MAX_LENGTH = 259;

  private static final String FORBIDDEN = "<>:\"|?*/\\";

  private static final Set<String> DEVICES = Set.of("CON", "PRN", "AUX", "NUL");

  public ControllerPath {
    names = List.copyOf(names);
  }

  /** A name from a client: its path, and which of the two forms it had. */
  record Parsed(ControllerPath path, boolean krcForm) {}

  /** Parses {@code KRC:\R1\X.SRC} or {@code /R1/X.SRC}, with either kind of slash. */
  static Parsed parse(String text) throws FileRefusedException {
    String slashed = text.replace('/', '\\');
    boolean full = slashed.regionMatches(true, 0, DRIVE, 0, DRIVE.length());
    String rest = full ? slashed.substring(DRIVE.length()) : slashed;
    if (rest.isEmpty() ? !full : rest.charAt(0) != '\\') {
      throw FileRefusedException.argument(
          "a name must begin with KRC:\\ or a slash, is " + quoted(text));
    }
    List<String> names = new ArrayList<>();
    for (String name : rest.split("\\\\", -1)) {
      names.add(name);
    }
    names.remove(0);
    if (!names.isEmpty() && names.get(names.size() - 1).isEmpty()) {
      // a slash at the end is allowed (docs/reference/c3-messages.md#files-20-to-28)
      names.remove(names.size() - 1);
    }
    ControllerPath path = ROOT;
    for (String name : names) {
      path = path.child(name);
    }
    return new Parsed(path, !full);
  }

  /** Returns why a text is not the name of a file. */
  public static Optional<String> problem(String text) {
    try {
      parse(text);
      return Optional.empty();
    } catch (FileRefusedException e) {
      return Optional.ofNullable(e.getMessage());
    }
  }

  /** Appends a name, which is checked. */
  ControllerPath child(String name) throws FileRefusedException {
    if (!isSafe(name)) {
      throw FileRefusedException.argument(quoted(name) + " cannot be the name of a file");
    }
    ControllerPath child = known(name);
    if (child.fullName().length() > MAX_LENGTH) {
      throw FileRefusedException.argument(
          "a full name has at most "
              + MAX_LENGTH
              + " characters, has "
              + child.fullName().length());
    }
    return child;
  }

  /** Appends the name of an item that exists. */
  ControllerPath known(String name) {
    List<String> longer = new ArrayList<>(names);
    longer.add(name);
    return new ControllerPath(longer);
  }

  static boolean isSafe(String name) {
    if (name.isEmpty() || name.endsWith(".") || name.endsWith(" ") || name.startsWith(" ")) {
      return false;
    }
    boolean good =
        name.chars()
            .allMatch(
                c ->
                    c >= ' '
                        && c != 0x7F
                        && !Character.isSurrogate((char) c)
                        && FORBIDDEN.indexOf(c) < 0);
    return good && !isDevice(name);
  }

  private static boolean isDevice(String name) {
    int dot = name.indexOf('.');
    String base = (dot < 0 ? name : name.substring(0, dot)).strip().toUpperCase(Locale.ROOT);
    return DEVICES.contains(base) || base.matches("(COM|LPT)[0-9¹²³]");
  }

  private static String quoted(String text) {
    StringBuilder shown = new StringBuilder("\"");
    text.chars().limit(60).forEach(c -> shown.append(c < ' ' || c == 0x7F ? '?' : (char) c));
    return shown.append('"').toString();
  }

  boolean isRoot() {
    return names.isEmpty();
  }

  /** Returns the last name; empty for the root. */
  public String name() {
    return isRoot() ? "" : names.get(names.size() - 1);
  }

  /** Returns the folder of this item; the root is its own folder. */
  ControllerPath parent() {
    return isRoot() ? this : new ControllerPath(names.subList(0, names.size() - 1));
  }

  /** Returns the form {@code KRC:\R1\Program\x.src}, with the names spelled as they are. */
  public String fullName() {
    return DRIVE + "\\" + String.join("\\", names);
  }

  /** Returns whether another path is this one or below it. */
  boolean contains(ControllerPath other) {
    return other.names.size() >= names.size()
        && new ControllerPath(other.names.subList(0, names.size())).isSame(this);
  }

  /** Returns whether another path is this one, ignoring case. */
  boolean isSame(ControllerPath other) {
    return names.size() == other.names.size() && fullName().equalsIgnoreCase(other.fullName());
  }

  /** Converts each character to upper case, without changing the length. */
  static String upper(String text) {
    StringBuilder upper = new StringBuilder(text.length());
    text.chars().forEach(c -> upper.append(Character.toUpperCase((char) c)));
    return upper.toString();
  }

  @Override
  public String toString() {
    return fullName();
  }
}
