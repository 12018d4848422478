package no.hials.crosscom.cli.base;

import static org.assertj.core.api.Assertions.assertThat;

import ch.qos.logback.classic.LoggerContext;
import ch.qos.logback.classic.util.LogbackMDCAdapter;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.util.function.Consumer;
import org.junit.jupiter.api.Test;
import org.slf4j.Logger;

class LogConfiguratorTest {
  private static final String UNSAFE = "\u001B[2J\u202E\r\n12:00:00.000 WARN Connection: forged";
  private static final String SAFE =
      "\\x1B[2J\\u202E\\x0D\\x0A12:00:00.000 WARN Connection: forged";

  /** Returns the text on stderr. */
  private static String logged(Consumer<Logger> log) {
    LoggerContext context = new LoggerContext();
    PrintStream before = System.err;
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    System.setErr(new PrintStream(bytes, true, StandardCharsets.UTF_8));
    try {
      new LogConfigurator().configure(context);
      context.setMDCAdapter(new LogbackMDCAdapter());
      log.accept(context.getLogger("no.hials.crosscom.Connection"));
    } finally {
      System.setErr(before);
      context.stop();
    }
    return bytes.toString(StandardCharsets.UTF_8);
  }

  @Test
  void keepsAMessageOnItsLine() {
    assertThat(logged(log -> log.warn("answered {}", UNSAFE)).lines())
        .singleElement()
        .asString()
        .endsWith(" WARN Connection: answered " + SAFE);
  }

  @Test
  void keepsTheMessagesOfAStackTraceOnTheirLines() {
    Exception failure = new IllegalStateException("outer " + UNSAFE, new IOException(UNSAFE));

    assertThat(logged(log -> log.warn("failed", failure)).lines())
        .anyMatch(line -> line.equals("java.lang.IllegalStateException: outer " + SAFE))
        .anyMatch(line -> line.equals("Caused by: java.io.IOException: " + SAFE))
        .anyMatch(line -> line.startsWith("\tat no.hials.crosscom.cli.base.LogConfiguratorTest"))
        .noneMatch(line -> line.startsWith("12:00:00.000"));
  }
}
