package no.hials.crosscom.cli.shell;

import java.util.ArrayList;
import java.util.List;
import java.util.regex.Pattern;

/**
 * Splits a line of the shell language into words: at blanks and at the first {@code =}, but not
 * within double quotes and brackets. Quotes are kept, since they belong to the values.
 */
final class ShellWords {
  /** A name, an index in brackets, fields after dots; {@code @} as in {@code @PROXY_TYPE}. */
  private static final Pattern NAME = Pattern.compile("[$@A-Za-z_][\\w$]*(\\[[^\\]]*]|[\\w$.])*");

  private final String line;
  private final List<String> words = new ArrayList<>();
  private final StringBuilder word = new StringBuilder();
  private int depth;
  private boolean quoted;

  private ShellWords(String line) {
    this.line = line;
  }

  static boolean isName(String word) {
    return NAME.matcher(word).matches();
  }

  /** Returns whether a word is the command that writes. */
  static boolean isSet(String word) {
    return word.equalsIgnoreCase("set") || word.equalsIgnoreCase("write");
  }

  /** Removes the double quotes around a word. */
  static String unquoted(String word) {
    boolean inQuotes = word.length() > 1 && word.startsWith("\"") && word.endsWith("\"");
    return inQuotes ? word.substring(1, word.length() - 1) : word;
  }

  /**
   * Returns the words of a line without its comment.
   *
   * @throws ShellSyntaxException if a quote is not closed
   */
  static List<String> split(String line) throws ShellSyntaxException {
    return line.strip().startsWith("#") ? List.of() : new ShellWords(line).split();
  }

  private List<String> split() throws ShellSyntaxException {
    for (int i = 0; i < line.length(); i++) {
      char c = line.charAt(i);
      if (c == '"') {
        quoted = !quoted;
        word.append(c);
      } else if (quoted) {
        word.append(c);
      } else if (c == ';') {
        break;
      } else {
        take(c);
      }
    }
    if (quoted) {
      throw new ShellSyntaxException("a text must end with a double quote: " + line.strip());
    }
    end();
    return List.copyOf(words);
  }

  private void take(char c) {
    if (c == '[' || c == '{') {
      depth++;
    } else if (c == ']' || c == '}') {
      depth--;
    }
    if (depth > 0) {
      word.append(c);
    } else if (Character.isWhitespace(c)) {
      end();
    } else if (c == '=' && isSign()) {
      end();
      words.add("=");
    } else {
      word.append(c);
    }
  }

  /**
   * Returns whether a {@code =} here is the sign of a write, and not part of an option or a value.
   */
  private boolean isSign() {
    int names = words.size() + (word.isEmpty() ? 0 : 1);
    boolean behindSet = !words.isEmpty() && isSet(words.get(0));
    return !words.contains("=")
        && names == (behindSet ? 2 : 1)
        && isName(word.isEmpty() ? words.get(names - 1) : word.toString());
  }

  private void end() {
    if (!word.isEmpty()) {
      words.add(word.toString());
      word.setLength(0);
    }
  }
}
