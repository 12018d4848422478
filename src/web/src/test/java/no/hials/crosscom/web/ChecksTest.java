package no.hials.crosscom.web;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import java.io.IOException;
import java.nio.file.Path;
import no.hials.crosscom.protocol.ServerType;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** The checks of why a robot does not move, as a page receives them. */
class ChecksTest {
  @TempDir private Path folder;
  private TestPages pages;
  private TestSocket socket;

  @AfterEach
  void stop() throws IOException {
    socket.close();
    pages.close();
  }

  private void start(ServerType server) throws Exception {
    pages = TestPages.start(server, folder, cfg -> {});
    socket = pages.open(Role.VIEW);
    assertThat(socket.call("checks", "robot", "'mock'", "on", "true").has("ok")).isTrue();
  }

  private JsonNode awaitCheck(String name, String state) throws InterruptedException {
    return socket.await(
        event -> {
          for (JsonNode check : event.path("checks")) {
            if (check.path("name").asText().equals(name)
                && check.path("state").asText().equals(state)) {
              return true;
            }
          }
          return false;
        });
  }

  @ParameterizedTest
  @EnumSource(ServerType.class)
  void aChangeOnTheControllerIsInTheNextChecks(ServerType server) throws Exception {
    start(server);
    JsonNode event = awaitCheck("Override", "ok");
    assertThat(event.path("robot").asText()).isEqualTo("mock");
    assertThat(event.path("moving").asBoolean(true)).isFalse();

    pages.controller().variables().set("$OV_PRO", "0");

    awaitCheck("Override", "problem");
  }

  @Test
  void aServerThatIsGoneIsAProblem() throws Exception {
    start(ServerType.C3_BRIDGE);
    awaitCheck("Server", "ok");

    pages.controller().refuseConnections();
    pages.controller().disconnectClients();

    awaitCheck("Server", "problem");
  }

  @Test
  void nothingIsSentToWhoDoesNotLook() throws Exception {
    start(ServerType.C3_BRIDGE);
    awaitCheck("Override", "ok");

    socket.call("checks", "robot", "'mock'", "on", "false");
    pages.controller().variables().set("$OV_PRO", "0");

    socket.await(
        it -> {
          assertThat(it.path("checks").toString()).doesNotContain("at 0 % nothing moves");
          return it.path("override").asText().equals("0");
        });
  }
}
