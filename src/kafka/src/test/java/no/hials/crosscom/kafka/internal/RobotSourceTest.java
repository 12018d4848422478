package no.hials.crosscom.kafka.internal;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.time.Instant;
import java.util.HashSet;
import java.util.Map;
import java.util.Objects;
import java.util.Set;
import java.util.concurrent.ArrayBlockingQueue;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicBoolean;
import no.hials.crosscom.cell.feed.PollPlan;
import no.hials.crosscom.cell.feed.Quality;
import no.hials.crosscom.cell.feed.Update;
import no.hials.crosscom.kafka.internal.RobotSource.Item;
import no.hials.crosscom.kafka.internal.SampleRecords.Gap;
import no.hials.crosscom.mock.Fault;
import no.hials.crosscom.mock.MockServer;
import no.hials.crosscom.mock.junit.KukaController;
import org.apache.kafka.connect.data.Struct;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** The samples of one robot and the gaps between them. */
@Timeout(60)
class RobotSourceTest {
  private static final Map<String, ?> STORED = Map.of("run", 5L, "sequence", 70L, "time", 1000L);

  private static final String SLOW_GROUP =
      "[groups.other]\nvariables = [\"$MODE_OP\"]\nperiod = \"200ms\"";

  private static final Duration SLOW_ANSWER = Duration.ofMillis(1100);

  @KukaController private MockServer robot;
  private final SampleRecords records = new SampleRecords();

  private PollPlan plan() throws Exception {
    return plan("");
  }

  /**
   * Returns the plan of a robot that is read every 10 ms.
   *
   * @param more more groups
   */
  private PollPlan plan(String more) throws Exception {
    String text =
        """
        [robots.r1]
        host = "%s"
        port = %d
        [groups.all]
        variables = ["$OV_PRO"]
        period = "10ms"
        %s
        [limits]
        load = 100
        """
            .formatted(robot.host(), robot.port(), more);
    return PlantText.read("plant.toml", text).plans().get(0);
  }

  private static Item next(BlockingQueue<Item> queue) throws InterruptedException {
    return Objects.requireNonNull(queue.poll(30, TimeUnit.SECONDS));
  }

  @Test
  void theFirstRecordTellsOfTheGapSinceTheStoredOffset() throws Exception {
    BlockingQueue<Item> queue = new ArrayBlockingQueue<>(100);
    try (RobotSource source = new RobotSource(plan(), queue, STORED)) {
      source.open(() -> true);
      Gap gap = Objects.requireNonNull(next(queue).gap());
      assertThat(gap.from().toEpochMilli()).isEqualTo(1000);
      // those between the offset and the first reading, which may be due at the same millisecond
      assertThat(gap.missed()).isEqualTo((gap.to().toEpochMilli() - 1000 - 1) / 10);
      assertThat(gap.reason()).contains("5/70");
    }
  }

  @Test
  void aRobotWithoutAnOffsetBeginsWithASample() throws Exception {
    BlockingQueue<Item> queue = new ArrayBlockingQueue<>(100);
    try (RobotSource source = new RobotSource(plan(), queue, null)) {
      source.open(() -> true);
      Struct value = source.take(next(queue), records);
      assertThat(value.getMap("numbers")).isEqualTo(Map.of("value", 100.0));
      assertThat(value.getMap("units")).isEqualTo(Map.of("value", "%"));
      assertThat(value.getInt64("sequence")).isEqualTo(1);
      assertThat(source.offset()).containsEntry("sequence", 1L);
      value.validate();
    }
  }

  @Test
  void samplesThatFindTheBufferFullAreCountedAndToldOf() throws Exception {
    BlockingQueue<Item> queue = new ArrayBlockingQueue<>(2);
    try (RobotSource source = new RobotSource(plan(), queue, null)) {
      source.open(() -> true);
      while (source.lost() < 3) {
        Thread.onSpinWait();
      }
      long told = 0;
      for (Item item = next(queue); told == 0; item = next(queue)) {
        Struct value = source.take(item, records);
        Struct gap = value.getStruct("gap");
        told = gap == null ? 0 : gap.getInt64("lost");
      }
      assertThat(told).isGreaterThanOrEqualTo(3);
    }
  }

  @Test
  void aLeaseThatIsLostAndHeldAgainIsAGap() throws Exception {
    BlockingQueue<Item> queue = new ArrayBlockingQueue<>(10_000);
    AtomicBoolean held = new AtomicBoolean(true);
    try (RobotSource source = new RobotSource(plan(), queue, null)) {
      source.open(held::get);
      Item before = next(queue);
      held.set(false);
      Item item = next(queue);
      while (isGood(item)) {
        item = next(queue);
      }
      assertThat(item.update().reason())
          .isEqualTo("the task does not use the robot: it has no lease");
      source.resumed("held again");
      held.set(true);
      item = next(queue);
      // and a second reason if the robot was due just before the lease was held
      assertThat(item.gap().reason()).startsWith("held again");
      assertThat(item.gap().from()).isAfterOrEqualTo(before.time());
    }
  }

  @Test
  void readingsLeftOutWhileTheLeaseIsLostAreCountedOnce() throws Exception {
    BlockingQueue<Item> queue = new ArrayBlockingQueue<>(10_000);
    AtomicBoolean held = new AtomicBoolean(true);
    try (RobotSource source = new RobotSource(plan(), queue, null)) {
      source.open(held::get);
      Item before = next(queue);
      // as in a process that is frozen during an access, and longer than the lease
      robot.fault(request -> held.getAndSet(false), Fault.delay(Duration.ofMillis(1500)));
      long read = 0;
      Item item = before;
      while (item.update().quality() != Quality.STALE) {
        read++;
        item = next(queue);
      }
      robot.clearFaults();
      source.check();
      source.resumed("frozen");
      held.set(true);
      long missed = 0;
      boolean resumed = false;
      while (!resumed || !isGood(item)) {
        source.check();
        read += isGood(item) ? 1 : 0;
        if (item.gap() != null) {
          missed += item.gap().missed();
          resumed |= item.gap().reason().contains("frozen");
        }
        item = next(queue);
      }
      long planned = Duration.between(before.time(), item.time()).toMillis() / 10;
      assertThat(planned).isGreaterThanOrEqualTo(150);
      assertThat(read + missed).isBetween(planned - 5, planned + 5);
    }
  }

  @Test
  void aGapThatNoSampleEndsIsReportedAndOffsetsGoOn() throws Exception {
    BlockingQueue<Item> queue = new ArrayBlockingQueue<>(10_000);
    try (RobotSource source = new RobotSource(plan("on-change = true"), queue, null)) {
      source.open(() -> true);
      var unused = source.take(next(queue), records);
      source.resumed("held again");
      Item item = queue.poll();
      while (item == null) {
        source.check();
        item = queue.poll(10, TimeUnit.MILLISECONDS);
      }
      assertThat(item.gap().reason()).isEqualTo("held again");
      unused = source.take(item, records);

      Map<String, Object> offset = source.quietOffset();
      while (offset == null) {
        offset = source.quietOffset();
      }
      assertThat((long) offset.get("read.10")).isGreaterThan(item.gap().to().toEpochMilli());
    }
  }

  @Test
  void eachPeriodHasAGapFromItsOwnLastReading() throws Exception {
    BlockingQueue<Item> queue = new ArrayBlockingQueue<>(10_000);
    AtomicBoolean held = new AtomicBoolean(true);
    try (RobotSource source = new RobotSource(plan(SLOW_GROUP), queue, null)) {
      source.open(held::get);
      Set<String> read = new HashSet<>();
      while (read.size() < 2) { // a period that was never read has no gap
        Update update = next(queue).update();
        if (update != null) {
          read.add(update.variable().key());
        }
      }
      held.set(false);
      TimeUnit.MILLISECONDS.sleep(1000);
      Instant resumed = Instant.now();
      source.resumed("held again");
      held.set(true);

      Instant end = resumed.plusMillis(1000);
      long missed = 0;
      Duration shortest = Duration.ofDays(1);
      for (Item item = next(queue); item.time().isBefore(end); item = next(queue)) {
        Gap gap = item.gap();
        if (gap != null && gap.from().isBefore(resumed) && gap.to().isAfter(resumed)) {
          missed += gap.missed();
          Duration length = Duration.between(gap.from(), gap.to());
          shortest = length.compareTo(shortest) < 0 ? length : shortest;
        }
      }
      assertThat(missed).as("100 of one period and 5 of the other").isBetween(90L, 200L);
      assertThat(shortest).isGreaterThan(Duration.ofMillis(700));
    }
  }

  private static boolean isGood(Item item) {
    return item.update() != null && item.update().quality() == Quality.GOOD;
  }

  @Test
  void readingsLeftOutByASlowRobotAreToldBeforeTheNextSample() throws Exception {
    BlockingQueue<Item> queue = new ArrayBlockingQueue<>(10_000);
    try (RobotSource source = new RobotSource(plan(), queue, null)) {
      source.open(() -> true);
      Item first = next(queue);
      Item before = first;
      answerSlowly();
      Item item = next(queue);
      while (!isLongGap(item)) {
        assertThat(Duration.between(before.time(), item.time())).isLessThan(SLOW_ANSWER);
        before = item;
        item = next(queue);
      }
      assertThat(item.gap().reason())
          .isEqualTo(
              "the robot or this computer was too slow for the period, or the process was frozen");
      assertThat(item.gap().from()).isAfterOrEqualTo(first.time());
      assertThat(item.gap().to()).isAfter(item.gap().from()).isBeforeOrEqualTo(next(queue).time());
    }
  }

  @Test
  void aGapOfASlowRobotHasTheTimeOfItsReadingsWithTwoPeriodsToo() throws Exception {
    BlockingQueue<Item> queue = new ArrayBlockingQueue<>(10_000);
    try (RobotSource source = new RobotSource(plan(SLOW_GROUP), queue, null)) {
      source.open(() -> true);
      next(queue);
      answerSlowly();
      Item item = next(queue);
      while (!isLongGap(item)) {
        item = next(queue);
      }
      assertThat(Duration.between(item.gap().from(), item.gap().to()))
          .isGreaterThan(Duration.ofSeconds(1));
    }
  }

  /** Delays the next answer of the robot by {@link #SLOW_ANSWER}. */
  private void answerSlowly() {
    AtomicBoolean slow = new AtomicBoolean(true);
    robot.fault(request -> slow.getAndSet(false), Fault.delay(SLOW_ANSWER));
  }

  private static boolean isLongGap(Item item) {
    return item.gap() != null && item.gap().missed() >= 100;
  }

  @Test
  void aGapAfterTheClockWasSetBackBeginsWithTheLastSample() throws Exception {
    BlockingQueue<Item> queue = new ArrayBlockingQueue<>(10_000);
    long ahead = System.currentTimeMillis() + 3_600_000;
    Map<String, Object> stored = Map.of("run", 5L, "sequence", 70L, "time", ahead);
    try (RobotSource source = new RobotSource(plan(), queue, stored)) {
      source.open(() -> true);
      var unused = source.take(next(queue), records);
      Item sample = next(queue);
      source.resumed("held again");
      Item item = sample;
      while (item.gap() == null) {
        unused = source.take(item, records);
        item = next(queue);
      }
      assertThat(item.gap().from()).isBetween(sample.time(), item.gap().to());
      assertThat((long) source.offset().get("time")).isBetween(1L, ahead - 1);
    }
  }
}
