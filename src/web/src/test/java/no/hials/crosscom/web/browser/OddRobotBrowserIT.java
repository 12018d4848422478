package no.hials.crosscom.web.browser;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.net.URI;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import no.hials.crosscom.mock.Fault;
import no.hials.crosscom.mock.RecordedRequest;
import no.hials.crosscom.protocol.ServerType;
import no.hials.crosscom.protocol.Tail;
import no.hials.crosscom.protocol.code.OperatingMode;
import no.hials.crosscom.protocol.program.ProgramRequest.ProgramControlRequest;
import no.hials.crosscom.simulator.Controller;
import no.hials.crosscom.web.Role;
import no.hials.crosscom.web.TestPages;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.ExtendWith;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.openqa.selenium.Keys;

/** The page with a robot that answers late, or with values of other types. */
@ExtendWith(WithBrowser.class)
class OddRobotBrowserIT {
  @TempDir private Path folder;
  private TestPages pages;
  private final CountDownLatch released = new CountDownLatch(1);

  @AfterEach
  void stop() throws IOException {
    released.countDown();
    pages.close();
  }

  private void open(Browser browser, ServerType server, String view) throws Exception {
    pages = TestPages.start(server, folder, cfg -> {});
    browser.open(URI.create(pages.web().link(Role.OPERATE)));
    browser.open(pages.at("/?odd=" + view + "#/" + view));
    browser.await("document.querySelector('.top:not(.stale)')");
  }

  /** Lets the controller answer reads of a variable with another value. */
  private void answer(String name, String value) {
    pages
        .controller()
        .fault(request -> request.names().contains(name), Fault.answer(value, Tail.SUCCESS));
  }

  private static void awaitText(Browser browser, String selector, String text) {
    browser.await(
        "document.querySelector(`" + selector + "`)?.textContent.includes('" + text + "')");
  }

  @ParameterizedTest
  @CsvSource({
    "robot, .stage.old",
    "programs, .interpreters.stale .state.reading",
    "programs, .text.stale",
    "programs, .messages.stale",
    "io, .stale .lamp",
    "jog, .jog.stale .reading",
    "variables, '#main .stale'"
  })
  void aViewIsMarkedAsSoonAsTheHeaderIs(String view, String marked, Browser browser)
      throws Exception {
    open(browser, ServerType.C3_BRIDGE, view);
    browser.await("document.querySelector('#main .reading, #main .words, #main .program-state')");

    pages.controller().fault(request -> true, Fault.hold(released));

    // the banner comes with the client's time-out
    browser.await(
        "document.querySelector('.top.stale') && document.querySelector(`"
            + marked
            + "`) && !document.querySelector('.banner.lost')");
  }

  @Test
  void aLampIsMarkedWhenItsOwnReadingIsOld(Browser browser) throws Exception {
    open(browser, ServerType.KUKAVARPROXY, "io");
    browser.await("document.querySelector('.lamps .words.reading')");

    pages
        .controller()
        .fault(
            request -> request.names().stream().anyMatch(it -> it.matches("\\$(IN|OUT)\\[.*")),
            Fault.delay(Duration.ofMillis(60)));

    browser.await(
        "document.querySelector('.top:not(.stale)') && document.querySelector('.stale .lamp')");
    awaitText(browser, ".stale .hint", "the server needs long");
  }

  @Test
  void anOldVerdictDoesNotLookGood(Browser browser) throws Exception {
    open(browser, ServerType.C3_BRIDGE, "programs");
    Controller controller = pages.controller().controller();
    controller.load("long.src", "DEF LONG ( )\nLOOP\nENDLOOP\nEND\n");
    controller.setMode(OperatingMode.AUT);
    controller.robot().select("LONG");
    controller.start();
    awaitText(browser, ".verdict.ok", "No problem found");

    pages.controller().fault(request -> true, Fault.hold(released));

    browser.await(
        "document.querySelector('.top.stale') && !document.querySelector('.verdict.ok')"
            + " && !document.querySelector('.verdict').textContent.includes('No problem')");
  }

  @Test
  void aProgramPointerOfAnotherTypeLeavesThePageAlive(Browser browser) throws Exception {
    open(browser, ServerType.KUKAVARPROXY, "programs");

    answer("$PRO_IP1", "{PRO_IP: NAME[] 5,SNR \"x\",SI01 {NAME[] 5,SNR 1}}");
    answer("$STOPMESS", "#UNKNOWN");

    awaitText(browser, ".messages [role=status]", "Unknown whether a message waits.");
    assertThat(browser.text(".top")).doesNotContain("none");
    assertThat(browser.errors()).isEmpty();
  }

  @ParameterizedTest
  @ValueSource(strings = {"robot", "teach"})
  void aViewSaysThatTheRobotHasNotAnsweredYet(String view, Browser browser) throws Exception {
    pages = TestPages.start(ServerType.C3_BRIDGE, folder, cfg -> {});
    pages.controller().fault(request -> true, Fault.hold(released));
    browser.open(URI.create(pages.web().link(Role.OPERATE)));
    browser.open(pages.at("/?odd=" + view + "#/" + view));

    awaitText(browser, "#main .failure", "The robot has not answered yet.");
  }

  @Test
  void whatIsNoNumberIsShownAsUnknown(Browser browser) throws Exception {
    open(browser, ServerType.KUKAVARPROXY, "jog");
    browser.await("document.querySelector('.pad .reading')?.textContent !== '–'");

    answer("$POS_ACT", "{E6POS: X \"x\",Y 1E30,Z TRUE,A -0.001}");
    answer("$OV_PRO", "\"abc\"");

    browser.await(
        "[...document.querySelectorAll('.pad .reading')].map((it) => it.textContent).join()"
            + " === '–,1.00e+30 mm,–,0.00 °,–,–'");
    browser.await("document.querySelector('.top').textContent.includes('Override–')");
  }

  @ParameterizedTest
  @CsvSource({"charts, .lines", "variables, .watched"})
  void aStructureMayHaveFieldsThatObjectsOfThePageHave(String view, String place, Browser browser)
      throws Exception {
    open(browser, ServerType.KUKAVARPROXY, view);

    answer("$POS_ACT", "{E6POS: __proto__ 11.5,constructor 22.5,toString 33.5}");

    for (String field : List.of("__proto__", "constructor", "toString")) {
      awaitText(browser, place, field);
    }
    awaitText(browser, place, "22.5");
    browser.await("document.querySelector('.top:not(.stale)')");
    assertThat(browser.run("return Object.keys(Object.prototype).length")).isEqualTo(0L);
    assertThat(browser.errors()).isEmpty();
  }

  @Test
  void theHeaderMayHaveWordsThatObjectsOfThePageHave(Browser browser) throws Exception {
    open(browser, ServerType.KUKAVARPROXY, "programs");

    answer("$MODE_OP", "\"constructor\"");
    answer("$PRO_STATE1", "\"toString\"");
    answer("$STOPMESS", "\"valueOf\"");

    awaitText(browser, ".top .mode", "constructor");
    awaitText(browser, ".interpreter.robot .state", "toString");
    awaitText(browser, ".top", "Stop–");
    assertThat(browser.errors()).isEmpty();
  }

  @Test
  void anAddressOfNoViewShowsTheFirstOne(Browser browser) throws Exception {
    pages = TestPages.start(folder);
    browser.open(URI.create(pages.web().link(Role.OPERATE)));

    browser.open(pages.at("/?odd=address#/constructor"));

    browser.await("document.querySelector('.variables')");
    assertThat(browser.errors()).isEmpty();
  }

  @Test
  void aLongNumberNeedsOneLineOnASmallPhone(Browser browser) throws Exception {
    browser.size(Browser.Size.SMALL_PHONE);
    open(browser, ServerType.C3_BRIDGE, "variables");

    answer("$POS_ACT", "{E6POS: X -7.88860905E-31,Y -7.88860905E-31,E1 -7.88860905E-31,E2 1.0}");

    awaitText(browser, ".watched .fields", "E1-7.88860905e-31");
    browser.picture("variables-long-numbers");
    assertThat(
            browser.run(
                """
                const fields = [...document.querySelectorAll('.watched .fields')]
                  .find((it) => it.textContent.includes('e-31'));
                const line = parseFloat(getComputedStyle(fields).fontSize) * 2;
                return [...fields.children].every((it) => it.clientHeight < line);
                """))
        .isEqualTo(true);
  }

  @Test
  void axesThatAreNoNumbersAreNoPose(Browser browser) throws Exception {
    open(browser, ServerType.KUKAVARPROXY, "robot");
    browser.await("document.querySelector('.axes .reading')?.textContent !== '–'");

    answer("$AXIS_ACT", "{E6AXIS: A1 \"x\",A2 -20}");

    awaitText(browser, ".old-mark", "No axes");
    assertThat(browser.errors()).isEmpty();
  }

  @Test
  void anotherRobotBehindTheAddressIsShownAfterTheReconnection(Browser browser) throws Exception {
    pages = TestPages.startRemote(ServerType.C3_BRIDGE, folder, cfg -> {});
    browser.open(URI.create(pages.web().link(Role.OPERATE)));
    browser.open(pages.at("/?odd=another#/robot"));
    awaitText(browser, ".picture h1", "KR 6 R900 sixx");

    pages.controller().variables().set("$TRAFONAME[]", "\"#KR10R1100_2 C4 FLR\"");
    pages.controller().disconnectClients();

    awaitText(browser, ".picture h1", "KR 10 R1100-2");
    assertThat(browser.errors()).isEmpty();
  }

  /** Returns an STL file in text with a triangle whose first vertex is given. */
  private static String triangle(String vertex) {
    return """
        SOLID x
        facet normal 0 0 1
        outer loop
        vertex %s
        vertex 0 1 2E2
        vertex 1 0 2e2
        endloop
        endfacet
        ENDSOLID x
        """
        .formatted(vertex);
  }

  @Test
  void allBadShapesAreNamedWithTheirReasonsAndTheOthersAreShown(Browser browser) throws Exception {
    Path shapes = Files.createDirectory(folder.resolve("shapes"));
    Files.writeString(shapes.resolve("base.stl"), triangle("0 0 200"));
    Files.writeString(shapes.resolve("a1.stl"), "not a shape");
    Files.writeString(shapes.resolve("a2.stl"), "x".repeat(200));
    Files.writeString(shapes.resolve("a3.stl"), "solid x\nendsolid x\n");
    ByteBuffer binary = ByteBuffer.allocate(84 + 50).order(ByteOrder.LITTLE_ENDIAN);
    binary.putInt(80, 1).putFloat(84 + 12 + 4, Float.NaN);
    Files.write(shapes.resolve("a4.stl"), binary.array());
    Files.writeString(shapes.resolve("a5.stl"), triangle("0 1e9 200"));
    Files.writeString(shapes.resolve("a6.stl"), triangle("0 -1e999 200"));
    Files.writeString(shapes.resolve("tool.stl"), triangle("0 nan 200"));
    pages = TestPages.start(ServerType.C3_BRIDGE, folder, cfg -> cfg.shapes(shapes));
    browser.open(URI.create(pages.web().link(Role.VIEW)));
    browser.open(pages.at("/?odd=shapes#/robot"));

    awaitText(browser, ".unshown", "tool.stl is not shown: ");
    assertThat(browser.text(".unshown").lines())
        .containsExactly(
            "a1.stl is not shown: it has 11 bytes and does not begin with solid, unlike an STL file",
            "a2.stl is not shown: it does not begin with solid, and as a binary file of 2021161080"
                + " triangles it must have 101058054084 bytes, has 200",
            "a3.stl is not shown: it has no complete triangle",
            "a4.stl is not shown: a vertex must be within 100 m, is at 0, NaN, 0 mm",
            "a5.stl is not shown: a vertex must be within 100 m, is at 0, 1000000000, 200 mm",
            "a6.stl is not shown: a vertex must be within 100 m, is at 0, -Infinity, 200 mm",
            "tool.stl is not shown: a triangle must have three vertices of three numbers each");
  }

  @Test
  void aNameThatIsNoneIsRefusedInItsRowAndTheOthersAreRead(Browser browser) throws Exception {
    open(browser, ServerType.C3_BRIDGE, "variables");
    browser.run(
        "localStorage.setItem('watch-list/mock',"
            + " JSON.stringify({ name: '', period: 250, names: ['A\\nB', '$OV_PRO'] }))");
    browser.open(pages.at("/?odd=names#/variables"));
    awaitText(browser, ".watched tbody tr:nth-child(1)", "must not have a line break or NUL");
    awaitText(browser, ".watched tbody tr:nth-child(2) .reading", "100");

    for (String name : List.of(".X", ".Y")) {
      browser.find(".search input").sendKeys(name, Keys.ENTER);
    }

    browser.await("document.querySelectorAll('.watched tbody tr').length === 4");
    awaitText(browser, ".watched tbody tr:nth-child(4) .reading", ".Y");
    browser.await("document.querySelector('.top:not(.stale)')");
    pages.controller().variables().set("$OV_PRO", "37");
    awaitText(browser, ".watched tbody tr:nth-child(2) .reading", "37");
  }

  @Test
  void stopIsPressedOnceUntilItIsAnsweredAlsoOnALockedRobot(Browser browser) throws Exception {
    open(browser, ServerType.C3_BRIDGE, "programs");
    pages
        .controller()
        .fault(it -> it.request() instanceof ProgramControlRequest, Fault.hold(released));
    String stop = ".interpreter.robot .stop";
    browser.await("document.querySelector('" + stop + ":not(:disabled)')");

    browser.run("document.querySelector(arguments[0]).scrollIntoView({ block: 'center' })", stop);
    browser.click(stop);

    browser.await("document.querySelector('" + stop + "').textContent === 'Stopping …'");
    assertThat(browser.run("return document.querySelector(arguments[0]).disabled", stop))
        .isEqualTo(true);
    released.countDown();
    browser.await("document.querySelector('" + stop + "').textContent === 'Stop'");
    assertThat(pages.controller().requests())
        .filteredOn(it -> it.request() instanceof ProgramControlRequest)
        .hasSize(1);
  }

  @Test
  void aMovingRobotIsNoProblem(Browser browser) throws Exception {
    open(browser, ServerType.KUKAVARPROXY, "programs");
    answer("$ROB_STOPPED", "FALSE");

    browser.await(
        "document.querySelector('.verdict.ok')?.textContent.includes('The robot moves.')");
  }

  /** Opens the sliders of MYPOS. */
  private void openSliders(Browser browser) throws Exception {
    // without batches, since an odd answer would hold for all variables of one
    open(browser, ServerType.KUKAVARPROXY, "teach");
    browser.click(".lock");
    browser.await("document.querySelector('.lock[aria-pressed=true]')");
    browser.await("document.querySelector('.mode-key:not(:disabled)')");
    browser.run(
        "[...document.querySelectorAll('button')].find((it) => it.textContent.startsWith('MYPOS'))"
            + ".click()");
    browser.await("document.querySelector('.increments input:not(:disabled)')");
  }

  @Test
  void aSliderShowsWhatIsOnTheController(Browser browser) throws Exception {
    openSliders(browser);

    pages.controller().variables().set("MYPOS.Y", "2.5");

    awaitText(browser, ".increments label:nth-of-type(2) output", "2.50 mm");
    browser.await("document.querySelectorAll('.increments input')[1].value === '2.5'");
    answer("MYPOS", "{E6POS: X \"x\"}");
    browser.await("document.querySelector('.increments input').disabled");
    awaitText(browser, ".increments output", "–");
  }

  @Test
  void allSlidersAreSetTo0AlsoOnALockedRobot(Browser browser) throws Exception {
    openSliders(browser);
    pages.controller().variables().set("MYPOS.Y", "2.5");
    awaitText(browser, ".increments label:nth-of-type(2) output", "2.50 mm");
    browser.click(".lock");
    browser.await("document.querySelector('.increments input:disabled')");

    // by script: the hint for a locked robot moves the button, and a pointer could miss it
    browser.run("document.querySelector('.increments button.main').click()");

    awaitText(browser, ".increments label:nth-of-type(2) output", "0.00 mm");
  }

  @ParameterizedTest
  @ValueSource(strings = {"#/teach", "#/programs"})
  void theNewestValueIsWrittenAfterAFailureAndAfterTheView(String next, Browser browser)
      throws Exception {
    openSliders(browser);
    pages
        .controller()
        .fault(it -> isIncrement(it) && "-1.000".equals(incrementX(it)), Fault.drop());

    browser.run(
        "const slider = document.querySelector('.increments input'); slider.value = -1;"
            + " slider.dispatchEvent(new Event('input'));"
            + " document.querySelector('.increments button.main').click();"
            + " location.hash = arguments[0]",
        next);

    awaitText(browser, ".note.error", "the outcome is unknown");
    while (pages.controller().requests().stream().filter(OddRobotBrowserIT::isIncrement).count()
        < 2) {
      Thread.onSpinWait();
    }
    assertThat(pages.controller().requests())
        .filteredOn(OddRobotBrowserIT::isIncrement)
        .extracting(OddRobotBrowserIT::incrementX)
        .containsExactly("-1.000", "0.000");
  }

  private static String incrementX(RecordedRequest request) {
    return String.valueOf(request.value()).replaceAll(".*X (-?[0-9.]+).*", "$1");
  }

  private static boolean isIncrement(RecordedRequest request) {
    return request.isWrite() && request.names().contains("MYPOS");
  }
}
