package no.hials.crosscom.cell;

/** Words of messages. */
public final class Printable {
  private Printable() {}

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
