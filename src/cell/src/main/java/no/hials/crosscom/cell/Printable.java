package no.hials.crosscom.cell;

/** Makes foreign texts and numbers safe to print on a line of the terminal. */
public final class Printable {
  private Printable() {}

  /** Escapes line breaks and the control characters of a text. */
  public static String of(String text) {
    return of(text, "");
  }

  /** Escapes the control characters of a message, which may have several lines. */
  public static String message(String text) {
    return of(text, System.lineSeparator() + "\n");
  }

  private static String of(String text, String kept) {
    StringBuilder line = new StringBuilder();
    for (int i = 0; i < text.length(); i++) {
      char c = text.charAt(i);
      if (Character.isISOControl(c) && kept.indexOf(c) < 0) {
        line.append(String.format("\\x%02X", (int) c));
      } else {
        line.append(c);
      }
    }
    return line.toString();
  }

  /** Returns a number with its noun, such as {@code 1 byte} and {@code 2 bytes}. */
  public static String count(long number, String thing) {
    return number + " " + thing + (number == 1 ? "" : "s");
  }

  /** Returns a message with a lower-case first letter, unless it begins with a NAME. */
  public static String lowerFirst(String message) {
    return message.length() > 1 && Character.isLowerCase(message.charAt(1))
        ? Character.toLowerCase(message.charAt(0)) + message.substring(1)
        : message;
  }
}
