package no.hials.crosscom.web.browser;

import static org.assertj.core.api.Assertions.assertThat;

import java.net.URI;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import no.hials.crosscom.protocol.ServerType;
import no.hials.crosscom.web.Role;
import no.hials.crosscom.web.TestPages;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.ExtendWith;
import org.junit.jupiter.api.io.TempDir;
import org.openqa.selenium.Keys;

/** Jogging with a finger on a phone, and without a mouse. */
@ExtendWith(WithBrowser.class)
class JogBrowserIT {
  private static final String PLUS = "[aria-label='Hold to move X plus']";
  private static final String MOVING = "document.querySelector('.jog .state.moving')";
  private static final String STANDING = "document.querySelector('.jog .state.ready')";

  /** Returns the number of buttons that are held. */
  private static final String HELD = "return document.querySelectorAll('.hold.held').length";

  /** Less than the 500 ms after which the watchdog stops the robot. */
  private static final Duration BEFORE_WATCHDOG = Duration.ofMillis(300);

  @TempDir private Path folder;
  private TestPages pages;

  @BeforeEach
  void start() throws Exception {
    pages =
        TestPages.start(
            ServerType.C3_BRIDGE, folder, cfg -> cfg.jogMaxDelay(Duration.ofSeconds(2)));
  }

  @AfterEach
  void stop() throws Exception {
    pages.close();
  }

  /** Opens the view, unlocks the robot, prepares it and starts jogging. */
  private void open(Browser browser, Browser.Size size) {
    browser.size(size);
    browser.open(URI.create(pages.web().link(Role.JOG)));
    browser.open(pages.at("/?view=jog#/jog"));
    browser.await("document.querySelector('.top:not(.stale)')");
    browser.click(".lock");
    browser.await("document.querySelector('.lock.open')");
    browser.await("document.querySelector('.jog .state button:nth-child(2):not(:disabled)')");
    browser.click(".jog .state button:nth-child(2)");
    browser.await(STANDING);
  }

  private double x() {
    String text = pages.controller().variables().get("$POS_ACT");
    return Double.parseDouble(text.replaceFirst(".*X (-?[0-9.]+).*", "$1"));
  }

  /** Returns whether the robot is told to stand; the page shows the release a cycle earlier. */
  private boolean stands() {
    long before = System.nanoTime();
    boolean stands;
    do {
      stands = pages.controller().variables().get("MYPOS").contains("X 0.0,");
    } while (!stands && System.nanoTime() - before < BEFORE_WATCHDOG.toNanos());
    return stands;
  }

  private static void holdUntilItMoves(Browser browser) {
    holdUntilItMoves(browser, () -> browser.touch(PLUS), browser::lift);
  }

  /** Holds the button; again, if this computer has paused for 150 ms, which ends a hold. */
  private static void holdUntilItMoves(Browser browser, Runnable press, Runnable release) {
    for (int i = 0; i < 10; i++) {
      press.run();
      browser.run("window.touched = performance.now()");
      browser.await(MOVING + " || performance.now() > window.touched + 2000");
      if (Boolean.TRUE.equals(browser.run("return !!" + MOVING))) {
        return;
      }
      release.run();
    }
    throw new AssertionError("the robot does not move");
  }

  @Test
  void theRobotMovesWhileAFingerIsDown(Browser browser) throws Exception {
    open(browser, Browser.Size.SMALL_PHONE);
    double begin = x();
    assertThat(browser.text(".jog .warning"))
        .isEqualTo("Not an enabling device, not an emergency stop.");
    assertThat(browser.barriers()).isEmpty();
    assertThat(browser.smallTargets()).isEmpty();
    assertThat(browser.overflow()).isNotPositive();

    holdUntilItMoves(browser);
    browser.picture("jog-moving");
    assertThat(browser.text(".jog .status")).isEqualTo("Moving");
    browser.lift();

    browser.await(STANDING);
    assertThat(stands()).isTrue();
    assertThat(x()).isGreaterThan(begin);
    assertThat(browser.errors()).isEmpty();
  }

  @Test
  void aSecondFingerAddsADirection(Browser browser) {
    open(browser, Browser.Size.SMALL_PHONE);
    holdUntilItMoves(browser);

    browser.touch("[aria-label='Hold to move Y plus']");

    browser.await("document.querySelectorAll('.hold.moving').length === 2");
    browser.lift();
    browser.await(STANDING);
    assertThat(stands()).isTrue();
  }

  @Test
  void fingersOnBothButtonsOfADirectionEndIt(Browser browser) {
    open(browser, Browser.Size.SMALL_PHONE);
    holdUntilItMoves(browser);

    browser.touch("[aria-label='Hold to move X minus']");

    browser.await(STANDING);
    assertThat(stands()).isTrue();
    assertThat(browser.run(HELD)).isEqualTo(0L);
    browser.lift();
  }

  @Test
  void theLeftMouseButtonEndsTheHoldWhileTheMiddleOneIsDown(Browser browser) {
    open(browser, Browser.Size.DESKTOP);
    holdUntilItMoves(
        browser,
        () -> browser.press(Browser.MouseButton.LEFT, PLUS),
        () -> browser.release(Browser.MouseButton.LEFT));
    browser.press(Browser.MouseButton.MIDDLE, PLUS);

    browser.release(Browser.MouseButton.LEFT);

    browser.await(STANDING);
    assertThat(stands()).isTrue();
    assertThat(browser.run(HELD)).isEqualTo(0L);
  }

  @Test
  void aMouseOverTheButtonDoesNotEndTheHoldOfAKey(Browser browser) {
    open(browser, Browser.Size.DESKTOP);
    browser.run(
        "window.sent = [];"
            + "const send = WebSocket.prototype.send;"
            + "WebSocket.prototype.send ="
            + " function (message) { window.sent.push(message); send.call(this, message); }");

    browser.run(
        "const button = document.querySelector(arguments[0]);"
            + "button.focus();"
            + "button.dispatchEvent(new KeyboardEvent('keydown', { key: ' ' }));"
            + "button.dispatchEvent(new PointerEvent('pointermove', { pointerType: 'mouse' }));"
            + "window.then = window.sent.join();",
        PLUS);

    assertThat(browser.run("return window.then"))
        .asString()
        .contains("jog-press")
        .doesNotContain("jog-release");
  }

  /** Presses Space on the button; the release of the key is never seen by the page. */
  private static void holdByKey(Browser browser) {
    pressKey(browser, "{ key: ' ' }");
  }

  private static void holdByKeyUntilItMoves(Browser browser) {
    holdUntilItMoves(browser, () -> holdByKey(browser), () -> {});
  }

  private static void pressKey(Browser browser, String key) {
    browser.run(
        "const button = document.querySelector(arguments[0]);"
            + "button.focus();"
            + ("button.dispatchEvent(new KeyboardEvent('keydown', " + key + "));"),
        PLUS);
  }

  @Test
  void aKeyDoesNotHoldWithControlAltOrCommand(Browser browser) {
    open(browser, Browser.Size.DESKTOP);

    for (String modifier : List.of("ctrlKey", "altKey", "metaKey")) {
      pressKey(browser, "{ key: ' ', " + modifier + ": true }");
      assertThat(browser.run(HELD)).isEqualTo(0L);
    }
    holdByKeyUntilItMoves(browser);
    pressKey(browser, "{ key: 'Meta', metaKey: true }");

    browser.await(STANDING);
    assertThat(browser.run(HELD)).isEqualTo(0L);
    assertThat(stands()).isTrue();
  }

  @Test
  void aKeyAndAFingerOnBothButtonsOfADirectionEndIt(Browser browser) {
    open(browser, Browser.Size.SMALL_PHONE);
    holdByKeyUntilItMoves(browser);

    browser.touch("[aria-label='Hold to move X minus']");

    browser.await(STANDING);
    assertThat(stands()).isTrue();
    assertThat(browser.run(HELD)).isEqualTo(0L);
    browser.lift();
  }

  /** Returns an expression for whether no element of a selector hides a part of its text. */
  private static String isWhole(String selector) {
    return "[...document.querySelectorAll('"
        + selector
        + "')].every((it) => it.scrollWidth <= it.clientWidth && it.scrollHeight <= it.clientHeight)";
  }

  @Test
  void aSmallPhoneShowsTheWholeRefusalAndTheNamesOfThePrograms(Browser browser) throws Exception {
    open(browser, Browser.Size.SMALL_PHONE);
    browser.await(
        "document.querySelectorAll('.item.program').length === 2"
            + " && document.querySelector('.items').textContent.includes('ACTUATOR · running')");

    browser.click(".jog .choice button"); // the axes, for which another program must run

    browser.await("document.querySelector('.jog .status').textContent.includes('EXT_MOVE_AXIS')");
    browser.picture("jog-refused");
    assertThat(browser.run("return " + isWhole(".jog .status"))).isEqualTo(true);
    assertThat(browser.run("return " + isWhole(".item.program .value :first-child")))
        .isEqualTo(true);
    assertThat(browser.overflow()).isNotPositive();
  }

  @Test
  void aPageThatIsCutOffStopsTheRobotAndSaysSo(Browser browser) {
    open(browser, Browser.Size.PHONE);
    holdUntilItMoves(browser);

    browser.run("WebSocket.prototype.send = () => {}"); // as a network that forwards nothing

    browser.await("document.querySelector('.note.error')?.textContent.includes('300 ms')");
    browser.await("!" + MOVING);
    assertThat(stands()).isTrue();
  }

  @Test
  void aHiddenOrBlurredPageReleases(Browser browser) {
    open(browser, Browser.Size.PHONE);
    holdUntilItMoves(browser);

    browser.run("dispatchEvent(new Event('blur'))");

    browser.await(STANDING);
    assertThat(stands()).isTrue();
  }

  @Test
  void leavingTheViewGivesUpTheRobot(Browser browser) {
    open(browser, Browser.Size.PHONE);
    holdUntilItMoves(browser);

    browser.run("location.hash = '#/variables'");

    browser.await(
        "![...document.querySelectorAll('.item .name')].some((it) => it.textContent === 'Jog')");
    assertThat(stands()).isTrue();
  }

  @Test
  void aKeyEndsWithTheFocusBeforeThePageHasShownIt(Browser browser) {
    open(browser, Browser.Size.DESKTOP);

    browser.run(
        "const button = document.querySelector(arguments[0]);"
            + "button.focus();"
            + "button.dispatchEvent(new KeyboardEvent('keydown', { key: ' ', bubbles: true }));"
            + "document.querySelector(\"[aria-label='Hold to move X minus']\").focus();"
            + "setTimeout(() => (window.later = true), 500);",
        PLUS);
    browser.await("window.later");

    assertThat(browser.run(HELD)).isEqualTo(0L);
    assertThat(stands()).isTrue();
  }

  @Test
  void aKeyMovesTheRobotUntilTheNextButton(Browser browser) {
    open(browser, Browser.Size.DESKTOP);
    holdByKeyUntilItMoves(browser);

    browser.press(Keys.TAB); // the release of the key is not seen by the button

    browser.await(STANDING);
    assertThat(stands()).isTrue();
  }
}
