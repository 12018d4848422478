package no.hials.crosscom.bench;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;

/** Runs the measurement of the web page's server with one viewer. */
@EnabledOnOs(value = OS.LINUX, disabledReason = "the memory is read from /proc")
class PageViewersTest {
  @Test
  void printsARowAndDeletesItsFolder() throws Exception {
    ByteArrayOutputStream text = new ByteArrayOutputStream();

    PageViewers.measure(1, 0, 1, new PrintStream(text, true, StandardCharsets.UTF_8));

    assertThat(text.toString(StandardCharsets.UTF_8)).startsWith("1 viewers: ");
  }
}
