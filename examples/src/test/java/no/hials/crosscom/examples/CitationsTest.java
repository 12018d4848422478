package no.hials.crosscom.examples;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Follows the citations in comments, such as {@code docs/reference/types.md#records}. */
class CitationsTest {
  private static final Set<String> NOT_OURS = Set.of("target", ".git", ".idea", "node_modules");
  private static final Set<String> KINDS =
      Set.of("java", "g4", "properties", "md", "xml", "sh", "py", "yml", "src", "sub", "dat");
  private static final Pattern CITATION = Pattern.compile("\\bdocs/[\\w./-]+\\.md(#[\\w-]*)?");

  @Test
  void everyCitedPageAndHeadingIsThere() throws IOException {
    List<String> wrong = new ArrayList<>();
    for (Path file : files(MarkdownPages.ROOT)) {
      wrong.addAll(wrongCitations(MarkdownPages.ROOT, file));
    }

    assertThat(wrong).isEmpty();
  }

  @Test
  void aCitationOfNoPageOrNoHeadingIsFound(@TempDir Path root) throws IOException {
    Files.createDirectories(root.resolve("docs/reference"));
    Files.writeString(root.resolve("docs/reference/page.md"), "# A page\n## 50,000 `$X.Y`: 1\n");
    Path file = root.resolve("Some.java");
    Files.writeString(
        file,
        """
        // good (docs/reference/page.md, docs/reference/page.md#50000-xy-1).
        // bad (docs/reference/other.md)
        // bad (docs/reference/page.md#pages)
        """);

    assertThat(wrongCitations(root, file))
        .containsExactly(
            "Some.java:2: docs/reference/other.md", "Some.java:3: docs/reference/page.md#pages");
  }

  private static List<String> wrongCitations(Path root, Path file) throws IOException {
    List<String> wrong = new ArrayList<>();
    int number = 0;
    for (String line : Files.readAllLines(file, StandardCharsets.ISO_8859_1)) {
      number++;
      Matcher citation = CITATION.matcher(line);
      while (citation.find()) {
        if (!isThere(root, citation.group())) {
          wrong.add(root.relativize(file) + ":" + number + ": " + citation.group());
        }
      }
    }
    return wrong;
  }

  private static boolean isThere(Path root, String citation) throws IOException {
    String[] parts = citation.split("#", 2);
    Path page = root.resolve(parts[0]);
    return Files.exists(page)
        && (parts.length == 1 || MarkdownPages.anchors(page).contains(parts[1]));
  }

  /** Returns the text files of the repository, without this test and the results of builds. */
  private static List<Path> files(Path folder) throws IOException {
    List<Path> files = new ArrayList<>();
    try (Stream<Path> entries = Files.list(folder)) {
      for (Path entry : entries.sorted().toList()) {
        String name = entry.getFileName().toString();
        if (NOT_OURS.contains(name) || name.equals("CitationsTest.java")) {
          continue;
        }
        if (Files.isDirectory(entry)) {
          files.addAll(files(entry));
        } else if (KINDS.contains(name.substring(name.lastIndexOf('.') + 1))) {
          files.add(entry);
        }
      }
    }
    return files;
  }
}
