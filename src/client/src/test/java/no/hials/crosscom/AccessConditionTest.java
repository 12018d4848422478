package no.hials.crosscom;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;

import java.time.Duration;
import java.util.Iterator;
import java.util.List;
import java.util.concurrent.atomic.AtomicBoolean;
import org.junit.jupiter.api.Test;

/** Checks the condition of {@link ClientConfig.Builder#accessIf} before each access. */
class AccessConditionTest extends RobotTest {
  private static final Duration TINY = Duration.ofMillis(1);

  private final AtomicBoolean allowed = new AtomicBoolean(true);

  private CrossComClient guarded() throws Exception {
    return client(cfg -> cfg.accessIf(allowed::get).reconnectBackoff(TINY, TINY));
  }

  @Test
  void nothingIsSentWhileItDoesNotHold() throws Exception {
    try (CrossComClient its = guarded()) {
      assertThat(its.readText("$OV_PRO")).isEqualTo("100");
      robot.clearRequests();
      allowed.set(false);
      assertThatExceptionOfType(CrossComConnectException.class)
          .isThrownBy(() -> its.readText("$OV_PRO"))
          .withMessageContaining("not allowed now");
      assertThatExceptionOfType(CrossComConnectException.class)
          .isThrownBy(() -> its.writeText("MYINT", "5"))
          .satisfies(e -> assertThat(e.isOutcomeUnknown()).isFalse());
      assertThat(robot.requests()).isEmpty();
    }
  }

  @Test
  void theClientReconnectsOnceItHoldsAgain() throws Exception {
    try (CrossComClient its = guarded()) {
      allowed.set(false);
      assertThatExceptionOfType(CrossComConnectException.class)
          .isThrownBy(() -> its.readText("$OV_PRO"));
      allowed.set(true);
      its.connected().get();
      assertThat(its.readText("$OV_PRO")).isEqualTo("100");
    }
  }

  @Test
  void aWatchMissesItsReadingsMeanwhile() throws Exception {
    try (CrossComClient its = guarded();
        Watch watch =
            its.watch(
                WatchConfig.create(
                    List.of("$OV_PRO"), cfg -> cfg.period(TINY).missedSamples(true)))) {
      Iterator<Sample> samples = watch.iterator();
      assertThat(samples.next().readings().get("$OV_PRO").value()).isNotNull();
      allowed.set(false);
      Sample sample = samples.next();
      while (sample.readings().get("$OV_PRO").value() != null) {
        sample = samples.next();
      }
      robot.clearRequests();
      assertThat(sample.readings().get("$OV_PRO").failure()).hasMessageContaining("not allowed");
      samples.next();
      assertThat(robot.requests()).isEmpty();
      allowed.set(true);
      while (sample.readings().get("$OV_PRO").value() == null) {
        sample = samples.next();
      }
    }
  }

  @Test
  void noConnectionIsMadeWhileItDoesNotHold() throws Exception {
    assertThat(client.readText("$OV_PRO")).isEqualTo("100"); // the server knows this client
    int before = robot.clientCount();
    allowed.set(false);
    assertThatExceptionOfType(CrossComConnectException.class)
        .isThrownBy(this::guarded)
        .withMessageContaining("not allowed now");
    assertThat(robot.clientCount()).isEqualTo(before);
  }
}
