package no.hials.crosscom.gateway.internal.opcua;

import static org.assertj.core.api.Assertions.assertThat;

import java.net.Socket;
import java.time.Duration;
import org.eclipse.milo.opcua.sdk.client.OpcUaClient;
import org.junit.jupiter.api.Test;

/** Clients that connect and do not log in. */
class ConnectionsTest extends SocketClientsTest {
  @Test
  void aConnectionWithoutASessionIsClosedAndOneWithASessionIsNot() throws Exception {
    OpcUaClient client = OpcUaClient.create(url()).connect();
    Socket hello = hello("127.0.0.1");
    Socket channel = hello("127.0.0.1");
    open(channel, 600_000);
    now.addAndGet(Duration.ofSeconds(30).toNanos());
    Socket later = hello("127.0.0.1");

    now.addAndGet(Duration.ofSeconds(1).toNanos());

    assertThat(isClosed(hello)).isTrue();
    assertThat(isClosed(channel)).isTrue();
    assertThat(open(later, 600_000).lifetime()).isEqualTo(600_000);
    assertLoggedIn(client);

    client.disconnect();
    now.addAndGet(Duration.ofSeconds(30).toNanos());

    assertThat(isClosed(later)).isTrue();
  }

  @Test
  void connectionsAreLimited() throws Exception {
    for (int i = 0; i < 100; i++) {
      hello("127.0.0.1");
    }
    assertThat(isClosed(connect("127.0.0.1"))).isTrue();
    for (int i = 0; i < 50; i++) {
      hello("127.0.0.2");
    }
    assertThat(isClosed(connect("127.0.0.2"))).isTrue();

    // all of them, so that new ones find a place
    now.addAndGet(Duration.ofSeconds(31).toNanos());
    for (Socket socket : sockets) {
      assertThat(isClosed(socket)).isTrue();
    }
    hello("127.0.0.1");
    hello("127.0.0.2");
  }

  @Test
  void aSecureChannelMustBeRenewedAfterAnHour() throws Exception {
    assertThat(open(hello("127.0.0.1"), Integer.MAX_VALUE).lifetime()).isEqualTo(3_600_000);
  }
}
