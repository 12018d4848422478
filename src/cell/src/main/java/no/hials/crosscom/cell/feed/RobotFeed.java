package no.hials.crosscom.cell.feed;

import java.io.Closeable;
import java.io.IOException;
import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.Function;
import no.hials.crosscom.ConnectionEvent;
import no.hials.crosscom.CrossComClient;
import no.hials.crosscom.CrossComException;
import no.hials.crosscom.Sample;
import no.hials.crosscom.Watch;
import no.hials.crosscom.WatchConfig;
import no.hials.crosscom.cell.Robot;
import no.hials.crosscom.cell.RobotConnection;
import no.hials.crosscom.protocol.value.DeadBand;
import no.hials.crosscom.protocol.value.KrlValue;
import org.jspecify.annotations.Nullable;

/**
 * Reads the variables of a plan from one robot, over one connection with one access at a time, and
 * passes new values on to a listener. When the robot stops answering, each variable is passed on
 * once as stale; when it answers again, all values are passed on again.
 */
public final class RobotFeed implements Closeable {
  /** A value is stale this long after the time of its next reading. */
  private static final Duration GRACE = Duration.ofSeconds(1);

  private static final String LATE = "the controller has not answered in time";

  /** The samples that can wait for a listener. It must not block, so few do. */
  private static final int BUFFER = 16;

  private final PollPlan plan;
  private final FeedListener listener;
  private final RobotConnection connection;
  private final Map<String, Held> held = new TreeMap<>(String.CASE_INSENSITIVE_ORDER);
  private final List<Watch> watches = new CopyOnWriteArrayList<>();

  private volatile boolean connected;
  private volatile boolean closed;

  /** The last reading of a variable; guarded by the feed. */
  private static final class Held {
    private final PlannedVariable variable;
    private final DeadBand deadBand;
    private final KnownParts parts = new KnownParts();
    private @Nullable KrlValue value;
    private @Nullable KrlValue passedOn;
    private @Nullable Instant time;
    private long nanos = System.nanoTime();
    private @Nullable Quality quality;
    private String reason = "";

    Held(PlannedVariable variable) {
      this.variable = variable;
      this.deadBand = new DeadBand(variable.deadBand(), false);
    }

    /**
     * Stores a value, and returns its update if it must be passed on. A value that was read long
     * before its sample was complete is stale. One with too many fields is bad.
     *
     * @param readNanos when it was read, by {@link System#nanoTime}
     */
    @Nullable Update read(KrlValue now, Instant readAt, long readNanos) {
      String tooMany = parts.add(now);
      if (!tooMany.isEmpty()) {
        return without(Quality.BAD, variable.name() + " " + tooMany, readAt);
      }
      nanos = readNanos;
      boolean late = isLate(System.nanoTime());
      Quality current = late ? Quality.STALE : Quality.GOOD;
      KrlValue before = passedOn;
      boolean isNew =
          quality != current
              || before == null
              || !variable.onChange()
              || deadBand.differs(before, now);
      value = now;
      time = readAt;
      quality = current;
      reason = late ? LATE : "";
      if (!isNew) {
        return null;
      }
      passedOn = now;
      return new Update(variable, readAt, current, now, reason);
    }

    /** Stores that there is no value, and returns the update the first time. */
    @Nullable Update without(Quality why, String text, Instant failedAt) {
      if (quality == why && (why == Quality.STALE || reason.equals(text))) {
        return null;
      }
      boolean hadValue = quality == Quality.GOOD || quality == Quality.STALE;
      quality = why;
      reason = text;
      if (why == Quality.BAD) {
        value = null;
      }
      Instant last = hadValue ? time : null;
      return new Update(
          variable, last == null || value == null ? failedAt : last, why, value, text);
    }

    boolean isOverdue(long now) {
      return quality == Quality.GOOD && isLate(now);
    }

    private boolean isLate(long now) {
      return now - nanos > variable.period().multipliedBy(2).plus(GRACE).toNanos();
    }
  }

  private RobotFeed(PollPlan plan, RobotConnection connection, FeedListener listener) {
    this.plan = plan;
    this.listener = listener;
    this.connection = connection;
    plan.variables().forEach((name, variable) -> held.put(name, new Held(variable)));
  }

  /** Receives the events of a connection, which begin before the feed exists. */
  private static final class Events {
    private final List<ConnectionEvent> early = new ArrayList<>();
    private @Nullable RobotFeed feed;

    synchronized void add(ConnectionEvent event) {
      if (feed == null) {
        early.add(event);
      } else {
        feed.connectionChanged(event);
      }
    }

    synchronized void to(RobotFeed one) {
      feed = one;
      early.forEach(one::connectionChanged);
    }
  }

  /**
   * Connects to a robot. Reading begins with {@link #start}.
   *
   * @param opener connects to the robot; if it does so in the background, the robot may be off
   */
  public static RobotFeed open(PollPlan plan, RobotConnection.Opener opener, FeedListener listener)
      throws IOException {
    Events events = new Events();
    RobotConnection connection =
        opener.open(plan.robot(), Robot.LASTING.andThen(cfg -> cfg.listener(events::add)));
    RobotFeed feed = new RobotFeed(plan, connection, listener);
    events.to(feed);
    return feed;
  }

  /**
   * Starts to read.
   *
   * @throws IOException if the client is closed
   */
  public void start() throws IOException {
    for (Map.Entry<Duration, List<String>> poll : plan.reads().entrySet()) {
      WatchConfig config =
          WatchConfig.create(
              poll.getValue(),
              cfg -> cfg.period(poll.getKey()).missedSamples(true).bufferSize(BUFFER));
      Watch watch = connection.client().watch(config);
      watches.add(watch);
      watch.addListener(sample -> take(poll.getKey(), sample));
    }
  }

  /** Returns the plan of this feed. */
  public PollPlan plan() {
    return plan;
  }

  /** Returns the name of the robot. */
  public String name() {
    return plan.robot().name();
  }

  /** Returns the client, whose connection is the only one to the robot. */
  public CrossComClient client() {
    return connection.client();
  }

  /** Returns whether the robot is connected. */
  public boolean isConnected() {
    return connected;
  }

  /** Returns the number of readings that were started. */
  public long polls() {
    return watches.stream().mapToLong(Watch::polls).sum();
  }

  /** Returns the number of readings left out because the robot was too slow. */
  public long missedPolls() {
    return watches.stream().mapToLong(Watch::missedPeriods).sum();
  }

  /** Returns the number of readings that failed as a whole. */
  public long failedPolls() {
    return watches.stream().mapToLong(Watch::failedPolls).sum();
  }

  /** Returns the number of samples that were dropped because the listener was too slow. */
  public long droppedSamples() {
    return watches.stream().mapToLong(Watch::droppedSamples).sum();
  }

  /** Returns the last known value of a variable; empty if it is not read, or there is none. */
  public synchronized Optional<KrlValue> lastValue(String variable) {
    return Optional.ofNullable(held.get(variable)).map(it -> it.value);
  }

  /** Returns the time since the last reading of a variable; empty if there is none. */
  public synchronized Optional<Duration> age(String variable) {
    return Optional.ofNullable(held.get(variable))
        .filter(it -> it.time != null)
        .map(it -> Duration.ofNanos(System.nanoTime() - it.nanos));
  }

  private void connectionChanged(ConnectionEvent event) {
    switch (event.kind()) {
      case CONNECTED, RECONNECTED -> connected = true;
      default -> {
        connected = false;
        CrossComException cause = event.cause();
        String reason =
            String.valueOf(cause == null ? "the connection is lost" : cause.getMessage());
        passOn(one -> one.without(Quality.STALE, reason, event.time()), held.values());
      }
    }
  }

  private void take(Duration period, Sample sample) {
    List<Update> updates = new ArrayList<>();
    synchronized (this) {
      if (!closed) {
        boolean failed =
            sample.readings().values().stream()
                .allMatch(it -> it.status() == Sample.ReadingStatus.MISSED);
        listener.read(this, period, sample.time(), sample.missedPeriods(), failed);
      }
      sample
          .readings()
          .forEach(
              (read, reading) -> {
                // the times of a sample are measured from its beginning: the clock does not matter
                long offset = Duration.between(sample.time(), reading.time()).toNanos();
                for (PlannedVariable variable : plan.readBy(read)) {
                  Update update =
                      update(held.get(variable.key()), reading, sample.nanoTime() + offset);
                  if (update != null) {
                    updates.add(update);
                  }
                }
              });
      if (!updates.isEmpty() && !closed) {
        listener.updated(this, updates);
      }
    }
  }

  /** Stores a reading, which began at a time by {@link System#nanoTime}. */
  private static @Nullable Update update(
      @Nullable Held one, Sample.Reading reading, long readNanos) {
    if (one == null) {
      return null;
    }
    KrlValue whole = reading.value();
    if (whole != null) {
      KrlValue part = one.variable.in(whole).orElse(null);
      return part != null
          ? one.read(part, reading.time(), readNanos)
          : one.without(
              Quality.BAD, one.variable.read() + " has no such field now", reading.time());
    }
    CrossComException failure = reading.failure();
    return one.without(
        reading.status() == Sample.ReadingStatus.FAILED ? Quality.BAD : Quality.STALE,
        String.valueOf(failure == null ? "not read" : failure.getMessage()),
        reading.time());
  }

  /** Marks variables as stale if their next reading is overdue, such as after a slow one. */
  public void checkAges() {
    long now = System.nanoTime();
    Instant time = Instant.now();
    synchronized (this) {
      passOn(
          one -> one.without(Quality.STALE, LATE, time),
          held.values().stream().filter(one -> one.isOverdue(now)).toList());
    }
  }

  private synchronized void passOn(
      Function<Held, @Nullable Update> change, Iterable<Held> variables) {
    List<Update> updates = new ArrayList<>();
    for (Held one : variables) {
      Update update = change.apply(one);
      if (update != null) {
        updates.add(update);
      }
    }
    if (!updates.isEmpty() && !closed) {
      listener.updated(this, updates);
    }
  }

  /** Passes on all known values once more, for a listener that has missed them. */
  public void repeat() {
    passOn(
        one ->
            one.quality == null
                ? null
                : new Update(
                    one.variable,
                    one.time == null ? Instant.now() : one.time,
                    one.quality,
                    one.value,
                    one.reason),
        held.values());
  }

  /** Stops reading and closes the connection. After that, the listener is not called. */
  @Override
  public void close() throws IOException {
    synchronized (this) {
      closed = true;
    }
    watches.forEach(Watch::close);
    connection.close();
  }
}
