package no.hials.crosscom.lang;

import org.jspecify.annotations.Nullable;

/**
 * The description of a variable in the comment after its declaration.
 *
 * <p>The data lists of this project write {@code ;RO [mm/deg] commanded tool centre point (FIW)}:
 * access, unit or {@code -}, meaning, source. Any other comment is the meaning. The form is the
 * project's own, because a data list of KSS has no access rights.
 *
 * @param access the access of clients; null if the comment does not contain it
 * @param unit the unit; empty without a unit
 * @param meaning the meaning of the variable; empty if unknown
 * @param source the source of the description; empty if unknown
 */
public record VariableNote(@Nullable Access access, String unit, String meaning, String source) {
  /** An empty note. */
  public static final VariableNote NONE = new VariableNote(null, "", "", "");

  private static final String NO_UNIT = "-";

  /**
   * Parses a comment.
   *
   * @param comment the text after {@code ;}
   * @return the note
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

  /** Returns the text of a comment with the actual access; empty if there is no note. */
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
