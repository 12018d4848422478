package no.hials.crosscom.gateway.internal.broker;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
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
    Outgoing one = new Outgoing(message, null, null, now);
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

  private void confirm(List<Outgoing> messages, int afterMillis) {
    now += TimeUnit.MILLISECONDS.toNanos(afterMillis);
    messages.forEach(one -> inFlight.done(one, now));
    while (inFlight.pollDone() != null) {
      // the next one
    }
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
  void theWindowHasWhatTheConnectionCarriesInASecond() {
    confirm(send(1, 0), 1);

    confirm(fill(1), 800);

    assertThat(fill(1)).as("16 kB in 0.8 s").hasSize(21);
  }

  @Test
  void theFirstOfManyMessagesDoesNotShowTheSpeed() {
    confirm(send(1, 0), 1);
    List<Outgoing> sent = fill(1);
    confirm(sent.subList(0, 4), 1);
    confirm(sent.subList(4, 16), 2200);

    assertThat(fill(1)).hasSize(8);
  }

  @Test
  void aWindowThatIsNotInUseStays() {
    for (int i = 0; i < 10; i++) {
      confirm(send(1, 6 * PAYLOAD), 1);
    }

    assertThat(fill(1)).hasSize(16);
  }

  @Test
  void confirmationsWithinOneAndTwoSecondsKeepTheWindow() {
    confirm(send(1, 0), 1);
    confirm(fill(1), 1100);
    confirm(fill(1), 1900);

    assertThat(fill(1)).hasSize(16);
  }

  @Test
  void aSlowConfirmationHalvesTheWindow() {
    confirm(send(1, 0), 1);
    confirm(fill(1), 2100);

    assertThat(fill(1)).hasSize(8);
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
  void aRoundTripThatHasBecomeLongerIsNotASlowConnection() {
    confirm(send(1, 0), 1);
    for (int i = 0; i < 20; i++) {
      confirm(send(1, 0), 1200);
    }
    confirm(fill(1), 2400);

    assertThat(fill(1)).as("16 kB in 2.4 s: 22.7 kB in 3.4 s").hasSize(23);
  }

  @Test
  void aLongRoundTripIsNotASlowConnection() {
    confirm(send(1, 0), 1200);
    confirm(fill(1), 2400);

    assertThat(fill(1)).as("16 kB in 2.4 s: 22.7 kB in 3.4 s").hasSize(23);
  }

  @Test
  void aMessageFromBeforeAChangeDoesNotCount() {
    confirm(send(1, 0), 1);
    List<Outgoing> sent = fill(1);
    confirm(sent.get(0), 2100);
    confirm(sent.get(1), 2000);

    confirm(sent.subList(2, 16), 0);

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
    assertThat(inFlight.isHalfEmpty(now)).isFalse();
    confirm(large, 6000);
    assertThat(inFlight.isHalfEmpty(now)).isTrue();
    assertThat(fill(0)).hasSize(4);
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
    inFlight.add(new Outgoing(new StoredMessage("topic", new byte[50_000])));

    assertThat(inFlight.isHalfEmpty(now)).isTrue();
    assertThat(inFlight.pollDone()).isNotNull();
  }
}
