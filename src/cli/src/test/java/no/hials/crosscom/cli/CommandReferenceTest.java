package no.hials.crosscom.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import org.junit.jupiter.api.Test;

class CommandReferenceTest {
  private static final Path PAGE = Path.of("..", "..", "docs", "reference", "cli.md");
  private static final String RENEW =
      "mvn -B test -pl src/cli -am -Dtest=CommandReferenceTest"
          + " -Dtests.required=false -Dsurefire.failIfNoSpecifiedTests=false -Drenew.reference=true";

  @Test
  void isWhatTheCommandsSay() throws IOException {
    String page = Files.readString(PAGE);
    String renewed = renewed(page);
    if (Boolean.getBoolean("renew.reference")) {
      Files.writeString(PAGE, renewed);
      return;
    }

    // and not both pages
    assertThat(page.equals(renewed))
        .as("docs/reference/cli.md is not what the commands say; this renews it: " + RENEW)
        .isTrue();
  }

  /** Puts the parts between the comments that name them. */
  private static String renewed(String page) {
    String result = page;
    for (Map.Entry<String, String> part : CommandReference.parts().entrySet()) {
      String begin = "<!-- from the commands: " + part.getKey() + " -->\n";
      String end = "<!-- end of " + part.getKey() + " -->";
      assertThat(result).contains(begin, end);
      result =
          result.substring(0, result.indexOf(begin) + begin.length())
              + "\n"
              + part.getValue().strip()
              + "\n\n"
              + result.substring(result.indexOf(end));
    }
    return result;
  }
}
