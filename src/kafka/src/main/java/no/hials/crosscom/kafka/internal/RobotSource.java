package no.hials.crosscom.kafka.internal;

import java.io.Closeable;
import java.io.IOException;
import java.time.Duration;
import java.time.Instant;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Queue;
import java.util.function.BooleanSupplier;
import no.hials.crosscom.cell.RobotConnection;
import no.hials.crosscom.cell.feed.FeedListener;
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

  private static final String TOO_SLOW =
      "the robot or this computer was too slow for the period, or the process was frozen";

  /** The robot is connected again soon after its lease was lost and is held again. */
  static final Duration LONGEST_BACKOFF = Duration.ofSeconds(1);

  private final PollPlan plan;
  private final Queue<Item> queue;
  private final long run;
  private @Nullable RobotFeed feed;

  // used by the thread of the task only
  private long sequence;
  private long lastMillis;
  private long missed;
  private Map<String, Long> stored = Map.of();

  // guarded by this
  private final MissedReadings readings;

  /** The time of the last sample, or of the end of the last gap. */
  private Instant lastTime;

  /** When the last reading began. */
  private Instant lastRead;

  /** Why readings are counted by the time. */
  private String unreadReason = TOO_SLOW;

  private @Nullable OpenGap gap;
  private long lost;

  /** The number of items in the queue, or taken from it but not passed to {@link #take}. */
  private int waiting;

  /** The samples that the feed has dropped, as counted in the gaps. */
  private long dropped;

  /**
   * A sample or a gap that waits for Connect.
   *
   * @param robot the robot
   * @param update the sample; null for a gap
   * @param gap the gap; null for a sample
   * @param stored up to when readings are counted by this item and those before it
   */
  public record Item(
      RobotSource robot, @Nullable Update update, @Nullable Gap gap, Map<String, Long> stored) {
    /** Returns the time of the sample, or of the end of the gap. */
    public Instant time() {
      return gap != null ? gap.to() : Objects.requireNonNull(update).time();
    }
  }

  /** A gap that the next sample ends. */
  private static final class OpenGap {
    private Instant from;
    private String reason;
    private long missed;
    private long lost;

    /** Whether the robot has been read since, so that the gap cannot become longer. */
    private boolean ended;

    OpenGap(Instant from, String reason) {
      this.from = from;
      this.reason = reason;
    }

    /** Returns whether the gap can be reported, also if no sample follows. */
    boolean isComplete() {
      return lost > 0 || ended;
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
    this.readings = new MissedReadings(plan.reads().keySet());
    long now = System.currentTimeMillis();
    if (stored == null) {
      run = now;
      lastTime = Instant.ofEpochMilli(now);
    } else {
      // a clock that was set back must not repeat the number of a run
      run = Math.max(now, number(stored, RUN) + 1);
      lastTime = Instant.ofEpochMilli(number(stored, TIME));
      lastMillis = lastTime.toEpochMilli();
      readings.restore(stored, lastTime);
      unreadReason =
          "a task has started; the run before was stored up to "
              + number(stored, RUN)
              + "/"
              + number(stored, SEQUENCE);
      gap = new OpenGap(lastTime, unreadReason);
    }
    lastRead = lastTime;
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

  /**
   * Returns the source offset up to the last reading, if it has told nothing new: values that stay
   * the same, or attempts to read a robot that is off.
   *
   * @return null if there was no record yet, one waits, or the last offset says the same
   */
  public synchronized @Nullable Map<String, Object> quietOffset() {
    Map<String, Long> current = readings.stored();
    if (sequence == 0 || waiting > 0 || gap != null || current.equals(stored)) {
      return null;
    }
    stored = current;
    return offset();
  }

  /** Returns the source offset of the last record. */
  public Map<String, Object> offset() {
    Map<String, Object> offset = new HashMap<>(stored);
    offset.putAll(Map.of(RUN, run, SEQUENCE, sequence, TIME, lastMillis));
    return offset;
  }

  /**
   * Starts to read, unless it does already.
   *
   * @param allowed asked before each access
   */
  public void open(BooleanSupplier allowed) throws IOException {
    if (feed != null) {
      return;
    }
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
            new FeedListener() {
              @Override
              public void updated(RobotFeed robot, List<Update> updates) {
                add(robot.droppedSamples(), updates, allowed.getAsBoolean());
              }

              @Override
              public void read(
                  RobotFeed robot, Duration period, Instant time, long missed, boolean failed) {
                addReading(period, time, missed, failed, allowed.getAsBoolean());
              }
            });
    begin();
    try {
      opened.start();
    } catch (IOException | OutOfMemoryError e) {
      opened.close(); // the next attempt opens it again
      throw e;
    }
    feed = opened;
  }

  private synchronized void begin() {
    readings.resume(Instant.now());
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

  private synchronized void add(long droppedSamples, List<Update> updates, boolean used) {
    addDropped(droppedSamples); // before the samples that end the gap
    updates.forEach(update -> add(used ? update : unused(update)));
  }

  private synchronized void addReading(
      Duration period, Instant time, long missedBefore, boolean failed, boolean used) {
    if (!used) {
      unreadReason = WITHOUT_LEASE;
      readings.unused(period, time);
      return;
    }
    Instant before = readings.last(period);
    boolean byTime = readings.isUnread(period);
    long leftOut = readings.read(period, time, missedBefore, failed);
    lastRead = later(lastRead, time);
    if (leftOut > 0 && byTime && gap != null) {
      openGap(lastTime, unreadReason).missed += leftOut;
    } else if (leftOut > 0) {
      // the gap since the last reading of this period; the clock may have been set back
      Instant from = before != null && before.isBefore(time) ? before : time;
      openGap(from, byTime ? unreadReason : TOO_SLOW).missed += leftOut;
    }
    if (gap != null && !readings.isUnread(period)) {
      gap.ended = true;
    }
  }

  private void addDropped(long droppedSamples) {
    if (droppedSamples > dropped) {
      lose(droppedSamples - dropped, "this computer was too slow for the samples");
      dropped = droppedSamples;
    }
  }

  private void add(Update update) {
    if (closeGap() && offer(update, null)) {
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
    openGap(lastTime, reason).lost += count;
    lost += count;
  }

  /** Returns the open gap, or opens one. */
  private OpenGap openGap(Instant from, String reason) {
    OpenGap open = gap;
    if (open == null) {
      open = new OpenGap(from, reason);
      gap = open;
    } else {
      open.from = from.isBefore(open.from) ? from : open.from;
      open.reason += open.reason.contains(reason) ? "" : "; " + reason;
    }
    return open;
  }

  /** Puts the open gap into the queue, if there is one; returns false if the queue is full. */
  private boolean closeGap() {
    OpenGap open = gap;
    if (open == null) {
      return true;
    }
    Instant end = lastRead.isBefore(open.from) ? open.from : lastRead;
    Gap closed = new Gap(open.from, end, open.missed, open.lost, open.reason);
    boolean queued = offer(null, closed);
    if (queued) {
      gap = null;
      lastTime = later(lastTime, end);
    }
    return queued;
  }

  private boolean offer(@Nullable Update update, @Nullable Gap of) {
    boolean queued = queue.offer(new Item(this, update, of, readings.stored()));
    waiting += queued ? 1 : 0;
    return queued;
  }

  /** Begins a gap. Called when the robot, which was not read for a while, is read again. */
  public synchronized void resumed(String reason) {
    unreadReason = reason;
    OpenGap unused = openGap(lastTime, reason);
    readings.resume(Instant.now());
  }

  /**
   * Marks overdue variables as stale, and reports readings left out and samples dropped. Called
   * while the robot is used: without the lease, nobody knows yet who counts the readings.
   */
  public void check() {
    RobotFeed own = feed;
    if (own == null) {
      return;
    }
    own.checkAges();
    synchronized (this) {
      addDropped(own.droppedSamples());
      if (gap != null && gap.isComplete()) {
        boolean unused = closeGap();
      }
    }
  }

  /** Returns the record value of a queued item, and counts the item. */
  public Struct take(Item item, SampleRecords records) {
    sequence++;
    synchronized (this) {
      waiting--;
    }
    stored = item.stored;
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
