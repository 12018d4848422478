package no.hials.crosscom.web;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import java.io.IOException;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import no.hials.crosscom.mock.MockServer;
import no.hials.crosscom.protocol.ServerType;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;

class SharedReadingsTest {
  private static final int SAMPLES = 20;

  /** More than those that are recorded before the page is hidden. */
  private static final int MAX_LEFT = 500;

  @TempDir private Path folder;

  private TestPages start(ServerType type) throws IOException {
    return TestPages.start(type, folder, cfg -> {});
  }

  private static void watch(TestSocket socket, String names) throws InterruptedException {
    JsonNode answer =
        socket.call("watch", "robot", "'mock'", "list", "'list'", "names", names, "period", "20");
    assertThat(answer.has("ok")).as(answer.toString()).isTrue();
  }

  private static long reads(MockServer server, String name) {
    return server.requests().stream().filter(it -> it.names().contains(name)).count();
  }

  @ParameterizedTest
  @EnumSource(ServerType.class)
  void tenViewersCostAsManyAccessesAsOne(ServerType type) throws Exception {
    List<TestSocket> viewers = new ArrayList<>();
    try (TestPages pages = start(type)) {
      for (int i = 0; i < 10; i++) {
        viewers.add(pages.open(Role.VIEW));
        watch(viewers.get(i), "['MYREAL','$VEL_ACT']");
      }
      TestSocket first = viewers.get(0);
      first.call("ping");
      double begin = first.awaitSamples("list").path("time").asDouble();
      pages.controller().clearRequests();
      double end = begin;
      for (int i = 0; i < SAMPLES; i++) {
        end = first.awaitSamples("list").path("time").asDouble();
      }

      // each viewer alone would read once in 20 ms
      double alone = (end - begin) / 20;
      assertThat(reads(pages.controller(), "MYREAL")).isBetween(1L, (long) (2 * alone) + 4);
      for (TestSocket viewer : viewers) {
        assertThat(viewer.awaitSamples("list").path("values").has("MYREAL")).isTrue();
      }
      viewers.forEach(TestSocket::close);
    }
  }

  @ParameterizedTest
  @EnumSource(ServerType.class)
  void aHiddenPageReadsNothing(ServerType type) throws Exception {
    try (TestPages pages = start(type);
        TestSocket hidden = pages.open(Role.VIEW);
        TestSocket other = pages.open(Role.VIEW)) {
      watch(hidden, "['MYREAL']");
      hidden.awaitSamples("list");

      hidden.call("visible", "visible", "false");
      watch(other, "['MYINT']");
      other.awaitSamples("list"); // a reading of before the command has ended
      pages.controller().clearRequests();
      for (int i = 0; i < SAMPLES; i++) {
        other.awaitSamples("list");
      }
      assertThat(reads(pages.controller(), "MYREAL")).isZero();

      hidden.call("visible", "visible", "true");
      assertThat(hidden.awaitSamples("list").path("values").has("MYREAL")).isTrue();
    }
  }

  @Test
  void withoutAVisiblePageTheControllerIsLeftAlone() throws Exception {
    try (TestPages pages = start(ServerType.KUKAVARPROXY);
        TestSocket page = pages.open(Role.VIEW)) {
      page.await(it -> it.path("mode").asText().equals("#T1"));
      page.call("visible", "visible", "false");

      // two periods of the header
      int last = 0;
      while (pages.controller().takeRequest(Duration.ofMillis(500)).isPresent()) {
        last++;
        assertThat(last).as("requests after the last page was hidden").isLessThan(MAX_LEFT);
      }
    }
  }

  @ParameterizedTest
  @EnumSource(ServerType.class)
  void fieldsOfOneStructureAreReadByTheStructure(ServerType type) throws Exception {
    try (TestPages pages = start(type);
        TestSocket first = pages.open(Role.VIEW);
        TestSocket second = pages.open(Role.VIEW)) {
      watch(first, "['$POS_ACT.X', '$POS_ACT.Y']");
      watch(second, "['$pos_act.z']");

      JsonNode values = first.awaitSamples("list").path("values");
      assertThat(values.path("$POS_ACT.X").path("value").isNumber()).isTrue();
      assertThat(values.has("$POS_ACT.Z")).isFalse();
      assertThat(second.awaitSamples("list").path("values").path("$POS_ACT.Z").has("value"))
          .isTrue();
      assertThat(reads(pages.controller(), "$POS_ACT")).isPositive();
      assertThat(reads(pages.controller(), "$POS_ACT.X")).isZero();
    }
  }

  @Test
  void aFieldThatHasNoValueIsAnErrorOfThisField() throws Exception {
    try (TestPages pages = start(ServerType.C3_BRIDGE);
        TestSocket socket = pages.open(Role.VIEW)) {
      watch(socket, "['$POS_ACT.X', '$POS_ACT.NO_FIELD']");

      JsonNode values = socket.awaitSamples("list").path("values");
      assertThat(values.path("$POS_ACT.X").has("value")).isTrue();
      assertThat(values.path("$POS_ACT.NO_FIELD").path("error").asText()).isNotEmpty();
    }
  }

  @ParameterizedTest
  @CsvSource({
    "C3_BRIDGE, '.X', '.Y'",
    "KUKAVARPROXY, '.X', '.Y'",
    "C3_BRIDGE, '.X', '.'",
    "C3_BRIDGE, 'A\\u0000B', 'B'",
    "C3_BRIDGE, 'A\\nB', ' '",
    "KUKAVARPROXY, 'A\\nB', '\\uD83D\\uDE00'"
  })
  void aNameThatIsNoneHasAnErrorAndStopsNoOtherReading(ServerType type, String one, String other)
      throws Exception {
    try (TestPages pages = start(type);
        TestSocket odd = pages.open(Role.VIEW);
        TestSocket page = pages.open(Role.VIEW)) {
      watch(odd, "['" + one + "']");
      odd.send( // without a call, which drops the events before its answer
          ("{'id':900,'do':'watch','robot':'mock','list':'list','period':20,'names':"
                  + ("['" + one + "','" + other + "','MYREAL']}"))
              .replace('\'', '"'));

      Set<String> errors = new HashSet<>();
      odd.await(
          it -> {
            it.path("values").properties().stream()
                .filter(value -> !value.getValue().path("error").asText().isEmpty())
                .forEach(value -> errors.add(value.getKey()));
            return errors.size() == 2 && it.path("values").path("MYREAL").has("value");
          });
      assertThat(errors).containsExactlyInAnyOrder(name(one), name(other));
      watch(page, "['MYINT']");
      assertThat(page.awaitSamples("list").path("values").path("MYINT").has("value")).isTrue();
      assertThat(page.call("checks", "robot", "'mock'", "on", "true").has("ok")).isTrue();
      odd.call("unwatch", "robot", "'mock'", "list", "'list'");
      pages.controller().variables().set("$OV_PRO", "37");
      page.await(it -> it.path("override").asText().equals("37"));
    }
  }

  private static String name(String json) {
    return TestSocket.json("'" + json + "'").asText().strip();
  }

  @ParameterizedTest
  @EnumSource(ServerType.class)
  void theHeaderStaysCompleteWhileAViewerReadsOneOfItsVariablesFaster(ServerType type)
      throws Exception {
    try (TestPages pages = start(type);
        TestSocket page = pages.open(Role.VIEW);
        TestSocket chart = pages.open(Role.VIEW)) {
      page.await(it -> it.path("mode").asText().equals("#T1"));
      watch(chart, "['$OV_PRO']");
      chart.awaitSamples("list");

      Set<JsonNode> times = new HashSet<>();
      while (times.size() < 8) { // readings of both periods
        JsonNode header = page.awaitEvent("header");
        assertThat(header.path("mode").asText()).isEqualTo("#T1");
        assertThat(header.path("stop").asText()).isEqualTo("FALSE");
        assertThat(header.path("override").asText()).isEqualTo("100");
        times.add(header.path("time"));
      }
    }
  }
}
