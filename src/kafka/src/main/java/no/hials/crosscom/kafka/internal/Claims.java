package no.hials.crosscom.kafka.internal;

import static java.util.Objects.requireNonNull;

import java.time.Duration;
import java.util.ArrayDeque;
import java.util.Collection;
import java.util.Deque;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.NavigableMap;
import java.util.Optional;
import java.util.TreeMap;
import java.util.UUID;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import no.hials.crosscom.cell.Moment;
import org.apache.kafka.clients.admin.Admin;
import org.apache.kafka.clients.consumer.OffsetAndMetadata;
import org.apache.kafka.common.TopicPartition;
import org.apache.kafka.connect.errors.ConnectException;
import org.apache.kafka.connect.sink.SinkRecord;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * The records of a sink task and their claims. Before records are written, their offset is
 * committed together with a {@link Claim}, in the metadata of the offset. Only the member of the
 * group that has the partition can commit, and only an owner that reads its own claim back may
 * write. A claim found when a partition is assigned belongs to a task that ended before it
 * finished: whether its records were written is unknown. Records that a task did not try are
 * released: then the next task writes them. Not thread-safe.
 */
public final class Claims implements AutoCloseable {
  private static final Logger LOG = LoggerFactory.getLogger(Claims.class);

  /** The number of held records from which no more of the partition are asked for. */
  private static final int MOST_HELD = 500;

  private final Admin admin;
  private final String group;
  private final Duration patience;
  private final String owner = UUID.randomUUID().toString();
  private final Map<TopicPartition, Partition> partitions = new LinkedHashMap<>();

  /** Tells the claims of this task apart: a commit that comes late must not prove a newer one. */
  private long number;

  /** Why the offsets could not be read the last time, so that it is logged once. */
  private String complaint = "";

  /** A partition that the task has. */
  private static final class Partition {
    private final Deque<SinkRecord> held = new ArrayDeque<>();

    /** The end of the claim; records below it may be written once the claim is verified. */
    private long claimed;

    /** The end of the records that the task before had claimed. */
    private long unknown;

    /** The records that the task before had written or reported. */
    private NavigableMap<Long, Long> settledBefore = new TreeMap<>();

    boolean isSettled(long offset) {
      Map.Entry<Long, Long> before = settledBefore.floorEntry(offset);
      return before != null && offset < before.getValue();
    }

    /** Returns the settled records after the first one that is not settled. */
    NavigableMap<Long, Long> settled(long position) {
      NavigableMap<Long, Long> settled = new TreeMap<>();
      long end = first(position);
      for (SinkRecord record : held) {
        if (record.originalKafkaOffset() > end) {
          settled.put(end, record.originalKafkaOffset());
        }
        end = record.originalKafkaOffset() + 1;
      }
      if (end < position) {
        settled.put(end, position);
      }
      long seen = Math.max(end, position);
      settledBefore.forEach(
          (start, stop) -> {
            if (stop > seen) {
              settled.put(Math.max(start, seen), stop);
            }
          });
      return settled;
    }

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

  /** Returns the partition that a record came from. */
  public static TopicPartition partitionOf(SinkRecord record) {
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
    return open(added, committed(longest));
  }

  Map<TopicPartition, Long> open(
      Collection<TopicPartition> added, Map<TopicPartition, OffsetAndMetadata> committed) {
    Map<TopicPartition, Long> back = new HashMap<>();
    for (TopicPartition one : added) {
      Partition partition = new Partition();
      partitions.put(one, partition);
      claim(committed.get(one))
          .ifPresent(
              claim -> {
                partition.unknown = claim.to();
                partition.settledBefore = claim.settled();
                if (claim.from() < claim.to()) {
                  back.put(one, claim.from());
                }
              });
    }
    return back;
  }

  private static Optional<Claim> claim(@Nullable OffsetAndMetadata offset) {
    return Claim.parse(offset == null ? "" : offset.metadata());
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

  /** Returns whether another task has written or reported a record. */
  public boolean isSettled(SinkRecord record) {
    Partition partition = partitions.get(partitionOf(record));
    return partition != null && partition.isSettled(record.originalKafkaOffset());
  }

  /** Returns held records that another task may have written: they are reported, not written. */
  public List<SinkRecord> unknown() {
    return partitions.values().stream()
        .flatMap(one -> one.held.stream().takeWhile(it -> it.originalKafkaOffset() < one.unknown))
        .toList();
  }

  /** Holds a record until it is written or reported. */
  public void hold(SinkRecord record) {
    Partition partition = partitions.get(partitionOf(record));
    if (partition == null) {
      throw new IllegalStateException(partitionOf(record) + " is not assigned");
    }
    partition.held.add(record);
  }

  /** Returns whether no records wait. */
  public boolean isEmpty() {
    return partitions.values().stream().allMatch(one -> one.held.isEmpty());
  }

  /** Returns whether there are records that are claimed but not written yet. */
  public boolean hasClaimed() {
    return partitions.values().stream().anyMatch(Partition::hasClaimed);
  }

  /** Claims all held records. The claim is valid once it is committed and verified. */
  public void claim() {
    number++;
    for (Partition partition : partitions.values()) {
      if (!partition.held.isEmpty()) {
        partition.claimed = partition.held.getLast().originalKafkaOffset() + 1;
      }
    }
  }

  /**
   * Ends the claim of the records that are not settled, none of which was tried. The partition that
   * came first is the last one of the next claim.
   */
  public void release() {
    number++;
    partitions.values().forEach(one -> one.claimed = 0);
    partitions.keySet().stream()
        .findFirst()
        .ifPresent(first -> partitions.put(first, requireNonNull(partitions.remove(first))));
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
    long claimed = partition.hasClaimed() ? partition.claimed : from;
    long to = Math.max(claimed, partition.unknown);
    Claim claim = new Claim(id(), from, to, partition.settled(position)).fitting();
    return new OffsetAndMetadata(Math.min(claim.to(), position), claim.print());
  }

  private String id() {
    return owner + "-" + number;
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
    if (!areCommitted(committed)) {
      return false;
    }
    lease.renew(moment);
    return true;
  }

  boolean areCommitted(Map<TopicPartition, OffsetAndMetadata> committed) {
    return partitions.entrySet().stream()
        .filter(one -> one.getValue().hasClaimed())
        .allMatch(
            one ->
                claim(committed.get(one.getKey()))
                    .filter(it -> it.owner().equals(id()) && it.to() >= one.getValue().claimed)
                    .isPresent());
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
    Partition partition = partitions.get(partitionOf(record));
    if (partition != null) {
      boolean unused = partition.held.remove(record);
    }
  }

  /** Returns the assigned partitions. */
  public TopicPartition[] assigned() {
    return partitions.keySet().toArray(TopicPartition[]::new);
  }

  /** Returns the partitions of which enough records are held. */
  public TopicPartition[] full() {
    return partitions.entrySet().stream()
        .filter(one -> one.getValue().held.size() >= MOST_HELD)
        .map(Map.Entry::getKey)
        .toArray(TopicPartition[]::new);
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
