package no.hials.crosscom.web;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.net.InetAddress;
import java.net.Socket;
import java.net.URI;
import java.net.http.HttpResponse;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.security.MessageDigest;
import java.util.ArrayList;
import java.util.Base64;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class AccessTest {
  private static final Pattern IMPORT_MAP =
      Pattern.compile("<script type=\"importmap\">(.*?)</script>", Pattern.DOTALL);

  @TempDir private Path folder;
  private TestPages pages;

  @BeforeEach
  void start() throws IOException {
    pages = TestPages.start(folder);
  }

  @AfterEach
  void stop() throws IOException {
    pages.close();
  }

  @Test
  void aLinkIsExchangedForACookieThatScriptsAndOtherSitesDoNotGet() throws Exception {
    HttpResponse<String> answer = pages.get(URI.create(pages.web().link(Role.VIEW)));

    assertThat(answer.statusCode()).isEqualTo(200);
    assertThat(answer.body())
        .contains("content=\"0; url=/\"")
        .contains("<link rel=\"icon\" href=\"/icon.svg\""); // or browsers ask for /favicon.ico
    assertThat(answer.headers().firstValue("set-cookie").orElseThrow())
        .contains("HttpOnly", "SameSite=Strict", "Path=/");
  }

  @Test
  void aBrowserWithManyPagesDoesNotShutOutOthers() throws Exception {
    String cookie = pages.login(Role.VIEW);
    List<TestSocket> open = new ArrayList<>();
    try {
      for (int i = 0; i < 65; i++) {
        open.add(pages.open(cookie));
      }

      assertThat(open.get(64).closeReason()).isEqualTo("this browser has 64 pages open already");
      assertThat(open.get(63).call("ping").has("ok")).isTrue();
      try (TestSocket other = pages.open(Role.VIEW)) {
        assertThat(other.call("ping").has("ok")).isTrue();
      }
    } finally {
      open.forEach(TestSocket::close);
    }
  }

  @Test
  void aLinkWorksOnce() throws Exception {
    URI link = URI.create(pages.web().link(Role.VIEW));
    pages.get(link);

    HttpResponse<String> replay = pages.get(link);

    assertThat(replay.statusCode()).isEqualTo(403);
    assertThat(replay.headers().firstValue("set-cookie")).isEmpty();
    assertThat(replay.body()).contains("This browser has no session.");
    assertThat(pages.get(link, "Cookie", pages.login(Role.VIEW)).body())
        .startsWith(
            "This link is not valid, is too old, or was used before. This browser is already")
        .contains("let in");
  }

  @ParameterizedTest
  @ValueSource(strings = {"/", "/app.js", "/lib/preact.js", "/socket", "/?token=wrong"})
  void nothingIsServedWithoutASession(String path) throws Exception {
    assertThat(pages.get(pages.at(path)).statusCode()).isEqualTo(403);
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "/app.js",
        "/style/base.css",
        "/lib/preact.js",
        "/lib/uplot.css",
        "/lib/three.module.min.js",
        "/lib/three.core.min.js",
        "/lib/orbit-controls.js"
      })
  void filesAreServedToASession(String path) throws Exception {
    HttpResponse<String> answer = pages.get(pages.at(path), "Cookie", pages.login(Role.VIEW));

    assertThat(answer.statusCode()).isEqualTo(200);
    assertThat(answer.body()).isNotEmpty();
    assertThat(answer.headers().firstValue("x-content-type-options")).hasValue("nosniff");
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "/index.html",
        "/style/",
        "/../WebServer.class",
        "/%2e%2e/WebServer.class",
        "/style/%2e%2e/index.html",
        "/META-INF/MANIFEST.MF",
        "/lib/three.js"
      })
  void nothingElseOfTheClassPathIsServed(String path) throws Exception {
    assertThat(pages.get(pages.at(path), "Cookie", pages.login(Role.VIEW)).statusCode())
        .isIn(400, 404);
  }

  @Test
  void aRequestThatJettyRefusesGetsNoDetail() throws Exception {
    HttpResponse<String> answer = pages.get(pages.at("/%00"), "Cookie", pages.login(Role.VIEW));

    assertThat(answer.statusCode()).isEqualTo(400);
    assertThat(answer.body()).isEqualTo("The request cannot be answered.\n");
    assertThat(answer.headers().firstValue("content-security-policy"))
        .hasValue("default-src 'none'");
  }

  @Test
  void aKnownFileIsNotSentAgain() throws Exception {
    String cookie = pages.login(Role.VIEW);
    String tag =
        pages.get(pages.at("/app.js"), "Cookie", cookie).headers().firstValue("etag").orElseThrow();

    assertThat(pages.get(pages.at("/app.js"), "Cookie", cookie, "If-None-Match", tag).statusCode())
        .isEqualTo(304);
  }

  @Test
  void theOnlyScriptWithinThePageIsTheImportMapWhoseHashIsAllowed() throws Exception {
    HttpResponse<String> page = pages.get(pages.at("/"), "Cookie", pages.login(Role.VIEW));
    Matcher map = IMPORT_MAP.matcher(page.body());
    assertThat(map.find()).isTrue();
    byte[] hash =
        MessageDigest.getInstance("SHA-256").digest(map.group(1).getBytes(StandardCharsets.UTF_8));

    assertThat(page.headers().firstValue("content-security-policy").orElseThrow())
        .contains("default-src 'none'")
        .contains("script-src 'self' 'sha256-" + Base64.getEncoder().encodeToString(hash) + "';")
        .doesNotContain("unsafe");
    assertThat(page.headers().firstValue("cache-control")).hasValue("no-store");
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "evil.example",
        "evil.example:PORT",
        "127.0.0.1:1",
        "127.0.0.1.evil.example:PORT",
        ""
      })
  void aNameOfAnotherHostIsRefused(String host) throws Exception {
    assertThat(rawStatus(host.replace("PORT", "" + pages.web().port()), pages.login(Role.VIEW)))
        .isIn(400, 403);
  }

  @Test
  void theNamesOfTheLoopbackAddressAreAccepted() throws Exception {
    String cookie = pages.login(Role.VIEW);

    assertThat(rawStatus("localhost:" + pages.web().port(), cookie)).isEqualTo(200);
    assertThat(rawStatus("127.0.0.1:" + pages.web().port(), cookie)).isEqualTo(200);
  }

  /** Sends a request with any host, which no HTTP client does. */
  private int rawStatus(String host, String cookie) throws IOException {
    try (Socket socket = new Socket(InetAddress.getLoopbackAddress(), pages.web().port())) {
      String request =
          "GET / HTTP/1.1\r\nHost: "
              + host
              + "\r\nCookie: "
              + cookie
              + "\r\nConnection: close\r\n\r\n";
      socket.getOutputStream().write(request.getBytes(StandardCharsets.US_ASCII));
      String answer = new String(socket.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
      return Integer.parseInt(answer.split(" ", 3)[1]);
    }
  }

  @Test
  void aRequestOfAnotherSiteIsRefused() throws Exception {
    String cookie = pages.login(Role.VIEW);

    assertThat(
            pages
                .get(pages.at("/"), "Cookie", cookie, "Origin", "http://evil.example")
                .statusCode())
        .isEqualTo(403);
    assertThat(pages.get(pages.at("/"), "Cookie", cookie, "Origin", pages.origin()).headers().map())
        .doesNotContainKey("access-control-allow-origin");
  }

  @ParameterizedTest
  @ValueSource(strings = {"http://evil.example", "null", "", "http://127.0.0.1:1"})
  void aSocketOfAnotherSiteIsRefused(String origin) throws Exception {
    String cookie = pages.login(Role.JOG);
    String page = pages.pageToken(cookie);

    assertThatThrownBy(() -> TestSocket.open(pages.web().port(), cookie, page, origin))
        .isInstanceOf(IOException.class)
        .hasRootCauseMessage("Unexpected HTTP response status code 403");
  }

  @Test
  void aSocketNeedsTheTokenOfAPageOfItsOwnBrowser() throws Exception {
    String cookie = pages.login(Role.JOG);
    String ofAnother = pages.pageToken(pages.login(Role.JOG));

    assertThatThrownBy(() -> TestSocket.open(pages.web().port(), cookie, ofAnother, pages.origin()))
        .isInstanceOf(IOException.class);
    TestSocket.open(pages.web().port(), cookie, pages.pageToken(cookie), pages.origin()).close();
  }
}
