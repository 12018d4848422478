package no.hials.crosscom.kafka.internal;

import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.net.InetAddress;
import java.net.ServerSocket;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import org.apache.kafka.clients.admin.Admin;
import org.apache.kafka.clients.admin.AdminClientConfig;
import org.apache.kafka.common.TopicPartition;
import org.apache.kafka.connect.errors.ConnectException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** Claims that cannot be read. */
@Timeout(60)
class ClaimsTest {
  @Test
  void theReasonWhyTheOffsetsCannotBeReadIsTold() throws Exception {
    try (ServerSocket silent = new ServerSocket(0, 50, InetAddress.getLoopbackAddress());
        Claims claims =
            new Claims(
                Admin.create(
                    Map.of(
                        AdminClientConfig.BOOTSTRAP_SERVERS_CONFIG,
                        "127.0.0.1:" + silent.getLocalPort(),
                        AdminClientConfig.REQUEST_TIMEOUT_MS_CONFIG,
                        "100",
                        AdminClientConfig.DEFAULT_API_TIMEOUT_MS_CONFIG,
                        "100")),
                "connect-writes",
                Duration.ofMinutes(1))) {
      assertThatThrownBy(
              () -> claims.open(List.of(new TopicPartition("commands", 0)), Duration.ofMinutes(1)))
          .isInstanceOf(ConnectException.class)
          .hasMessageContaining("cannot read the offsets of the group connect-writes: ")
          .hasMessageContaining("Timed out");
    }
  }
}
