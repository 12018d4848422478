package no.hials.crosscom.cli;

/** Makes texts of others fit for a line of the terminal. */
final class Printable {
  private Printable() {}

  /** Keeps a text on its line, and its characters from steering the terminal. */
  static String of(String text) {
    StringBuilder line = new StringBuilder();
    for (int i = 0; i < text.length(); i++) {
      char c = text.charAt(i);
      if (Character.isISOControl(c)) {
        line.append(String.format("\\x%02X", (int) c));
      } else {
        line.append(c);
      }
    }
    return line.toString();
  }
}
