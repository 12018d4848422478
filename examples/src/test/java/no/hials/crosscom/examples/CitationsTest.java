package no.hials.crosscom.examples;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.function.Predicate;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Follows the citations in comments, such as {@code docs/reference/types.md#records}. */
class CitationsTest {
  private static final Set<String> NOT_OURS = Set.of("target", ".git", ".idea", "node_modules");
  private static final Set<String> KINDS =
      Set.of(
          "java",
          "g4",
          "properties",
          "md",
          "tsv",
          "xml",
          "sh",
          "py",
          "yml",
          "src",
          "sub",
          "dat",
          "js",
          "css",
          "html");
  private static final Pattern CITATION = Pattern.compile("\\bdocs/[\\w./-]+\\.md(#[\\w-]*)?");

  /** A page or a table that a text names, such as {@code docs/index.md}. */
  private static final Pattern NAMED = Pattern.compile("(?<![\\w/$.*<>-])[\\w./-]+\\.(md|tsv)\\b");

  private static final Pattern COMMENT = Pattern.compile("^\\s*(/?\\*|#|//|\"\"\").*|.*\\s//\\s.*");

  @Test
  void everyCitedPageAndHeadingIsThere() throws IOException {
    List<String> wrong = new ArrayList<>();
    for (Path file : files(MarkdownPages.ROOT)) {
      wrong.addAll(wrongCitations(MarkdownPages.ROOT, file));
    }

    assertThat(wrong).isEmpty();
  }

  @Test
  void everyPageAndTableThatAFileNamesIsInTheRepository() throws IOException {
    List<Path> files = files(MarkdownPages.ROOT);
    Set<String> tables =
        Set.copyOf(files.stream().map(f -> f.getFileName().toString()).filter(isA("tsv")).toList());
    List<String> wrong = new ArrayList<>();
    for (Path file : files) {
      wrong.addAll(missing(MarkdownPages.ROOT, file, tables));
    }

    assertThat(wrong).isEmpty();
  }

  @Test
  void aFileThatIsNotInTheRepositoryIsFound(@TempDir Path root) throws IOException {
    Files.writeString(root.resolve("README.md"), "# Read me");
    Path java = root.resolve("Some.java");
    Files.writeString(
        java,
        """
        // README.md, a.tsv; but not krl.md, docs/other.md, b.tsv
        String page = "page.md";
        """);
    Path page = root.resolve("page.md");
    Files.writeString(page, "page.md, README.md and [x](krl.md)");

    assertThat(missing(root, java, Set.of("a.tsv")))
        .containsExactly("Some.java:1: krl.md", "Some.java:1: docs/other.md", "Some.java:1: b.tsv");
    assertThat(missing(root, page, Set.of())).containsExactly("page.md:1: krl.md");
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

  private static List<String> missing(Path root, Path file, Set<String> tables) throws IOException {
    boolean page = isA("md").test(file.toString());
    List<String> missing = new ArrayList<>();
    int number = 0;
    for (String line : Files.readAllLines(file, StandardCharsets.ISO_8859_1)) {
      number++;
      Matcher named = NAMED.matcher(page || COMMENT.matcher(line).matches() ? line : "");
      while (named.find()) {
        String name = named.group();
        if (!tables.contains(name)
            && !Files.exists(root.resolve(name))
            && !Files.exists(file.resolveSibling(name))) {
          missing.add(root.relativize(file) + ":" + number + ": " + name);
        }
      }
    }
    return missing;
  }

  private static Predicate<String> isA(String kind) {
    return name -> name.endsWith("." + kind);
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
