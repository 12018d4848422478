package no.hials.crosscom.examples;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;

/** The pages of the documentation, with their headings as anchors. */
final class MarkdownPages {
  static final Path ROOT = Path.of("..").toAbsolutePath().normalize();

  private static final Pattern HEADING = Pattern.compile("^#{1,6} +(.*?)\\s*$");

  /** The characters that neither a code host nor the site keeps in an anchor. */
  private static final Pattern DROPPED = Pattern.compile("[^\\p{L}\\p{N} _-]");

  private MarkdownPages() {}

  /** Returns the pages at the top, those of docs, and the list of examples. */
  static List<Path> ofTheDocumentation() throws IOException {
    List<Path> pages =
        new ArrayList<>(
            List.of(
                ROOT.resolve("README.md"),
                ROOT.resolve("examples/README.md"),
                ROOT.resolve(".github/SECURITY.md")));
    try (Stream<Path> docs = Files.walk(ROOT.resolve("docs"))) {
      docs.filter(p -> p.toString().endsWith(".md")).sorted().forEach(pages::add);
    }
    return pages;
  }

  /** Returns the anchors of the headings of a page; a repeated one gets a number. */
  static List<String> anchors(Path page) throws IOException {
    List<String> anchors = new ArrayList<>();
    Map<String, Integer> seen = new HashMap<>();
    for (String line : withoutCode(page)) {
      Matcher heading = HEADING.matcher(line);
      if (heading.matches()) {
        String anchor = anchor(heading.group(1));
        int before = seen.merge(anchor, 1, Integer::sum) - 1;
        anchors.add(before == 0 ? anchor : anchor + "-" + before);
      }
    }
    return anchors;
  }

  private static String anchor(String heading) {
    return DROPPED
        .matcher(heading)
        .replaceAll("")
        .strip()
        .toLowerCase(Locale.ROOT)
        .replace(' ', '-');
  }

  /** Returns the lines of a page, those of code blocks blank. */
  static List<String> withoutCode(Path page) throws IOException {
    List<String> lines = new ArrayList<>();
    boolean code = false;
    for (String line : Files.readAllLines(page)) {
      boolean fence = line.strip().startsWith("```");
      code ^= fence;
      lines.add(code || fence ? "" : line);
    }
    return lines;
  }
}
