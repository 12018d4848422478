package no.hials.crosscom.gateway.internal.opcua;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.ByteArrayOutputStream;
import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import org.eclipse.milo.opcua.sdk.client.OpcUaClient;
import org.eclipse.milo.opcua.sdk.server.Session;
import org.eclipse.milo.opcua.stack.core.types.builtin.NodeId;
import org.eclipse.milo.opcua.stack.core.types.builtin.StatusCode;
import org.eclipse.milo.opcua.stack.core.types.structured.CreateSessionRequest;
import org.eclipse.milo.opcua.stack.core.types.structured.CreateSessionResponse;
import org.junit.jupiter.api.Test;

/** Clients that create sessions and do not log in. */
class LogInsTest extends SocketClientsTest {
  /** Creates a session on the connection of a client, and does not log in. */
  private void createSession(OpcUaClient client) throws Exception {
    CreateSessionRequest request = createSession(client.newRequestHeader());
    assertThat(client.getTransport().sendRequestMessage(request).get())
        .isInstanceOf(CreateSessionResponse.class);
  }

  /** Waits for a number of sessions; the test's timeout is the deadline. */
  private void awaitSessions(OpcUaClient client, int number) throws Exception {
    do {
      assertLoggedIn(client);
    } while (server.sessions() != number);
  }

  @Test
  void sessionsThatAreNotLoggedInKeepNobodyOut() throws Exception {
    OpcUaClient client = OpcUaClient.create(url()).connect();
    for (int i = 0; i < 200; i++) {
      createSession(client);
    }
    client.disconnect();

    OpcUaClient.create(url()).connect().disconnect();
  }

  @Test
  void theOldestSessionThatIsNotLoggedInEndsWhenThereAreTooMany() throws Exception {
    List<OpcUaClient> clients = new ArrayList<>();
    for (int i = 0; i < 60; i++) {
      OpcUaClient client = OpcUaClient.create(url()).connect();
      clients.add(client);
      createSession(client);
    }

    awaitSessions(clients.get(0), 100);
    for (OpcUaClient client : clients) {
      assertLoggedIn(client);
      client.disconnect();
    }
  }

  @Test
  void manySessionsOfOneAddressDoNotEndThatOfAnother() throws Exception {
    Channel slow = open(hello("127.0.0.2"), 600_000);
    NodeId session = createSession(slow);
    for (int i = 0; i < 100; i++) {
      createSession(open(hello("127.0.0.1"), 600_000));
    }

    assertThat(logIn(slow, session)).isEqualTo(StatusCode.GOOD);
  }

  @Test
  void theOldestSessionEndsFirstIfEachHasAnAddressOfItsOwn() throws Exception {
    for (int i = 1; i < 100; i++) {
      createSession(open(hello("127.0.1." + i), 600_000));
      now.incrementAndGet();
    }
    Channel youngest = open(hello("127.0.0.1"), 600_000);
    NodeId session = createSession(youngest);
    for (int i = 1; i < 40; i++) {
      now.incrementAndGet();
      createSession(open(hello("127.0.2." + i), 600_000));
    }

    assertThat(logIn(youngest, session)).isEqualTo(StatusCode.GOOD);
  }

  @Test
  void aFloodOfLogInsOverAConnectionDoesNotTakeManyThreads() throws Exception {
    ThreadMXBean threads = ManagementFactory.getThreadMXBean();
    threads.resetPeakThreadCount();
    int before = threads.getThreadCount();
    List<Channel> channels = new ArrayList<>();
    for (int i = 0; i < 10; i++) {
      channels.add(open(hello("127.0.0.1"), 600_000));
    }
    for (Channel channel : channels) {
      ByteArrayOutputStream flood = new ByteArrayOutputStream();
      for (int number = 2; number < 62; number++) {
        flood.write(bytes(channel.message(number, createSession(header(NodeId.NULL_VALUE)))));
      }
      channel.socket().getOutputStream().write(flood.toByteArray());
    }

    for (Channel channel : channels) {
      for (int number = 2; number < 62; number++) {
        answer(channel.socket());
      }
    }

    assertThat(threads.getPeakThreadCount() - before).isLessThan(550);
    OpcUaClient.create(url()).connect().disconnect();
  }

  @Test
  void sessionsThatHaveEndedTakeNoMemory() throws Exception {
    Channel channel = open(hello("127.0.0.1"), 600_000);
    createSession(channel);
    int before = inMemory(Session.class);

    for (int number = 3; number < 203; number++) {
      channel.send(number, createSession(header(NodeId.NULL_VALUE)));
    }

    assertThat(inMemory(Session.class)).isBetween(1, before + 100);
  }

  @Test
  void aSessionThatCannotBeCreatedIsRefused() throws Exception {
    OpcUaClient client = OpcUaClient.create(url()).connect();

    assertRefused(client, "x".repeat(513), 1000);
    assertRefused(client, "idle", Double.NaN);
    client.disconnect();
  }

  private void assertRefused(OpcUaClient client, String name, double timeout) {
    CreateSessionRequest request = createSession(client.newRequestHeader(), name, timeout);

    assertThatThrownBy(() -> client.getTransport().sendRequestMessage(request).get())
        .hasMessageContaining("Bad_InvalidArgument");
  }

  @Test
  void aSessionThatIsNotLoggedInEndsWithItsConnectionOrAfterSomeTime() throws Exception {
    OpcUaClient leaving = OpcUaClient.create(url()).connect();
    createSession(leaving);
    OpcUaClient staying = OpcUaClient.create(url()).connect();
    createSession(staying);
    awaitSessions(staying, 4);

    leaving.disconnect();
    awaitSessions(staying, 2);

    now.addAndGet(Duration.ofSeconds(31).toNanos());
    awaitSessions(staying, 1);
    staying.disconnect();
  }
}
