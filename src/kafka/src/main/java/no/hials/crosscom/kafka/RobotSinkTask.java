package no.hials.crosscom.kafka;

import java.nio.file.Path;
import java.time.Duration;
import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import no.hials.crosscom.cell.AuditLog;
import no.hials.crosscom.cell.FileException;
import no.hials.crosscom.cell.feed.Writes;
import no.hials.crosscom.kafka.internal.Claims;
import no.hials.crosscom.kafka.internal.CommandWriter;
import no.hials.crosscom.kafka.internal.ConnectorSettings;
import no.hials.crosscom.kafka.internal.ConnectorVersion;
import no.hials.crosscom.kafka.internal.DeadLetters;
import no.hials.crosscom.kafka.internal.Lease;
import no.hials.crosscom.kafka.internal.TaskPlant;
import org.apache.kafka.clients.consumer.OffsetAndMetadata;
import org.apache.kafka.common.TopicPartition;
import org.apache.kafka.connect.errors.ConnectException;
import org.apache.kafka.connect.sink.ErrantRecordReporter;
import org.apache.kafka.connect.sink.SinkRecord;
import org.apache.kafka.connect.sink.SinkTask;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Writes records in four steps: it holds them, lets Connect commit their offset with a claim, reads
 * the claim back from the brokers, and then writes each record once, while the lease that the
 * answer started lasts. A record is written only after it is claimed, only by the task that claimed
 * it, and only while the plant of the task is that of the file on its worker. A claim lasts for one
 * batch: records that were not tried in it are released, and claimed again with newer ones.
 */
public final class RobotSinkTask extends SinkTask {
  private static final Logger LOG = LoggerFactory.getLogger(RobotSinkTask.class);

  /** The time until the task is called again while it waits for a commit. */
  private static final long WAIT_MILLIS = 5;

  /** The time until the task is called again while its plant differs from the file. */
  private static final long OUTDATED_MILLIS = 500;

  /** The time after which a claim that is not verified is committed again. */
  private static final long REPEAT_NANOS = 5_000_000_000L;

  private static final Duration PATIENCE = Duration.ofSeconds(2);
  private static final Duration FIRST_PATIENCE = Duration.ofSeconds(30);
  private static final Duration REPORT_PATIENCE = Duration.ofSeconds(30);

  /**
   * The time after which Connect can go on: it takes a task for dead that is not back for 5 min.
   */
  private static final Duration LONGEST_REPORT = Duration.ofSeconds(30);

  private final Duration longestReport;
  private @Nullable CommandWriter writer;
  private @Nullable Claims claims;
  private @Nullable DeadLetters dead;
  private @Nullable Lease lease;
  private boolean requested;
  private long requestedAt;

  /** Whether a commit that the task did not ask for gives up a claim that is not used yet. */
  private boolean cautious = true;

  /** Whether claimed records may have been tried; stays so until the failures are reported. */
  private boolean writing;

  /** The failures of the batch that are not reported yet. */
  private final Map<SinkRecord, Exception> failed = new LinkedHashMap<>();

  /** Creates a task that Connect starts. */
  public RobotSinkTask() {
    this(LONGEST_REPORT);
  }

  RobotSinkTask(Duration longestReport) {
    this.longestReport = longestReport;
  }

  /** The outcome of a write is unknown, because the task that claimed it ended in between. */
  private static final class UnknownOutcomeException extends ConnectException {
    private static final long serialVersionUID = 1L;

    UnknownOutcomeException() {
      super("outcome unknown: a task ended after it had claimed this record; it is not repeated");
    }
  }

  @Override
  public String version() {
    return ConnectorVersion.own();
  }

  @Override
  public void start(Map<String, String> properties) {
    ConnectorSettings read = ConnectorSettings.of(ConnectorSettings.SINK, properties);
    TaskPlant plant;
    try {
      plant = read.taskPlant();
    } catch (FileException e) {
      throw new ConnectException(e.getMessage(), e);
    }
    Lease own = new Lease(read.time(ConnectorSettings.LEASE));
    lease = own;
    writer =
        new CommandWriter(
            plant,
            new Writes(new AuditLog(Path.of(read.getString(ConnectorSettings.AUDIT)))),
            own,
            read.time(ConnectorSettings.MAX_AGE));
    String group =
        properties.getOrDefault("consumer.override.group.id", "connect-" + read.connector());
    claims = new Claims(read.admin(), group, PATIENCE);
    ErrantRecordReporter reporter = context.errantRecordReporter();
    if (reporter == null) {
      throw new ConnectException("the sink needs a dead-letter topic");
    }
    dead =
        new DeadLetters(reporter, read.getString(ConnectorSettings.DEAD_LETTERS), REPORT_PATIENCE);
  }

  private Claims claims() {
    if (claims == null) {
      throw new IllegalStateException("not started");
    }
    return claims;
  }

  private CommandWriter writer() {
    if (writer == null) {
      throw new IllegalStateException("not started");
    }
    return writer;
  }

  @Override
  public void open(Collection<TopicPartition> partitions) {
    claims().open(partitions, FIRST_PATIENCE).forEach(context::offset);
  }

  @Override
  public void close(Collection<TopicPartition> partitions) {
    failed.keySet().removeIf(record -> partitions.contains(Claims.partitionOf(record)));
    long left = claims().close(partitions);
    if (left > 0) {
      LOG.warn("{} claimed records were not written: they will be reported as unknown", left);
    }
    requested = false;
  }

  @Override
  public void put(Collection<SinkRecord> records) {
    for (SinkRecord record : records) {
      if (!claims().isSettled(record)) {
        claims().hold(record);
      }
    }
    Map<SinkRecord, Exception> unknown = new LinkedHashMap<>();
    claims().unknown().forEach(record -> unknown.put(record, new UnknownOutcomeException()));
    if (writing) {
      finishBatch();
    } else if (!unknown.isEmpty()) {
      report(unknown);
      requestCommit();
    } else if (!claims().isEmpty() && !writer().isCurrent()) {
      // before a claim too: what is not claimed stays for the task with the new plant
      requested = false;
      if (claims().hasClaimed()) {
        release();
      }
      context.pause(claims().assigned());
      context.timeout(OUTDATED_MILLIS);
      return;
    } else if (!claims().hasClaimed()) {
      requestClaim();
    } else if (isVerified()) {
      writeClaimed();
    } else if (System.nanoTime() - requestedAt > REPEAT_NANOS) {
      LOG.warn("the offsets are not committed yet: nothing is written");
      requestCommit();
    }
    context.resume(claims().assigned());
    context.pause(claims().full());
    if (!claims().isEmpty()) {
      context.timeout(WAIT_MILLIS);
    }
  }

  private void requestClaim() {
    if (!claims().isEmpty() && !requested) {
      requested = true;
      requestCommit();
    }
  }

  /** Ends the claim: if it stayed, it would look like that of a task that has ended. */
  private void release() {
    writing = false;
    claims().release();
    requestCommit();
  }

  private void requestCommit() {
    requestedAt = System.nanoTime();
    context.requestCommit();
  }

  @Override
  public Map<TopicPartition, OffsetAndMetadata> preCommit(
      Map<TopicPartition, OffsetAndMetadata> currentOffsets) {
    if (requested) {
      requested = false;
      claims().claim();
      context.timeout(WAIT_MILLIS);
    } else if (claims().hasClaimed() && !writing && cautious) {
      // it can be the last commit before the partitions are closed; not each time, or a short
      // offset.flush.interval.ms would leave no claim
      cautious = false;
      claims().release();
    }
    return claims().offsets(currentOffsets);
  }

  private boolean isVerified() {
    return lease != null && claims().verify(lease);
  }

  private void writeClaimed() {
    cautious = true;
    writing = true;
    List<SinkRecord> claimed = claims().claimed();
    Map<SinkRecord, Optional<Exception>> outcomes = writer().write(claimed);
    for (SinkRecord record : claimed) {
      Optional<Exception> outcome = outcomes.get(record);
      if (outcome == null) {
        continue; // not tried
      }
      if (outcome.isPresent()) {
        failed.put(record, outcome.get());
      } else {
        claims().settle(record);
      }
    }
    finishBatch();
  }

  /** Reports the failures of the batch, and releases the records that were not tried. */
  private void finishBatch() {
    report(failed);
    if (failed.isEmpty()) {
      release();
    }
  }

  /** Puts records on the dead-letter topic for some time, and removes those that are there. */
  private void report(Map<SinkRecord, Exception> letters) {
    if (dead == null) {
      throw new IllegalStateException("not started");
    }
    for (SinkRecord record : dead.put(letters, longestReport)) {
      claims().settle(record);
      letters.remove(record);
    }
  }

  @Override
  public void stop() {
    if (dead != null) {
      dead.close();
    }
    if (lease != null) {
      lease.end();
    }
    if (writer != null) {
      writer.close();
    }
    if (claims != null) {
      claims.close();
    }
  }
}
