package no.hials.crosscom.web.browser;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.net.URI;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import no.hials.crosscom.cell.recording.RecordedData;
import no.hials.crosscom.web.Role;
import no.hials.crosscom.web.TestPages;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.ExtendWith;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.openqa.selenium.Keys;

/** Live charts, a recording, and its replay in the charts and in 3-D. */
@ExtendWith(WithBrowser.class)
class ChartsBrowserIT {
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

  private void override(int percent) {
    pages.controller().variables().set("$OV_PRO", Integer.toString(percent));
  }

  /** Returns an expression for whether the list of lines has a text. */
  private static String lines(String text) {
    return "document.querySelector('.lines').innerText.replace(/\\s+/g, ' ').includes('"
        + text
        + "')";
  }

  private static String button(String text) {
    return "[...document.querySelectorAll('button')].find((it) => it.textContent === '"
        + text
        + "')";
  }

  private static void click(Browser browser, String text) {
    browser.await(button(text));
    browser.run(button(text) + ".click()");
  }

  @ParameterizedTest
  @EnumSource(names = {"DESKTOP", "PHONE"})
  void aRecordingIsReplayedInTheChartsAndIn3d(Browser.Size size, Browser browser)
      throws IOException {
    browser.size(size);
    override(40);
    browser.open(URI.create(pages.web().link(Role.OPERATE)));
    browser.open(pages.at("/?view=charts#/charts"));

    // live
    browser.await("document.querySelectorAll('.chart canvas').length === 2");
    browser.await(lines(".X 525 mm"));
    browser.run("document.querySelector('.add').open = true");
    browser.find(".charts input[type=search]").sendKeys("$OV_PRO", Keys.ENTER);
    browser.await(lines("value 40 %"));
    browser.await("document.querySelectorAll('.chart canvas').length === 3");
    assertThat(browser.run("return localStorage.getItem('charts/mock')").toString())
        .contains("$OV_PRO");

    // a pause freezes the picture
    click(browser, "Pause");
    override(60);
    click(browser, "+");
    browser.await(button("Reset") + ".disabled === false");
    click(browser, "Reset"); // ends the zoom, not the pause
    browser.await(button("Reset") + ".disabled");
    click(browser, "Resume");
    browser.await(lines("value 60 %"));

    // a recording
    click(browser, "● Record …");
    browser.find("dialog input").sendKeys("run-1");
    click(browser, "Record");
    browser.await("/ [1-9]\\d* rows/.test(document.querySelector('.recordings').innerText)");
    override(80);
    browser.await("/ 1[0-9]\\d* rows/.test(document.querySelector('.recordings').innerText)");
    click(browser, "Stop");
    browser.await(button("Open"));
    RecordedData file = RecordedData.read(folder.resolve("recordings/run-1.csv"));
    assertThat(file.find("$OV_PRO").orElseThrow().values()).contains(60, 80);
    assertThat(file.find("$AXIS_ACT.A1")).isPresent();

    // what happens now is not in it
    override(20);
    click(browser, "Open");
    browser.await("document.querySelector('.replay')");
    browser.await(lines("value 60 %"));
    assertThat(browser.text(".replay")).contains("run-1.csv");
    seek(browser, file.find("$OV_PRO").orElseThrow().seconds());
    browser.await(lines("value 80 %"));
    assertThat(browser.barriers()).isEmpty();
    assertThat(browser.overflow()).isNotPositive();
    if (size == Browser.Size.PHONE) {
      assertThat(browser.smallTargets()).isEmpty();
    }
    browser.picture("charts-replay-" + size);
  }

  @Test
  void aSecondEnterDoesNotStartASecondRecording(Browser browser) throws IOException {
    browser.open(URI.create(pages.web().link(Role.OPERATE)));
    browser.open(pages.at("/?view=charts#/charts"));
    click(browser, "● Record …");
    browser.await("document.querySelector('.record-form')");

    browser.run(
        "const form = document.querySelector('.record-form');"
            + "form.requestSubmit(); form.requestSubmit();");
    browser.await("document.querySelector('.recordings .running')");
    click(browser, "Stop");
    browser.await(button("Open"));

    try (Stream<Path> files = Files.list(folder.resolve("recordings"))) {
      assertThat(files).hasSize(1);
    }
  }

  @ParameterizedTest
  @EnumSource(names = {"DESKTOP", "PHONE"})
  void theReplayMovesTheNumbersOfThe3dView(Browser.Size size, Browser browser) throws IOException {
    Path recordings = Files.createDirectories(folder.resolve("recordings"));
    Files.writeString(
        recordings.resolve("turn.csv"),
        """
        time,seconds,$AXIS_ACT.A1,$AXIS_ACT.A2,$AXIS_ACT.A3,$AXIS_ACT.A4,$AXIS_ACT.A5,$AXIS_ACT.A6,access_ms,status
        2026-05-04T10:15:30.000000Z,0.000000,11,-80,90,0,30,0,1.0,
        2026-05-04T10:15:31.000000Z,1.000000,22,-80,90,0,30,0,1.0,
        2026-05-04T10:15:32.000000Z,2.000000,33,-80,90,0,30,0,1.0,
        """);
    browser.size(size);
    browser.open(URI.create(pages.web().link(Role.JOG)));
    browser.open(pages.at("/?view=charts#/charts"));
    click(browser, "Open");
    browser.await("document.querySelector('.replay')");

    browser.run("location.hash = '#/robot'");
    browser.await(axes("11.00"));
    browser.await("document.querySelector('.replay-mark')");
    seek(browser, new double[] {1.5});
    browser.await(axes("22.00"));
    click(browser, "Play");
    browser.await(axes("33.00"));
    browser.await(button("Play")); // at the end
    assertThat(browser.barriers()).isEmpty();
    assertThat(browser.overflow()).isNotPositive();
    browser.picture("robot-replay-" + size);

    // nobody takes the recorded pose for that of the robot to jog
    browser.run("location.hash = '#/jog'");
    browser.await("document.querySelector('main').textContent.includes('a recording is open')");

    browser.run("location.hash = '#/robot'");
    browser.await("document.querySelector('.replay-mark')");
    click(browser, "Close");
    browser.await("!document.querySelector('.replay-mark')");
    browser.await(axes("-90.00")); // the robot itself
    assertThat(browser.errors()).isEmpty();
  }

  /** Writes a recording into the folder of the server. */
  private void write(String file, String text) throws IOException {
    Path recordings = Files.createDirectories(folder.resolve("recordings"));
    Files.writeString(recordings.resolve(file), text);
  }

  /** Opens the charts, and the only recording in them. */
  private void openRecording(Browser browser) {
    browser.open(URI.create(pages.web().link(Role.OPERATE)));
    browser.open(pages.at("/?view=charts#/charts"));
    click(browser, "Open");
    browser.await("document.querySelector('.replay')");
  }

  @ParameterizedTest
  @ValueSource(strings = {"odd.csv", "odd.jsonl"})
  void aRecordingMayHaveNamesThatObjectsOfThePageHave(String file, Browser browser)
      throws IOException {
    write(
        file,
        file.endsWith(".csv")
            ? """
            time,seconds,__proto__,constructor,__proto__.a,X.__proto__,access_ms,status
            2026-05-04T10:15:30.000000Z,0.000000,11,22,33,44,1.0,
            2026-05-04T10:15:31.000000Z,1.000000,11,22,33,44,1.0,
            """
            : """
            {"time":"2026-05-04T10:15:30Z","seconds":0,"values":{"__proto__":11,"constructor":22}}
            {"time":"2026-05-04T10:15:31Z","seconds":1,"values":{"__proto__":{"a":33},"X":{"__proto__":44}}}
            """);
    openRecording(browser);

    browser.run("document.querySelectorAll('.lines details').forEach((it) => (it.open = true))");
    browser.await(lines("__proto__"));
    browser.await(lines("constructor value 22"));
    browser.run("document.querySelectorAll('.lines input').forEach((it) => it.click())");
    seek(browser, new double[] {1});
    browser.await(lines(".a 33"));
    browser.await(lines(".__proto__ 44"));
    browser.await("localStorage.getItem('charts/mock').includes('\"__proto__\":')");

    browser.run("location.hash = '#/robot'");
    browser.await("document.querySelector('.replay-mark')");
    seek(browser, new double[] {0});
    browser.await("document.querySelector('.old-mark').textContent.includes('no $AXIS_ACT')");
    assertThat(browser.run("return Object.keys(Object.prototype).length")).isEqualTo(0L);
    assertThat(browser.errors()).isEmpty();
  }

  @ParameterizedTest
  @CsvSource({"V%d, V2999, V2999 value 2999", "$IN[%d], $IN[2999], [2999] 2999"})
  void aRecordingOfThousandsOfNumbersIsListedInPartsAndFiltered(
      String name, String filter, String row, Browser browser) throws IOException {
    String values =
        IntStream.range(1, 3000)
            .mapToObj(i -> "\"" + name.formatted(i) + "\":" + i)
            .collect(Collectors.joining(",", "{", "}"));
    write(
        "many.jsonl",
        "{\"time\":\"2026-05-04T10:15:30Z\",\"seconds\":0,\"values\":%s}\n".formatted(values));
    openRecording(browser);
    browser.await(lines("2999 found. The first 200 are listed."));
    assertThat(count(browser, ".lines .line")).isEqualTo(200);
    assertThat(count(browser, "*")).isLessThan(3000);
    assertThat(browser.run("return " + lines(row))).isEqualTo(false);

    browser.find(".lines input[type=search]").sendKeys(filter.toLowerCase(Locale.ROOT));

    browser.await(lines("1 found."));
    browser.await(lines(row));
    browser.click(".lines .line input");
    browser.await("document.querySelector('.chart .plot').ariaLabel.includes('" + filter + "')");
    assertThat(browser.errors()).isEmpty();
  }

  @ParameterizedTest
  @ValueSource(strings = {"1E308", "Infinity"})
  void aNumberThatIsTooLargeForAnAxisLeavesTheOtherLinesVisible(String large, Browser browser)
      throws IOException {
    String time = "2026-05-04T10:15:30.000000Z";
    write(
        "large.csv",
        String.join(
            "\n",
            "time,seconds,X,Y,access_ms,status",
            time + ",0," + large + ",5,1,",
            time + ",1,-" + large + ",5,1,",
            time + ",2," + large + ",5,1,"));
    openRecording(browser);
    browser.await("document.querySelector('.chart canvas')");
    browser.run(
        """
        window.isDrawn = (line) => {
          const canvas = document.querySelector('.chart canvas');
          const { data } = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height);
          const swatch = getComputedStyle(document.querySelector(`.swatch.${line}`));
          const wanted = swatch.backgroundColor.match(/\\d+/g).map(Number);
          for (let i = 0; i < data.length; i += 4) {
            if (data[i + 3] > 200 && wanted.every((it, k) => Math.abs(data[i + k] - it) < 30)) {
              return true;
            }
          }
          return false;
        };
        """);

    browser.await("isDrawn('line-0') && isDrawn('line-1')");
    browser.picture("charts-large-" + large);
    assertThat(browser.errors()).isEmpty();
  }

  private static long count(Browser browser, String selector) {
    return (Long) browser.run("return document.querySelectorAll(arguments[0]).length", selector);
  }

  /** Returns an expression for whether the table of axes has a value. */
  private static String axes(String value) {
    return "document.querySelector('.axes')?.innerText.includes('" + value + "')";
  }

  /** Moves the player to the last time. */
  private static void seek(Browser browser, double[] seconds) {
    browser.run(
        """
        const slider = document.querySelector('.replay input');
        slider.value = arguments[0];
        slider.dispatchEvent(new Event('input'));
        """,
        seconds[seconds.length - 1]);
  }
}
