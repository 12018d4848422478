package no.hials.crosscom.gateway;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.atomic.AtomicReference;
import no.hials.crosscom.cell.FileException;
import no.hials.crosscom.cell.RobotConnection;
import no.hials.crosscom.cell.TomlTable;
import no.hials.crosscom.cell.feed.Quality;
import no.hials.crosscom.cell.feed.RobotFeed;
import no.hials.crosscom.cell.feed.Update;
import no.hials.crosscom.mock.Fault;
import no.hials.crosscom.mock.MockServer;
import no.hials.crosscom.mock.junit.KukaController;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/** Changes of a configuration, and outputs that fail. */
@Timeout(60)
class GatewayTest {
  @KukaController private MockServer first;
  @KukaController private MockServer second;
  @TempDir private Path folder;
  private final List<String> events = Collections.synchronizedList(new ArrayList<>());
  private final BlockingQueue<Update> updates = new LinkedBlockingQueue<>();
  private volatile boolean occupied;
  private Gateway gateway;

  @AfterEach
  void close() {
    gateway.close();
  }

  /** Records its calls; throws with the setting {@code fails}. */
  private final class Notes implements OutputKind<String> {
    @Override
    public String table() {
      return "notes";
    }

    @Override
    public String read(TomlTable table) throws FileException {
      String text = table.text("text");
      return text == null ? "" : text;
    }

    @Override
    public Output open(String settings, GatewayContext context) throws IOException {
      if (settings.equals("throws")) {
        throw new IllegalStateException("broken");
      }
      if (settings.equals("cannot start") || occupied) {
        throw new IOException("the output cannot start");
      }
      if (settings.equals("has no thread")) {
        throw new OutOfMemoryError("simulated");
      }
      events.add("open " + settings);
      return new Output() {
        @Override
        public void ready() {
          if (settings.equals("waits")) {
            events.add("ready");
          }
        }

        @Override
        public void added(RobotFeed robot) {
          events.add("added " + robot.name());
        }

        @Override
        public void updated(RobotFeed robot, List<Update> some) {
          if (settings.equals("fails")) {
            events.add("failed");
            throw new IllegalStateException("broken");
          }
          if (settings.equals("has no memory")) {
            events.add("failed");
            throw new OutOfMemoryError("simulated");
          }
          updates.addAll(some);
        }

        @Override
        public void removed(RobotFeed robot) {
          events.add("removed " + robot.name());
        }

        @Override
        public void close() {
          events.add("close " + settings);
        }
      };
    }
  }

  private GatewayConfig config(String group, String notes, MockServer... robots)
      throws IOException {
    StringBuilder text = new StringBuilder();
    for (MockServer robot : robots) {
      text.append("[robots.%s]\n".formatted(robot == first ? "first" : "second"));
      text.append("host = \"%s:%d\"\n".formatted(robot.host(), robot.port()));
    }
    text.append(
        "[groups.all]\nperiod = \"50ms\"\non-change = true\nvariables = [%s]\n".formatted(group));
    text.append("[notes]\ntext = \"%s\"\n".formatted(notes));
    return GatewayConfig.read(
        TomlTable.parse(Path.of("plant.toml"), text.toString()), folder, Map.of(), kinds);
  }

  private final List<OutputKind<?>> kinds = List.of(new Notes());

  private void start(GatewayConfig config) throws IOException {
    gateway = Gateway.start(config, kinds, RobotConnection::openLazily);
  }

  private void await(String variable) throws InterruptedException {
    Update update = updates.take();
    while (!update.variable().name().equals(variable) || update.quality() != Quality.GOOD) {
      update = updates.take();
    }
  }

  private void awaitFailure() throws InterruptedException {
    while (!events.contains("failed")) {
      if (Thread.interrupted()) {
        throw new InterruptedException("the output was not called");
      }
      Thread.onSpinWait();
    }
  }

  private RobotFeed robot(String name) {
    return gateway.robots().stream().filter(it -> it.name().equals(name)).findAny().orElseThrow();
  }

  @Test
  void aRobotThatStaysIsNotInterruptedByAChange() throws Exception {
    start(config("\"$OV_PRO\"", "a", first));
    await("$OV_PRO");
    RobotFeed before = robot("first");

    gateway.apply(config("\"$OV_PRO\"", "a", first, second));

    assertThat(robot("first")).isSameAs(before);
    assertThat(events).containsExactly("open a", "added first", "added second");
    await("$OV_PRO");

    gateway.apply(config("\"$OV_PRO\"", "a", second));

    assertThat(events).endsWith("removed first");
    assertThat(gateway.robots()).extracting(RobotFeed::name).containsExactly("second");
  }

  @Test
  void aChangedGroupIsReadAtOnce() throws Exception {
    start(config("\"$OV_PRO\"", "a", first));
    await("$OV_PRO");

    gateway.apply(config("\"$OV_PRO\", \"MYINT\"", "a", first));

    await("MYINT");
  }

  @Test
  void aChangedOutputGetsWhatIsKnown() throws Exception {
    start(config("\"$OV_PRO\"", "a", first));
    await("$OV_PRO");
    RobotFeed before = robot("first");

    gateway.apply(config("\"$OV_PRO\"", "b", first));

    await("$OV_PRO"); // although it has not changed
    assertThat(robot("first")).isSameAs(before);
    assertThat(events).containsExactly("open a", "added first", "close a", "open b", "added first");
  }

  @Test
  void anOutputThatFailsDoesNotEndTheReadings() throws Exception {
    start(config("\"$OV_PRO\"", "fails", first));
    awaitFailure();

    gateway.apply(config("\"$OV_PRO\"", "a", first));

    await("$OV_PRO");
  }

  @Test
  void anErrorOfAnOutputDoesNotStopTheChecksOfAges() throws Exception {
    CountDownLatch released = new CountDownLatch(1);
    start(config("\"$OV_PRO\"", "has no memory", first));
    awaitFailure();
    events.clear();
    first.fault(request -> true, Fault.hold(released));
    // the timer passes on that the value is stale, and fails
    awaitFailure();
    released.countDown();
    first.clearFaults();
    gateway.apply(config("\"$OV_PRO\"", "a", first));
    await("$OV_PRO");

    CountDownLatch again = new CountDownLatch(1);
    first.fault(request -> true, Fault.hold(again));
    try {
      Update update = updates.take();
      while (update.quality() != Quality.STALE) {
        update = updates.take();
      }
      assertThat(update.reason()).isEqualTo("the controller has not answered in time");
    } finally {
      again.countDown();
    }
  }

  @Test
  void anOutputThatCannotStartLeavesTheOthersAlone() throws Exception {
    start(config("\"$OV_PRO\"", "a", first));
    GatewayConfig next = config("\"$OV_PRO\"", "cannot start", first, second);

    assertThatThrownBy(() -> gateway.apply(next)).hasMessage("the output cannot start");

    assertThat(gateway.robots()).hasSize(2);
  }

  @Test
  void anOutputThatIsBrokenDoesNotEndTheGateway() throws Exception {
    start(config("\"$OV_PRO\"", "a", first));
    GatewayConfig next = config("\"$OV_PRO\"", "throws", first, second);

    assertThatThrownBy(() -> gateway.apply(next))
        .isInstanceOf(IOException.class)
        .hasMessage("[notes] cannot start: java.lang.IllegalStateException: broken");

    assertThat(gateway.robots()).hasSize(2);
  }

  @Test
  void anOutputThatCouldNotStartIsTriedAgain() throws Exception {
    GatewayConfig before = config("\"$OV_PRO\"", "a", first);
    start(before);
    GatewayConfig next = config("\"$OV_PRO\"", "b", first);
    ConfigFollower follower = new ConfigFollower(gateway, before, () -> next);
    occupied = true;
    assertThat(follower.check()).isFalse();
    occupied = false;

    while (!follower.check()) {
      assertThat(events).endsWith("close a");
    }

    assertThat(events).endsWith("open b", "added first");
    assertThat(follower.check()).isFalse();
  }

  @Test
  void theConfigurationBeforeIsTakenAgainAfterOneThatCouldNotStart() throws Exception {
    GatewayConfig before = config("\"$OV_PRO\"", "a", first);
    start(before);
    AtomicReference<GatewayConfig> file =
        new AtomicReference<>(config("\"$OV_PRO\"", "cannot start", first));
    ConfigFollower follower = new ConfigFollower(gateway, before, file::get);
    assertThat(follower.check()).isFalse();

    file.set(before);

    assertThat(follower.check()).isTrue();
    assertThat(events).endsWith("close a", "open a", "added first");
  }

  @Test
  void anOutputIsReadyWhenTheRobotsAreAdded() throws Exception {
    start(config("\"$OV_PRO\"", "waits", first, second));

    assertThat(events).hasSize(4).endsWith("ready");

    gateway.apply(config("\"$OV_PRO\"", "waits", first));

    assertThat(events).hasSize(5);
  }

  @Test
  void anErrorOfANewOutputDoesNotEndTheGateway() throws Exception {
    start(config("\"$OV_PRO\"", "old", first));
    GatewayConfig next = config("\"$OV_PRO\"", "has no thread", first);
    ConfigFollower follower =
        new ConfigFollower(gateway, config("\"$OV_PRO\"", "old", first), () -> next);

    assertThat(follower.check()).isFalse();
    assertThat(gateway.robots()).hasSize(1);
  }
}
