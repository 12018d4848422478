package no.hials.crosscom.web.browser;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.net.URI;
import java.nio.file.Path;
import java.util.concurrent.CountDownLatch;
import no.hials.crosscom.protocol.ServerType;
import no.hials.crosscom.protocol.code.OperatingMode;
import no.hials.crosscom.web.Role;
import no.hials.crosscom.web.TestPages;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.ExtendWith;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Programs, messages, inputs and outputs on the page. */
@ExtendWith(WithBrowser.class)
class ProgramsBrowserIT {
  private static final String PROGRAM =
      """
      DEF WORK ( )
        BAS (#INITMOV,0)
        PTP $AXIS_ACT ; <img src=x onerror=hacked=1>
        LOOP
          WAIT SEC 0.3
          $OUT[3]=TRUE
          WAIT SEC 0.3
          WAIT SEC 0.3
        ENDLOOP
      END
      """;
  private static final String LIVE = "document.querySelector('.top:not(.stale)')";

  @TempDir private Path folder;
  private TestPages pages;

  @AfterEach
  void stop() throws IOException {
    pages.close();
  }

  private void open(Browser browser, ServerType server, String view) throws Exception {
    pages = TestPages.start(server, folder, cfg -> {});
    pages.controller().controller().load("work.src", PROGRAM);
    browser.open(URI.create(pages.web().link(Role.OPERATE)));
    browser.open(pages.at("/?view=" + view + "#/" + view));
    browser.await(LIVE);
    browser.click(".lock");
    browser.await("document.querySelector('.lock[aria-pressed=true]')");
  }

  /** Presses a button, and the main one of the dialog that asks. */
  private static void pressAndConfirm(Browser browser, String button, String question) {
    browser.await("document.querySelector(`" + button + "`)?.disabled === false");
    // on a phone the views are over the end of the page
    browser.run("document.querySelector(arguments[0]).scrollIntoView({ block: 'center' })", button);
    browser.click(button);
    awaitText(browser, "dialog[open]", "mock");
    assertThat(browser.text("dialog")).contains(question);
    browser.click("dialog button.main");
    browser.await("!document.querySelector('dialog')");
  }

  private static void awaitText(Browser browser, String selector, String text) {
    browser.await(
        "document.querySelector(`" + selector + "`)?.textContent.includes('" + text + "')");
  }

  @ParameterizedTest
  @EnumSource(
      value = Browser.Size.class,
      names = {"DESKTOP", "PHONE"})
  void aProgramIsSelectedStartedTwiceAndStopped(Browser.Size size, Browser browser)
      throws Exception {
    browser.size(size);
    open(browser, ServerType.C3_BRIDGE, "programs");
    awaitText(browser, ".verdict", "First problem: Program.");

    pressAndConfirm(browser, "[aria-label='Select WORK.src']", "The robot does not move yet.");
    awaitText(browser, ".interpreter.robot .program-state", "WORK");
    awaitText(browser, ".code", "onerror=hacked=1");
    awaitText(browser, ".verdict", "First problem: Start.");
    String start = ".interpreter.robot button.main";
    pressAndConfirm(browser, start, "The robot will move.");
    awaitText(browser, ".bco", "as at the end of the BCO run. Press Start again");
    pressAndConfirm(browser, start, "The robot will move.");
    browser.await(
        "(window.lines ??= new Set()).add(document.querySelector('.running .number')?.textContent)"
            + ".size >= 3");
    assertThat(browser.barriers()).isEmpty();
    browser.picture("programs-running-" + size);
    browser.run("document.querySelector('.stop').scrollIntoView({ block: 'center' })");
    browser.click(".interpreter.robot .stop");
    awaitText(browser, ".interpreter.robot .program-state", "stopped");

    assertThat(browser.run("return window.hacked")).isNull();
    assertThat(browser.overflow()).isNotPositive();
    assertThat(browser.errors()).isEmpty();
  }

  @ParameterizedTest
  @ValueSource(
      strings = {"document.querySelector('dialog button.quiet').click()", "history.back()"})
  void aStartThatWaitsIsCancelledWithItsDialog(String leave, Browser browser) throws Exception {
    open(browser, ServerType.C3_BRIDGE, "io");
    browser.run("location.hash = '#/programs'");
    pressAndConfirm(browser, "[aria-label='Select WORK.src']", "The robot does not move yet.");
    String start = ".interpreter.robot button.main";
    browser.await("document.querySelector('" + start + "')?.disabled === false");
    browser.click(start);
    awaitText(browser, "dialog[open]", "The robot will move.");
    CountDownLatch released = new CountDownLatch(1);
    pages.hold("$PRO_STATE1", released).await();

    browser.click("dialog button.main");
    browser.run(leave);

    awaitText(browser, ".notes", "it was cancelled on the page");
    released.countDown();
    browser.await(LIVE);
    assertThat(pages.controller().variables().get("$PRO_STATE1")).isEqualTo("#P_RESET");
  }

  @Test
  void aMessageIsReadAndConfirmed(Browser browser) throws Exception {
    open(browser, ServerType.C3_BRIDGE, "programs");
    pages.controller().controller().emergencyStop(true);
    awaitText(browser, ".verdict", "First problem: Emergency stop.");
    awaitText(browser, ".message-list", "the emergency stop is pressed");
    pages.controller().controller().emergencyStop(false);
    awaitText(browser, ".verdict", "First problem: Messages.");

    pressAndConfirm(browser, ".messages .text-tools button", "Remove their causes first.");

    awaitText(browser, ".messages .text-tools", "None to confirm.");
    assertThat(pages.controller().variables().get("$STOPMESS")).isEqualTo("FALSE");
    assertThat(browser.errors()).isEmpty();
  }

  @Test
  void aReaderElsewhereIsNotMovedToTheRunningLine(Browser browser) throws Exception {
    open(browser, ServerType.C3_BRIDGE, "programs");
    pages
        .controller()
        .controller()
        .load("long.src", "DEF LONG ( )\n" + "; a line\n".repeat(5000) + "LOOP\nENDLOOP\nEND\n");
    pages.controller().controller().setMode(OperatingMode.AUT);
    pages.controller().controller().robot().select("LONG");
    pages.controller().controller().start();
    awaitText(browser, ".code .running", "OOP");
    assertThat((Long) browser.run("return document.querySelectorAll('.code .line').length"))
        .isBetween(10L, 150L);

    browser.run("document.querySelector('.code').scrollTop = 2000");
    awaitText(browser, ".follow", "Follow line 500");
    awaitText(browser, ".code", "101");
    assertThat(browser.run("return document.querySelector('.code').scrollTop")).isEqualTo(2000L);
    browser.click(".follow");

    awaitText(browser, ".code .running", "OOP");
    assertThat(browser.errors()).isEmpty();
  }

  @ParameterizedTest
  @EnumSource(ServerType.class)
  void anOutputIsSwitched(ServerType server, Browser browser) throws Exception {
    open(browser, server, "io");

    pressAndConfirm(browser, "[aria-label='$OUT[5]']", "An output can move a gripper");
    browser.await("document.querySelector(`[aria-label='$OUT[5]'][aria-checked=true]`)");
    browser.click(".io .switch input");
    browser.click("[aria-label='$IN[2]']");
    browser.await("document.querySelector(`[aria-label='$IN[2]'][aria-checked=true]`)");

    assertThat(pages.controller().variables().get("$OUT[5]")).isEqualTo("TRUE");
    assertThat(pages.controller().variables().get("$IN[2]")).isEqualTo("TRUE");
    assertThat(browser.errors()).isEmpty();
  }

  @Test
  void anOutputIsFoundByTheNameOfItsSignal(Browser browser) throws Exception {
    pages =
        TestPages.startRemote(
            folder, "cell.dat", "DEFDAT CELL PUBLIC\nSIGNAL PART $OUT[49] TO $OUT[56]\nENDDAT\n");
    browser.open(URI.create(pages.web().link(Role.OPERATE)));
    browser.open(pages.at("/?view=io#/io"));

    browser.click(".find input");
    browser.press("part bit 3");
    browser.click(".find button");

    browser.await("document.querySelector(`[aria-label='$OUT[52], PART bit 3']`)");
    assertThat(browser.text(".find button")).isEqualTo("PART bit 3 $OUT[52]");
    assertThat(browser.errors()).isEmpty();
  }
}
