package no.hials.crosscom;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;

import java.time.Duration;
import java.util.List;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import no.hials.crosscom.ConnectionEvent.ChangeReason;
import no.hials.crosscom.ConnectionEvent.ConnectionChange;
import no.hials.crosscom.mock.Fault;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

/** The reasons of the events of a connection. */
class ConnectionEventTest extends RobotTest {
  private static final Duration TINY = Duration.ofMillis(1);

  private final BlockingQueue<ConnectionEvent> events = new LinkedBlockingQueue<>();

  private CrossComClient listening(Consumer<ClientConfig.Builder> settings) throws Exception {
    return client(
        cfg -> {
          cfg.reconnectBackoff(TINY, TINY).listener(events::add);
          settings.accept(cfg);
        });
  }

  /** Returns the reason of the next event of a kind. */
  private ChangeReason reason(ConnectionChange kind) throws Exception {
    ConnectionEvent event;
    do {
      event = events.poll(60, TimeUnit.SECONDS);
      assertThat(event).isNotNull();
    } while (event.kind() != kind);
    return event.reason();
  }

  static List<Arguments> faults() {
    return List.of(
        Arguments.of(Fault.closeBefore(), ChangeReason.SERVER_CLOSED),
        Arguments.of(Fault.closeDuring(3), ChangeReason.SERVER_CLOSED),
        Arguments.of(Fault.resetBefore(), ChangeReason.NETWORK_FAILED),
        Arguments.of(Fault.dropAnswer(), ChangeReason.TIMEOUT),
        Arguments.of(Fault.wrongId(), ChangeReason.PROTOCOL_ERROR),
        Arguments.of(Fault.wrongLength(-1), ChangeReason.PROTOCOL_ERROR));
  }

  @ParameterizedTest
  @MethodSource("faults")
  void aLossHasAReasonAndTheReconnectHasNone(Fault fault, ChangeReason reason) throws Exception {
    try (CrossComClient its = listening(cfg -> {})) {
      its.readInt("MYINT");
      its.setSoTimeout((int) SHORT.toMillis());
      robot.enqueue(fault);
      assertThatExceptionOfType(CrossComException.class).isThrownBy(() -> its.writeInt("MYINT", 1));
      its.setSoTimeout((int) LONG.toMillis());
      assertThat(its.readInt("MYINT")).isEqualTo(fault.executes() ? 1 : 0);

      assertThat(reason(ConnectionChange.CONNECTED)).isEqualTo(ChangeReason.NONE);
      assertThat(reason(ConnectionChange.LOST)).isEqualTo(reason);
      assertThat(reason(ConnectionChange.RECONNECTED)).isEqualTo(ChangeReason.NONE);
    }
    assertThat(reason(ConnectionChange.CLOSED)).isEqualTo(ChangeReason.CLOSED_BY_PROGRAM);
  }

  @ParameterizedTest
  @MethodSource("rejections")
  void aConnectionThatEndsWithoutAnyAnswerWasRejected(Fault fault) throws Exception {
    try (CrossComClient its = listening(cfg -> {})) {
      robot.enqueue(fault);
      assertThatExceptionOfType(CrossComConnectionLostException.class)
          .isThrownBy(() -> its.writeInt("MYINT", 1));

      assertThat(reason(ConnectionChange.LOST)).isEqualTo(ChangeReason.REJECTED);
    }
  }

  static List<Fault> rejections() {
    return List.of(Fault.closeBefore(), Fault.resetBefore());
  }

  @Test
  void anInterruptedExchangeIsTheReasonOfALoss() throws Exception {
    CountDownLatch released = new CountDownLatch(1);
    CountDownLatch received = new CountDownLatch(1);
    robot.fault(
        r -> {
          received.countDown();
          return r.name().equals("MYINT");
        },
        Fault.hold(released));
    try (CrossComClient its = listening(cfg -> {})) {
      Thread reader =
          new Thread(
              () ->
                  assertThatExceptionOfType(CrossComConnectionLostException.class)
                      .isThrownBy(() -> its.readInt("MYINT")));
      reader.start();
      received.await();
      reader.interrupt();
      reader.join();

      assertThat(reason(ConnectionChange.LOST)).isEqualTo(ChangeReason.INTERRUPTED);
    } finally {
      released.countDown();
    }
  }

  @Test
  void aFailedAttemptToConnectSaysThatNoServerListens() throws Exception {
    robot.close();
    try (CrossComClient its = CrossComClient.lazy(config(robot.host()))) {
      assertThat(reason(ConnectionChange.RECONNECT_FAILED)).isEqualTo(ChangeReason.REFUSED);
      assertThat(its.isClosed()).isFalse();
    }
  }

  @Test
  void aFailedAttemptToConnectSaysThatTheHostIsUnknown() throws Exception {
    try (CrossComClient its = CrossComClient.lazy(config("no.such.host.invalid"))) {
      assertThat(reason(ConnectionChange.RECONNECT_FAILED)).isEqualTo(ChangeReason.UNKNOWN_HOST);
      assertThat(its.isClosed()).isFalse();
    }
  }

  @Test
  @SuppressWarnings("try") // the runtime is closed while the client is in use
  void aClientWhoseRuntimeIsClosedSaysSo() throws Exception {
    try (ClientRuntime runtime = ClientRuntime.create(cfg -> {});
        CrossComClient its = listening(cfg -> cfg.runtime(runtime))) {
      runtime.close();

      assertThat(reason(ConnectionChange.CLOSED)).isEqualTo(ChangeReason.RUNTIME_CLOSED);
      assertThat(its.isClosed()).isTrue();
    }
  }

  private ClientConfig config(String host) {
    return ClientConfig.create(
        host, cfg -> cfg.port(robot.port()).reconnectBackoff(TINY, TINY).listener(events::add));
  }
}
