package no.hials.crosscom.kafka.internal;

import java.io.IOException;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Collection;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.function.BooleanSupplier;
import java.util.function.LongSupplier;
import no.hials.crosscom.CrossComAccessException;
import no.hials.crosscom.CrossComConnectException;
import no.hials.crosscom.CrossComException;
import no.hials.crosscom.CrossComValueException;
import no.hials.crosscom.cell.DaemonThreadFactory;
import no.hials.crosscom.cell.RobotConnection;
import no.hials.crosscom.cell.feed.PollPlan;
import no.hials.crosscom.cell.feed.RobotFeed;
import no.hials.crosscom.cell.feed.Writes;
import org.apache.kafka.connect.errors.ConnectException;
import org.apache.kafka.connect.errors.DataException;
import org.apache.kafka.connect.sink.SinkRecord;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Writes each record once: the records of one robot in their order, and different robots at the
 * same time. The records are written in batches that have a time limit, so that a slow robot does
 * not delay the others for longer than one access. Connects to a robot only while there are records
 * for it.
 */
public final class CommandWriter implements AutoCloseable {
  private static final Logger LOG = LoggerFactory.getLogger(CommandWriter.class);

  /** The time from the start of a batch after which no further record of it is sent. */
  private static final Duration LIMIT = Duration.ofMillis(500);

  private final TaskPlant plant;
  private final Writes writes;
  private final Lease lease;
  private final Duration maxAge;
  private final Duration limit;
  private final LongSupplier millis;
  private final ExecutorService threads =
      Executors.newCachedThreadPool(DaemonThreadFactory.named("jopenshowvar-write"));

  /**
   * Creates a writer.
   *
   * @param plant the robots; no record is written while their file differs
   * @param lease the lease, without which no record is written
   * @param maxAge the maximum difference between the timestamp of a record and the current time
   */
  public CommandWriter(TaskPlant plant, Writes writes, Lease lease, Duration maxAge) {
    this(plant, writes, lease, maxAge, LIMIT, System::currentTimeMillis);
  }

  CommandWriter(
      TaskPlant plant,
      Writes writes,
      Lease lease,
      Duration maxAge,
      Duration limit,
      LongSupplier millis) {
    this.plant = plant;
    this.writes = writes;
    this.lease = lease;
    this.maxAge = maxAge;
    this.limit = limit;
    this.millis = millis;
  }

  /**
   * Writes records as one batch, while the lease is held and the plant is that of the file. After
   * the time limit no further record is sent, except the first one of each robot.
   *
   * @return the result of each finished record: empty if it was written, otherwise the reason why
   *     not. A record without a result was not sent
   * @throws ConnectException if the outcome of the records is unknown
   */
  public Map<SinkRecord, Optional<Exception>> write(Collection<SinkRecord> records) {
    long end = System.nanoTime() + limit.toNanos();
    Map<SinkRecord, Optional<Exception>> outcomes = new HashMap<>();
    Map<String, Map<SinkRecord, SinkCommand>> robots = new LinkedHashMap<>();
    for (SinkRecord record : records) {
      try {
        SinkCommand command = SinkCommand.of(record);
        robots.computeIfAbsent(command.robot(), name -> new LinkedHashMap<>()).put(record, command);
      } catch (DataException e) {
        outcomes.put(record, Optional.of(e));
      }
    }
    List<Future<Map<SinkRecord, Optional<Exception>>>> writers = new ArrayList<>();
    robots.forEach(
        (name, commands) -> {
          try {
            writers.add(threads.submit(() -> write(name, commands, end)));
          } catch (OutOfMemoryError e) {
            Exception reason =
                new ConnectException("not written: no thread can be started for " + name, e);
            commands.keySet().forEach(record -> outcomes.put(record, Optional.of(reason)));
          }
        });
    ConnectException failure = null;
    for (Future<Map<SinkRecord, Optional<Exception>>> writer : writers) {
      try {
        outcomes.putAll(writer.get());
      } catch (ExecutionException e) {
        failure = new ConnectException(e.getCause());
      } catch (InterruptedException e) {
        Thread.currentThread().interrupt();
        throw new ConnectException("interrupted", e);
      }
    }
    if (failure != null) {
      throw failure;
    }
    return outcomes;
  }

  /** Returns whether the plant is that of the file: otherwise no record is written. */
  public boolean isCurrent() {
    return plant.isCurrent();
  }

  private Map<SinkRecord, Optional<Exception>> write(
      String name, Map<SinkRecord, SinkCommand> commands, long end) {
    Map<SinkRecord, Optional<Exception>> outcomes = new HashMap<>();
    RobotFeed robot = null;
    boolean tried = false;
    boolean late = false;
    boolean silent = false;
    AtomicBoolean refused = new AtomicBoolean();
    // before each access: it can take seconds to connect, and the file can change meanwhile
    BooleanSupplier allowed =
        () -> {
          boolean may = mayWrite();
          refused.compareAndSet(false, !may);
          return may;
        };
    try {
      for (Map.Entry<SinkRecord, SinkCommand> one : commands.entrySet()) {
        if (!silent && !late && !mayWrite()) {
          break;
        }
        SinkRecord record = one.getKey();
        try {
          check(name, silent, record);
          late |= tried && System.nanoTime() - end >= 0;
          if (late) {
            continue;
          }
          tried = true;
          if (robot == null) {
            robot = open(one.getValue(), who(record), allowed);
          }
          writes.write(
              who(record),
              plant.plant(),
              robot,
              one.getValue().variable(),
              one.getValue().value(),
              maxAge.minusMillis(age(record))); // it can have waited for the connection
          outcomes.put(record, Optional.empty());
        } catch (CrossComConnectException e) {
          // the lease ended or the file changed meanwhile: the robot may not be silent at all
          if (refused.get()) {
            break; // nothing was sent
          }
          silent = true;
          outcomes.put(record, Optional.of(e));
        } catch (IOException | IllegalArgumentException | DataException e) {
          silent |= isWithoutAnswer(e);
          outcomes.put(record, Optional.of(reason(e)));
        } catch (RuntimeException e) {
          // a fault of this program: the outcomes of other records stay known
          LOG.error("{}: the outcome is unknown", who(record), e);
          outcomes.put(record, Optional.of(new ConnectException("outcome unknown: " + e, e)));
        }
      }
    } finally {
      close(robot);
    }
    return outcomes;
  }

  private boolean mayWrite() {
    return lease.isHeld() && plant.isCurrent();
  }

  private static void close(@Nullable RobotFeed robot) {
    try {
      if (robot != null) {
        robot.close();
      }
    } catch (IOException | RuntimeException e) {
      LOG.warn("{}: {}", robot.name(), e.getMessage());
    }
  }

  /**
   * Returns a failure that says if nothing was written: a dead letter has no other place for it.
   */
  private static Exception reason(Exception failure) {
    return isWithoutAnswer(failure)
            && failure instanceof CrossComException before
            && !before.isOutcomeUnknown()
        ? new ConnectException("not written: " + before.getMessage(), before)
        : failure;
  }

  private static boolean isWithoutAnswer(Exception failure) {
    return failure instanceof CrossComException
        && !(failure instanceof CrossComAccessException
            || failure instanceof CrossComValueException);
  }

  private static String who(SinkRecord record) {
    return "kafka:"
        + record.originalTopic()
        + "-"
        + record.originalKafkaPartition()
        + "@"
        + record.originalKafkaOffset();
  }

  private void check(String name, boolean silent, SinkRecord record) {
    if (silent) {
      throw new DataException("not written: " + name + " has not answered the command before");
    }
    // nobody knows whether the write of an old record is still wanted
    long limit = maxAge.toMillis();
    long age = age(record);
    if (age > limit) {
      throw new DataException(
          "not written: the record is older than " + limit + " ms (max.age.ms)");
    } else if (age < -limit) {
      throw new DataException(
          "not written: the clock of the record is " + -age + " ms ahead (max.age.ms)");
    }
  }

  /** Returns the age of a record in ms. */
  private long age(SinkRecord record) {
    Long time = record.timestamp();
    return time == null ? Long.MAX_VALUE : millis.getAsLong() - time;
  }

  private RobotFeed open(SinkCommand command, String who, BooleanSupplier allowed)
      throws IOException {
    String name = command.robot();
    Optional<PollPlan> plan =
        plant.plant().plans().stream().filter(one -> one.robot().name().equals(name)).findFirst();
    if (plan.isEmpty()) {
      String reason = "no robot is named " + name;
      writes.refused(who, name, command.variable(), command.value(), reason);
      throw new DataException(reason);
    }
    return RobotFeed.open(
        plan.get(),
        (robot, more) ->
            RobotConnection.open(
                robot,
                more.andThen(
                    cfg -> cfg.accessIf(allowed).reconnect(false).keepAlive(Duration.ZERO))),
        (feed, updates) -> {});
  }

  @Override
  public void close() {
    threads.shutdown();
  }
}
