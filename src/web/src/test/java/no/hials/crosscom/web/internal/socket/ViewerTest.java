package no.hials.crosscom.web.internal.socket;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Clock;
import java.util.ArrayList;
import java.util.List;
import no.hials.crosscom.web.Role;
import no.hials.crosscom.web.internal.http.BrowserSession;
import no.hials.crosscom.web.internal.http.Tokens;
import org.eclipse.jetty.server.Server;
import org.eclipse.jetty.websocket.api.Callback;
import org.junit.jupiter.api.Test;

class ViewerTest {
  @Test
  void aTaskThatFailsAtTheEndOfAPageKeepsNoOtherFromRunning() {
    Tokens tokens = new Tokens(Clock.systemUTC());
    assertThat(tokens.open(tokens.newLink(Role.VIEW))).isPresent();
    BrowserSession browser = tokens.browsers().get(0);
    Commands commands = new Commands();
    try (Sockets sockets = new Sockets(new Server(), commands)) {
      Viewer viewer = new Viewer(browser, commands, Runnable::run, sockets);
      List<String> done = new ArrayList<>();
      viewer.atClose(() -> done.add("first"));
      viewer.atClose(
          () -> {
            throw new IllegalStateException("a task that fails");
          });
      viewer.atClose(() -> done.add("last"));

      viewer.onWebSocketClose(1000, null, Callback.NOOP);

      assertThat(done).containsExactly("first", "last");
    }
  }
}
