package no.hials.crosscom.kafka.internal;

import java.io.Closeable;
import java.io.IOException;
import java.time.Duration;
import java.time.Instant;
import java.util.Map;
import java.util.Objects;
import java.util.Queue;
import java.util.function.BooleanSupplier;
import no.hials.crosscom.cell.RobotConnection;
import no.hials.crosscom.cell.feed.PollPlan;
import no.hials.crosscom.cell.feed.Quality;
import no.hials.crosscom.cell.feed.RobotFeed;
import no.hials.crosscom.cell.feed.Update;
import no.hials.crosscom.kafka.internal.SampleRecords.Gap;
import org.apache.kafka.connect.data.Struct;
import org.jspecify.annotations.Nullable;

/**
 * One robot of a task: its feed, the samples that wait for Connect, and the gaps between them. The
 * feed calls it on its own threads; all other methods are for the thread of the task.
 */
public final class RobotSource implements Closeable {
  /** The key of the robot in the partition of a source offset. */
  public static final String PARTITION = "robot";

  private static final String RUN = "run";
  private static final String SEQUENCE = "sequence";
  private static final String TIME = "time";

  private static final String WITHOUT_LEASE = "the task does not use the robot: it has no lease";

  /** The robot is connected again soon after its lease was lost and is held again. */
  private static final Duration LONGEST_BACKOFF = Duration.ofSeconds(1);

  private static final long REPORT_NANOS = 1_000_000_000;

  private final PollPlan plan;
  private final Queue<Item> queue;
  private final long run;
  private @Nullable RobotFeed feed;

  // used by the thread of the task only
  private long sequence;
  private long lastMillis;
  private long missedBefore;
  private long droppedBefore;
  private long missed;
  private long reported = System.nanoTime();

  // guarded by this
  private Instant lastTime;
  private @Nullable OpenGap gap;
  private long lost;

  /**
   * A sample or a gap that waits for Connect.
   *
   * @param robot the robot
   * @param update the sample; null for a gap
   * @param gap the gap; null for a sample
   */
  public record Item(RobotSource robot, @Nullable Update update, @Nullable Gap gap) {
    /** Returns the time of the sample, or of the end of the gap. */
    public Instant time() {
      return gap != null ? gap.to() : Objects.requireNonNull(update).time();
    }
  }

  /** A gap that the next sample ends. */
  private static final class OpenGap {
    private final Instant from;
    private final String reason;
    private boolean unread;
    private long lost;

    OpenGap(Instant from, String reason) {
      this.from = from;
      this.reason = reason;
    }
  }

  /**
   * Creates the source of a robot.
   *
   * @param queue a bounded queue for all robots of the task
   * @param stored the last source offset of the robot; null if it has none
   */
  public RobotSource(PollPlan plan, Queue<Item> queue, @Nullable Map<String, ?> stored) {
    this.plan = plan;
    this.queue = queue;
    long now = System.currentTimeMillis();
    if (stored == null) {
      run = now;
      lastTime = Instant.ofEpochMilli(now);
    } else {
      // a clock that was set back must not repeat the number of a run
      run = Math.max(now, number(stored, RUN) + 1);
      lastTime = Instant.ofEpochMilli(number(stored, TIME));
      lastMillis = lastTime.toEpochMilli();
      OpenGap since =
          new OpenGap(
              lastTime,
              "a task has started; the run before was stored up to "
                  + number(stored, RUN)
                  + "/"
                  + number(stored, SEQUENCE));
      since.unread = true;
      gap = since;
    }
  }

  private static long number(Map<String, ?> offset, String key) {
    return offset.get(key) instanceof Number number ? number.longValue() : 0;
  }

  /** Returns the name of the robot. */
  public String name() {
    return plan.robot().name();
  }

  /** Returns the partition of its source offset. */
  public Map<String, String> partition() {
    return Map.of(PARTITION, name());
  }

  /** Returns the source offset of the last record. */
  public Map<String, Object> offset() {
    return Map.of(RUN, run, SEQUENCE, sequence, TIME, lastMillis);
  }

  /**
   * Starts to read.
   *
   * @param allowed asked before each access
   */
  public void open(BooleanSupplier allowed) throws IOException {
    RobotFeed opened =
        RobotFeed.open(
            plan,
            (robot, settings) ->
                RobotConnection.openLazily(
                    robot,
                    settings.andThen(
                        cfg ->
                            cfg.accessIf(allowed)
                                .reconnectBackoff(Duration.ofMillis(100), LONGEST_BACKOFF))),
            (robot, updates) ->
                updates.forEach(update -> add(allowed.getAsBoolean() ? update : unused(update))));
    feed = opened;
    opened.start();
  }

  /** Returns whether the robot is connected. */
  public boolean isConnected() {
    return feed != null && feed.isConnected();
  }

  /** Returns the number of readings that were left out, as counted in the gaps. */
  public long missed() {
    return missed;
  }

  /** Returns the number of samples that were dropped. */
  public synchronized long lost() {
    return lost;
  }

  /** Returns a stale sample with the reason, which the client does not know: there is no lease. */
  private static Update unused(Update update) {
    return update.quality() == Quality.STALE
        ? new Update(
            update.variable(), update.time(), update.quality(), update.value(), WITHOUT_LEASE)
        : update;
  }

  private synchronized void add(Update update) {
    if (closeGap(update.time()) && queue.offer(new Item(this, update, null))) {
      lastTime = later(lastTime, update.time());
    } else {
      lose(1, "the buffer of the task was full");
    }
  }

  /** Returns the later time. Ignores a time in the future, since the clock was set back. */
  private static Instant later(Instant before, Instant time) {
    return time.isAfter(before) || before.isAfter(Instant.now()) ? time : before;
  }

  private void lose(long count, String reason) {
    if (gap == null) {
      gap = new OpenGap(lastTime, reason);
    }
    gap.lost += count;
    lost += count;
  }

  /** Puts the open gap into the queue, if there is one; returns false if the queue is full. */
  private boolean closeGap(Instant to) {
    OpenGap open = gap;
    if (open == null) {
      return true;
    }
    Instant end = to.isBefore(open.from) ? open.from : to;
    long unread = open.unread ? readings(open.from, end) : 0;
    boolean queued =
        queue.offer(new Item(this, null, new Gap(open.from, end, unread, open.lost, open.reason)));
    if (queued) {
      gap = null;
    }
    return queued;
  }

  /** Returns the number of readings that the plan has between two times. */
  private long readings(Instant from, Instant to) {
    long millis = Duration.between(from, to).toMillis();
    return plan.reads().keySet().stream().mapToLong(period -> millis / period.toMillis()).sum();
  }

  /** Begins a gap. Called when the robot, which was not read for a while, is read again. */
  public void resumed(String reason) {
    RobotFeed own = feed;
    if (own != null) {
      missedBefore = own.missedPolls();
    }
    synchronized (this) {
      if (gap == null) {
        gap = new OpenGap(lastTime, reason);
      }
      gap.unread = true;
    }
  }

  /** Marks overdue variables as stale, and reports readings left out and samples dropped. */
  public void check() {
    RobotFeed own = feed;
    if (own == null) {
      return;
    }
    own.checkAges();
    long now = System.nanoTime();
    if (now - reported < REPORT_NANOS) {
      return;
    }
    reported = now;
    long left = own.missedPolls() - missedBefore;
    long dropped = own.droppedSamples() - droppedBefore;
    missedBefore += left;
    droppedBefore += dropped;
    synchronized (this) {
      Instant time = Instant.now();
      if (left > 0) {
        String reason = "the robot or this computer was too slow for the period";
        Item item = new Item(this, null, new Gap(lastTime, time, left, 0, reason));
        if (!queue.offer(item)) {
          missedBefore -= left;
        }
      }
      if (dropped > 0) {
        lose(dropped, "this computer was too slow for the samples");
      }
      if (gap != null && gap.lost > 0) {
        boolean unused = closeGap(time);
      }
    }
  }

  /** Returns the record value of a queued item, and counts the item. */
  public Struct take(Item item, SampleRecords records) {
    sequence++;
    lastMillis = later(Instant.ofEpochMilli(lastMillis), item.time()).toEpochMilli();
    Gap of = item.gap;
    if (of != null) {
      missed += of.missed();
      return SampleRecords.of(name(), of, run, sequence);
    }
    return records.of(name(), Objects.requireNonNull(item.update), run, sequence);
  }

  @Override
  public void close() throws IOException {
    if (feed != null) {
      feed.close();
    }
  }
}
