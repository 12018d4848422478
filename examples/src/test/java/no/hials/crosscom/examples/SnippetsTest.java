package no.hials.crosscom.examples;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Compares the Java snippets of the documentation with the compiled examples. */
class SnippetsTest {
  record Snippet(Path page, int line, List<String> lines) {
    @Override
    public String toString() {
      return MarkdownPages.ROOT.relativize(page) + ":" + line;
    }
  }

  static List<Snippet> snippets() throws IOException {
    List<Snippet> snippets = new ArrayList<>();
    for (Path page : MarkdownPages.ofTheDocumentation()) {
      List<String> open = null;
      int line = 0;
      for (String text : Files.readAllLines(page)) {
        line++;
        if (open == null && text.strip().equals("```java")) {
          open = new ArrayList<>();
        } else if (open != null && text.strip().equals("```")) {
          snippets.add(new Snippet(page, line - open.size(), List.copyOf(open)));
          open = null;
        } else if (open != null) {
          open.add(text);
        }
      }
    }
    return snippets;
  }

  @ParameterizedTest
  @MethodSource("snippets")
  void everyJavaSnippetOfTheDocumentationIsALineByLineCopyOfAnExample(Snippet snippet)
      throws IOException {
    List<String> wanted = stripped(snippet.lines());
    List<List<String>> sources = new ArrayList<>();
    try (Stream<Path> files = Files.walk(Path.of("src"))) {
      for (Path file : files.filter(p -> p.toString().endsWith(".java")).toList()) {
        sources.add(stripped(Files.readAllLines(file)));
      }
    }
    assertThat(sources)
        .as("%s must be in an example: %s", snippet, wanted)
        .anyMatch(source -> Collections.indexOfSubList(source, wanted) >= 0);
  }

  private static List<String> stripped(List<String> lines) {
    return lines.stream().map(String::strip).filter(l -> !l.isEmpty()).toList();
  }
}
