package no.hials.crosscom.internal;

import java.util.Objects;

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
   * Checks a name.
   *
   * @param name the name
   * @return the name
   * @throws IllegalArgumentException if the name is blank or too long for a message
   */
  public static String check(String name) {
    if (Objects.requireNonNull(name, "name").isBlank()) {
      throw new IllegalArgumentException("a variable's name must not be blank");
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
