package no.hials.crosscom;

import static no.hials.crosscom.Sample.ReadingStatus.FAILED;
import static no.hials.crosscom.Sample.ReadingStatus.FRESH;
import static no.hials.crosscom.Sample.ReadingStatus.MISSED;

import java.time.Duration;
import java.time.Instant;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Set;
import java.util.concurrent.SubmissionPublisher;
import java.util.concurrent.atomic.AtomicLong;
import no.hials.crosscom.Batch.Item;
import no.hials.crosscom.KRL.KRLAny;
import no.hials.crosscom.KRL.KRLVariable;
import no.hials.crosscom.Sample.Reading;
import no.hials.crosscom.Sample.ReadingStatus;
import no.hials.crosscom.internal.exchange.TextAnswer;
import no.hials.crosscom.protocol.value.DeadBand;
import org.jspecify.annotations.Nullable;

/**
 * Creates the samples of a watch from its readings, and publishes them. One thread at a time uses
 * it; since it creates records of the program, this is a thread of samplers.
 */
final class Sampler {
  private final WatchConfig config;
  private final List<SubmissionPublisher<Sample>> publishers;
  private final List<Watched> watched;
  private final List<KRLVariable> variables;
  private final AtomicLong dropped = new AtomicLong();
  private long samples;
  private long missedInSamples;
  private long failedSinceSample;
  private boolean lastFailed;

  /** The readings last reported as changed; the dead band is relative to them. */
  private final Map<String, Reading> published = new HashMap<>();

  /** The changes in dropped samples, which the next sample repeats. */
  private final Set<String> undelivered = new HashSet<>();

  Sampler(WatchConfig config, List<SubmissionPublisher<Sample>> publishers) {
    this.config = config;
    this.publishers = publishers;
    this.watched =
        config.handles().isEmpty()
            ? config.names().stream().map(name -> new Watched(name, null, config)).toList()
            : config.handles().stream().map(h -> new Watched(h.name(), h, config)).toList();
    this.variables = watched.stream().map(Watched::variable).toList();
  }

  /** Returns the variables to read; any thread may call it. */
  List<KRLVariable> variables() {
    return variables;
  }

  /** Returns the number of dropped samples; any thread may call it. */
  long dropped() {
    return dropped.get();
  }

  /** Returns the failure of a whole reading; null if only single variables could not be read. */
  static @Nullable CrossComException failure(List<Item> items) {
    for (Item item : items) {
      CrossComException failure = item.failure;
      if (failure != null && !Batch.isOfOneItem(failure)) {
        return failure;
      }
    }
    return null;
  }

  /**
   * Publishes the sample of a reading, if it is wanted.
   *
   * @param items the variables and their answers or failures
   * @param time when the reading began
   * @param startNanos the same, by {@link System#nanoTime}
   * @param duration how long it took
   * @param missedBefore the number of periods missed before it, since the start of the watch
   */
  void add(List<Item> items, Instant time, long startNanos, Duration duration, long missedBefore) {
    Map<String, Reading> readings = new LinkedHashMap<>();
    ReadResults results = config.handles().isEmpty() ? ReadResults.NONE : new ReadResults();
    Set<String> changed = new HashSet<>();
    CrossComException failure = failure(items);
    boolean failedBefore = lastFailed;
    lastFailed = failure != null;
    if (failure != null) {
      failedSinceSample++;
      if (!config.missedSamples() || (failedBefore && config.changesOnly())) {
        return;
      }
      for (Watched variable : watched) {
        readings.put(variable.name, variable.failed(failure, MISSED, time, Duration.ZERO, results));
      }
    } else {
      changed.addAll(undelivered);
      for (int i = 0; i < items.size(); i++) {
        String name = items.get(i).name();
        Watched variable = watched.get(i);
        Item item = items.get(i);
        // the clock may be changed within a sample
        Instant sent = item.accessed ? time.plusNanos(item.sentNanos - startNanos) : time;
        Reading reading = variable.reading(item, sent, results);
        if (variable.differs(published.get(name), reading)) {
          changed.add(name);
        }
        readings.put(name, changed.contains(name) ? reading : reading.asRepeated());
      }
    }
    if (failure != null || !changed.isEmpty() || !config.changesOnly()) {
      long missedNow = missedBefore - missedInSamples;
      publish(
          new Sample(
              ++samples,
              time,
              startNanos,
              duration,
              readings,
              results,
              changed,
              missedNow,
              failedSinceSample),
          missedBefore);
    }
  }

  private void publish(Sample sample, long missedBefore) {
    sample.changed().forEach(name -> published.put(name, sample.readings().get(name)));
    long before = dropped.get();
    for (SubmissionPublisher<Sample> publisher : publishers) {
      publisher.offer(
          sample,
          (subscriber, lost) -> {
            dropped.incrementAndGet();
            return false;
          });
    }
    if (dropped.get() == before) {
      missedInSamples = missedBefore;
      failedSinceSample = 0;
      undelivered.removeAll(sample.changed()); // all of them, if the sample has values
    } else {
      // the next sample repeats the changes, so that a slow listener gets the last values too
      undelivered.addAll(sample.changed());
    }
  }

  /** A variable of the watch, whose value only the sampler sets. */
  private static final class Watched {
    private final String name;
    private final KRLAny any;
    private final @Nullable Handle<?> handle;
    private final @Nullable Slot<?> slot;
    private final DeadBand deadBand;

    Watched(String name, @Nullable Handle<?> handle, WatchConfig config) {
      this.name = name;
      this.any = new KRLAny(name);
      this.handle = handle;
      this.slot = handle == null ? null : Slot.of(name, handle.type());
      boolean isReal =
          handle != null && (handle.type() == Double.class || handle.type() == double[].class);
      this.deadBand = new DeadBand(config.deadBand(), isReal);
    }

    boolean differs(@Nullable Reading before, Reading now) {
      if (before == null || before.value() == null || now.value() == null) {
        return before == null || before.value() != now.value();
      }
      return deadBand.differs(before.value(), now.value());
    }

    KRLVariable variable() {
      return slot == null ? any : slot.variable();
    }

    Reading reading(Item item, Instant time, ReadResults results) {
      CrossComException failure = item.failure;
      Duration accessTime = Duration.ofNanos(item.nanos);
      if (failure == null) {
        try {
          TextAnswer answer = Objects.requireNonNull(item.answer);
          VariableExchange.take(any, answer, false);
          if (handle != null && slot != null) {
            VariableExchange.take(slot.variable(), answer, false);
            results.add(handle, slot.value());
          }
          return new Reading(any.getValue(), null, FRESH, time, accessTime);
        } catch (CrossComValueException e) {
          failure = e;
        }
      }
      return failed(failure, FAILED, time, accessTime, results);
    }

    Reading failed(
        CrossComException failure,
        ReadingStatus status,
        Instant time,
        Duration accessTime,
        ReadResults results) {
      if (handle != null) {
        results.add(handle, failure);
      }
      return new Reading(null, failure, status, time, accessTime);
    }
  }
}
