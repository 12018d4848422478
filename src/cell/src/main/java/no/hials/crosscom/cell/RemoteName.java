package no.hials.crosscom.cell;

import java.util.Locale;

/**
 * Splits and joins names of files on the controller, such as {@code KRC:\R1\PROGRAM\X.SRC} and
 * {@code /R1/X.SRC}.
 */
public final class RemoteName {
  private RemoteName() {}

  /** Returns whether it can only be a folder: it ends with a slash or a backslash. */
  public static boolean isFolder(String name) {
    return name.endsWith("/") || name.endsWith("\\");
  }

  /** Returns the last part, such as {@code X.SRC}. */
  public static String last(String name) {
    return name.substring(Math.max(name.lastIndexOf('/'), name.lastIndexOf('\\')) + 1);
  }

  /** Returns the name of a file in a folder, in the folder's form. */
  public static String in(String folder, String name) {
    if (isFolder(folder)) {
      return folder + name;
    }
    boolean slashes = folder.indexOf('/') >= 0 && folder.indexOf('\\') < 0;
    return folder + (slashes ? "/" : "\\") + name;
  }

  /** Returns whether a name has an ending, in any case. */
  public static boolean hasEnding(String name, String ending) {
    return name.toLowerCase(Locale.ROOT).endsWith(ending);
  }

  /** Returns a name without the ending of its last part, if that has one. */
  public static String withoutEnding(String name) {
    int dot = name.lastIndexOf('.');
    return dot <= name.length() - last(name).length() ? name : name.substring(0, dot);
  }

  /**
   * Returns the name of the data list of a program, in capital letters if the program's ending is.
   */
  public static String dataListOf(String program) {
    boolean capitals = program.endsWith(".SRC") || program.endsWith(".SUB");
    return withoutEnding(program) + (capitals ? ".DAT" : ".dat");
  }

  /** Returns whether it is the name of a program. */
  public static boolean isProgram(String name) {
    return hasEnding(name, ".src") || hasEnding(name, ".sub");
  }
}
