package no.hials.crosscom;

import java.time.Duration;
import java.time.Instant;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.Flow;
import java.util.concurrent.SubmissionPublisher;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicLong;
import java.util.concurrent.locks.LockSupport;
import java.util.function.Consumer;
import java.util.stream.IntStream;
import no.hials.crosscom.KRL.KRLAny;
import no.hials.crosscom.Sample.Reading;
import no.hials.crosscom.protocol.value.KrlArray;
import no.hials.crosscom.protocol.value.KrlReal;
import no.hials.crosscom.protocol.value.KrlStruct;
import no.hials.crosscom.protocol.value.KrlValue;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Reads variables repeatedly, at a fixed period without drift; created by {@link
 * CrossComClient#watch}.
 *
 * <p>A reading that takes longer than a period does not delay later readings: the missed periods
 * are skipped and counted. A slow listener does not delay readings either: samples wait for it up
 * to a limit; further samples are dropped and counted. While the connection is lost, the watch
 * continues; the next sample contains the number of failed readings.
 *
 * <p>It runs the daemon thread {@code crosscom-watch-N}. It ends when it or its client is closed;
 * subscribers then get {@code onComplete}. A variable that cannot be read, for example because its
 * name is too long for a request, is a failed {@link Reading} in each sample. Only an unexpected
 * exception ends the watch with {@code onError}.
 */
public final class Watch implements Flow.Publisher<Sample>, AutoCloseable {
  private static final Logger LOG = LoggerFactory.getLogger(Watch.class);
  private static final AtomicInteger COUNT = new AtomicInteger();

  private final VariableExchange exchange;
  private final ReconnectingConnection connection;
  private final Consumer<Watch> ended;
  private final WatchConfig config;
  private final List<KRLAny> variables;
  private final SubmissionPublisher<Sample> publisher;
  private final Thread thread;
  private final AtomicLong dropped = new AtomicLong();
  private volatile boolean closed;
  private final AtomicLong polls = new AtomicLong();
  private final AtomicLong missed = new AtomicLong();
  private final AtomicLong failed = new AtomicLong();
  private final AtomicLong listenerFailures = new AtomicLong();
  private volatile @Nullable Throwable listenerFailure;

  // used only by the watching thread
  private long samples;
  private long missedSinceSample;
  private long failedSinceSample;

  /** The readings last reported as changed; the dead band is relative to them. */
  private final Map<String, Reading> published = new HashMap<>();

  /** The changes in dropped samples, which the next sample repeats. */
  private final Set<String> undelivered = new HashSet<>();

  Watch(
      VariableExchange exchange,
      ReconnectingConnection connection,
      WatchConfig config,
      ClientRuntime runtime,
      Consumer<Watch> ended) {
    this.exchange = exchange;
    this.connection = connection;
    this.ended = ended;
    this.config = config;
    this.variables = config.names().stream().map(KRLAny::new).toList();
    String name = "crosscom-watch-" + COUNT.incrementAndGet();
    // not shut down: a subscriber may request waiting samples after the end
    this.publisher = new SubmissionPublisher<>(runtime.listeners(), config.bufferSize());
    this.thread = new Thread(this::run, name);
    thread.setDaemon(true);
  }

  void start() {
    thread.start();
  }

  /**
   * Adds a listener.
   *
   * @param listener called with each later sample, one after the other, even after it has thrown an
   *     exception; {@link #listenerFailure} returns its exceptions
   */
  public void addListener(Consumer<? super Sample> listener) {
    Objects.requireNonNull(listener, "listener");
    CompletableFuture<Void> unused =
        publisher.consume(
            sample -> {
              try {
                listener.accept(sample);
              } catch (RuntimeException | Error e) {
                listenerFailed(sample, e);
              }
            });
  }

  private void listenerFailed(Sample sample, Throwable failure) {
    listenerFailure = failure;
    if (listenerFailures.getAndIncrement() == 0) {
      LOG.warn("the listener of a watch failed on sample {}", sample.number(), failure);
    } else {
      LOG.debug("the listener of a watch failed on sample {}: {}", sample.number(), failure);
    }
  }

  /**
   * Adds a subscriber.
   *
   * @param subscriber receives later samples, as many as it requests
   */
  @Override
  public void subscribe(Flow.Subscriber<? super Sample> subscriber) {
    publisher.subscribe(subscriber);
  }

  /** Returns the number of readings started. */
  public long polls() {
    return polls.get();
  }

  /** Returns the number of periods skipped because a reading took too long. */
  public long missedPeriods() {
    return missed.get();
  }

  /** Returns the number of readings that failed as a whole. */
  public long failedPolls() {
    return failed.get();
  }

  /** Returns the number of samples dropped for slow listeners and subscribers. */
  public long droppedSamples() {
    return dropped.get();
  }

  /** Returns how often a listener has thrown an exception. */
  public long listenerFailures() {
    return listenerFailures.get();
  }

  /** Returns the last exception of a listener; null if there was none. The first one is logged. */
  public @Nullable Throwable listenerFailure() {
    return listenerFailure;
  }

  private void run() {
    try {
      long period = config.period().toNanos();
      long next = System.nanoTime();
      while (!closed) {
        long late = System.nanoTime() - next;
        if (late < 0) {
          LockSupport.parkNanos(this, -late);
          continue;
        }
        long leftOut = late / period;
        missed.addAndGet(leftOut);
        missedSinceSample += leftOut;
        next += (leftOut + 1) * period;
        poll();
      }
    } catch (RuntimeException | Error e) {
      LOG.warn("a watch failed", e);
      publisher.closeExceptionally(e);
    } finally {
      ended.accept(this);
      publisher.close();
    }
  }

  private void poll() {
    polls.incrementAndGet();
    Instant time = Instant.now();
    long start = System.nanoTime();
    Map<String, Reading> readings = new LinkedHashMap<>();
    for (VariableResult result : exchange.readAll(variables)) {
      CrossComException failure = result.failure();
      if (failure instanceof CrossComClosedException) {
        close();
        return;
      }
      if (failure != null
          && !(failure instanceof CrossComAccessException)
          && !(failure instanceof CrossComValueException)
          && !(failure instanceof CrossComUnsupportedException)) {
        LOG.debug("a reading failed: {}", failure.getMessage());
        failed.incrementAndGet();
        failedSinceSample++;
        if (connection.isClosed()) {
          close(); // the connection is lost and reconnecting is off
        }
        return;
      }
      readings.put(
          result.variable().getName(),
          new Reading(failure == null ? ((KRLAny) result.variable()).getValue() : null, failure));
    }
    Duration duration = Duration.ofNanos(System.nanoTime() - start);
    Set<String> changed = changed(readings);
    if (!changed.isEmpty() || !config.changesOnly()) {
      publish(
          new Sample(
              ++samples, time, duration, readings, changed, missedSinceSample, failedSinceSample));
    }
  }

  private void publish(Sample sample) {
    sample.changed().forEach(name -> published.put(name, sample.readings().get(name)));
    long before = dropped.get();
    publisher.offer(
        sample,
        (subscriber, lost) -> {
          dropped.incrementAndGet();
          return false;
        });
    if (dropped.get() == before) {
      missedSinceSample = 0;
      failedSinceSample = 0;
      undelivered.clear();
    } else {
      // the next sample repeats the changes, so that a slow listener gets the last values too
      undelivered.addAll(sample.changed());
    }
  }

  private Set<String> changed(Map<String, Reading> readings) {
    Set<String> changed = new HashSet<>(undelivered);
    readings.forEach(
        (name, reading) -> {
          if (differs(published.get(name), reading)) {
            changed.add(name);
          }
        });
    return changed;
  }

  private boolean differs(@Nullable Reading before, Reading now) {
    if (before == null || before.value() == null || now.value() == null) {
      return before == null || before.value() != now.value();
    }
    return differs(before.value(), now.value());
  }

  private boolean differs(KrlValue before, KrlValue now) {
    if (before instanceof KrlReal a && now instanceof KrlReal b) {
      return Math.abs((double) a.value() - b.value()) > config.deadBand();
    }
    if (before instanceof KrlStruct a && now instanceof KrlStruct b) {
      return a.fields().size() != b.fields().size()
          || b.fields().stream()
              .anyMatch(f -> a.get(f.name()).map(old -> differs(old, f.value())).orElse(true));
    }
    if (before instanceof KrlArray a && now instanceof KrlArray b) {
      int size = a.elements().size();
      return size != b.elements().size()
          || IntStream.range(0, size)
              .anyMatch(i -> differs(a.elements().get(i), b.elements().get(i)));
    }
    return !before.equals(now);
  }

  /** Ends the watch after the current reading, and completes the subscribers. */
  @Override
  public void close() {
    closed = true;
    LockSupport.unpark(thread);
  }
}
