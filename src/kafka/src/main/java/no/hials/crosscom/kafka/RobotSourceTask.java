package no.hials.crosscom.kafka;

import java.io.IOException;
import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.Date;
import java.util.List;
import java.util.Map;
import java.util.concurrent.ArrayBlockingQueue;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.TimeUnit;
import no.hials.crosscom.cell.FileException;
import no.hials.crosscom.cell.Moment;
import no.hials.crosscom.cell.feed.Plant;
import no.hials.crosscom.kafka.internal.ConnectorSettings;
import no.hials.crosscom.kafka.internal.ConnectorVersion;
import no.hials.crosscom.kafka.internal.Lease;
import no.hials.crosscom.kafka.internal.RobotSource;
import no.hials.crosscom.kafka.internal.RobotSource.Item;
import no.hials.crosscom.kafka.internal.SampleRecords;
import org.apache.kafka.clients.producer.RecordMetadata;
import org.apache.kafka.connect.data.Schema;
import org.apache.kafka.connect.data.Struct;
import org.apache.kafka.connect.errors.ConnectException;
import org.apache.kafka.connect.source.SourceRecord;
import org.apache.kafka.connect.source.SourceTask;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Reads the robots of one task. A record that the broker acknowledges renews the lease, counted
 * from the time when the task passed the record to Connect. Several small records per lease make
 * sure that there is always a record to acknowledge. The client checks the lease before each
 * access, so that no robot is used without it.
 */
public final class RobotSourceTask extends SourceTask {
  private static final Logger LOG = LoggerFactory.getLogger(RobotSourceTask.class);

  /** The number of records per lease that renew it. */
  private static final int BEATS = 4;

  /** After this time at most, the offset of a robot without other records is stored. */
  private static final Duration QUIET = Duration.ofSeconds(5);

  private static final int MAX_BATCH = 2000;
  private static final long POLL_MILLIS = 100;
  private static final long CHECK_NANOS = 250_000_000;

  private final List<RobotSource> robots = new ArrayList<>();
  private final SampleRecords values = new SampleRecords();
  private @Nullable ConnectorSettings settings;
  private @Nullable Lease lease;
  private @Nullable BlockingQueue<Item> queue;

  /** Whether robots may be used while the lease is held. */
  private volatile boolean allowed;

  /** Taken from the queue, but not passed to Connect yet. */
  private @Nullable Item kept;

  private boolean opened;
  private boolean failedToOpen;
  private boolean recovering;
  private long recoveringSince;
  private Moment lastPoll = Moment.now();
  private boolean warned;

  /** Why the robots are not used. */
  private String lost = "";

  private long lastBeat;

  /** The number of robots whose offset was asked for. */
  private long turns;

  private long lastCheck;
  private long records;

  /** Creates a task that Connect starts. */
  public RobotSourceTask() {}

  /** A record with the time when the task passed it to Connect. */
  private static final class Given extends SourceRecord {
    private final Moment moment;

    Given(
        Map<String, ?> partition,
        Map<String, ?> offset,
        String topic,
        String key,
        Struct value,
        Instant time,
        Moment moment) {
      super(
          partition,
          offset,
          topic,
          null,
          Schema.STRING_SCHEMA,
          key,
          value.schema(),
          value,
          time.toEpochMilli());
      this.moment = moment;
    }

    @Override
    public boolean equals(Object other) {
      return this == other;
    }

    @Override
    public int hashCode() {
      return System.identityHashCode(this);
    }
  }

  @Override
  public String version() {
    return ConnectorVersion.own();
  }

  @Override
  public void start(Map<String, String> properties) {
    ConnectorSettings read = ConnectorSettings.of(ConnectorSettings.SOURCE, properties);
    settings = read;
    lease = new Lease(read.time(ConnectorSettings.LEASE));
    BlockingQueue<Item> waiting = new ArrayBlockingQueue<>(read.getInt(ConnectorSettings.BUFFER));
    queue = waiting;
    lastBeat = System.nanoTime() - beatNanos(read);
    List<String> names = read.taskRobots();
    List<Map<String, String>> partitions =
        names.stream().map(name -> Map.of(RobotSource.PARTITION, name)).toList();
    Map<Map<String, String>, Map<String, Object>> offsets =
        context.offsetStorageReader().offsets(partitions);
    try {
      Plant plant = read.taskPlant().plant();
      plant.plans().stream()
          .filter(plan -> names.contains(plan.robot().name()))
          .map(
              plan ->
                  new RobotSource(
                      plan,
                      waiting,
                      offsets.get(Map.of(RobotSource.PARTITION, plan.robot().name()))))
          .forEach(robots::add);
    } catch (FileException e) {
      throw new ConnectException(e.getMessage(), e);
    }
    LOG.info("{} robots: {}", names.size(), String.join(", ", names));
  }

  private static long beatNanos(ConnectorSettings settings) {
    return settings.time(ConnectorSettings.LEASE).dividedBy(BEATS).toNanos();
  }

  @Override
  public @Nullable List<SourceRecord> poll() throws InterruptedException {
    ConnectorSettings own = settings;
    BlockingQueue<Item> waiting = queue;
    if (own == null || waiting == null) {
      throw new IllegalStateException("not started");
    }
    // before the lease is checked: a process that is frozen in between gets no later time
    Moment moment = Moment.now();
    followLease(own, moment);
    lastPoll = moment;
    if (allowed && moment.nanos() - lastCheck > CHECK_NANOS) {
      lastCheck = moment.nanos();
      robots.forEach(RobotSource::check);
    }
    List<SourceRecord> batch = new ArrayList<>();
    if (moment.nanos() - lastBeat >= beatNanos(own)) {
      lastBeat = moment.nanos();
      beat(own, moment, batch);
    }
    Item item = next(waiting, batch.isEmpty());
    while (item != null) {
      batch.add(record(own, item, moment));
      item = batch.size() < MAX_BATCH ? waiting.poll() : null;
    }
    records += batch.size();
    return batch.isEmpty() ? null : batch;
  }

  /**
   * Returns the next sample or gap; null without the lease: a record of a robot would then replace
   * the offset of the task that may have the robot now. What waits is sent once the lease is held.
   */
  private @Nullable Item next(BlockingQueue<Item> waiting, boolean wait)
      throws InterruptedException {
    if (!mayUse()) {
      if (wait) {
        TimeUnit.MILLISECONDS.sleep(POLL_MILLIS);
      }
      return null;
    }
    if (kept == null) {
      kept = wait ? waiting.poll(POLL_MILLIS, TimeUnit.MILLISECONDS) : waiting.poll();
    }
    // checked again: the process may have been frozen while it waited
    Item item = mayUse() ? kept : null;
    if (item != null) {
      kept = null;
    }
    return item;
  }

  private boolean mayUse() {
    return allowed && isHeld();
  }

  private boolean isHeld() {
    return lease != null && lease.isHeld();
  }

  private void followLease(ConnectorSettings own, Moment now) {
    if (!isHeld()) {
      if (allowed) {
        allowed = false;
        // the last beat may be old already: less than the lease without a call ends it
        long longest = own.time(ConnectorSettings.LEASE).toNanos() / 2;
        boolean called = now.nanosSince(lastPoll) < longest;
        lost =
            called
                ? "the task had not reached the broker"
                : "the task had not been called: it was paused, frozen, or blocked by the broker, or"
                    + " the clock was set";
        LOG.warn(
            "the lease of {} ms has ended, the robots are not used: {}",
            own.getLong(ConnectorSettings.LEASE),
            lost);
      }
      recovering = false;
    } else if (!opened) {
      allowed = true; // before the robots are opened, which begin at once
      opened = open();
      allowed = opened;
    } else if (!allowed) {
      follow(own.time(ConnectorSettings.LEASE_RECOVERY), now);
    }
  }

  /** Waits until Connect would have taken the robots away from a worker outside the group. */
  private void follow(Duration wait, Moment now) {
    if (!recovering) {
      recovering = true;
      recoveringSince = now.nanos();
    }
    if (now.nanos() - recoveringSince >= wait.toNanos()) {
      LOG.info("the lease is held again: the robots are used");
      robots.forEach(robot -> robot.resumed(lost));
      allowed = true;
    }
  }

  /** Begins to read all robots; returns false if some need another attempt. */
  private boolean open() {
    for (RobotSource robot : robots) {
      try {
        robot.open(this::mayUse);
      } catch (IOException | OutOfMemoryError e) {
        if (!failedToOpen) {
          LOG.warn("{} cannot be read yet, which is tried again: {}", robot.name(), e.getMessage());
        }
        failedToOpen = true;
        return false;
      }
    }
    return true;
  }

  private SourceRecord record(ConnectorSettings own, Item item, Moment moment) {
    RobotSource robot = item.robot();
    Struct value = robot.take(item, values);
    return new Given(
        robot.partition(),
        robot.offset(),
        own.topic(robot.name()),
        robot.name(),
        value,
        item.time(),
        moment);
  }

  /** Adds the record that renews the lease, and copies of it that store offsets of robots. */
  private void beat(ConnectorSettings own, Moment moment, List<SourceRecord> batch) {
    Struct value =
        new Struct(SampleRecords.LEASE_SCHEMA)
            .put("connector", own.connector())
            .put("task", own.taskNumber())
            .put("time", Date.from(Instant.ofEpochMilli(moment.millis())))
            .put("held", allowed)
            .put("robots", robots.size())
            .put("connected", (int) robots.stream().filter(RobotSource::isConnected).count())
            .put("records", records)
            .put("missed", robots.stream().mapToLong(RobotSource::missed).sum())
            .put("lost", robots.stream().mapToLong(RobotSource::lost).sum());
    Map<String, ?> task = Map.of("task", own.taskNumber());
    batch.add(leaseRecord(own, moment, value, task, Map.of("time", moment.millis())));
    long end = turns + turnsPerBeat(own);
    // another task may have the robots now if the lease is not held
    for (; turns < end && mayUse(); turns++) {
      RobotSource robot = robots.get((int) (turns % robots.size()));
      Map<String, Object> offset = robot.quietOffset();
      if (offset != null) {
        batch.add(leaseRecord(own, moment, value, robot.partition(), offset));
      }
    }
  }

  /** Returns for how many robots an offset may be stored with each beat, rounded up. */
  private long turnsPerBeat(ConnectorSettings own) {
    long due = robots.size() * beatNanos(own) / QUIET.toNanos() + 1;
    return Math.min(robots.size(), due);
  }

  private static SourceRecord leaseRecord(
      ConnectorSettings own,
      Moment moment,
      Struct value,
      Map<String, ?> partition,
      Map<String, ?> offset) {
    return new Given(
        partition,
        offset,
        own.getString(ConnectorSettings.LEASE_TOPIC),
        own.connector() + "-" + own.taskNumber(),
        value,
        Instant.ofEpochMilli(moment.millis()),
        moment);
  }

  @Override
  public void commitRecord(SourceRecord record, @Nullable RecordMetadata metadata) {
    if (!(record instanceof Given given) || lease == null || settings == null) {
      return;
    }
    if (metadata != null && metadata.hasOffset()) {
      lease.renew(given.moment);
    } else if (!warned && given.topic().equals(settings.getString(ConnectorSettings.LEASE_TOPIC))) {
      warned = true;
      warnOfLease(given.topic(), metadata);
    }
  }

  /** Logs why a record of the lease has not renewed it. */
  private static void warnOfLease(String topic, @Nullable RecordMetadata metadata) {
    if (metadata == null) {
      LOG.warn(
          "a transformation or a tolerated error left out a record of {}: without them no lease is"
              + " held, and no robot is read",
          topic);
    } else {
      LOG.error(
          "the broker has not confirmed a record of {}: with acks=0 it confirms none, so that no"
              + " lease is held, and no robot is read; set acks=all for the producer",
          topic);
    }
  }

  @Override
  public void stop() {
    allowed = false;
    if (lease != null) {
      lease.end();
    }
    for (RobotSource robot : robots) {
      try {
        robot.close();
      } catch (IOException e) {
        LOG.warn("{}: {}", robot.name(), e.getMessage());
      }
    }
  }
}
