package no.hials.crosscom.bench;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import org.junit.jupiter.api.Test;

/** Runs the measurement of many robots with a few. */
class ManyRobotsTest {
  @Test
  void theSamplesOfTheRobotsThatAnswerAreCounted() throws Exception {
    ByteArrayOutputStream text = new ByteArrayOutputStream();
    PrintStream out = new PrintStream(text, true, StandardCharsets.UTF_8);

    double inTime =
        new ManyRobots(out, Duration.ofMillis(200)).run(5, 1, Duration.ofMillis(500), 2);

    assertThat(inTime).isBetween(0.0, 100.0);
    assertThat(text.toString(StandardCharsets.UTF_8))
        .startsWith("5 robots, 1 of them silent, every 200 ms: ")
        .contains("samples of 40, ")
        .doesNotContain(" 0 samples");
  }
}
