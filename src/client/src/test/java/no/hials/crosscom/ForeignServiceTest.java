package no.hials.crosscom;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;

import com.sun.net.httpserver.HttpServer;
import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.HexFormat;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import no.hials.crosscom.mock.Fault;
import no.hials.crosscom.protocol.Tail;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Names the protocol of a server that is neither KUKAVARPROXY nor C3 Bridge. */
class ForeignServiceTest extends RobotTest {
  /** The request to read it contains CR LF, for which an HTTP server waits: its length, 3338. */
  private static final String NAME_WITH_LINE_END = "A".repeat(3335);

  private final ExecutorService threads = Executors.newCachedThreadPool();

  @AfterEach
  void stop() {
    threads.shutdownNow();
  }

  private static CrossComClient connect(InetSocketAddress address) throws IOException {
    return new CrossComClient(
        ClientConfig.create(
            address.getHostString(),
            cfg ->
                cfg.port(address.getPort())
                    .reconnect(false)
                    .keepAlive(Duration.ZERO)
                    .maxRequestLength(4096)
                    .requestTimeout(Duration.ofSeconds(30))));
  }

  @Test
  void aWebServerIsNamed() throws Exception {
    HttpServer web =
        HttpServer.create(new InetSocketAddress(InetAddress.getLoopbackAddress(), 0), 0);
    web.start();
    try (CrossComClient lost = connect(web.getAddress())) {
      assertThatExceptionOfType(CrossComProtocolException.class)
          .isThrownBy(() -> lost.readText(NAME_WITH_LINE_END))
          .withMessage(
              "127.0.0.1:%d answered with HTTP (HTTP/1.1 400 Bad Request), not KUKAVARPROXY or C3"
                  + " Bridge",
              web.getAddress().getPort());
      assertThat(lost.isClosed()).isTrue();
    } finally {
      web.stop(0);
    }
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "SSH-2.0-OpenSSH_9.6              | SSH (SSH-2.0-OpenSSH_9.6)",
        "<!DOCTYPE HTML>                  | HTTP (<!DOCTYPE HTML>)",
        "220 ftp.example ready            | a text (220 ftp.example ready)"
      })
  void aTextIsNamedBeforeARequestOrAfterIt(String banner, String service) throws Exception {
    byte[] bytes = (banner + "\r\n").getBytes(StandardCharsets.US_ASCII);
    for (boolean atOnce : new boolean[] {true, false}) {
      assertThat(failure(bytes, atOnce)).contains(" answered with " + service + ", not KUKA");
    }
  }

  @ParameterizedTest
  @ValueSource(strings = {"15 03 01 00 02 02 46", "15 03 03 00 02 02 0A"})
  void anAlertOfTlsIsNamed(String alert) throws Exception {
    byte[] bytes = HexFormat.ofDelimiter(" ").parseHex(alert);

    assertThat(failure(bytes, false)).contains(" answered with TLS, not KUKAVARPROXY or C3 Bridge");
  }

  /** Returns the message of a read from a server that sends these bytes and closes. */
  private String failure(byte[] bytes, boolean atOnce) throws Exception {
    try (ServerSocket server = new ServerSocket(0, 1, InetAddress.getLoopbackAddress())) {
      CompletableFuture<Void> sent = new CompletableFuture<>();
      threads.execute(() -> serve(server, bytes, atOnce, sent));
      try (CrossComClient lost = connect((InetSocketAddress) server.getLocalSocketAddress())) {
        if (atOnce) {
          sent.get();
        }
        return assertThatExceptionOfType(CrossComProtocolException.class)
            .isThrownBy(() -> lost.readText("$OV_PRO"))
            .actual()
            .getMessage();
      }
    }
  }

  private static void serve(
      ServerSocket server, byte[] bytes, boolean atOnce, CompletableFuture<Void> sent) {
    try (Socket socket = server.accept()) {
      if (!atOnce) {
        socket.getInputStream().readNBytes(14);
      }
      socket.getOutputStream().write(bytes);
      socket.shutdownOutput();
      sent.complete(null);
      socket.getInputStream().readAllBytes();
    } catch (IOException e) {
      sent.completeExceptionally(e);
    }
  }

  @Test
  void aShortTextBeforeARequestIsShownAsText() throws Exception {
    assertThat(failure("+PONG\r\n".getBytes(StandardCharsets.US_ASCII), true))
        .isEqualTo("the server sent bytes without a request: \"+PONG\\x0D\\x0A\"");
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {"FF FB 01 | FF FB 01", "48 45 4C 31 | \"HEL1\"", "48 45 4C 4C 4F | \"HELLO\""})
  void bytesThatAreNoAnswerAreShownAfterATimeOut(String sent, String shown) throws Exception {
    robot.enqueue(Fault.raw(sent));

    try (CrossComClient hasty = client(Duration.ofSeconds(1))) {
      assertThatExceptionOfType(CrossComTimeoutException.class)
          .isThrownBy(() -> hasty.readText("$OV_PRO"))
          .withMessageContaining(" within 1000 ms, only the bytes " + shown + "; the connection");
    }
  }

  @Test
  void aValueThatLooksLikeAnotherProtocolIsAValue() throws Exception {
    robot.enqueue(Fault.answer("HTTP/1.1 400", Tail.SUCCESS));

    assertThat(client.readText("MYSTRING[]")).isEqualTo("HTTP/1.1 400");
  }

  @Test
  void aBrokenFrameIsShownByItsFirst32Bytes() {
    robot.enqueue(Fault.raw("FF FF 00 30" + " 00".repeat(48)));

    assertThatExceptionOfType(CrossComProtocolException.class)
        .isThrownBy(() -> client.readText("$OV_PRO"))
        .withMessageEndingWith("frame: FF FF 00 30" + " 00".repeat(28) + " ... (52 bytes)");
  }
}
