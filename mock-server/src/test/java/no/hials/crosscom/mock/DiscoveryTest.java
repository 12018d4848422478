package no.hials.crosscom.mock;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.net.DatagramPacket;
import java.net.DatagramSocket;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.charset.StandardCharsets;
import java.util.List;
import no.hials.crosscom.protocol.ServerType;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** Tests discovery by UDP. */
class DiscoveryTest {
  private static final String QUESTION = "WHEREAREYOU?";
  private static final String ANSWER = "KUKA|#KR6R900 C4SR FLR 230|736512";

  /** Fails a test that would otherwise hang. */
  private static final int GIVE_UP_MILLIS = 20_000;

  private DatagramSocket asking;

  @BeforeEach
  void open() throws IOException {
    asking = socket();
  }

  @AfterEach
  void close() {
    asking.close();
  }

  private static DatagramSocket socket() throws IOException {
    DatagramSocket socket =
        new DatagramSocket(new InetSocketAddress(InetAddress.getLoopbackAddress(), 0));
    socket.setSoTimeout(GIVE_UP_MILLIS);
    return socket;
  }

  private void ask(MockServer server, String question) throws IOException {
    ask(server.discoveryPort().orElseThrow(), question);
  }

  private void ask(int port, String question) throws IOException {
    byte[] bytes = question.getBytes(StandardCharsets.ISO_8859_1);
    asking.send(new DatagramPacket(bytes, bytes.length, InetAddress.getLoopbackAddress(), port));
  }

  private static String receive(DatagramSocket socket) throws IOException {
    DatagramPacket packet = new DatagramPacket(new byte[1000], 1000);
    socket.receive(packet);
    return new String(packet.getData(), 0, packet.getLength(), StandardCharsets.ISO_8859_1);
  }

  private static MockServer answeringTo(int port) throws IOException {
    return MockServer.start(cfg -> cfg.discoveryPort(0).discoveryReplyPort(port));
  }

  @Test
  void isOffUnlessToldOtherwise() throws IOException {
    try (MockServer server = MockServer.start()) {
      assertThat(server.discoveryPort()).isEmpty();
    }
  }

  /** The form of docs/reference/wire-format.md#discovery. */
  @Test
  void answersModelAndSerialNumberToTheGivenPortOfTheSender() throws IOException {
    try (DatagramSocket answered = socket();
        MockServer server = answeringTo(answered.getLocalPort())) {
      ask(server, QUESTION);
      assertThat(receive(answered)).isEqualTo(ANSWER);
    }
  }

  @Test
  void canAnswerToThePortThatTheQuestionCameFrom() throws IOException {
    try (MockServer server = answeringTo(0)) {
      ask(server, QUESTION);
      assertThat(receive(asking)).isEqualTo(ANSWER);
    }
  }

  @Test
  void answersWithTheVariablesAsTheyAreNow() throws IOException {
    try (MockServer server = answeringTo(0)) {
      server.variables().set("$MODEL_NAME[]", "\"#KR16\"");
      server.variables().remove("$KR_SERIALNO");
      ask(server, QUESTION);
      assertThat(receive(asking)).isEqualTo("KUKA|#KR16|");
    }
  }

  @Test
  void doesNotAnswerToAnythingElse() throws IOException {
    try (MockServer server = answeringTo(0)) {
      for (String garbage :
          List.of("", "whereareyou?", "WHEREAREYOU", QUESTION + "\0", QUESTION.repeat(100))) {
        ask(server, garbage);
      }
      server.variables().set("$MODEL_NAME[]", "\"ASKED\"");
      ask(server, QUESTION);
      // the first answer belongs to the last datagram
      assertThat(receive(asking)).startsWith("KUKA|ASKED|");
    }
  }

  @Test
  void leavesOutADiscoveryWhosePortIsInUseIfToldTo() throws IOException {
    int taken = asking.getLocalPort();
    try (MockServer server =
        MockServer.start(
            cfg ->
                cfg.server(ServerType.C3_BRIDGE)
                    .discoveryPortIfFree(taken)
                    .standardDiscoveryPortIfFree(0))) {
      assertThat(server.discoveryPort()).isEmpty();
      assertThat(server.standardDiscoveryPort()).isPresent();
    }
  }

  @Test
  void saysWhichPortItCannotListenOnAndClosesTheOtherAgain() throws IOException {
    int taken = asking.getLocalPort();
    int free;
    try (MockServer server = MockServer.start()) {
      free = server.port();
    }
    assertThatThrownBy(() -> MockServer.start(cfg -> cfg.port(free).discoveryPort(taken)))
        .isInstanceOf(IOException.class)
        .hasMessageContaining("cannot listen on UDP")
        .hasMessageContaining(String.valueOf(taken));
    try (MockServer server = MockServer.start(cfg -> cfg.port(free))) {
      assertThat(server.port()).isEqualTo(free);
    }
  }

  @Test
  void isOffInStandardModeUnlessToldOtherwise() throws IOException {
    try (MockServer server = MockServer.start(cfg -> cfg.server(ServerType.C3_BRIDGE))) {
      assertThat(server.standardDiscoveryPort()).isEmpty();
    }
  }

  @Test
  void answersInStandardModeToThePortThatTheQuestionCameFrom() throws IOException {
    try (MockServer server = c3()) {
      server.variables().remove("$KR_SERIALNO");
      ask(server.standardDiscoveryPort().orElseThrow(), QUESTION);
      assertThat(receive(asking)).isEqualTo("KUKA|\"#KR6R900 C4SR FLR 230\"|");
      ask(server.standardDiscoveryPort().orElseThrow(), "@PROXY_PORT");
      assertThat(receive(asking)).isEqualTo(String.valueOf(server.port()));
    }
  }

  @Test
  void tellsAsC3BridgeNothingButWhatItSaysOfItself() throws IOException {
    try (MockServer server = c3()) {
      int port = server.standardDiscoveryPort().orElseThrow();
      for (String garbage : List.of("", "PING", "$OV_PRO", "@PROXY_", QUESTION + "\r\n")) {
        ask(port, garbage);
      }
      ask(port, "@PROXY_ENABLED\0" + "x".repeat(40));
      // the first answer belongs to the last datagram
      assertThat(receive(asking)).isEqualTo("TRUE");
    }
  }

  @Test
  void closesAllThatWasOpenIfTheStandardModeCannotListen() throws IOException {
    int taken = asking.getLocalPort();
    int free;
    int freeUdp;
    try (MockServer server = c3()) {
      free = server.port();
      freeUdp = server.discoveryPort().orElseThrow();
    }
    assertThatThrownBy(
            () ->
                MockServer.start(
                    cfg ->
                        cfg.server(ServerType.C3_BRIDGE)
                            .port(free)
                            .discoveryPort(freeUdp)
                            .standardDiscoveryPort(taken)))
        .hasMessageContaining("cannot listen on UDP");
    try (MockServer server = MockServer.start(cfg -> cfg.port(free).discoveryPort(freeUdp))) {
      assertThat(server.port()).isEqualTo(free);
    }
  }

  private static MockServer c3() throws IOException {
    return MockServer.start(
        cfg ->
            cfg.server(ServerType.C3_BRIDGE)
                .discoveryPort(0)
                .discoveryReplyPort(0)
                .standardDiscoveryPort(0));
  }
}
