package no.hials.crosscom.gateway.internal.broker;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Set;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;

class CulpritsTest {
  private final Culprits culprits = new Culprits("plain");

  /** The time; it begins near the largest number, where sums overflow. */
  private long now = Long.MAX_VALUE - TimeUnit.SECONDS.toNanos(3);

  private void pass(int seconds) {
    now += TimeUnit.SECONDS.toNanos(seconds);
  }

  /** Connects, and lets the broker end the connection after a second. */
  private boolean end(String... unconfirmed) {
    culprits.connected(now);
    pass(1);
    return culprits.ended(Set.of(unconfirmed), now);
  }

  /** Lets the broker end connections until messages are sent one at a time. */
  private void startSearch() {
    while (!culprits.isSearching(now)) {
      assertThat(end("good", "bad")).isFalse();
    }
  }

  private void block() {
    startSearch();
    assertThat(end("bad")).isFalse();
    assertThat(end("bad")).isTrue();
  }

  @Test
  void aTopicThatIsTwiceAloneIsBlocked() {
    block();

    assertThat(culprits.isBlocked("bad", now)).isTrue();
    assertThat(culprits.isBlocked("good", now)).isFalse();
  }

  @Test
  void aTopicThatIsConfirmedMeanwhileIsNotBlocked() {
    startSearch();
    assertThat(end("good")).isFalse();

    culprits.confirmed("good");

    assertThat(end("good")).isFalse();
  }

  @Test
  void severalCulpritsAreBlockedOneAfterTheOther() {
    startSearch();
    assertThat(end("bad")).isFalse();
    assertThat(end("worse")).isFalse();

    assertThat(end("bad")).isTrue();
    assertThat(end("worse")).isTrue();
  }

  @Test
  void theSearchBeginsAfterThreeConnections() {
    end("a");
    end("b");
    assertThat(culprits.isSearching(now)).isFalse();

    end("c", "d");

    assertThat(culprits.isSearching(now)).isTrue();
  }

  @Test
  void connectionsThatLastAreNotCounted() {
    end("a");
    end("b");
    culprits.connected(now);
    pass(11);
    culprits.ended(Set.of("a"), now);

    end("a");

    assertThat(culprits.isSearching(now)).isFalse();
  }

  @Test
  void connectionsWithoutMessagesAreNotCounted() {
    for (int i = 0; i < 10; i++) {
      assertThat(end()).isFalse();
    }

    assertThat(culprits.isSearching(now)).isFalse();
  }

  @Test
  void theSearchEndsWhenAllAreConfirmedOrBlocked() {
    block();
    assertThat(culprits.isSearching(now)).isTrue();

    culprits.confirmed("good");

    assertThat(culprits.isSearching(now)).isFalse();
  }

  @Test
  void theSearchEndsAfterSomeMinutes() {
    startSearch();

    pass(301);

    assertThat(culprits.isSearching(now)).isFalse();
  }

  @Test
  void theNextCulpritIsBlockedAtOnce() {
    block();
    culprits.confirmed("good");
    assertThat(end("other", "good")).isFalse();
    assertThat(culprits.isSearching(now)).isTrue();

    assertThat(end("other")).isTrue();

    assertThat(culprits.isBlocked("other", now)).isTrue();
  }

  @Test
  void aBlockEndsAndIsTwiceAsLongTheNextTime() {
    block();
    pass(11);
    assertThat(culprits.isBlocked("bad", now)).isFalse();

    assertThat(end("bad", "good")).isTrue();

    pass(19);
    assertThat(culprits.isBlocked("bad", now)).isTrue();
    pass(2);
    assertThat(culprits.isBlocked("bad", now)).isFalse();
  }

  @Test
  void aConfirmedTopicIsForgotten() {
    block();
    pass(11);
    culprits.confirmed("bad");
    culprits.confirmed("good");

    assertThat(end("bad", "good")).isFalse();
  }
}
