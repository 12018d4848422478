package no.hials.crosscom.mock;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.net.InetAddress;
import java.time.Duration;
import java.util.function.Consumer;
import no.hials.crosscom.protocol.Tail;
import org.junit.jupiter.api.Test;

class MockServerConfigTest {

  private static void assertRefused(Consumer<MockServerConfig.Builder> changes, String message) {
    assertThatThrownBy(() -> MockServerConfig.create(changes))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageContaining(message);
  }

  @Test
  void behavesAsKukavarproxyByDefault() {
    assertThat(MockServerConfig.create(cfg -> {}))
        .isEqualTo(
            new MockServerConfig(
                InetAddress.getLoopbackAddress(),
                0,
                FailedRead.EMPTY_SUCCESS,
                Tail.FAILURE,
                true,
                10,
                Duration.ofSeconds(30),
                255,
                10_000));
  }

  @Test
  void takesWhatIsSet() throws Exception {
    InetAddress any = InetAddress.getByAddress(new byte[4]);
    assertThat(
            MockServerConfig.create(
                cfg ->
                    cfg.bindAddress(any)
                        .port(65_535)
                        .failedRead(FailedRead.FAILURE)
                        .failedWriteTail(Tail.FAILURE_ZERO)
                        .trimValues(false)
                        .maxClients(0)
                        .idleTimeout(Duration.ZERO)
                        .maxAggregateLength(0)
                        .recordedRequests(0)))
        .isEqualTo(
            new MockServerConfig(
                any, 65_535, FailedRead.FAILURE, Tail.FAILURE_ZERO, false, 0, Duration.ZERO, 0, 0));
  }

  @Test
  void refusesWhatIsOutOfRange() {
    assertRefused(cfg -> cfg.port(-1), "port must be 0 to 65535, is -1");
    assertRefused(cfg -> cfg.port(65_536), "port must be 0 to 65535, is 65536");
    assertRefused(cfg -> cfg.failedWriteTail(Tail.SUCCESS), "failedWriteTail must say failure");
    assertRefused(cfg -> cfg.maxClients(-1), "maxClients");
    assertRefused(cfg -> cfg.idleTimeout(Duration.ofNanos(-1)), "idleTimeout");
    assertRefused(cfg -> cfg.idleTimeout(Duration.ofDays(25)), "idleTimeout");
    assertRefused(cfg -> cfg.maxAggregateLength(-1), "maxAggregateLength");
    assertRefused(cfg -> cfg.recordedRequests(-1), "recordedRequests");
  }
}
