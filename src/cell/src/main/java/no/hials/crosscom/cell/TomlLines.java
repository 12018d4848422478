package no.hials.crosscom.cell;

import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * Finds the lines of keys in a TOML text, which the parser does not keep. It looks at table headers
 * and at the text before an equals sign; a key in an inline table gets the line of the inline
 * table.
 */
final class TomlLines {
  private static final String KEY = "(?:[\\w-]+|\"[^\"]*\"|'[^']*')";
  private static final String KEYS = KEY + "(?:\\s*\\.\\s*" + KEY + ")*";
  private static final Pattern HEADER = Pattern.compile("\\s*\\[\\[?\\s*(" + KEYS + ")\\s*\\].*");
  private static final Pattern VALUE = Pattern.compile("\\s*(" + KEYS + ")\\s*=.*");

  private final List<String> lines;

  TomlLines(String text) {
    lines = text.lines().toList();
  }

  /** Returns the line of a key, from 1; 0 if it is not found. */
  int find(List<String> path) {
    int found = 0;
    int length = 0;
    List<String> table = List.of();
    for (int i = 0; i < lines.size(); i++) {
      Matcher header = HEADER.matcher(lines.get(i));
      Matcher value = VALUE.matcher(lines.get(i));
      List<String> here;
      if (header.matches()) {
        table = parts(header.group(1));
        here = table;
      } else if (value.matches()) {
        here = new ArrayList<>(table);
        here.addAll(parts(value.group(1)));
      } else {
        continue;
      }
      int common = common(here, path);
      if (common > length) {
        length = common;
        found = i + 1;
      }
    }
    return found;
  }

  private static List<String> parts(String keys) {
    List<String> parts = new ArrayList<>();
    Matcher matcher = Pattern.compile(KEY).matcher(keys);
    while (matcher.find()) {
      String key = matcher.group();
      boolean quoted = key.startsWith("\"") || key.startsWith("'");
      parts.add(quoted ? key.substring(1, key.length() - 1) : key);
    }
    return parts;
  }

  /** Returns the number of equal parts at the beginning. */
  private static int common(List<String> a, List<String> b) {
    int count = 0;
    while (count < Math.min(a.size(), b.size()) && a.get(count).equals(b.get(count))) {
      count++;
    }
    return count;
  }
}
