package no.hials.crosscom.mock;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Clock;
import java.time.Instant;
import java.time.ZoneId;
import java.time.ZoneOffset;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.atomic.AtomicReference;
import no.hials.crosscom.protocol.Codec;
import no.hials.crosscom.protocol.ServerType;
import no.hials.crosscom.protocol.code.Code;
import no.hials.crosscom.protocol.code.Interpreter;
import no.hials.crosscom.protocol.code.ProgramCommand;
import no.hials.crosscom.protocol.program.ProgramRequest.ProgramSelectRequest;
import no.hials.crosscom.protocol.program.ProgramResponse;
import no.hials.crosscom.simulator.FileTree;
import no.hials.crosscom.simulator.KrlFileException;
import no.hials.crosscom.simulator.SimulationClock;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/** Tests that one client or file cannot stop the server for the others. */
@Timeout(value = 120, threadMode = Timeout.ThreadMode.SEPARATE_THREAD)
final class HostileClientTest {
  private static final String MAIN = "DEF MAIN()\nEND\n";

  @TempDir private Path folder;

  /** A clock whose next reading waits until it is released. */
  private static final class SlowClock extends Clock {
    private final CountDownLatch entered = new CountDownLatch(1);
    private final CountDownLatch released = new CountDownLatch(1);
    private volatile boolean slow;

    @Override
    public ZoneId getZone() {
      return ZoneOffset.UTC;
    }

    @Override
    public Clock withZone(ZoneId zone) {
      throw new UnsupportedOperationException();
    }

    @Override
    public Instant instant() {
      if (slow) {
        entered.countDown();
        try {
          released.await();
        } catch (InterruptedException e) {
          Thread.currentThread().interrupt();
        }
      }
      return Instant.EPOCH;
    }
  }

  private static MockServer start(FileTree files) throws IOException {
    return MockServer.start(
        cfg -> cfg.server(ServerType.C3_BRIDGE).files(files).clock(SimulationClock.stepped()));
  }

  private static ProgramSelectRequest select(String name) {
    return new ProgramSelectRequest(
        1, Code.of(ProgramCommand.SELECT), Code.of(Interpreter.SUBMIT), name, "", false);
  }

  private static boolean selects(RawClient client, String name) throws IOException {
    return ((ProgramResponse) client.exchange(select(name))).tail().success();
  }

  @Test
  void othersAreServedWhileAProgramIsLoaded() throws Exception {
    SlowClock clock = new SlowClock();
    FileTree files = FileTree.inMemory(clock, FileTree.DEFAULT_CAPACITY);
    try (MockServer server = start(files);
        RawClient client = new RawClient(server);
        RawClient other = new RawClient(server)) {
      server.controller();
      files.put("/R1/MAIN.SRC", MAIN);
      clock.slow = true;
      try {
        client.send(Codec.encode(select("MAIN")));
        clock.entered.await();
        assertThat(other.read("$OV_PRO").value()).isEqualTo("100");
      } finally {
        clock.released.countDown();
      }
      assertThat(((ProgramResponse) client.response()).tail().success()).isTrue();
    }
  }

  @Test
  void aListOfLargeArraysIsRefused() throws Exception {
    StringBuilder list = new StringBuilder("DEFDAT BOMB PUBLIC\n");
    for (int i = 0; i < 100; i++) {
      list.append("DECL GLOBAL INT A").append(i).append("[1000000]\n");
    }
    assertNotLoaded(list + "ENDDAT\n", "A99");
  }

  @Test
  void anArrayOfLargeStructuresIsRefused() throws Exception {
    assertNotLoaded(
        """
        DEFDAT BOMB PUBLIC
        GLOBAL STRUC LARGE INT N[1000000]
        DECL GLOBAL LARGE A99[1000000]
        ENDDAT
        """,
        "A99");
  }

  private static void assertNotLoaded(String list, String name) throws IOException {
    FileTree files = FileTree.inMemory();
    try (MockServer server = start(files);
        RawClient client = new RawClient(server)) {
      files.put("/R1/BOMB.DAT", list);
      files.put("/R1/MAIN.SRC", MAIN);
      assertThat(selects(client, "MAIN")).isTrue();
      assertThat(server.variables().contains(name)).isFalse();
    }
  }

  @Test
  void theVariablesOfAllModulesShareTheMemory() throws Exception {
    FileTree files = FileTree.inMemory();
    try (MockServer server = start(files);
        RawClient client = new RawClient(server)) {
      for (String name : new String[] {"P1", "P2", "P3"}) {
        files.put("/R1/" + name + ".DAT", "DEFDAT " + name + "\nINT A[900000]\nENDDAT\n");
        files.put("/R1/" + name + ".SRC", "DEF " + name + "()\nA[1]=1\nEND\n");
      }
      assertThat(selects(client, "P1")).isTrue();
      assertThat(selects(client, "P2")).isTrue();
      assertThat(selects(client, "P3")).isFalse();
    }
  }

  @Test
  void aFileThatCannotBeReadStopsOnlyItsOwnSelection() throws Exception {
    FileTree files = FileTree.over(folder, Clock.systemUTC(), 1 << 20);
    try (MockServer server = start(files);
        RawClient client = new RawClient(server)) {
      files.put("/R1/MAIN.SRC", MAIN);
      Files.write(folder.resolve("R1/Program/poison.src"), new byte[3 << 20]);
      assertThat(selects(client, "POISON")).isFalse();
      assertThat(selects(client, "MAIN")).isTrue();
    }
  }

  @Test
  void anErrorEndsOneConnectionAndIsNotUncaught() throws Exception {
    AtomicReference<Throwable> uncaught = new AtomicReference<>();
    Thread.UncaughtExceptionHandler before = Thread.getDefaultUncaughtExceptionHandler();
    Thread.setDefaultUncaughtExceptionHandler((thread, e) -> uncaught.set(e));
    try (MockServer server = MockServer.start();
        RawClient client = new RawClient(server);
        RawClient other = new RawClient(server)) {
      server.faults(
          request -> {
            throw new StackOverflowError("thrown by a test");
          });
      client.send("00 09 00 07 00 00 04 50 49 4E 47");
      assertThat(client.receiveAll()).isEmpty();
      server.clearFaults();
      assertThat(other.read("PING").value()).isEqualTo("PONG");
    } finally {
      Thread.setDefaultUncaughtExceptionHandler(before);
    }
    assertThat(uncaught).hasNullValue();
  }

  @Test
  void aListThatIsTooLargeIsRefusedBeforeItIsParsed() throws Exception {
    String large = "DEFDAT $CONFIG\n" + "\n".repeat(32 << 20) + "ENDDAT\n";
    try (MockServer server = MockServer.start()) {
      assertThatExceptionOfType(KrlFileException.class)
          .isThrownBy(() -> server.controller().load("$config.dat", large))
          .withMessageContaining("at most 33554432 bytes");
      Path file = Files.writeString(folder.resolve("$config.dat"), large);
      assertThatExceptionOfType(KrlFileException.class)
          .isThrownBy(() -> server.controller().load(file))
          .withMessageContaining("at most 33554432 bytes");
    }
  }
}
