package no.hials.crosscom.gateway.internal.broker;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Random;
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

  private void connect() {
    pass(1);
    culprits.connected(now);
  }

  /** Connects, and lets the broker end the connection after a second. */
  private boolean end(String... unconfirmed) {
    connect();
    pass(1);
    return culprits.ended(Set.of(unconfirmed), now);
  }

  private void startSearch() {
    for (int i = 0; i < 3; i++) {
      assertThat(end("good", "bad", "worse")).isFalse();
    }
    assertThat(culprits.isSearching(now)).isTrue();
  }

  /** Sends a suspect on a connection that has lasted, and lets the broker end it. */
  private void endAt(String suspect) {
    pass(10);
    assertThat(culprits.mustWait(suspect, now)).isFalse();
    culprits.sent(suspect);
    assertThat(culprits.ended(Set.of(suspect, "good"), now)).isTrue();
  }

  private void block(String suspect) {
    startSearch();
    end(suspect);
    connect();
    endAt(suspect);
  }

  @Test
  void aSuspectThatEndsALastingConnectionIsBlocked() {
    startSearch();
    assertThat(end("bad")).isTrue();
    connect();
    assertThat(culprits.mustWait("bad", now)).isTrue();
    assertThat(culprits.mustWait("good", now)).isFalse();

    endAt("bad");

    assertThat(culprits.isBlocked("bad", now)).isTrue();
    assertThat(culprits.isBlocked("good", now)).isFalse();
  }

  @Test
  void severalCulpritsAreTestedOneAfterTheOther() {
    startSearch();
    end("bad");
    end("worse");
    connect();
    pass(10);
    culprits.sent("bad");

    assertThat(culprits.mustWait("worse", now)).isTrue();
    assertThat(culprits.ended(Set.of("bad"), now)).isTrue();

    connect();
    endAt("worse");
  }

  @Test
  void aSuspectThatIsConfirmedIsNotOneAnyMore() {
    startSearch();
    end("good");
    connect();
    pass(10);
    culprits.sent("good");

    culprits.confirmed("good", now);
    now += Culprits.SETTLING;

    assertThat(culprits.ended(Set.of("good"), now)).isFalse();
    connect();
    assertThat(culprits.mustWait("good", now)).isFalse();
  }

  @Test
  void aMessageThatIsConfirmedJustBeforeTheEndIsFound() {
    startSearch();
    connect();
    culprits.confirmed("good", now);
    pass(1);
    culprits.confirmed("bad", now);
    assertThat(culprits.ended(Set.of(), now)).isTrue();
    connect();
    assertThat(culprits.mustWait("good", now)).isFalse();
    pass(10);
    assertThat(culprits.mustWait("bad", now)).isFalse();
    culprits.sent("bad");
    culprits.confirmed("bad", now);
    culprits.confirmed("good", now);

    assertThat(culprits.ended(Set.of("good"), now)).isTrue();

    assertThat(culprits.isBlocked("bad", now)).isTrue();
    assertThat(culprits.isBlocked("good", now)).isFalse();
  }

  @Test
  void aSuspectWhoseConnectionTheNetworkEndsIsTestedOnTheNext() {
    startSearch();
    end("bad");
    connect();
    pass(10);
    culprits.sent("bad");

    connect();

    endAt("bad");
  }

  @Test
  void aStoredMessageTestsItsTopicIfThatIsASuspect() {
    StoredMessage stored = new StoredMessage("bad", new byte[1]);
    assertThat(culprits.name("bad", stored)).isEqualTo(stored.name());

    startSearch();
    end("bad");

    assertThat(culprits.name("bad", stored)).isEqualTo("bad");
    assertThat(culprits.name("good", stored)).isEqualTo(stored.name());
  }

  @Test
  void aStoredMessageThatIsASuspectIsTestedBeforeItsTopic() {
    StoredMessage stored = new StoredMessage("bad", new byte[1]);
    startSearch();
    end("bad");
    end(stored.name());

    assertThat(culprits.name("bad", stored)).isEqualTo(stored.name());
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
    connect();
    pass(5);
    assertThat(culprits.ended(Set.of("a"), now)).isFalse();

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
  void theSearchEndsWhenAConnectionLasts() {
    startSearch();
    connect();
    assertThat(culprits.isSearching(now)).isTrue();

    pass(10);

    assertThat(culprits.isSearching(now)).isFalse();
  }

  @Test
  void aBadNetworkBlocksNothingAndEndsTheSearch() {
    Random random = new Random(1);
    for (int i = 0; i < 70; i++) {
      connect();
      for (int message = 0; message < random.nextInt(20); message++) {
        culprits.confirmed("topic" + message, now);
      }
      pass(1);
      culprits.ended(Set.of("topic" + random.nextInt(20)), now);
    }

    connect();
    assertThat(culprits.isSearching(now)).isFalse();
    for (int topic = 0; topic < 20; topic++) {
      assertThat(culprits.mustWait("topic" + topic, now)).isFalse();
      assertThat(culprits.isBlocked("topic" + topic, now)).isFalse();
    }
  }

  @Test
  void aBlockEndsAndIsTwiceAsLongTheNextTime() {
    block("bad");
    connect();
    assertThat(culprits.mustWait("bad", now)).isFalse(); // it is refused
    pass(8);
    assertThat(culprits.isBlocked("bad", now)).isTrue();
    pass(1);
    assertThat(culprits.isBlocked("bad", now)).isFalse();
    assertThat(culprits.mustWait("bad", now)).isTrue();

    endAt("bad");

    pass(19);
    assertThat(culprits.isBlocked("bad", now)).isTrue();
    pass(1);
    assertThat(culprits.isBlocked("bad", now)).isFalse();
  }

  @Test
  void aConfirmedTopicIsForgotten() {
    block("bad");
    connect();
    pass(10);
    culprits.sent("bad");
    culprits.confirmed("bad", now);
    now += Culprits.SETTLING;

    assertThat(culprits.ended(Set.of("bad", "good"), now)).isFalse();
    assertThat(culprits.mustWait("bad", now)).isFalse();
  }
}
