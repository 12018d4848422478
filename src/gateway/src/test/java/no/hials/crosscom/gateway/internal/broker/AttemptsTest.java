package no.hials.crosscom.gateway.internal.broker;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import org.junit.jupiter.api.Test;

class AttemptsTest {
  private static final Duration SOON = Duration.ofMillis(150);

  private final Attempts attempts = new Attempts("plain", "tcp://127.0.0.1");

  private void fail(int times) {
    for (int i = 0; i < times; i++) {
      attempts.failed("refused");
    }
  }

  private boolean isDueIn(Duration time) {
    return attempts.isDue(System.nanoTime() + time.toNanos());
  }

  @Test
  void waitsLongerAfterEachFailureUpToFiveSeconds() {
    assertThat(isDueIn(Duration.ZERO)).isTrue();

    fail(1);
    assertThat(isDueIn(SOON)).isTrue();
    fail(1);
    assertThat(isDueIn(SOON)).isFalse();
    fail(20);
    assertThat(isDueIn(Duration.ofSeconds(4))).isFalse();
    assertThat(isDueIn(Duration.ofSeconds(5))).isTrue();
  }

  @Test
  void waitsLongerAfterEachConnectionThatEndsSoon() {
    attempts.connected();
    attempts.lost(false);
    assertThat(isDueIn(SOON)).isTrue();

    attempts.connected();
    attempts.lost(false);
    assertThat(isDueIn(SOON)).isFalse();
  }

  @Test
  void forgetsTheFailuresWhenItIsConnected() {
    fail(20);

    attempts.connected();
    attempts.lost(false);

    assertThat(isDueIn(SOON)).isTrue();
  }

  @Test
  void connectsSoonIfTheNextConnectionWillBeBetter() {
    for (int i = 0; i < 20; i++) {
      attempts.connected();
      attempts.lost(false);
    }

    attempts.connected();
    attempts.lost(true);

    assertThat(isDueIn(SOON)).isTrue();
  }
}
