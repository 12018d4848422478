package no.hials.crosscom.cli.shell;

import java.util.ArrayList;
import java.util.List;
import org.jline.reader.CompletingParsedLine;
import org.jline.reader.Parser;

/**
 * Splits a line for its completion while it is typed: at blanks and equals signs, each of which is
 * a word. A line with a mistake is split, too.
 */
final class ShellParser implements Parser {
  /**
   * A line in words.
   *
   * @param line the whole line
   * @param cursor the index of the cursor in the line
   * @param words its words
   * @param wordIndex the index of the word with the cursor
   * @param wordCursor the index of the cursor in that word
   */
  record Words(String line, int cursor, List<String> words, int wordIndex, int wordCursor)
      implements CompletingParsedLine {
    @Override
    public String word() {
      return words.get(wordIndex);
    }

    @Override
    public CharSequence escape(CharSequence candidate, boolean complete) {
      return candidate;
    }

    @Override
    public int rawWordCursor() {
      return wordCursor;
    }

    @Override
    public int rawWordLength() {
      return word().length();
    }
  }

  @Override
  public Words parse(String line, int cursor, ParseContext context) {
    List<String> words = new ArrayList<>();
    int wordIndex = -1;
    int wordCursor = 0;
    int begin = 0;
    for (int i = 0; i <= line.length(); i++) {
      boolean end = i == line.length() || Character.isWhitespace(line.charAt(i));
      boolean sign = !end && line.charAt(i) == '=';
      if (!end && !sign) {
        continue;
      }
      boolean here = wordIndex < 0 && cursor >= begin && cursor <= i;
      if (i > begin || here) {
        if (here) {
          wordIndex = words.size();
          wordCursor = cursor - begin;
        }
        words.add(line.substring(begin, i));
      }
      if (sign) {
        words.add("=");
      }
      begin = i + 1;
    }
    return new Words(line, cursor, List.copyOf(words), wordIndex, wordCursor);
  }

  @Override
  public boolean isEscapeChar(char c) {
    return false;
  }
}
