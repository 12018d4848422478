package no.hials.crosscom.gateway.internal.broker;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;

class InFlightTest {
  /** The payload of a message that counts as 1000 bytes. */
  private static final int PAYLOAD = 900;

  private final InFlight inFlight = new InFlight();

  /** The time; it begins near the largest number, where sums overflow. */
  private long now = Long.MAX_VALUE - TimeUnit.SECONDS.toNanos(3);

  private Outgoing send(int qos, int payload) {
    Publication message = new Publication("topic", new byte[payload], qos, false);
    Outgoing one = Outgoing.of(message, null, now);
    inFlight.add(one);
    return one;
  }

  /** Sends messages of 1000 bytes while there is room. */
  private List<Outgoing> fill(int qos) {
    List<Outgoing> sent = new ArrayList<>();
    while (inFlight.hasRoom(now)) {
      sent.add(send(qos, PAYLOAD));
    }
    return sent;
  }

  private void removeDone() {
    while (inFlight.pollDone() != null) {
      // the next one
    }
  }

  private void confirm(List<Outgoing> messages, int afterMillis) {
    now += TimeUnit.MILLISECONDS.toNanos(afterMillis);
    messages.forEach(one -> inFlight.done(one, now));
    removeDone();
  }

  /** Confirms messages as a connection does that carries some kilobytes a second. */
  private void carry(List<Outgoing> messages, int tripMillis, int kilobytesPerSecond) {
    now += TimeUnit.MILLISECONDS.toNanos(tripMillis);
    for (Outgoing one : messages) {
      now += TimeUnit.MILLISECONDS.toNanos(one.bytes / kilobytesPerSecond);
      inFlight.done(one, now);
    }
    removeDone();
  }

  private void loseConnection() {
    while (inFlight.pollLost() != null) {
      // the next one
    }
  }

  private void confirm(Outgoing message, int afterMillis) {
    confirm(List.of(message), afterMillis);
  }

  @Test
  void aConnectionBeginsWith16KilobytesOfAnyQualityOfService() {
    assertThat(fill(0)).hasSize(16);
    loseConnection();
    assertThat(fill(2)).hasSize(16);
  }

  @Test
  void quickConfirmationsDoubleTheWindowOncePerRoundTrip() {
    confirm(send(1, 0), 1);
    confirm(fill(1), 500);
    List<Outgoing> second = fill(1);
    confirm(second, 100);

    assertThat(second).hasSize(32);
    assertThat(fill(1)).hasSize(64);
  }

  @Test
  void theWindowHasWhatTheConnectionCarriesInTwoRoundTrips() {
    for (int i = 0; i < 10; i++) {
      carry(fill(1), 100, 100);
    }

    assertThat(fill(1)).as("100 kB/s, 0.11 s for a message alone").hasSize(17);
  }

  @Test
  void theFirstOfManyMessagesDoesNotShowTheSpeed() {
    confirm(send(1, 0), 1);
    List<Outgoing> sent = fill(1);
    confirm(sent.subList(0, 4), 1);
    confirm(sent.subList(4, 16), 2200);

    assertThat(fill(1)).hasSize(4);
  }

  @Test
  void aWindowThatIsNotInUseStays() {
    for (int i = 0; i < 10; i++) {
      confirm(send(1, 6 * PAYLOAD), 1);
    }

    assertThat(fill(1)).hasSize(16);
  }

  @Test
  void aSpeedThatIsEnoughKeepsTheWindow() {
    carry(fill(1), 0, 50);
    carry(fill(1), 0, 25);

    assertThat(fill(1)).hasSize(16);
  }

  /** Fills the large window of a fast connection. */
  private List<Outgoing> fillLarge() {
    for (int i = 0; i < 3; i++) {
      confirm(fill(1), 1);
    }
    List<Outgoing> large = fill(1);
    assertThat(large).hasSize(128);
    return large;
  }

  @Test
  void aConnectionThatBecomesSlowHasAWindowForItsSpeedAtOnce() {
    carry(fillLarge(), 1, 100);

    assertThat(fill(1)).as("100 kB/s, 0.011 s for a message alone: 7.2 kB").hasSize(8);
  }

  @Test
  void nothingIsSentWhileTheOldestMessageWaitsForLong() {
    confirm(send(1, 0), 1);
    Outgoing waiting = send(1, PAYLOAD);
    now += TimeUnit.MILLISECONDS.toNanos(1100);
    assertThat(inFlight.hasRoom(now)).isFalse();

    confirm(waiting, 0);

    assertThat(inFlight.hasRoom(now)).isTrue();
  }

  @Test
  void afterALateMessageNothingIsSentUntilAllAreConfirmed() {
    confirm(send(1, 0), 1);
    List<Outgoing> waiting = List.of(send(1, PAYLOAD), send(1, PAYLOAD));
    now += TimeUnit.MILLISECONDS.toNanos(1100);
    assertThat(inFlight.hasRoom(now)).isFalse();

    confirm(waiting.get(0), 0);
    assertThat(inFlight.hasRoom(now)).isFalse();
    confirm(waiting.get(1), 0);

    assertThat(inFlight.hasRoom(now)).isTrue();
  }

  @Test
  void aRoundTripThatHasBecomeLongerIsNotASlowConnection() {
    confirm(send(1, 0), 1);
    List<Outgoing> sent = fill(1);
    confirm(sent.subList(0, 8), 1);
    List<Outgoing> more = fill(1);
    confirm(sent.subList(8, 16), 1);
    confirm(more, 2000);
    assertThat(inFlight.hasRoom(now)).isTrue();

    for (int i = 0; i < 6; i++) {
      confirm(fill(1), 2000);
    }

    assertThat(fill(1)).as("from 4 kB, half as much again each time").hasSize(61);
  }

  @Test
  void aRoundTripThatHasBecomeALittleLongerIsNoticed() {
    Outgoing quick = send(1, 0);
    Deque<Outgoing> sent = new ArrayDeque<>(List.of(send(1, PAYLOAD)));
    confirm(quick, 1);
    // messages each 10 ms, so that none is sent alone
    for (int i = 0; i < 2000; i++) {
      now += TimeUnit.MILLISECONDS.toNanos(10);
      while (!sent.isEmpty() && now - sent.element().sentAt >= TimeUnit.MILLISECONDS.toNanos(200)) {
        confirm(sent.remove(), 0);
      }
      for (int more = 0; more < 2 && inFlight.hasRoom(now); more++) {
        sent.add(send(1, PAYLOAD));
      }
    }

    assertThat(sent).as("two messages each 10 ms").hasSizeBetween(38, 42);
  }

  @Test
  void storedMessagesGet32KilobytesBesidesNewOnes() {
    confirm(fillLarge(), 1);
    for (int i = 0; i < 40; i++) {
      send(1, PAYLOAD);
    }
    int stored = 0;
    for (; inFlight.hasRoomForStored(now); stored++) {
      Publication message = new Publication("topic", new byte[PAYLOAD], 1, false);
      StoredMessage from = new StoredMessage("topic", new byte[PAYLOAD]);
      inFlight.add(Outgoing.stored(message, from, "a stored message", now));
    }
    assertThat(stored).isEqualTo(32);
  }

  @Test
  void storedMessagesAreSentBesidesManySmallOnes() {
    confirm(fillLarge(), 1);
    for (int i = 0; i < 900; i++) {
      send(1, 1);
    }

    assertThat(inFlight.hasRoomForStored(now)).isTrue();
  }

  @Test
  void aLongRoundTripIsNotASlowConnection() {
    confirm(fill(1), 1200);

    assertThat(fill(1)).hasSize(32);
  }

  @Test
  void aMessageFromBeforeAChangeDoesNotCount() {
    List<Outgoing> sent = fillLarge();
    carry(sent.subList(0, 104), 1, 100);

    confirm(sent.subList(104, 128), 10_000);

    assertThat(fill(1)).hasSize(8);
  }

  @Test
  void answersGetHalfOfTheRoom() {
    int answers = 0;
    for (; inFlight.hasRoomForAnswer(now); answers++) {
      Publication answer = new Publication("topic", new byte[PAYLOAD], 1, false);
      inFlight.add(Outgoing.atOnce(answer, true, now));
    }

    assertThat(answers).isEqualTo(8);
    assertThat(fill(1)).hasSize(8);
  }

  @Test
  void aSlowConnectionSendsOneMessageOfAnySizeAtATime() {
    for (int i = 0; i < 10; i++) {
      confirm(send(0, 50_000), 6000);
    }
    assertThat(inFlight.hasRoom(now)).isTrue();

    Outgoing large = send(0, 50_000);

    assertThat(inFlight.hasRoom(now)).isFalse();
    assertThat(inFlight.hasRoomForStored(now)).isFalse();
    confirm(large, 6000);
    assertThat(inFlight.hasRoomForStored(now)).isTrue();
    assertThat(fill(0)).as("8 kB/s").hasSize(16);
  }

  @Test
  void aFastConnectionHasAThousandMessagesAtMost() {
    for (int i = 0; i < 10; i++) {
      confirm(fill(1), 1);
    }

    assertThat(fill(1)).hasSize(1000);
  }

  @Test
  void aFastConnectionHasAMegabyteAndOneMessageAtMost() {
    for (int i = 0; i < 10; i++) {
      confirm(fill(1), 1);
    }

    int large = 0;
    for (; inFlight.hasRoom(now); large++) {
      send(1, 99_900);
    }

    assertThat(large).isEqualTo(11);
  }

  @Test
  void anotherConnectionBeginsAgain() {
    confirm(fill(1), 1);
    fill(1);
    loseConnection();

    assertThat(fill(1)).hasSize(16);
  }

  @Test
  void aStoredMessageThatIsSkippedNeedsNoRoom() {
    inFlight.add(Outgoing.skipped(new StoredMessage("topic", new byte[50_000])));

    assertThat(inFlight.hasRoomForStored(now)).isTrue();
    assertThat(inFlight.pollDone()).isNotNull();
  }

  @Test
  void aLimitHoldsUntilTheConnectionIsLost() {
    inFlight.limit(2, 0);

    assertThat(fill(1)).hasSize(2);

    loseConnection();
    assertThat(fill(1)).hasSize(16);
  }

  @Test
  void withAPauseEachMessageWaitsForSomeTimeAfterTheLast() {
    Outgoing first = send(1, PAYLOAD);
    inFlight.limit(1000, 100);
    assertThat(inFlight.hasRoom(now)).isFalse();

    now += 50;
    inFlight.done(first, now);
    inFlight.pollDone();

    assertThat(inFlight.hasRoom(now + 99)).isFalse();
    assertThat(inFlight.hasRoom(now + 100)).isTrue();
  }
}
