package no.hials.crosscom.examples;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.lang.reflect.Method;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Set;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import no.hials.crosscom.CrossComClient;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Compares {@code docs/reference/api.md} with the public classes of the libraries. */
class ApiPageTest {
  private static final Pattern CODE = Pattern.compile("`[^`]+`");
  private static final Pattern WORD = Pattern.compile("\\w+");
  private static final Pattern PUBLIC_TYPE =
      Pattern.compile("(?m)^public .*\\b(?:class|interface|record|enum|@interface) (\\w+)");

  /** Returns the words of the code in the page. */
  private static Set<String> named() throws IOException {
    Path page = MarkdownPages.ROOT.resolve("docs/reference/api.md");
    return CODE.matcher(String.join("\n", MarkdownPages.withoutCode(page)))
        .results()
        .map(MatchResult::group)
        .flatMap(code -> WORD.matcher(code).results().map(MatchResult::group))
        .collect(Collectors.toSet());
  }

  private static List<String> publicTypes(String module) throws IOException {
    Path sources = MarkdownPages.ROOT.resolve(module).resolve("src/main/java");
    try (Stream<Path> files = Files.walk(sources)) {
      return files
          .filter(file -> file.toString().endsWith(".java"))
          .filter(file -> !sources.relativize(file).toString().contains("internal"))
          .map(ApiPageTest::read)
          .flatMap(source -> PUBLIC_TYPE.matcher(source).results().map(type -> type.group(1)))
          .toList();
    }
  }

  private static String read(Path file) {
    try {
      return Files.readString(file);
    } catch (IOException e) {
      throw new AssertionError(e);
    }
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "src/client",
        "src/protocol",
        "src/kinematics",
        "src/control",
        "src/lang",
        "src/simulator",
        "mock-server",
        "src/cell"
      })
  void everyPublicTypeIsOnThePage(String module) throws Exception {
    assertThat(publicTypes(module)).isNotEmpty().isSubsetOf(named());
  }

  @Test
  void everyMethodOfTheClientIsOnThePage() throws Exception {
    assertThat(
            Arrays.stream(CrossComClient.class.getMethods())
                .filter(method -> method.getDeclaringClass() != Object.class)
                .map(Method::getName)
                .filter(name -> !name.equals("toString")))
        .isNotEmpty()
        .isSubsetOf(named());
  }
}
