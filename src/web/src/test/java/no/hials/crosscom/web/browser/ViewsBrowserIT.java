package no.hials.crosscom.web.browser;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.InputStream;
import java.net.URI;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import no.hials.crosscom.protocol.ServerType;
import no.hials.crosscom.web.Role;
import no.hials.crosscom.web.TestPages;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestInstance;
import org.junit.jupiter.api.extension.ExtendWith;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

/** Checks every view of {@code app.js}. */
@TestInstance(TestInstance.Lifecycle.PER_CLASS)
@ExtendWith(WithBrowser.class)
class ViewsBrowserIT {
  private static final Pattern VIEW = Pattern.compile("(\\w+): \\['[^']+', \\(\\) => import\\(");

  private TestPages c3;
  private TestPages kukavarproxy;

  @BeforeAll
  void start(@TempDir Path folder) throws IOException {
    c3 = TestPages.start(folder.resolve("c3"));
    kukavarproxy =
        TestPages.start(ServerType.KUKAVARPROXY, folder.resolve("kukavarproxy"), cfg -> {});
  }

  @AfterAll
  void stop() throws IOException {
    c3.close();
    kukavarproxy.close();
  }

  private static List<String> views() throws IOException {
    try (InputStream app =
        TestPages.class.getResourceAsStream("/no/hials/crosscom/web/page/app.js")) {
      String text = new String(app.readAllBytes(), StandardCharsets.UTF_8);
      return VIEW.matcher(text).results().map((MatchResult it) -> it.group(1)).toList();
    }
  }

  static Stream<Arguments> viewsAndSizes() throws IOException {
    return views().stream()
        .flatMap(
            view ->
                Stream.of(Browser.Size.DESKTOP, Browser.Size.PHONE)
                    .map(size -> Arguments.of(view, size)));
  }

  @Test
  void theViewsAreFound() throws IOException {
    assertThat(views()).contains("variables", "robot");
  }

  @ParameterizedTest
  @MethodSource("viewsAndSizes")
  void aViewIsAccessibleFitsItsWindowAndShowsNoErrors(
      String view, Browser.Size size, Browser browser) throws IOException {
    browser.size(size);
    open(browser, c3, view);

    List<String> found = new ArrayList<>();
    for (boolean dark : new boolean[] {false, true}) {
      browser.dark(dark);
      found.addAll(browser.barriers());
      browser.picture(view + "-" + size + (dark ? "-dark" : ""));
    }
    assertThat(found).isEmpty();
    if (size == Browser.Size.PHONE) {
      assertThat(browser.smallTargets()).isEmpty();
    }
    for (Browser.Size other : Browser.Size.values()) {
      browser.size(other);
      assertThat(browser.overflow()).as("too wide for %s by", other).isNotPositive();
    }
    assertThat(browser.errors()).isEmpty();
  }

  @Test
  void theBadgeIsNotUnderTheButtonsOfASmallPhone(Browser browser) throws IOException {
    browser.size(Browser.Size.SMALL_PHONE);
    open(browser, c3, "jog");
    browser.click(".lock");
    browser.await("document.querySelector('.lock[aria-pressed=true]')");

    browser.picture("badge-SMALL_PHONE");
    assertThat(
            (Boolean)
                browser.run(
                    """
                    const badge = document.querySelector('.badge');
                    const box = badge.getBoundingClientRect();
                    return badge.scrollWidth <= badge.clientWidth
                      && [...document.querySelectorAll('.actions > *')].every((it) =>
                        it.getBoundingClientRect().left >= box.right);
                    """))
        .isTrue();
    browser.click(".lock");
    browser.await("document.querySelector('.lock[aria-pressed=false]')");
  }

  /** It names what this server cannot do. */
  @ParameterizedTest
  @MethodSource("views")
  void aViewShowsNoErrorsOnKukavarproxy(String view, Browser browser) throws IOException {
    open(browser, kukavarproxy, view);

    assertThat(browser.text(".top")).contains("KUKAVARPROXY");
    assertThat(browser.barriers()).isEmpty();
    assertThat(browser.errors()).isEmpty();
    browser.picture(view + "-KUKAVARPROXY");
  }

  /** Opens a view with a new link and waits until it shows the robot. */
  private static void open(Browser browser, TestPages pages, String view) {
    browser.open(URI.create(pages.web().link(Role.JOG)));
    browser.open(pages.at("/?view=" + view + "#/" + view));
    browser.await(
        "document.querySelector('.top:not(.stale)') && document.querySelector('main > *')");
  }
}
