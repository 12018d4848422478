package no.hials.crosscom.web;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class WatchListTest {
  @TempDir private Path folder;
  private TestPages pages;
  private TestSocket socket;

  @BeforeEach
  void start() throws Exception {
    pages = TestPages.start(folder);
    socket = pages.open(Role.OPERATE);
  }

  @AfterEach
  void stop() throws IOException {
    socket.close();
    pages.close();
  }

  private JsonNode save(String name, String period, String names) throws InterruptedException {
    return socket.call("list-save", "name", name, "period", period, "names", names);
  }

  private static List<String> texts(JsonNode array) {
    List<String> texts = new ArrayList<>();
    array.forEach(one -> texts.add(one.asText()));
    return texts;
  }

  @Test
  void aSavedListIsAFileWithOneNameOnEachLine() throws Exception {
    assertThat(save("'Cell 1'", "100", "['$pos_act', '$OV_PRO', '$POS_ACT']").has("ok")).isTrue();

    assertThat(folder.resolve("lists/Cell 1.txt"))
        .hasContent("# period 100 ms\n$POS_ACT\n$OV_PRO\n");
    JsonNode list = socket.call("lists").path("ok").path("lists").get(0);
    assertThat(list.path("name").asText()).isEqualTo("Cell 1");
    assertThat(list.path("period").asInt()).isEqualTo(100);
    assertThat(texts(list.path("names"))).containsExactly("$POS_ACT", "$OV_PRO");
  }

  @Test
  void aListReplacesTheOneWhoseNameDiffersInCase() throws Exception {
    save("'Cell'", "100", "['$OV_PRO']");

    assertThat(save("'cell'", "250", "['$POS_ACT']").has("ok")).isTrue();

    JsonNode lists = socket.call("lists").path("ok").path("lists");
    assertThat(lists).hasSize(1);
    assertThat(texts(lists.get(0).path("names"))).containsExactly("$POS_ACT");
    assertThat(socket.call("list-delete", "name", "'CELL'").has("ok")).isTrue();
    assertThat(folder.resolve("lists")).isEmptyDirectory();
  }

  @Test
  void theOtherBrowsersLearnOfAChange() throws Exception {
    try (TestSocket other = pages.open(Role.VIEW)) {
      save("'a'", "250", "['X']");
      other.awaitEvent("lists");

      assertThat(socket.call("list-delete", "name", "'a'").has("ok")).isTrue();
      other.awaitEvent("lists");

      assertThat(other.call("lists").path("ok").path("lists")).isEmpty();
      JsonNode refused = other.call("list-save", "name", "'b'", "period", "250", "names", "[]");
      assertThat(refused.path("error").asText())
          .isEqualTo("this needs the role OPERATE; this browser may only VIEW");
    }
  }

  @Test
  void theListOfTheOriginalIsRead() throws Exception {
    JsonNode list =
        socket
            .call("list-parse", "text", "'\\uFEFF$AXIS_ACT\\r\\n\\r\\n $OV_PRO \\r\\n$IN[1]\\r\\n'")
            .path("ok");

    assertThat(list.path("period").asInt()).isEqualTo(250);
    assertThat(texts(list.path("names"))).containsExactly("$AXIS_ACT", "$OV_PRO", "$IN[1]");
  }

  @Test
  void anExportedListIsReadBack() throws Exception {
    JsonNode text =
        socket
            .call("list-text", "period", "1000", "names", "['MYPOS', '$POS_ACT.X']")
            .path("ok")
            .path("text");

    JsonNode list = socket.call("list-parse", "text", text.toString()).path("ok");

    assertThat(list.path("period").asInt()).isEqualTo(1000);
    assertThat(texts(list.path("names"))).containsExactly("MYPOS", "$POS_ACT.X");
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "''",
        "'../x'",
        "'a/b'",
        "'.hidden'",
        "'CON:'",
        "'con'",
        "'NUL'",
        "' a'",
        "'a '",
        "'a\\u0000'"
      })
  void aNameThatIsNoFileIsRefused(String name) throws Exception {
    assertThat(save(name, "250", "['X']").path("error").asText())
        .as(name)
        .startsWith("the name of a list");
    assertThat(folder.resolve("lists")).doesNotExist();
  }

  @Test
  void wrongContentIsRefused() throws Exception {
    assertThat(save("'a'", "1", "['X']").path("error").asText())
        .isEqualTo("period must be 20 to 60000 ms, is 1");
    assertThat(save("'a'", "250", "['X\\nY']").path("error").asText())
        .startsWith("a name must have 1 to 255 characters, no control characters");
    JsonNode wide =
        socket.call("list-parse", "text", "'" + "X\\n".repeat(3) + "Y".repeat(300) + "'");
    assertThat(wide.path("error").asText())
        .startsWith("a name must have 1 to 255 characters")
        .hasSizeLessThan(200);
    assertThat(socket.call("list-delete", "name", "'a'").path("error").asText())
        .isEqualTo("there is no such list");
  }

  @Test
  void aDamagedFileHidesNoOtherList() throws Exception {
    save("'good'", "250", "['X']");
    Files.write(folder.resolve("lists/bad.txt"), new byte[] {(byte) 0xff, 0, 1});

    JsonNode lists = socket.call("lists").path("ok").path("lists");

    assertThat(lists).hasSize(1);
    assertThat(lists.get(0).path("name").asText()).isEqualTo("good");
  }
}
