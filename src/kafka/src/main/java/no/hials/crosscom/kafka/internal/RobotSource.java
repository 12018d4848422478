package no.hials.crosscom.kafka.internal;

import java.io.Closeable;
import java.io.IOException;
import java.time.Duration;
import java.time.Instant;
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
  private static final Duration LONGEST_BACKOFF = Duration.ofSeconds(1);

  private final PollPlan plan;
  private final Queue<Item> queue;
  private final long run;
  private @Nullable RobotFeed feed;

  // used by the thread of the task only
  private long sequence;
  private long lastMillis;
  private long missed;

  /** When the robot was last allowed to be accessed; 0 before the first time. */
  private volatile long lastAccess;

  // guarded by this
  private Instant lastTime;
  private @Nullable OpenGap gap;
  private long lost;

  /** The samples that the feed has dropped, as counted in the gaps. */
  private long dropped;

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
    private String reason;

    /** Since when the robot was not read; null if it was. */
    private @Nullable Instant unreadSince;

    /** The end of the time without readings, if no sample comes before. */
    private Instant unreadUntil = Instant.MAX;

    private long missed;
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
      since.unreadSince = lastTime;
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
                            cfg.accessIf(() -> mayAccess(allowed))
                                .reconnectBackoff(Duration.ofMillis(100), LONGEST_BACKOFF))),
            new FeedListener() {
              @Override
              public void updated(RobotFeed robot, List<Update> updates) {
                add(robot.droppedSamples(), updates, allowed.getAsBoolean());
              }

              @Override
              public void missed(RobotFeed robot, long number, Instant from, Instant to) {
                addMissed(number, from, to, allowed.getAsBoolean());
              }
            });
    try {
      opened.start();
    } catch (IOException | OutOfMemoryError e) {
      opened.close(); // the next attempt opens it again
      throw e;
    }
    feed = opened;
  }

  private boolean mayAccess(BooleanSupplier allowed) {
    // before the answer: a process that is frozen in between has no access at the later time
    long now = System.currentTimeMillis();
    boolean may = allowed.getAsBoolean();
    if (may) {
      lastAccess = now;
    }
    return may;
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
    updates.forEach(update -> add(used ? update : unused(update), used));
  }

  private synchronized void addMissed(long number, Instant from, Instant to, boolean used) {
    // without the lease, the time counts: the periods left out belong to its gap
    if (!used || (gap != null && gap.unreadSince != null)) {
      return;
    }
    // the clock may have been set back
    openGap(from.isBefore(to) ? from : to, TOO_SLOW).missed += number;
  }

  private void addDropped(long droppedSamples) {
    if (droppedSamples > dropped) {
      lose(droppedSamples - dropped, "this computer was too slow for the samples");
      dropped = droppedSamples;
    }
  }

  private void add(Update update, boolean used) {
    Instant time = update.quality() == Quality.STALE ? Instant.now() : update.time();
    if (used && gap != null && gap.unreadSince != null && time.isBefore(gap.unreadUntil)) {
      gap.unreadUntil = time;
    }
    if (closeGap(time) && queue.offer(new Item(this, update, null))) {
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
    } else if (open.unreadSince == null && !open.reason.contains(reason)) {
      open.reason += "; " + reason;
    }
    return open;
  }

  /** Puts the open gap into the queue, if there is one; returns false if the queue is full. */
  private boolean closeGap(Instant to) {
    OpenGap open = gap;
    if (open == null) {
      return true;
    }
    Instant end = to.isBefore(open.from) ? open.from : to;
    long unread =
        open.unreadSince == null
            ? 0
            : readings(open.unreadSince, end.isBefore(open.unreadUntil) ? end : open.unreadUntil);
    Gap closed = new Gap(open.from, end, open.missed + unread, open.lost, open.reason);
    boolean queued = queue.offer(new Item(this, null, closed));
    if (queued) {
      gap = null;
    }
    return queued;
  }

  /** Returns the number of readings that the plan has between two times. */
  private long readings(Instant from, Instant to) {
    long millis = Math.max(0, Duration.between(from, to).toMillis());
    return plan.reads().keySet().stream().mapToLong(period -> millis / period.toMillis()).sum();
  }

  /** Begins a gap. Called when the robot, which was not read for a while, is read again. */
  public synchronized void resumed(String reason) {
    OpenGap open = openGap(lastTime, reason);
    if (open.unreadSince == null) {
      open.unreadSince = lastAccess == 0 ? lastTime : Instant.ofEpochMilli(lastAccess);
    }
    // if it takes longer to connect, the robot is off: its readings are tried
    open.unreadUntil = Instant.now().plus(LONGEST_BACKOFF.multipliedBy(2));
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
      // a time without readings ends with the next reading
      if (gap != null && gap.unreadSince == null) {
        boolean unused = closeGap(Instant.now());
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
