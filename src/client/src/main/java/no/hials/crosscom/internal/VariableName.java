package no.hials.crosscom.internal;

import java.util.Objects;
import no.hials.crosscom.protocol.value.PrintableText;

/** The rules for the name of a variable. */
public final class VariableName {
  /** The maximum length in a read (docs/reference/wire-format.md#requests). */
  private static final int MAX_LENGTH = 65_532;

  /** The number of characters of a longer name in a message. */
  private static final int SHOWN = 40;

  private VariableName() {}

  /** Returns whether a name stands for the elements of an array, or for a text. */
  public static boolean isWhole(String name) {
    int last = name.length() - 1;
    return last > 0
        && name.charAt(last) == ']'
        && (name.charAt(last - 1) == '[' || name.charAt(last - 1) == ',');
  }

  /**
   * Returns the index of the first line break or NUL, which no name or value has: a line of KRL
   * ends there.
   *
   * @param hasTexts whether there can be texts in double quotes, which can have any character
   * @return -1 if there is none
   */
  public static int indexOfLineEnd(CharSequence text, boolean hasTexts) {
    boolean inText = false;
    for (int i = 0; i < text.length(); i++) {
      char c = text.charAt(i);
      if (c == '"') {
        inText = hasTexts && !inText;
      } else if (!inText && (c == '\n' || c == '\r' || c == 0)) {
        return i;
      }
    }
    return -1;
  }

  /**
   * Checks a name.
   *
   * @param name the name
   * @return the name
   * @throws IllegalArgumentException if the name is blank, has a line break or NUL, or is too long
   *     for a message
   */
  public static String check(String name) {
    if (Objects.requireNonNull(name, "name").isBlank()) {
      throw new IllegalArgumentException("a variable's name must not be blank");
    }
    int bad = indexOfLineEnd(name, false);
    if (bad >= 0) {
      throw new IllegalArgumentException(
          "a variable's name must not have a line break or NUL, has "
              + String.format("U+%04X at index %d: ", (int) name.charAt(bad), bad)
              + PrintableText.shortened(name));
    }
    if (name.length() > MAX_LENGTH) {
      throw new IllegalArgumentException(
          "a variable's name must have at most "
              + MAX_LENGTH
              + " characters, has "
              + name.length()
              + ": "
              + name.substring(0, SHOWN)
              + "...");
    }
    return name;
  }
}
