package no.hials.crosscom.web.internal.robot;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CountDownLatch;
import no.hials.crosscom.ClientConfig;
import no.hials.crosscom.CrossComClient;
import no.hials.crosscom.cell.Robot;
import no.hials.crosscom.mock.MockServer;
import no.hials.crosscom.mock.RecordedRequest;
import no.hials.crosscom.mock.junit.KukaController;
import no.hials.crosscom.web.internal.socket.Call;
import no.hials.crosscom.web.internal.socket.Commands;
import no.hials.crosscom.web.internal.socket.Json;
import no.hials.crosscom.web.internal.socket.Sockets;
import no.hials.crosscom.web.internal.socket.Viewer;
import no.hials.crosscom.web.internal.socket.Viewers;
import org.eclipse.jetty.server.Server;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

@Timeout(60)
class LockTest {
  @KukaController private MockServer server;

  @Test
  void aChangeThatWasCheckedIsNotSentAfterTheRobotIsLocked() throws Exception {
    Lock lock = new Lock(new Robot("mock", null, 0, null, null, null, null), false);
    lock.open("somebody");
    Thread closing = new Thread(lock::close);
    CountDownLatch idle = new CountDownLatch(1);
    String result = "done";
    Commands commands = new Commands();
    try (Sockets sockets = new Sockets(new Server(), commands);
        CrossComClient client =
            new CrossComClient(
                ClientConfig.create(server.host(), cfg -> cfg.port(server.port())))) {
      CompletableFuture<Void> busy = client.asyncRun(it -> await(idle));
      Viewer viewer = Viewers.create(commands, sockets);
      try {
        String unused =
            lock.send(
                new Call(viewer, Json.object().put("clock", Call.now()).put("confirmed", true)),
                "write MYINT",
                sendIf -> {
                  closing.start();
                  while (closing.isAlive() && closing.getState() != Thread.State.BLOCKED) {
                    Thread.onSpinWait();
                  }
                  CompletableFuture<String> change = client.async(it -> it.writeText("MYINT", "5"));
                  if (!closing.isAlive()) { // the robot is locked for its page
                    idle.countDown();
                    while (!change.isDone()) {
                      Thread.onSpinWait();
                    }
                  }
                  return change;
                });
      } catch (IOException e) {
        result = e.getMessage();
      }
      closing.join();
      idle.countDown();
      busy.join();
    }

    assertThat(result).isEqualTo("did not write MYINT: the robot is locked");
    assertThat(server.requests()).filteredOn(RecordedRequest::isWrite).isEmpty();
  }

  private static void await(CountDownLatch latch) throws IOException {
    try {
      latch.await();
    } catch (InterruptedException e) {
      throw new IOException(e);
    }
  }
}
