package no.hials.crosscom.web.browser;

import static java.nio.charset.StandardCharsets.US_ASCII;
import static org.assertj.core.api.Assertions.assertThat;

import com.google.zxing.BinaryBitmap;
import com.google.zxing.LuminanceSource;
import com.google.zxing.RGBLuminanceSource;
import com.google.zxing.ReaderException;
import com.google.zxing.common.HybridBinarizer;
import com.google.zxing.qrcode.QRCodeReader;
import com.sun.net.httpserver.HttpServer;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.URI;
import java.nio.file.Path;
import java.util.Base64;
import java.util.List;
import no.hials.crosscom.protocol.ServerType;
import no.hials.crosscom.web.OwnCertificate;
import no.hials.crosscom.web.PageAddress;
import no.hials.crosscom.web.Role;
import no.hials.crosscom.web.ServerCertificate;
import no.hials.crosscom.web.TestPages;
import no.hials.crosscom.web.TestSocket;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.ExtendWith;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.openqa.selenium.Keys;

/** Who gets in, hostile values, a lost server, and the page without a mouse. */
@ExtendWith(WithBrowser.class)
class AccessBrowserIT {
  private static final String LIVE =
      "document.querySelector('.top:not(.stale)') && document.querySelector('main > *')";

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
  void aLinkWorksInOneBrowserAndOnce(Browser browser) {
    URI link = URI.create(pages.web().link(Role.VIEW));
    browser.open(link);
    browser.await(LIVE);
    browser.forgetCookies();

    browser.open(link);

    assertThat(browser.text("body"))
        .startsWith("This link is not valid, is too old, or was used before.");
  }

  @Test
  void aBrowserThatMayOnlyViewIsNotAskedToUnlock(Browser browser) {
    browser.open(URI.create(pages.web().link(Role.VIEW)));
    browser.open(pages.at("/?view=io#/io"));
    browser.await("document.querySelector('main')?.textContent.includes('may only view')");

    assertThat(browser.text("main")).doesNotContain("Unlock");
  }

  /** Here a viewer reads why nothing is live, without pointing at anything. */
  @Test
  void thePageShowsWhyTheRobotIsLost(Browser browser) {
    browser.open(URI.create(pages.web().link(Role.VIEW)));
    browser.await(LIVE);

    pages.controller().refuseConnections();
    pages.controller().disconnectClients();

    browser.await("document.querySelector('.banner')");
    assertThat(browser.text(".banner")).startsWith("No connection to mock: ");
    assertThat(browser.barriers()).isEmpty();
  }

  @ParameterizedTest
  @ValueSource(strings = {"<script>hacked=1</script>", "<img src=x onerror=hacked=1>"})
  void aValueThatIsMarkupIsShownAsText(String markup, Browser browser) {
    pages.controller().variables().set("MYSTRING[]", '"' + markup + '"');
    browser.open(URI.create(pages.web().link(Role.VIEW)));
    browser.await(LIVE);

    browser.find("input[type=search]").sendKeys("MYSTRING[]", Keys.ENTER);
    browser.await("document.querySelector('main').textContent.includes('hacked=1')");

    assertThat(browser.text("main")).contains(markup);
    assertThat(browser.run("return window.hacked")).isNull();
    assertThat(browser.run("return document.querySelectorAll('main script, main img').length"))
        .isEqualTo(0L);
    assertThat(browser.errors()).isEmpty();
  }

  @Test
  void thePolicyStopsAScriptThatIsPutIntoThePage(Browser browser) {
    browser.open(URI.create(pages.web().link(Role.VIEW)));
    browser.await(LIVE);

    browser.run("document.body.insertAdjacentHTML('beforeend', '<img src=x onerror=hacked=1>')");
    browser.run(
        "document.body.append(Object.assign(document.createElement('script'),"
            + " { textContent: 'window.hacked = 1' }))");

    assertThat(browser.run("return window.hacked")).isNull();
    assertThat(browser.errors()).anyMatch(it -> it.contains("Content Security Policy"));
  }

  @Test
  void aPageOfAnotherSiteGetsNothingAlthoughTheBrowserSendsItsCookie(Browser browser)
      throws IOException {
    browser.open(URI.create(pages.web().link(Role.JOG)));
    browser.await(LIVE);
    Object token = browser.run("return document.querySelector('meta[name=socket-token]').content");
    HttpServer other =
        HttpServer.create(new InetSocketAddress(InetAddress.getLoopbackAddress(), 0), 0);
    other.createContext(
        "/",
        exchange -> {
          byte[] page = "<title>another site</title>".getBytes(US_ASCII);
          exchange.sendResponseHeaders(200, page.length);
          exchange.getResponseBody().write(page);
          exchange.close();
        });
    other.start();
    try {
      browser.open(URI.create("http://127.0.0.1:" + other.getAddress().getPort() + "/"));
      browser.run(
          """
          window.results = [];
          const add = (name) => () => window.results.push(name);
          const socket = new WebSocket(`ws://${arguments[0]}/socket?page=${arguments[1]}`);
          socket.onopen = add('opened');
          socket.onerror = add('socket refused');
          fetch(`http://${arguments[0]}/`, { credentials: 'include' })
            .then(add('read'), add('page refused'));
          """,
          "127.0.0.1:" + pages.web().port(),
          token);
      browser.await("window.results.length === 2");

      assertThat(browser.run("return window.results.sort().join()"))
          .isEqualTo("page refused,socket refused");
    } finally {
      other.stop(0);
    }
  }

  @Test
  void aLostServerIsShownAtOnceAndTheEndOfTheSessionAfterARestart(Browser browser)
      throws IOException {
    browser.open(URI.create(pages.web().link(Role.VIEW)));
    browser.await(LIVE);
    int port = pages.web().port();

    pages.close();

    browser.await("document.querySelector('.banner.lost[role=alert]')");
    assertThat(browser.text(".banner")).contains("Nothing on this page is up to date");
    browser.await("document.querySelector('.top.stale')");

    pages =
        TestPages.start(ServerType.C3_BRIDGE, folder.resolve("restarted"), cfg -> cfg.port(port));

    browser.await("document.querySelector('.banner.ended')");
    assertThat(browser.text(".banner")).contains("no session any more");
  }

  @ParameterizedTest
  @EnumSource(names = {"DESKTOP", "SMALL_PHONE"})
  void somebodyIsLetInByTheCodeAndSentAway(Browser.Size size, Browser browser) throws Exception {
    browser.size(size);
    browser.open(URI.create(pages.web().link(Role.OPERATE)));
    browser.await(LIVE);
    browser.click("[aria-label=\"Let somebody in\"]");
    browser.await("document.querySelectorAll('.browsers li').length === 1");
    assertThat(browser.run("return [...document.querySelectorAll('.let-in option')].length"))
        .isEqualTo(2L);
    assertThat(browser.barriers()).isEmpty();

    browser.find(".let-in input").sendKeys("phone");
    browser.click(".let-in .main");
    browser.find("svg.qr");
    browser.picture("access-" + size);
    assertThat(browser.barriers()).isEmpty();
    assertThat(browser.overflow()).isNotPositive();
    assertThat(size == Browser.Size.DESKTOP ? List.of() : browser.smallTargets()).isEmpty();
    String link = code(browser);
    assertThat(browser.run("return document.querySelector('.made .link').value")).isEqualTo(link);

    assertThat(pages.get(URI.create(link)).statusCode()).isEqualTo(200);

    browser.click("[aria-label=\"Send browser 2 (phone) away\"]");
    browser.click(".browsers .main");
    browser.await("document.querySelectorAll('.browsers li').length === 1");
    assertThat(browser.errors()).isEmpty();
  }

  @Test
  void aLinkOnAnotherSiteLetsTheBrowserIn(Browser browser) {
    String mail = "<a href=\"" + pages.web().link(Role.VIEW) + "\">the robot</a>";
    String encoded = Base64.getEncoder().encodeToString(mail.getBytes(US_ASCII));
    browser.open(URI.create("data:text/html;base64," + encoded));

    browser.click("a");

    browser.await(LIVE);
  }

  /** Reads the QR code on the page from one of some pictures, as the camera of a phone does. */
  private static String code(Browser browser) throws Exception {
    for (int left = 10; left > 1; left--) {
      try {
        return code(browser.picture());
      } catch (ReaderException e) {
        // the page was being drawn
      }
    }
    return code(browser.picture());
  }

  private static String code(BufferedImage picture) throws Exception {
    int width = picture.getWidth();
    int height = picture.getHeight();
    int[] pixels = picture.getRGB(0, 0, width, height, null, 0, width);
    LuminanceSource light = new RGBLuminanceSource(width, height, pixels);
    return new QRCodeReader().decode(new BinaryBitmap(new HybridBinarizer(light))).getText();
  }

  @Test
  void aBrowserThatIsSentAwayIsTold(Browser browser) throws Exception {
    browser.open(URI.create(pages.web().link(Role.VIEW)));
    browser.await(LIVE);

    try (TestSocket operator = pages.open(Role.OPERATE)) {
      operator.call("send_away", "browser", "1");
    }

    browser.await("document.querySelector('.banner.ended')");
    assertThat(browser.text(".banner")).contains("it was sent away");
  }

  @Test
  void thePageWorksWithTlsAndShowsTheFingerprint(Browser browser) throws IOException {
    ServerCertificate certificate =
        OwnCertificate.in(folder.resolve("tls"), PageAddress.loopback()).certificate();
    try (TestPages secure =
        TestPages.start(
            ServerType.C3_BRIDGE, folder.resolve("secure"), cfg -> cfg.certificate(certificate))) {
      browser.open(URI.create(secure.web().link(Role.VIEW)));
      browser.await(LIVE);
      browser.click("[aria-label=\"Let somebody in\"]");

      assertThat(browser.text(".fingerprint")).isEqualTo(certificate.fingerprint());
      assertThat(browser.errors()).isEmpty();
    }
  }

  @Test
  void aVariableIsChangedWithoutAMouse(Browser browser) throws Exception {
    browser.open(URI.create(pages.web().link(Role.OPERATE)));
    browser.await(LIVE);

    tabTo(browser, ".lock");
    browser.press(Keys.ENTER);
    browser.await("document.querySelector('.lock[aria-pressed=true]')");
    tabTo(browser, "[aria-label=\"Change $OV_PRO\"]");
    browser.press(Keys.ENTER);
    browser.await("document.activeElement.value === '100'");
    browser.press(Keys.BACK_SPACE, Keys.BACK_SPACE, Keys.BACK_SPACE, "30", Keys.ENTER);
    browser.await("document.querySelector('dialog .new')?.textContent === '30'");
    browser.await("document.activeElement.textContent === 'Cancel'");
    browser.press(Keys.ENTER);
    browser.await("!document.querySelector('dialog')");

    assertThat(browser.run("return document.activeElement.ariaLabel")).isEqualTo("Change $OV_PRO");
    assertThat(pages.controller().variables().get("$OV_PRO")).isEqualTo("100");
    assertThat(browser.errors()).isEmpty();
  }

  @Test
  void theFocusIsVisible(Browser browser) {
    browser.open(URI.create(pages.web().link(Role.OPERATE)));
    browser.await(LIVE);

    browser.press(Keys.TAB);

    assertThat(browser.run("return getComputedStyle(document.activeElement).outlineStyle"))
        .isEqualTo("solid");
  }

  /** Presses the tabulator until an element has the focus. */
  private static void tabTo(Browser browser, String selector) {
    for (int i = 0; i < 200; i++) {
      browser.press(Keys.TAB);
      if (Boolean.TRUE.equals(
          browser.run("return document.activeElement.matches(arguments[0])", selector))) {
        return;
      }
    }
    throw new AssertionError("no tabulator leads to " + selector);
  }
}
