package no.hials.crosscom;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;

import java.time.Duration;
import java.util.List;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import no.hials.crosscom.ConnectionEvent.ChangeReason;
import no.hials.crosscom.ConnectionEvent.ConnectionChange;
import org.assertj.core.api.ThrowableAssert.ThrowingCallable;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Connects at once or in the background, and closes clients that were dropped. */
class ConnectingTest extends RobotTest {
  private static final Duration TINY = Duration.ofMillis(10);

  private ClientConfig config() {
    return client.getConfig().toBuilder().reconnect(true).reconnectBackoff(TINY, TINY).build();
  }

  @Test
  void aLazyClientConnectsWhenTheServerAcceptsIt() throws Exception {
    robot.refuseConnections();
    BlockingQueue<ConnectionEvent> events = new LinkedBlockingQueue<>();
    try (CrossComClient lazy =
        CrossComClient.lazy(config().toBuilder().listener(events::add).build())) {
      CompletableFuture<Void> connected = lazy.connected();
      ConnectionEvent first = events.poll(60, TimeUnit.SECONDS);
      assertThat(first).isNotNull();
      assertThat(first.kind()).isIn(ConnectionChange.CONNECTED, ConnectionChange.RECONNECT_FAILED);
      robot.acceptConnections();
      connected.get(60, TimeUnit.SECONDS);
      assertThat(lazy.readText("$OV_PRO")).isEqualTo("100");
    }
  }

  @Test
  @SuppressWarnings("try") // closing is what is tested
  void aLazyClientWithoutAServerSaysWhyAndHasNoAddress() throws Exception {
    int port = robot.port();
    robot.close();
    try (CrossComClient lazy = CrossComClient.lazy(config())) {
      CompletableFuture<Void> connected = lazy.connected();
      assertThatExceptionOfType(CrossComConnectException.class)
          .isThrownBy(() -> lazy.readText("$OV_PRO"))
          .withMessageContaining("could not connect to 127.0.0.1:" + port);
      assertThat(lazy.getInetAddress()).isNull();
      assertThat(lazy.getLocalPort()).isEqualTo(-1);
      assertThat(connected).isNotDone();
      lazy.close();
      assertClosed(connected);
    }
  }

  @Test
  void theSharedRuntimeCannotBeClosed() throws Exception {
    ClientRuntime.shared().close();

    assertThat(client.readInt("$OV_PRO")).isEqualTo(100);
    try (CrossComClient other = new CrossComClient(config())) {
      assertThat(other.readInt("$OV_PRO")).isEqualTo(100);
    }
  }

  @Test
  void aClosedRuntimeRefusesNewClients() {
    ClientRuntime runtime = ClientRuntime.create(cfg -> {});
    runtime.close();
    ClientConfig config = config().toBuilder().runtime(runtime).build();

    for (ThrowingCallable create :
        List.<ThrowingCallable>of(
            () -> new CrossComClient(config), () -> CrossComClient.lazy(config))) {
      assertThatExceptionOfType(CrossComConnectException.class)
          .isThrownBy(create)
          .withMessageEndingWith("the runtime is closed");
    }
  }

  @Test
  void connectedIsDoneAfterTheConstructor() {
    assertThat(client.connected()).isCompleted();
  }

  @Test
  void asynchronousFunctionsOnConnectedRunInTheThreadsForCallbacks() throws Exception {
    assertThat(threadAfter(client.connected())).startsWith("crosscom-callback-");
    CrossComClient its = new CrossComClient(config());
    its.close();
    assertThat(threadAfter(its.connected().exceptionally(e -> null)))
        .startsWith("crosscom-callback-");
  }

  private static String threadAfter(CompletableFuture<Void> connected) throws Exception {
    return connected
        .thenApplyAsync(nothing -> Thread.currentThread().getName())
        .get(60, TimeUnit.SECONDS);
  }

  @ParameterizedTest
  @ValueSource(booleans = {false, true})
  void connectedConnectsAfterALossWithoutAnyAccess(boolean isLazy) throws Exception {
    try (CrossComClient its =
        isLazy ? CrossComClient.lazy(config()) : new CrossComClient(config())) {
      its.connected().get(60, TimeUnit.SECONDS);
      for (int i = 0; i < 2; i++) {
        assertThat(its.readText("$OV_PRO")).isEqualTo("100"); // the server knows this client
        robot.refuseConnections();
        robot.disconnectClients();
        assertThatExceptionOfType(CrossComException.class)
            .isThrownBy(() -> its.readText("$OV_PRO"));
        CompletableFuture<Void> connected = its.connected();
        assertThat(connected).isNotDone();
        robot.acceptConnections();
        connected.get(60, TimeUnit.SECONDS);
        assertThat(its.connected()).isCompleted();
      }
      assertThat(its.statistics().reconnects()).isEqualTo(2);
    }
  }

  @Test
  void connectedFailsIfTheConnectionIsLostForGoodOrTheClientIsClosed() throws Exception {
    // the client of the base class does not connect again
    assertThat(client.readText("$OV_PRO")).isEqualTo("100"); // the server knows it
    robot.disconnectClients();
    assertThatExceptionOfType(CrossComException.class).isThrownBy(() -> client.readText("$OV_PRO"));
    assertThat(client.isClosed()).isTrue();
    assertClosed(client.connected());

    CrossComClient its = new CrossComClient(config());
    its.close();
    assertClosed(its.connected());
  }

  private static void assertClosed(CompletableFuture<Void> connected) {
    assertThatExceptionOfType(ExecutionException.class)
        .isThrownBy(() -> connected.get(60, TimeUnit.SECONDS))
        .withCauseInstanceOf(CrossComClosedException.class);
  }

  @Test
  void aClientThatIsDroppedIsClosed() throws Exception {
    assertThat(client.readText("$OV_PRO")).isEqualTo("100"); // the server knows this client
    int before = robot.clientCount();
    BlockingQueue<ConnectionEvent> events = new LinkedBlockingQueue<>();
    dropAClient(events);
    while (robot.clientCount() > before) {
      System.gc();
      Thread.onSpinWait();
    }
    ConnectionEvent event = events.poll(60, TimeUnit.SECONDS);
    assertThat(event).isNotNull();
    assertThat(event.reason()).isEqualTo(ChangeReason.DROPPED);
  }

  @SuppressWarnings("resource")
  private void dropAClient(BlockingQueue<ConnectionEvent> events) throws Exception {
    ConnectionListener closed =
        event -> {
          if (event.kind() == ConnectionChange.CLOSED) {
            events.add(event);
          }
        };
    assertThat(client(cfg -> cfg.listener(closed)).readText("$OV_PRO")).isEqualTo("100");
  }

  @Test
  void theViewsOfADroppedClientKeepItOpen() throws Exception {
    KeptView view = keepAView();
    for (int i = 0; i < 5; i++) {
      System.gc();
      assertThat(view.isOpen()).isTrue();
    }
  }

  private interface KeptView {
    boolean isOpen() throws Exception;
  }

  @SuppressWarnings("resource")
  private KeptView keepAView() throws Exception {
    var information = client(cfg -> {}).information();
    return () -> {
      try {
        assertThat(information.get()).isNotNull();
      } catch (CrossComUnsupportedException e) {
        return true; // KUKAVARPROXY; the client is open
      }
      return true;
    };
  }
}
