package no.hials.crosscom.c3;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;
import static org.assertj.core.api.Assertions.assertThatIOException;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import java.io.InterruptedIOException;
import java.net.DatagramPacket;
import java.net.DatagramSocket;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.function.Consumer;
import no.hials.crosscom.mock.MockServer;
import no.hials.crosscom.protocol.ServerType;
import no.hials.crosscom.protocol.Version;
import org.junit.jupiter.api.Test;

/** Finds simulated controllers over loopback. */
class DiscoveryTest {
  private static final InetAddress LOOPBACK = InetAddress.getLoopbackAddress();

  private static DiscoveryConfig config(Consumer<DiscoveryConfig.Builder> settings) {
    return DiscoveryConfig.create(
        cfg -> {
          cfg.addresses(LOOPBACK).localAddress(LOOPBACK).timeout(Duration.ofMillis(300));
          settings.accept(cfg);
        });
  }

  @Test
  void aKukavarproxyIsFoundInLegacyMode() throws Exception {
    try (MockServer robot = MockServer.start(cfg -> cfg.discoveryPort(0).discoveryReplyPort(0))) {
      List<FoundServer> found =
          Discovery.find(
              config(cfg -> cfg.standard(false).legacyPorts(robot.discoveryPort().getAsInt(), 0)));

      assertThat(found).hasSize(1);
      FoundServer server = found.get(0);
      assertThat(server.address()).isEqualTo(LOOPBACK);
      assertThat(server.type()).isEqualTo(ServerType.KUKAVARPROXY);
      assertThat(server.version()).isNull();
      assertThat(server.port()).isEqualTo(7000);
      assertThat(server.model()).isNotEmpty().doesNotContain("\"");
      assertThat(server.serialNumber()).isNotEmpty();
    }
  }

  @Test
  void aC3BridgeIsFoundOnceInBothModesAndSaysWhatItIs() throws Exception {
    try (MockServer robot =
        MockServer.start(
            cfg ->
                cfg.server(ServerType.C3_BRIDGE)
                    .discoveryPort(0)
                    .discoveryReplyPort(0)
                    .standardDiscoveryPort(0))) {
      DiscoveryConfig config =
          config(
              cfg ->
                  cfg.standardPort(robot.standardDiscoveryPort().getAsInt())
                      .legacyPorts(robot.discoveryPort().getAsInt(), 0));
      List<FoundServer> found = Discovery.find(config);

      assertThat(found)
          .containsExactly(
              new FoundServer(
                  LOOPBACK,
                  robot.port(),
                  found.get(0).model(),
                  found.get(0).serialNumber(),
                  ServerType.C3_BRIDGE,
                  new Version(1, 4, 0)));
      assertThat(found.get(0).model()).isNotEmpty().doesNotContain("\"");
    }
  }

  @Test
  void emptyFieldsAndNonsenseAreTakenAsTheyAre() throws Exception {
    try (DatagramSocket server = new DatagramSocket(new InetSocketAddress(LOOPBACK, 0))) {
      Thread answering =
          new Thread(
              () -> {
                try {
                  DatagramPacket question = new DatagramPacket(new byte[64], 64);
                  server.receive(question);
                  for (String text : List.of("nonsense", "99999", "0", "1.x", "KUKA||")) {
                    byte[] bytes = text.getBytes(StandardCharsets.ISO_8859_1);
                    server.send(
                        new DatagramPacket(bytes, bytes.length, question.getSocketAddress()));
                  }
                } catch (java.io.IOException e) {
                  throw new AssertionError(e);
                }
              });
      answering.start();
      List<FoundServer> found =
          Discovery.find(config(cfg -> cfg.legacy(false).standardPort(server.getLocalPort())));
      answering.join();

      assertThat(found)
          .containsExactly(new FoundServer(LOOPBACK, 7000, "", "", ServerType.KUKAVARPROXY, null));
    }
  }

  @Test
  void aServerThatAnswersEverythingWithWhereItIsIsAskedOnceARoundAndFoundOnce() throws Exception {
    List<String> questions = Collections.synchronizedList(new ArrayList<>());
    DatagramSocket server = new DatagramSocket(new InetSocketAddress(LOOPBACK, 0));
    Thread answering = new Thread(() -> answerAll(server, questions));
    answering.start();
    try {
      List<FoundServer> found =
          Discovery.find(config(cfg -> cfg.legacy(false).standardPort(server.getLocalPort())));

      assertThat(found).hasSize(1);
      assertThat(found.get(0).model()).matches("x{1,1024}");
      assertThat(questions).contains("@PROXY_TYPE").hasSizeLessThanOrEqualTo(8);
    } finally {
      server.close();
      answering.join();
    }
  }

  private static void answerAll(DatagramSocket server, List<String> questions) {
    byte[] answer = ("KUKA|" + "x".repeat(2000)).getBytes(StandardCharsets.US_ASCII);
    DatagramPacket question = new DatagramPacket(new byte[64], 64);
    try {
      while (questions.size() < 1000) {
        server.receive(question);
        questions.add(
            new String(question.getData(), 0, question.getLength(), StandardCharsets.US_ASCII));
        server.send(new DatagramPacket(answer, answer.length, question.getSocketAddress()));
      }
    } catch (java.io.IOException e) {
      assertThat(server.isClosed()).isTrue();
    }
  }

  @Test
  void aServerThatNeverStopsAnsweringDoesNotStretchTheSearch() throws Exception {
    AtomicBoolean over = new AtomicBoolean();
    try (DatagramSocket server = new DatagramSocket(new InetSocketAddress(LOOPBACK, 0))) {
      Thread flooding =
          new Thread(
              () -> {
                try {
                  DatagramPacket question = new DatagramPacket(new byte[64], 64);
                  server.receive(question);
                  byte[] bytes = "KUKA|A|1".getBytes(StandardCharsets.US_ASCII);
                  while (!over.get()) {
                    server.send(
                        new DatagramPacket(bytes, bytes.length, question.getSocketAddress()));
                  }
                } catch (java.io.IOException e) {
                  throw new AssertionError(e);
                }
              });
      flooding.start();
      List<FoundServer> found =
          Discovery.find(config(cfg -> cfg.legacy(false).standardPort(server.getLocalPort())));
      over.set(true);
      flooding.join();

      assertThat(found).extracting(FoundServer::model).containsExactly("A");
    }
  }

  @Test
  void nobodyIsNobody() throws Exception {
    try (DatagramSocket silent = new DatagramSocket(new InetSocketAddress(LOOPBACK, 0))) {
      assertThat(
              Discovery.find(
                  config(
                      cfg ->
                          cfg.legacy(false)
                              .standardPort(silent.getLocalPort())
                              .timeout(Duration.ofMillis(20)))))
          .isEmpty();
    }
  }

  @Test
  void aReplyPortThatIsTakenIsSaid() throws Exception {
    try (DatagramSocket taken = new DatagramSocket(new InetSocketAddress(LOOPBACK, 0))) {
      DiscoveryConfig config = config(cfg -> cfg.legacyPorts(6999, taken.getLocalPort()));
      assertThatIOException()
          .isThrownBy(() -> Discovery.find(config))
          .withMessageContaining("cannot listen on UDP port " + taken.getLocalPort())
          .withMessageContaining("legacy mode, which may be left out");
    }
  }

  @Test
  void anInterruptedSearchEndsAndKeepsTheFlag() throws Exception {
    try (DatagramSocket silent = new DatagramSocket(new InetSocketAddress(LOOPBACK, 0))) {
      DiscoveryConfig config =
          config(
              cfg ->
                  cfg.legacy(false)
                      .standardPort(silent.getLocalPort())
                      .timeout(Duration.ofMinutes(1)));
      Thread.currentThread().interrupt();
      try {
        assertThatExceptionOfType(InterruptedIOException.class)
            .isThrownBy(() -> Discovery.find(config));
      } finally {
        assertThat(Thread.interrupted()).isTrue();
      }
    }
  }

  @Test
  void nobodyIsAskedUnlessNamed() {
    assertThatIllegalArgumentException()
        .isThrownBy(() -> DiscoveryConfig.create(cfg -> {}))
        .withMessageContaining("at least one address");
    assertThatIllegalArgumentException()
        .isThrownBy(() -> config(cfg -> cfg.legacy(false).standard(false)));
    assertThatIllegalArgumentException().isThrownBy(() -> config(cfg -> cfg.standardPort(0)));
    assertThatIllegalArgumentException()
        .isThrownBy(() -> config(cfg -> cfg.timeout(Duration.ZERO)));
  }
}
