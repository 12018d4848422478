package no.hials.crosscom.cell;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.regex.Pattern;
import no.hials.crosscom.protocol.value.KrlArray;
import no.hials.crosscom.protocol.value.KrlStruct;
import no.hials.crosscom.protocol.value.KrlSyntaxException;
import no.hials.crosscom.protocol.value.KrlValue;

/** Parses values that a user typed. */
public final class ValueText {
  /** The maximum length of a text that a hint repeats as an example. */
  private static final int LONGEST_EXAMPLE = 100;

  /** The text before a second field without a comma: a name and a value. */
  private static final Pattern FIELD =
      Pattern.compile(".*[{,:]\\s*[\\w$]+(\\[])?\\s+\\S+\\s+", Pattern.DOTALL);

  private ValueText() {}

  /**
   * Parses a value to write to a variable.
   *
   * @param quote the quotation mark around the value, for an example; empty if it needs none
   * @throws IllegalArgumentException if the text is not a KRL value, has several values for a name
   *     that is not an array, or not a field; with the message of the parser and a hint to the
   *     usual mistakes
   */
  public static KrlValue parse(String name, String text, String quote) {
    try {
      KrlValue value = KrlValue.parse(text);
      if (value instanceof KrlArray array
          && array.elements().size() > 1
          && !Leaf.isWholeArray(name)) {
        int start = text.length() - text.stripLeading().length();
        throw wrong(text, start, "one value, since the name does not end with []");
      }
      if (value instanceof KrlStruct struct && struct.fields().isEmpty()) {
        throw wrong(text, text.lastIndexOf('}'), "a field with its value");
      }
      return value;
    } catch (KrlSyntaxException e) {
      String hint = hint(e, quote);
      String message = hint.isEmpty() ? e.getMessage() : e.getMessage() + "; " + hint;
      throw new IllegalArgumentException("is not a KRL value: " + message, e);
    }
  }

  private static KrlSyntaxException wrong(String text, int position, String expected) {
    return new KrlSyntaxException(text, position, expected, "'" + text.charAt(position) + "'");
  }

  private static String hint(KrlSyntaxException e, String quote) {
    String text = e.text().strip();
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
    if (text.matches("'(?![BbHh]\\p{XDigit}*')[^'\"]*'")) {
      return "a text needs double quotes instead of single ones";
    }
    if (FIELD.matcher(e.text().substring(0, e.position())).matches()) {
      return "fields need commas between them, such as {X 1.0,Y 2.0}";
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
