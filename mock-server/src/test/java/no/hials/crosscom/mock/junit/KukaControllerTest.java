package no.hials.crosscom.mock.junit;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.lang.annotation.Retention;
import java.lang.annotation.RetentionPolicy;
import java.time.Duration;
import java.util.HashSet;
import java.util.Set;
import no.hials.crosscom.mock.Fault;
import no.hials.crosscom.mock.Latency;
import no.hials.crosscom.mock.MockServer;
import no.hials.crosscom.mock.PendingRequests;
import no.hials.crosscom.mock.RawClient;
import no.hials.crosscom.mock.RecordedRequest;
import no.hials.crosscom.protocol.ServerType;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Nested;
import org.junit.jupiter.api.RepeatedTest;
import org.junit.jupiter.api.Test;

/** Tests the extension as a user sees it. */
class KukaControllerTest {
  private static final Set<MockServer> SEEN = new HashSet<>();

  @KukaController private static MockServer ofClass;

  private static MockServer ofBeforeAll;
  private static MockServer firstOfClass;

  @KukaController private MockServer ofTest;

  private MockServer ofBeforeEach;

  /** A named set of attributes. */
  @KukaController(latency = "5ms", maxClients = 3)
  @Retention(RetentionPolicy.RUNTIME)
  private @interface SlowController {}

  @BeforeAll
  static void keepThatOfTheClass(@KukaController MockServer server) {
    ofBeforeAll = server;
    firstOfClass = ofClass;
  }

  @BeforeEach
  void keepThatOfTheTest(@KukaController MockServer server) {
    ofBeforeEach = server;
  }

  private static void assertAnswers(MockServer server) throws IOException {
    try (RawClient client = new RawClient(server)) {
      assertThat(client.read("PING").value()).isEqualTo("PONG");
    }
  }

  @RepeatedTest(2)
  void givesEachTestAServerOfItsOwn(@KukaController MockServer parameter) throws IOException {
    for (MockServer server : Set.of(ofTest, ofBeforeEach, parameter)) {
      assertAnswers(server);
      assertThat(SEEN.add(server)).isTrue();
    }
  }

  @RepeatedTest(2)
  void givesAllTestsTheServersOfTheClass() throws IOException {
    assertThat(ofClass).isSameAs(firstOfClass).isNotSameAs(ofBeforeAll);
    assertAnswers(ofClass);
    assertAnswers(ofBeforeAll);
  }

  @Test
  void startsWithTheDefaultsUnlessToldOtherwise(@KukaController MockServer server)
      throws IOException {
    try (MockServer plain = MockServer.start()) {
      assertThat(server.config()).usingRecursiveComparison().isEqualTo(plain.config());
    }
  }

  @Test
  void takesLatencyAndNumberOfClients(
      @KukaController(latency = "krc4", seed = 7, maxClients = 2) MockServer server) {
    assertThat(server.config().latency()).isEqualTo(Latency.krc4(7));
    assertThat(server.config().maxClients()).isEqualTo(2);
  }

  @Test
  void takesFaults(@KukaController(faults = {"wrongId@2", "wrongId:2"}) MockServer server)
      throws IOException {
    try (RawClient client = new RawClient(server)) {
      assertThat(client.read("PING").id()).isEqualTo(9);
      assertThat(client.read("PING").id()).isEqualTo(8);
      assertThat(client.read("PING").id()).isEqualTo(9);
    }
  }

  @Test
  void canBeAsTheController(
      @KukaController(asOnTheController = true, seed = 7) MockServer strict,
      @KukaController(asOnTheController = true, latency = "none", maxClients = 0)
          MockServer strictAndQuick) {
    assertThat(strict.config().pendingRequests()).isEqualTo(PendingRequests.DROP_OF_SAME_CLIENT);
    assertThat(strict.config().latency()).isEqualTo(Latency.krc4(7));
    assertThat(strictAndQuick.config().joinSplitRequests()).isFalse();
    assertThat(strictAndQuick.config().latency()).isEqualTo(Latency.none());
    assertThat(strictAndQuick.config().maxClients()).isZero();
  }

  @Test
  void canBeC3Bridge(@KukaController(server = ServerType.C3_BRIDGE) MockServer server)
      throws IOException {
    assertThat(server.config().server()).isEqualTo(ServerType.C3_BRIDGE);
    assertThat(server.config().maxClients()).isZero();
    try (RawClient client = new RawClient(server)) {
      assertThat(client.read("@PROXY_TYPE").value()).isEqualTo("C3 BRIDGE INTERFACE");
    }
  }

  @Test
  void canBePutOnAnAnnotationOfYourOwn(@SlowController MockServer server) {
    assertThat(server.config().latency()).isEqualTo(Latency.fixed(Duration.ofMillis(5)));
    assertThat(server.config().maxClients()).isEqualTo(3);
  }

  @Test
  void leavesTheServerToTheTest() throws IOException {
    ofTest.variables().set("MYINT", "5");
    ofTest.enqueue(Fault.closeBefore());
    try (RawClient client = new RawClient(ofTest)) {
      assertThatThrownBy(() -> client.read("MYINT")).isInstanceOf(IOException.class);
    }
    assertThat(ofTest.requests()).extracting(RecordedRequest::name).containsExactly("MYINT");
  }

  @Nested
  class InANestedClass {
    @KukaController private MockServer inner;

    @RepeatedTest(2)
    void hasTheServersAroundIt() throws IOException {
      assertThat(ofClass).isSameAs(firstOfClass);
      assertAnswers(ofClass);
      for (MockServer server : Set.of(inner, ofTest, ofBeforeEach)) {
        assertAnswers(server);
        assertThat(SEEN.add(server)).isTrue();
      }
    }
  }
}
