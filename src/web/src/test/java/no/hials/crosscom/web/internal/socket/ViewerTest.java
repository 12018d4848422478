package no.hials.crosscom.web.internal.socket;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import org.eclipse.jetty.server.Server;
import org.eclipse.jetty.websocket.api.Callback;
import org.junit.jupiter.api.Test;

class ViewerTest {
  @Test
  void aTaskThatFailsAtTheEndOfAPageKeepsNoOtherFromRunning() {
    Commands commands = new Commands();
    try (Sockets sockets = new Sockets(new Server(), commands)) {
      Viewer viewer = Viewers.create(commands, sockets);
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
