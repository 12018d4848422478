package no.hials.crosscom.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import no.hials.crosscom.cli.base.Cli;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * Runs the commands that the docs quote and whose output is always the same: those that need no
 * controller, and those that start a simulated one.
 */
class QuotedCommandsTest {
  private static final Path ROOT = Path.of("..", "..");

  /** A command, and its output up to the next command or the end of the block. */
  private static final Pattern COMMAND =
      Pattern.compile("(?m)^( *)\\$ jopenshowvar (.*)\\R((?:(?! *(?:\\$ |```)).*\\R)*)");

  private static final Pattern REPEATABLE =
      Pattern.compile("vars .*|(?:read|write) .*--mock(?! *[|<>]).*");
  private static final Pattern ARGUMENT = Pattern.compile("'([^']*)'|\\S+");

  private record Quote(String page, String command, String output) {
    static Quote of(Path page, Matcher found) {
      String output = found.group(3).replaceAll("(?m)^" + found.group(1), "");
      return new Quote(ROOT.relativize(page).toString(), found.group(2), output.stripTrailing());
    }

    String[] arguments() {
      return ARGUMENT
          .matcher(command)
          .results()
          .map(it -> it.group(1) == null ? it.group() : it.group(1))
          .map(it -> it.startsWith("krl/") ? ROOT.resolve(it).toString() : it)
          .toArray(String[]::new);
    }

    @Override
    public String toString() {
      return page + ": " + command;
    }
  }

  static List<Quote> quotes() throws IOException {
    try (Stream<Path> pages = Files.walk(ROOT.resolve("docs"))) {
      return pages
          .filter(page -> page.toString().endsWith(".md"))
          .sorted()
          .flatMap(QuotedCommandsTest::quotes)
          .filter(quote -> REPEATABLE.matcher(quote.command()).matches())
          .toList();
    }
  }

  private static Stream<Quote> quotes(Path page) {
    try {
      Matcher found = COMMAND.matcher(Files.readString(page));
      Stream.Builder<Quote> quotes = Stream.builder();
      while (found.find()) {
        quotes.add(Quote.of(page, found));
      }
      return quotes.build();
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  @ParameterizedTest
  @MethodSource("quotes")
  void theOutputIsThatOfThePage(Quote quote) {
    Cli.Result result = Cli.run(quote.arguments());

    assertThat((result.out() + result.err()).replaceAll("(?m) +$", "").stripTrailing())
        .isEqualTo(quote.output());
  }
}
