package no.hials.crosscom.gateway.internal.opcua;

import static org.assertj.core.api.Assertions.assertThat;

import ch.qos.logback.classic.Logger;
import ch.qos.logback.classic.spi.ILoggingEvent;
import ch.qos.logback.core.read.ListAppender;
import io.prometheus.metrics.core.metrics.Counter;
import java.net.InetAddress;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.slf4j.LoggerFactory;

class UsersTest {
  private static final InetAddress HERE = InetAddress.getLoopbackAddress();

  private final Counter refused = Counter.builder().name("refused").build();
  private final Users users =
      new Users(new OpcUaSettings("127.0.0.1", 0, true, List.of(), true, true), refused);

  @Test
  void manyRefusalsAreOnlyCounted() {
    ListAppender<ILoggingEvent> log = new ListAppender<>();
    Logger logger = (Logger) LoggerFactory.getLogger(Users.class);
    log.start();
    logger.addAppender(log);
    try {
      for (int i = 0; i < 1000; i++) {
        users.refuse(HERE, "user 'eve'");
      }
    } finally {
      logger.detachAppender(log);
    }

    assertThat(refused.get()).isEqualTo(1000);
    assertThat(log.list).hasSize(20);
    assertThat(log.list.get(0).getFormattedMessage())
        .startsWith("OPC UA: user 'eve' at ")
        .endsWith("may not log in");
    assertThat(log.list.get(19).getFormattedMessage())
        .endsWith("; further refusals of the next seconds are only counted");
  }

  @Test
  void aNameFromAClientIsOneShortLineInTheLog() {
    assertThat(Users.printable("a\r\nb\u2028c\u0007")).isEqualTo("a??b?c?");
    assertThat(Users.printable("x".repeat(60_000))).hasSize(100);
  }
}
