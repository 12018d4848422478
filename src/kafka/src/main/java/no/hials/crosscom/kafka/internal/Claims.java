package no.hials.crosscom.kafka.internal;

import java.time.Duration;
import java.util.ArrayDeque;
import java.util.Collection;
import java.util.Deque;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.UUID;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import no.hials.crosscom.cell.Moment;
import org.apache.kafka.clients.admin.Admin;
import org.apache.kafka.clients.consumer.OffsetAndMetadata;
import org.apache.kafka.common.TopicPartition;
import org.apache.kafka.connect.errors.ConnectException;
import org.apache.kafka.connect.sink.SinkRecord;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * The records of a sink task and their claims. Before records are written, their offset is
 * committed together with a claim, in the metadata of the offset: the owner, and the offsets where
 * the claim begins and ends. Only the member of the group that has the partition can commit, and
 * only an owner that reads its own claim back may write. A claim found when a partition is assigned
 * belongs to a task that ended before it finished: whether its records were written is unknown. Not
 * thread-safe.
 */
public final class Claims implements AutoCloseable {
  private static final Logger LOG = LoggerFactory.getLogger(Claims.class);
  private static final Pattern METADATA =
      Pattern.compile("jopenshowvar (\\S+) from (\\d+) to (\\d+)");

  private final Admin admin;
  private final String group;
  private final Duration patience;
  private final String owner = UUID.randomUUID().toString();
  private final Map<TopicPartition, Partition> partitions = new LinkedHashMap<>();

  /** Why the offsets could not be read the last time, so that it is logged once. */
  private String complaint = "";

  /** A partition that the task has. */
  private static final class Partition {
    private final Deque<SinkRecord> held = new ArrayDeque<>();

    /** The end of the claim; records below it may be written once the claim is verified. */
    private long claimed;

    /** The end of the records whose outcome is unknown. */
    private long unknown;

    /** Returns the first record that is not settled, or the end. */
    long first(long end) {
      return held.isEmpty() ? end : held.getFirst().originalKafkaOffset();
    }

    boolean hasClaimed() {
      return !held.isEmpty() && held.getFirst().originalKafkaOffset() < claimed;
    }
  }

  /**
   * Creates an object without partitions.
   *
   * @param admin a client of the brokers; closed with this object
   * @param group the consumer group of the connector
   * @param patience the longest wait for the answer to a verification
   */
  public Claims(Admin admin, String group, Duration patience) {
    this.admin = admin;
    this.group = group;
    this.patience = patience;
  }

  private static TopicPartition of(SinkRecord record) {
    return new TopicPartition(record.originalTopic(), record.originalKafkaPartition());
  }

  /**
   * Adds partitions that were assigned.
   *
   * @param longest the longest wait for the answer of the brokers
   * @return the offsets to go back to, of partitions with records whose outcome is unknown
   * @throws ConnectException if the offsets of the group cannot be read
   */
  public Map<TopicPartition, Long> open(Collection<TopicPartition> added, Duration longest) {
    Map<TopicPartition, Long> back = new HashMap<>();
    Map<TopicPartition, OffsetAndMetadata> committed = committed(longest);
    for (TopicPartition one : added) {
      Partition partition = new Partition();
      partitions.put(one, partition);
      OffsetAndMetadata offset = committed.get(one);
      Matcher claim = METADATA.matcher(offset == null ? "" : offset.metadata());
      if (claim.matches() && Long.parseLong(claim.group(2)) < Long.parseLong(claim.group(3))) {
        partition.unknown = Long.parseLong(claim.group(3));
        back.put(one, Long.parseLong(claim.group(2)));
      }
    }
    return back;
  }

  /**
   * Removes partitions, and returns the number of their records that were claimed but not written.
   */
  public long close(Collection<TopicPartition> removed) {
    long left = 0;
    for (TopicPartition one : removed) {
      Partition partition = partitions.remove(one);
      if (partition != null) {
        left +=
            partition.held.stream()
                .filter(record -> record.originalKafkaOffset() < partition.claimed)
                .count();
      }
    }
    return left;
  }

  /** Returns whether another task may have written a record. */
  public boolean isUnknown(SinkRecord record) {
    Partition partition = partitions.get(of(record));
    return partition != null && record.originalKafkaOffset() < partition.unknown;
  }

  /** Holds a record until it is claimed and written. */
  public void hold(SinkRecord record) {
    Partition partition = partitions.get(of(record));
    if (partition == null) {
      throw new IllegalStateException(of(record) + " is not assigned");
    }
    partition.held.add(record);
  }

  /** Returns whether no records wait for a claim or a write. */
  public boolean isEmpty() {
    return partitions.values().stream().allMatch(one -> one.held.isEmpty());
  }

  /** Returns whether there are records that are claimed but not written yet. */
  public boolean hasClaimed() {
    return partitions.values().stream().anyMatch(Partition::hasClaimed);
  }

  /** Claims all held records. The claim is valid once it is committed and verified. */
  public void claim() {
    for (Partition partition : partitions.values()) {
      if (!partition.held.isEmpty()) {
        partition.claimed = partition.held.getLast().originalKafkaOffset() + 1;
      }
    }
  }

  /** Returns the offsets to commit, with the claims. */
  public Map<TopicPartition, OffsetAndMetadata> offsets(
      Map<TopicPartition, OffsetAndMetadata> current) {
    Map<TopicPartition, OffsetAndMetadata> offsets = new HashMap<>();
    current.forEach(
        (one, position) -> {
          Partition partition = partitions.get(one);
          if (partition != null) {
            offsets.put(one, offset(partition, position.offset()));
          }
        });
    return offsets;
  }

  private OffsetAndMetadata offset(Partition partition, long position) {
    long from = partition.first(position);
    // unknown outcomes stay claimed until reported: Connect commits all partitions together
    long to = partition.hasClaimed() ? partition.claimed : Math.max(from, partition.unknown);
    return new OffsetAndMetadata(
        Math.min(to, position), "jopenshowvar " + owner + " from " + from + " to " + to);
  }

  /**
   * Asks the brokers whether the claims of this task are committed.
   *
   * @param lease renewed if they are
   */
  public boolean verify(Lease lease) {
    Moment moment = Moment.now();
    Map<TopicPartition, OffsetAndMetadata> committed;
    try {
      committed = committed(patience);
      complaint = "";
    } catch (ConnectException e) {
      String message = String.valueOf(e.getMessage());
      if (!message.equals(complaint)) {
        LOG.warn("nothing is written: {}", message);
      }
      complaint = message;
      return false;
    }
    for (Map.Entry<TopicPartition, Partition> one : partitions.entrySet()) {
      Partition partition = one.getValue();
      if (partition.hasClaimed()) {
        OffsetAndMetadata offset = committed.get(one.getKey());
        Matcher claim = METADATA.matcher(offset == null ? "" : offset.metadata());
        if (offset == null
            || offset.offset() != partition.claimed
            || !claim.matches()
            || !claim.group(1).equals(owner)) {
          return false;
        }
      }
    }
    lease.renew(moment);
    return true;
  }

  /** Returns the records that are claimed and not settled, those of a partition in their order. */
  public List<SinkRecord> claimed() {
    return partitions.values().stream()
        .flatMap(
            one -> one.held.stream().filter(record -> record.originalKafkaOffset() < one.claimed))
        .toList();
  }

  /** Marks a record as written or reported. */
  public void settle(SinkRecord record) {
    Partition partition = partitions.get(of(record));
    if (partition != null) {
      boolean unused = partition.held.remove(record);
    }
  }

  /** Returns the assigned partitions. */
  public TopicPartition[] assigned() {
    return partitions.keySet().toArray(TopicPartition[]::new);
  }

  /** Returns the committed offsets of the group. */
  private Map<TopicPartition, OffsetAndMetadata> committed(Duration longest) {
    String failed = "cannot read the offsets of the group " + group + ": ";
    try {
      return admin
          .listConsumerGroupOffsets(group)
          .partitionsToOffsetAndMetadata()
          .get(longest.toMillis(), TimeUnit.MILLISECONDS);
    } catch (ExecutionException e) {
      Throwable cause = e.getCause();
      throw new ConnectException(failed + (cause == null ? e : cause), e);
    } catch (TimeoutException e) {
      throw new ConnectException(failed + "the brokers do not answer", e);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new ConnectException(failed + "interrupted", e);
    }
  }

  @Override
  public void close() {
    admin.close(Duration.ZERO);
  }
}
