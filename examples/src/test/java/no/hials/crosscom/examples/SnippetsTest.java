package no.hials.crosscom.examples;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * Compares the Java and KRL snippets of the documentation, and the Java statements in its tables,
 * with the examples and programs.
 */
class SnippetsTest {
  /** The folders with the sources of each language. */
  private static final Map<String, Path> SOURCES =
      Map.of("java", Path.of("src"), "krl", MarkdownPages.ROOT.resolve("krl"));

  /** A line of Java in a table: it ends with a semicolon. */
  private static final Pattern STATEMENT = Pattern.compile("`([^`]+;)`");

  record Snippet(Path page, int line, String language, List<String> lines) {
    @Override
    public String toString() {
      return MarkdownPages.ROOT.relativize(page) + ":" + line;
    }
  }

  static List<Snippet> snippets() throws IOException {
    List<Snippet> snippets = new ArrayList<>();
    for (Path page : MarkdownPages.ofTheDocumentation()) {
      List<String> open = null;
      String language = "";
      int line = 0;
      for (String text : Files.readAllLines(page)) {
        line++;
        if (open == null && SOURCES.containsKey(text.strip().replaceFirst("^```", ""))) {
          open = new ArrayList<>();
          language = text.strip().substring(3);
        } else if (open != null && text.strip().equals("```")) {
          snippets.add(new Snippet(page, line - open.size(), language, List.copyOf(open)));
          open = null;
        } else if (open != null) {
          open.add(text);
        } else if (text.startsWith("|")) {
          for (MatchResult match : STATEMENT.matcher(text).results().toList()) {
            snippets.add(new Snippet(page, line, "java", List.of(match.group(1))));
          }
        }
      }
    }
    return snippets;
  }

  @ParameterizedTest
  @MethodSource("snippets")
  void everySnippetOfTheDocumentationIsALineByLineCopyOfASource(Snippet snippet)
      throws IOException {
    List<String> wanted = stripped(snippet.lines());
    List<List<String>> sources = new ArrayList<>();
    try (Stream<Path> files = Files.walk(SOURCES.get(snippet.language()))) {
      for (Path file : files.filter(Files::isRegularFile).toList()) {
        sources.add(stripped(Files.readAllLines(file, StandardCharsets.ISO_8859_1)));
      }
    }
    assertThat(sources)
        .as("%s must be in a file of %s: %s", snippet, snippet.language(), wanted)
        .anyMatch(source -> Collections.indexOfSubList(source, wanted) >= 0);
  }

  private static List<String> stripped(List<String> lines) {
    return lines.stream().map(String::strip).filter(l -> !l.isEmpty()).toList();
  }
}
