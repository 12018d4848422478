package no.hials.crosscom.web;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.io.InputStream;
import java.net.InetAddress;
import java.net.Socket;
import java.net.URI;
import java.net.http.HttpResponse;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.Callable;
import javax.net.ssl.SSLContext;
import javax.net.ssl.SSLHandshakeException;
import javax.net.ssl.SSLSocket;
import javax.net.ssl.TrustManager;
import javax.net.ssl.TrustManagerFactory;
import no.hials.crosscom.protocol.ServerType;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestInstance;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** A page with TLS, on another loopback address and under names of its own. */
@TestInstance(TestInstance.Lifecycle.PER_CLASS)
class TlsTest {
  private static final String HOST = "127.0.0.2";
  private static final int SILENCE_MILLIS = 5000;

  private ServerCertificate certificate;
  private TestPages pages;

  @BeforeAll
  void start(@TempDir Path folder) throws IOException {
    PageAddress address = PageAddress.of(List.of(HOST, "cell-pc.example"));
    certificate = OwnCertificate.in(folder.resolve("tls"), address).certificate();
    pages =
        TestPages.start(
            ServerType.C3_BRIDGE, folder, cfg -> cfg.address(address).certificate(certificate));
  }

  @AfterAll
  void stop() throws IOException {
    pages.close();
  }

  @Test
  void theCookieIsSentWithTlsOnly() throws Exception {
    URI link = URI.create(pages.web().link(Role.VIEW));
    assertThat(link.getScheme()).isEqualTo("https");
    assertThat(link.getHost()).isEqualTo(HOST);

    HttpResponse<String> answer = pages.get(link);

    assertThat(answer.headers().firstValue("set-cookie").orElseThrow())
        .startsWith("__Host-")
        .contains("HttpOnly", "Secure", "SameSite=Strict", "Path=/")
        .doesNotContain("Domain");
    // it would hold for other servers of this host, too
    assertThat(answer.headers().map()).doesNotContainKey("strict-transport-security");
  }

  @Test
  void thePageAndItsSocketWork() throws Exception {
    String cookie = pages.login(Role.VIEW);

    assertThat(pages.get(pages.at("/app.js"), "Cookie", cookie).statusCode()).isEqualTo(200);
    try (TestSocket socket = pages.open(cookie)) {
      assertThat(socket.call("browsers").at("/ok/fingerprint").asText())
          .isEqualTo(certificate.fingerprint());
    }
  }

  @Test
  void linksAreForAnyOfItsNames() throws Exception {
    try (TestSocket socket = pages.open(Role.VIEW)) {
      int port = pages.web().port();
      String byName = "https://cell-pc.example:" + port;

      assertThat(socket.call("browsers").at("/ok/addresses").toString())
          .isEqualTo("[\"https://127.0.0.2:" + port + "\",\"" + byName + "\"]");
      assertThat(
              socket
                  .call("let_in", "role", "'VIEW'", "name", "''", "address", "'" + byName + "'")
                  .at("/ok/link")
                  .asText())
          .startsWith(byName + "/?token=");
    }
  }

  @ParameterizedTest
  @ValueSource(strings = {"127.0.0.2", "cell-pc.example", "CELL-PC.example", "localhost", "[::1]"})
  void itsNamesAreAccepted(String host) throws Exception {
    assertThat(raw(host + ":" + pages.web().port(), null)).startsWith("HTTP/1.1 200");
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "evil.example:PORT",
        "127.0.0.2",
        "127.0.0.2:1",
        "127.0.0.3:PORT",
        "cell-pc.example.evil.example:PORT",
        "cell-pc.example@evil.example:PORT"
      })
  void otherNamesAreRefused(String host) throws Exception {
    String answer = raw(host.replace("PORT", "" + pages.web().port()), null);

    assertThat(answer).matches("(?s)HTTP/1.1 40[03].*").doesNotContain("socket-token");
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "http://127.0.0.2:PORT",
        "https://evil.example",
        "https://127.0.0.2",
        "https://cell-pc.example:PORT",
        "null"
      })
  void otherOriginsAreRefused(String origin) throws Exception {
    String other = origin.replace("PORT", "" + pages.web().port());
    String cookie = pages.login(Role.VIEW);

    assertThat(raw("127.0.0.2:" + pages.web().port(), other)).startsWith("HTTP/1.1 403");
    assertThat(
            pages
                .get(
                    pages.at("/socket?page=" + pages.pageToken(cookie)),
                    "Cookie",
                    cookie,
                    "Origin",
                    other)
                .statusCode())
        .isEqualTo(403);
  }

  /** Returns the answer to a request for the page of a browser that is in. */
  private String raw(String host, String origin) throws Exception {
    String cookie = pages.login(Role.VIEW);
    try (Socket socket = client(HOST, "TLSv1.3")) {
      return answer(socket, host, cookie, origin);
    }
  }

  private static String answer(Socket socket, String host, String cookie, String origin)
      throws IOException {
    String request =
        "GET / HTTP/1.1\r\nHost: "
            + host
            + "\r\nCookie: "
            + cookie
            + (origin == null ? "" : "\r\nOrigin: " + origin)
            + "\r\nConnection: close\r\n\r\n";
    socket.getOutputStream().write(request.getBytes(StandardCharsets.US_ASCII));
    return new String(socket.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
  }

  private SSLSocket client(String address, String protocol) throws Exception {
    TrustManagerFactory managers =
        TrustManagerFactory.getInstance(TrustManagerFactory.getDefaultAlgorithm());
    java.security.KeyStore trusted = java.security.KeyStore.getInstance("PKCS12");
    trusted.load(null, null);
    char[] password = {};
    trusted.setCertificateEntry("page", certificate.keyStore(password).getCertificate("page"));
    managers.init(trusted);
    SSLContext context = SSLContext.getInstance("TLS");
    TrustManager[] trust = managers.getTrustManagers();
    context.init(null, trust, null);
    SSLSocket socket =
        (SSLSocket)
            context
                .getSocketFactory()
                .createSocket(InetAddress.getByName(address), pages.web().port());
    socket.setEnabledProtocols(new String[] {protocol});
    return socket;
  }

  @ParameterizedTest
  @ValueSource(strings = {"TLSv1.2", "TLSv1.3"})
  void newProtocolsAreAccepted(String protocol) throws Exception {
    try (SSLSocket socket = client(HOST, protocol)) {
      socket.startHandshake();

      assertThat(socket.getSession().getProtocol()).isEqualTo(protocol);
    }
  }

  /** The hello of a client that knows nothing newer, since this JDK has it switched off. */
  @ParameterizedTest
  @ValueSource(ints = {1, 2})
  void oldProtocolsAreRefused(int minor) throws Exception {
    byte[] hello = new byte[5 + 4 + 2 + 32 + 1 + 6 + 2];
    hello[0] = 22; // a handshake
    hello[1] = 3;
    hello[2] = (byte) minor;
    hello[4] = (byte) (hello.length - 5);
    hello[5] = 1; // a hello
    hello[8] = (byte) (hello.length - 9);
    hello[9] = 3;
    hello[10] = (byte) minor;
    hello[9 + 2 + 32 + 2] = 4; // two suites: TLS_ECDHE_ECDSA_WITH_AES_128_CBC_SHA and _256_
    hello[9 + 2 + 32 + 3] = (byte) 0xc0;
    hello[9 + 2 + 32 + 4] = 0x09;
    hello[9 + 2 + 32 + 5] = (byte) 0xc0;
    hello[9 + 2 + 32 + 6] = 0x0a;
    hello[9 + 2 + 32 + 7] = 1; // one method of compression: none
    byte[] answer = plain(hello);

    assertThat(answer).startsWith(21, 3).hasSize(7); // an alert, which ends the connection
    assertThat(answer[6]).isEqualTo((byte) 70); // the version is not supported
  }

  @Test
  void aRequestWithoutTlsGetsNothing() throws Exception {
    String request = "GET / HTTP/1.1\r\nHost: 127.0.0.2:" + pages.web().port() + "\r\n\r\n";

    byte[] answer = plain(request.getBytes(StandardCharsets.US_ASCII));

    assertThat(new String(answer, StandardCharsets.ISO_8859_1))
        .hasSizeLessThan(10)
        .doesNotContain("HTTP");
  }

  private byte[] plain(byte[] request) throws IOException {
    try (Socket socket = new Socket(HOST, pages.web().port())) {
      socket.getOutputStream().write(request);
      InputStream in = socket.getInputStream();
      return in.readAllBytes();
    }
  }

  @Test
  void aClientThatTrustsNobodyHereIsNotConnected() throws Exception {
    try (SSLSocket socket =
        (SSLSocket)
            SSLContext.getDefault().getSocketFactory().createSocket(HOST, pages.web().port())) {
      assertThatThrownBy(socket::startHandshake).isInstanceOf(SSLHandshakeException.class);
    }
  }

  /** Another program can have the same port there, but does not know the browser. */
  @ParameterizedTest
  @ValueSource(strings = {"127.0.0.2", "127.1.2.3"})
  void thePageIsOnItsAddressOnly(String other, @TempDir Path folder) throws Exception {
    try (TestPages plain = TestPages.start(folder)) {
      assertThat(plain.origin()).startsWith("http://127.0.0.1:");
      int port = plain.web().port();
      String cookie = plain.login(Role.VIEW);

      assertThat(answer(() -> new Socket(InetAddress.getLoopbackAddress(), port), port, cookie))
          .contains(" 200 ");
      assertThat(answer(() -> new Socket(other, port), port, cookie)).doesNotContain(" 200 ");
    }
  }

  private static String answer(Callable<Socket> connected, int port, String cookie)
      throws Exception {
    try (Socket socket = connected.call()) {
      socket.setSoTimeout(SILENCE_MILLIS);
      return answer(socket, "127.0.0.1:" + port, cookie, null);
    } catch (IOException e) {
      return "";
    }
  }

  @ParameterizedTest
  @ValueSource(strings = {"127.0.0.1", "127.0.0.3"})
  void thePageWithTlsIsOnItsAddressOnly(String other) {
    assertThatThrownBy(
            () -> {
              try (SSLSocket socket = client(other, "TLSv1.3")) {
                socket.setSoTimeout(SILENCE_MILLIS);
                socket.startHandshake();
              }
            })
        .isInstanceOf(IOException.class);
  }
}
