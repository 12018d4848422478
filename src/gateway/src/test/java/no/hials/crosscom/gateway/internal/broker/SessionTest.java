package no.hials.crosscom.gateway.internal.broker;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.concurrent.atomic.AtomicReference;
import no.hials.crosscom.gateway.Health;
import no.hials.crosscom.gateway.LogLines;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/** A session with a broker that stops answering in the middle. */
@Timeout(30)
class SessionTest {
  private static final byte[] CONNACK = {0x20, 2, 0, 0};
  private static final int SUBSCRIBE = 0x82;

  private final LogLines lines = LogLines.of(Session.class);

  @TempDir private Path folder;
  private ServerSocket broker;
  private Session session;

  @BeforeEach
  void listen() throws IOException {
    broker = new ServerSocket(0, 10, InetAddress.getLoopbackAddress());
  }

  @AfterEach
  void stop() throws IOException {
    session.close();
    broker.close();
    lines.close();
  }

  /**
   * Publishes a message over each connection, and once more if the broker may not have handled it.
   */
  private static final class OneMessage implements Traffic {
    private int qos = 1;
    private boolean kept = true;
    private final List<TopicFilter> subscriptions;
    private final AtomicReference<Session> session = new AtomicReference<>();

    OneMessage(TopicFilter... subscriptions) {
      this.subscriptions = List.of(subscriptions);
    }

    @Override
    public Publication will() {
      return new Publication("will", new byte[0], 1, false);
    }

    @Override
    public List<TopicFilter> subscriptions() {
      return subscriptions;
    }

    @Override
    public void connected() {
      byte[] payload = "text".getBytes(UTF_8);
      session
          .get()
          .publish(
              new Publication("topic", payload, qos, false),
              kept ? () -> new StoredMessage("topic", payload) : null);
    }

    @Override
    public void tick() {}

    @Override
    public boolean forward(StoredMessage message) {
      session.get().publishStored(new Publication("again", new byte[0], qos, false), message);
      return true;
    }

    @Override
    public void forwarded() {}

    @Override
    public void closing() {}
  }

  private void start(Traffic.TopicFilter... subscriptions) {
    start(new OneMessage(subscriptions));
  }

  private void start(OneMessage traffic) {
    BrokerSettings settings =
        new BrokerSettings(
            "127.0.0.1", broker.getLocalPort(), false, 3, null, null, null, null, 100_000);
    session = new Session(settings, "test", folder, new Health(), Duration.ofSeconds(1));
    traffic.session.set(session);
    session.start(traffic);
  }

  /** Waits until the client ends the connection. */
  private static void awaitEnd(Socket connection) throws IOException {
    connection.getInputStream().transferTo(OutputStream.nullOutputStream());
  }

  @Test
  void anAttemptWithoutAnAnswerIsGivenUp() throws IOException {
    start();
    try (Socket first = broker.accept();
        Socket second = broker.accept()) {
      first.getOutputStream().write(CONNACK);

      awaitEnd(first);
      assertThat(second.isConnected()).isTrue();
    }
  }

  @Test
  void itConnectsAgainIfASubscriptionIsNotAnswered() throws IOException {
    start(new Traffic.TopicFilter("set", 1, message -> {}));
    try (Socket first = broker.accept()) {
      first.getOutputStream().write(CONNACK);

      awaitEnd(first);
      broker.accept().close();
    }
  }

  @Test
  void itPublishesWithoutARefusedSubscription() throws IOException {
    start(new Traffic.TopicFilter("set", 1, message -> {}));
    try (Socket connection = broker.accept()) {
      connection.getOutputStream().write(CONNACK);
      InputStream in = connection.getInputStream();
      int next;
      do {
        next = in.read();
        assertThat(next).isNotNegative();
      } while (next != SUBSCRIBE);
      byte[] lengthAndId = in.readNBytes(3);
      connection
          .getOutputStream()
          .write(new byte[] {(byte) 0x90, 3, lengthAndId[1], lengthAndId[2], (byte) 0x80});

      awaitText(connection, "text");
    }
    assertThat(refusedSubscriptions()).hasSize(1);
  }

  private List<String> refusedSubscriptions() {
    return lines.get().stream().filter(it -> it.contains("refuses to subscribe set")).toList();
  }

  @Test
  void aMessageWithQos0IsPublishedAgainIfTheBrokerMayNotHaveHandledIt() throws IOException {
    OneMessage traffic = new OneMessage();
    traffic.qos = 0;
    start(traffic);
    try (Socket first = broker.accept()) {
      first.getOutputStream().write(CONNACK);
      awaitEnd(first);
    }
    try (Socket second = broker.accept()) {
      second.getOutputStream().write(CONNACK);

      awaitText(second, "again");
    }
  }

  /** Waits until a connection has sent a text. */
  private static void awaitText(Socket connection, String wanted) throws IOException {
    StringBuilder text = new StringBuilder();
    while (text.indexOf(wanted) < 0) {
      int next = connection.getInputStream().read();
      assertThat(next).describedAs("end of the connection after " + text).isNotNegative();
      text.append((char) next);
    }
  }

  @Test
  void aMessageWithQos0ThatIsNotStoredIsFollowedByAQuestion() throws IOException {
    OneMessage traffic = new OneMessage();
    traffic.qos = 0;
    traffic.kept = false;
    start(traffic);
    try (Socket connection = broker.accept()) {
      connection.getOutputStream().write(CONNACK);

      awaitText(connection, "jopenshowvar/round-trip");
    }
  }

  @Test
  void itConnectsAgainIfAMessageIsNotConfirmed() throws IOException {
    start();
    try (Socket first = broker.accept()) {
      first.getOutputStream().write(CONNACK);

      awaitEnd(first);
      broker.accept().close();
    }
  }
}
