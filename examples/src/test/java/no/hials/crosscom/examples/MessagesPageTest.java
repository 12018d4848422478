package no.hials.crosscom.examples;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;

/** Compares docs/reference/simulated-controller.md#messages with the constants of the simulator. */
class MessagesPageTest {
  private static final List<String> CLASSES =
      List.of(
          "KrlExecutionException",
          "internal/core/AdvanceRun",
          "internal/core/BlockCoincidence",
          "internal/core/OperatorPanel",
          "internal/motion/MotionProblem",
          "internal/program/MotionCompiler");

  private static final Pattern CONSTANT = Pattern.compile("\\bint (?!KEPT_|MAX_)[A-Z_]+ = (\\d+);");
  private static final Pattern ROW = Pattern.compile("(?m)^\\| (\\d+) \\|");

  @Test
  void thePageHasEachMessageOfTheSimulator() throws IOException {
    List<String> numbers = new ArrayList<>();
    for (String name : CLASSES) {
      Path file =
          Path.of("src/simulator/src/main/java/no/hials/crosscom/simulator", name + ".java");
      List<String> found = numbers(CONSTANT, Files.readString(MarkdownPages.ROOT.resolve(file)));
      assertThat(found).as(name).isNotEmpty();
      numbers.addAll(found);
    }
    String page =
        Files.readString(MarkdownPages.ROOT.resolve("docs/reference/simulated-controller.md"));
    String section = page.substring(page.indexOf("\n## Messages\n"));
    String table = section.substring(0, section.indexOf("\n## ", 1));

    assertThat(numbers(ROW, table)).containsExactlyInAnyOrderElementsOf(new TreeSet<>(numbers));
  }

  private static List<String> numbers(Pattern pattern, String text) {
    List<String> numbers = new ArrayList<>();
    for (Matcher matcher = pattern.matcher(text); matcher.find(); ) {
      numbers.add(matcher.group(1));
    }
    return numbers;
  }
}
