package no.hials.crosscom.cli.base;

import java.util.ArrayDeque;
import java.util.Deque;
import no.hials.crosscom.protocol.value.KrlSyntaxException;

/** Explains why the text of a value that a user typed is not a KRL value. */
public final class ValueText {
  /** The maximum length of a text that a hint repeats as an example. */
  private static final int LONGEST_EXAMPLE = 100;

  private ValueText() {}

  /**
   * Returns the message of the parser and a hint to the usual mistakes.
   *
   * @param quote the quotation mark around the value, for its example; empty if it needs none
   */
  public static String explain(KrlSyntaxException e, String quote) {
    String hint = hint(e.text().strip(), quote);
    return hint.isEmpty() ? String.valueOf(e.getMessage()) : e.getMessage() + "; " + hint;
  }

  private static String hint(String text, String quote) {
    if (text.matches("\\w*[\\p{L}_][^\"#{}]*")) {
      if (text.length() > LONGEST_EXAMPLE) {
        return "a text needs double quotes";
      }
      String constant =
          text.matches("\\w+")
              ? ", a constant of an ENUM begins with #: " + quote + "#" + text + quote
              : "";
      return "a text needs double quotes: " + quote + '"' + text + '"' + quote + constant;
    }
    if (text.matches("[-+]?\\d+,\\d+")) {
      return "a decimal number has a point: " + text.replace(',', '.');
    }
    Deque<Integer> open = new ArrayDeque<>();
    int quotedFrom = -1;
    for (int i = 0; i < text.length(); i++) {
      char c = text.charAt(i);
      if (c == '"') {
        quotedFrom = quotedFrom < 0 ? i : -1;
      } else if (c == '{' && quotedFrom < 0) {
        open.push(i);
      } else if (c == '}' && quotedFrom < 0) {
        open.poll();
      }
    }
    if (quotedFrom >= 0) {
      return "the double quote at position " + quotedFrom + " is not closed";
    }
    return open.isEmpty() ? "" : "the brace at position " + open.peek() + " is not closed";
  }
}
