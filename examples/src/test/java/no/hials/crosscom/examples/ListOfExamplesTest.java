package no.hials.crosscom.examples;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/** Compares the table of examples in README.md with the examples. */
class ListOfExamplesTest {
  private static final Path JAVA = Path.of("src", "main", "java", "no", "hials", "crosscom");

  /** A line of the table: a link to a Java file with a {@code main} method, and its description. */
  private static final Pattern LINE =
      Pattern.compile("(?m)^\\| \\[(\\w+)]\\((src/main/java/[\\w/]+/\\1\\.java)\\) \\| .+ \\|$");

  private static List<MatchResult> listed() throws IOException {
    return LINE.matcher(Files.readString(Path.of("README.md"))).results().toList();
  }

  private static List<String> examples() throws IOException {
    try (Stream<Path> files = Files.list(JAVA.resolve("examples"))) {
      return files.filter(ListOfExamplesTest::hasMain).map(ListOfExamplesTest::className).toList();
    }
  }

  private static boolean hasMain(Path file) {
    try {
      return Files.readString(file).contains("public static void main(");
    } catch (IOException e) {
      throw new AssertionError(e);
    }
  }

  private static String className(Path file) {
    return file.getFileName().toString().replace(".java", "");
  }

  @Test
  void everyExampleIsInTheTableOnce() throws Exception {
    assertThat(listed().stream().map(line -> line.group(1)))
        .containsExactlyInAnyOrderElementsOf(examples());
  }

  @Test
  void everyLinkOfTheTableLeadsToAFile() throws Exception {
    assertThat(listed()).isNotEmpty().allMatch(line -> Files.exists(Path.of(line.group(2))));
  }

  @Test
  void everyExampleIsRunByATest() throws Exception {
    String tests =
        Files.readString(Path.of("src/test/java/no/hials/crosscom/examples/ExamplesTest.java"));
    assertThat(examples()).allMatch(example -> tests.contains(example + ".main("));
  }
}
