package no.hials.crosscom.lang;

import org.jspecify.annotations.Nullable;

/**
 * What the comment behind a declaration says of a variable.
 *
 * <p>The data lists of this project write {@code ;RO [mm/deg] commanded tool centre point (FIW)}:
 * access, unit or {@code -}, meaning, source. Any other comment is the meaning as it stands. A data
 * list of KSS has no access rights, so this is a form of our own.
 *
 * @param access what clients may do; null if it does not say
 * @param unit the unit; empty if it has none or does not say
 * @param meaning what the variable stands for; empty if it does not say
 * @param source where that is known from; empty if it does not say
 */
public record VariableNote(@Nullable Access access, String unit, String meaning, String source) {
  /** Says nothing. */
  public static final VariableNote NONE = new VariableNote(null, "", "", "");

  private static final String NO_UNIT = "-";

  /**
   * Reads a comment.
   *
   * @param comment what stands behind {@code ;}
   * @return what it says
   */
  public static VariableNote of(String comment) {
    String text = comment.strip();
    Access access = null;
    if (text.startsWith("RO [")) {
      access = Access.READ_ONLY;
    } else if (text.startsWith("RW [")) {
      access = Access.READ_WRITE;
    }
    int unitEnd = text.indexOf("] ");
    int sourceStart = text.lastIndexOf('(');
    if (access == null || unitEnd < 0 || sourceStart < unitEnd || !text.endsWith(")")) {
      return new VariableNote(null, "", text, "");
    }
    String unit = text.substring("RO [".length(), unitEnd);
    return new VariableNote(
        access,
        unit.equals(NO_UNIT) ? "" : unit,
        text.substring(unitEnd + 1, sourceStart).strip(),
        text.substring(sourceStart + 1, text.length() - 1));
  }

  /** Writes the comment of a variable that clients may access so; empty if there is nothing. */
  public String comment(Access actual) {
    boolean plain =
        actual == Access.READ_WRITE
            && unit.isEmpty()
            && source.isEmpty()
            && of(meaning).access() == null;
    if (plain) {
      return meaning;
    }
    return (actual == Access.READ_ONLY ? "RO" : "RW")
        + (" [" + (unit.isEmpty() ? NO_UNIT : unit) + "] ")
        + (meaning.isEmpty() ? "" : meaning + " ")
        + ("(" + source + ")");
  }
}
