package no.hials.crosscom.gateway.internal.opcua;

import static org.assertj.core.api.Assertions.assertThat;

import io.prometheus.metrics.core.metrics.Counter;
import java.net.InetAddress;
import java.util.List;
import no.hials.crosscom.gateway.LogLines;
import org.junit.jupiter.api.Test;

class UsersTest {
  private static final InetAddress HERE = InetAddress.getLoopbackAddress();

  private final Counter refused = Counter.builder().name("refused").build();
  private final Users users =
      new Users(new OpcUaSettings("127.0.0.1", 0, true, List.of(), true, true), refused);

  @Test
  void manyRefusalsAreOnlyCounted() {
    try (LogLines lines = LogLines.of(Users.class)) {
      for (int i = 0; i < 1000; i++) {
        users.refuse(HERE, "user 'eve'");
      }

      assertThat(refused.get()).isEqualTo(1000);
      assertThat(lines.get()).hasSize(20);
      assertThat(lines.get().get(0))
          .startsWith("OPC UA: user 'eve' at ")
          .endsWith("may not log in");
      assertThat(lines.get().get(19))
          .endsWith("; further refusals of the next seconds are only counted");
    }
  }

  @Test
  void aNameFromAClientIsOneShortLineInTheLog() {
    assertThat(Users.printable("a\r\nb\u2028c\u0007")).isEqualTo("a??b?c?");
    assertThat(Users.printable("x".repeat(60_000))).hasSize(100);
  }
}
