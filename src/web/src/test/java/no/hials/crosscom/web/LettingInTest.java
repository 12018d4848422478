package no.hials.crosscom.web;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import com.google.zxing.common.BitMatrix;
import com.google.zxing.qrcode.decoder.Decoder;
import java.io.IOException;
import java.net.URI;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Clock;
import java.time.Duration;
import java.time.Instant;
import java.time.ZoneId;
import java.time.ZoneOffset;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Links that a page makes for others, and browsers that are sent away. */
class LettingInTest {
  @TempDir private Path folder;
  private final Hours clock = new Hours();
  private TestPages pages;

  @BeforeEach
  void start() throws IOException {
    pages = TestPages.start(folder, clock);
  }

  @AfterEach
  void stop() throws IOException {
    pages.close();
  }

  /** A clock that a test sets. */
  private static final class Hours extends Clock {
    private Instant now = Instant.parse("2026-01-02T03:04:05Z");

    @Override
    public ZoneId getZone() {
      return ZoneOffset.UTC;
    }

    @Override
    public Clock withZone(ZoneId zone) {
      return this;
    }

    @Override
    public Instant instant() {
      return now;
    }
  }

  private JsonNode letIn(TestSocket from, String role, String name) throws InterruptedException {
    return from.call(
        "let_in",
        "role",
        "'" + role + "'",
        "name",
        "'" + name + "'",
        "address",
        "'" + pages.origin() + "'");
  }

  private URI link(TestSocket from, String role) throws InterruptedException {
    return URI.create(letIn(from, role, "").at("/ok/link").asText());
  }

  private String audit() throws IOException {
    return Files.readString(folder.resolve("audit.jsonl"));
  }

  @Test
  void aLinkOfAPageLetsOneBrowserInWithItsRole() throws Exception {
    try (TestSocket operator = pages.open(Role.JOG)) {
      URI link = URI.create(letIn(operator, "OPERATE", "Anna-2").at("/ok/link").asText());

      String cookie = pages.get(link).headers().firstValue("set-cookie").orElseThrow();

      assertThat(pages.get(link).statusCode()).isEqualTo(403);
      try (TestSocket phone = pages.open(cookie.substring(0, cookie.indexOf(';')))) {
        assertThat(phone.call("who").path("ok").toString())
            .contains("\"browser 2 (Anna-2)\"", "\"OPERATE\"");
      }
      assertThat(audit().lines())
          .anyMatch(it -> it.contains("\"let in\"") && it.contains("OPERATE, for Anna-2"))
          .anyMatch(it -> it.contains("\"come in\"") && it.contains("let in by browser 1"));
    }
  }

  @Test
  void theCodeOfALinkIsTheLink() throws Exception {
    try (TestSocket operator = pages.open(Role.JOG)) {
      JsonNode made = letIn(operator, "VIEW", "").path("ok");
      JsonNode rows = made.path("code");
      BitMatrix code = new BitMatrix(rows.size());
      for (int y = 0; y < rows.size(); y++) {
        for (int x = 0; x < rows.size(); x++) {
          if (rows.get(y).asText().charAt(x) == '1') {
            code.set(x, y);
          }
        }
      }

      assertThat(new Decoder().decode(code).getText())
          .isEqualTo(made.path("link").asText())
          .startsWith(pages.origin() + "/?token=");
    }
  }

  @Test
  void aLinkOfAPageEndsAfterTenMinutesAndThatOfTheCommandDoesNot() throws Exception {
    URI ofTheCommand = URI.create(pages.web().link(Role.VIEW));
    try (TestSocket operator = pages.open(Role.JOG)) {
      URI inTime = link(operator, "VIEW");
      URI late = link(operator, "VIEW");

      clock.now = clock.now.plus(Duration.ofMinutes(10)).minusMillis(1);
      assertThat(pages.get(inTime).statusCode()).isEqualTo(200);
      clock.now = clock.now.plusMillis(1);
      assertThat(pages.get(late).statusCode()).isEqualTo(403);
      assertThat(pages.get(ofTheCommand).statusCode()).isEqualTo(200);
    }
  }

  @ParameterizedTest
  @CsvSource({"VIEW, OPERATE", "VIEW, JOG", "OPERATE, JOG"})
  void nobodyLetsOneInWhoMayDoMore(Role own, String wanted) throws Exception {
    try (TestSocket page = pages.open(own)) {
      assertThat(letIn(page, wanted, "").path("error").asText())
          .isEqualTo("a browser that may only " + own + " cannot create a link for " + wanted);
      assertThat(letIn(page, own.name(), "").at("/ok/link").asText()).isNotEmpty();
    }
  }

  @ParameterizedTest
  @ValueSource(strings = {"<b>", "12345678901234567890123456789012345678901", "\\u202e", "a\\nb"})
  void aNameIsShortAndPlain(String name) throws Exception {
    try (TestSocket operator = pages.open(Role.JOG)) {
      assertThat(letIn(operator, "VIEW", name).path("error").asText()).startsWith("a name has");
    }
  }

  @Test
  void aLinkLeadsToThisPageOnly() throws Exception {
    try (TestSocket operator = pages.open(Role.JOG)) {
      JsonNode answer =
          operator.call(
              "let_in", "role", "'VIEW'", "name", "''", "address", "'http://evil.example'");

      assertThat(answer.path("error").asText()).isEqualTo("the page has no such address");
    }
  }

  @Test
  void linksAreMadeSlowly() throws Exception {
    try (TestSocket operator = pages.open(Role.JOG)) {
      JsonNode answer = letIn(operator, "VIEW", "");
      for (int i = 0; i < 1000 && answer.has("ok"); i++) {
        answer = letIn(operator, "VIEW", "");
      }

      assertThat(answer.path("error").asText()).startsWith("too many links were made");
    }
  }

  @Test
  void aBrowserThatIsSentAwayLosesItsSocketItsSessionAndTheLinksThatItHasMade() throws Exception {
    String cookie = pages.login(Role.OPERATE);
    try (TestSocket operator = pages.open(Role.JOG);
        TestSocket other = pages.open(cookie)) {
      URI ofTheOther = link(other, "OPERATE");
      String page = pages.pageToken(cookie);

      assertThat(operator.call("send_away", "browser", "1").has("ok")).isTrue();

      assertThat(other.closeCode()).isEqualTo(1008);
      assertThat(pages.get(pages.at("/"), "Cookie", cookie).statusCode()).isEqualTo(403);
      assertThat(pages.get(pages.at("/socket?page=" + page), "Cookie", cookie).statusCode())
          .isEqualTo(403);
      assertThat(pages.get(ofTheOther).statusCode()).isEqualTo(403);
      assertThat(operator.call("browsers").at("/ok/browsers").findValuesAsText("name"))
          .containsExactly("browser 2");
      assertThat(audit().lines())
          .anyMatch(it -> it.contains("\"send away\"") && it.contains("\"browser 1\""));
    }
  }

  @ParameterizedTest
  @CsvSource({
    "VIEW, VIEW, this needs the role OPERATE",
    "OPERATE, JOG, this browser may do less than browser 1"
  })
  void nobodySendsOneAwayWhoMayDoMore(Role own, Role other, String reason) throws Exception {
    String cookie = pages.login(other);
    try (TestSocket page = pages.open(own)) {
      assertThat(page.call("send_away", "browser", "1").path("error").asText()).startsWith(reason);
      assertThat(pages.get(pages.at("/"), "Cookie", cookie).statusCode()).isEqualTo(200);
    }
  }

  @Test
  void pagesLearnWhoComesAndGoes() throws Exception {
    try (TestSocket operator = pages.open(Role.JOG)) {
      operator.awaitEvent("browsers");
      TestSocket other = pages.open(Role.VIEW);
      other.call("ping"); // the server knows the page, not only its login
      operator.awaitEvent("browsers");
      JsonNode both = operator.call("browsers").at("/ok/browsers");
      assertThat(both.findValuesAsText("pages")).containsExactly("1", "1");
      assertThat(both.findValuesAsText("own")).containsExactly("true", "false");
      assertThat(both.findValuesAsText("since")).containsOnly("" + clock.now.toEpochMilli());
      operator.call("ping");

      other.close();

      operator.awaitEvent("browsers");
    }
  }
}
