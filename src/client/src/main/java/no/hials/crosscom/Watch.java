package no.hials.crosscom;

import java.time.Duration;
import java.time.Instant;
import java.util.Iterator;
import java.util.List;
import java.util.Objects;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.Flow;
import java.util.concurrent.Future;
import java.util.concurrent.RejectedExecutionException;
import java.util.concurrent.SubmissionPublisher;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.Consumer;
import no.hials.crosscom.Batch.Item;
import no.hials.crosscom.Sample.Reading;
import no.hials.crosscom.internal.exchange.SerialExecutor;
import no.hials.crosscom.internal.exchange.SubscriberIterator;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Reads variables repeatedly, at a fixed period without drift; created by {@link
 * CrossComClient#watch}. The first reading starts with the first listener, subscriber or iterator,
 * so that none misses it.
 *
 * <p>A reading that takes longer than a period does not delay later readings: the missed periods
 * are skipped and counted. A slow listener does not delay readings either: samples wait for it up
 * to a limit; further samples are dropped and counted. While the connection is lost, the watch
 * continues; the next sample contains the number of failed readings. When there is a connection
 * again and the next reading is more than a second away, it starts at once, and the next ones
 * follow at the period from there.
 *
 * <p>A watch has no thread. The {@link ClientRuntime} of the client starts its readings by the
 * timer and reads in the selector thread, both for all watches; the threads of samplers create the
 * samples, and the threads of listeners call listeners and subscribers. If the constructors of the
 * program's records block all samplers, periods are missed, because at most one reading waits until
 * its sample is created.
 *
 * <p>A watch ends when it, its client or the runtime is closed, or the connection is lost and
 * {@link ClientConfig#reconnect} is off. After one of these {@code close} methods has returned, no
 * listener is called with a sample any more; a call under way goes on. Subscribers still get the
 * samples that wait, as they request them, and then {@code onComplete}; iterators return them. A
 * variable that cannot be read, for example because its name is too long for a request, is a failed
 * {@link Reading} in each sample. Only an unexpected exception ends the watch with {@code onError};
 * a lack of memory does not, its readings are counted as failed.
 */
public final class Watch implements Flow.Publisher<Sample>, Iterable<Sample>, AutoCloseable {
  private static final Logger LOG = LoggerFactory.getLogger(Watch.class);

  /** A reading that is further away is not waited for when there is a connection again. */
  private static final long FAR_AWAY = Duration.ofSeconds(1).toNanos();

  private static final long SOON = Duration.ofMillis(100).toNanos();

  private final VariableExchange exchange;
  private final ReconnectingConnection connection;
  private final C3Channel channel;
  private final WatchConfig config;
  private final ClientRuntime runtime;

  /** Runs the sampler, and completes the subscribers. */
  private final SerialExecutor sampling;

  /** For listeners and subscribers. */
  private final SubmissionPublisher<Sample> publisher;

  /** For iterators, which run no code of the program. */
  private final SubmissionPublisher<Sample> iterators;

  private final Sampler sampler;
  private final AtomicLong polls = new AtomicLong();
  private final AtomicLong missed = new AtomicLong();
  private final AtomicLong failed = new AtomicLong();
  private final AtomicLong listenerFailures = new AtomicLong();
  private volatile @Nullable Throwable listenerFailure;

  /** Whether listeners get no more samples. */
  private volatile boolean listenersDone;

  /** Whether a reading waits until its sample is created. */
  private volatile boolean waiting;

  // guarded by this
  /** When the next reading starts, by {@link System#nanoTime}. */
  private long next;

  private boolean started;
  private boolean reading;
  private boolean readAgain;

  /** Whether a tick is scheduled: then no reading is under way. */
  private boolean scheduled;

  /** The number of ticks that were scheduled. */
  private long ticks;

  private boolean closed;
  private boolean ended;
  private @Nullable Future<?> nextTick;

  Watch(
      VariableExchange exchange,
      ReconnectingConnection connection,
      C3Channel channel,
      WatchConfig config,
      ClientRuntime runtime) {
    this.exchange = exchange;
    this.connection = connection;
    this.channel = channel;
    this.config = config;
    this.runtime = runtime;
    this.sampling = new SerialExecutor(runtime.samplers());
    // not shut down: a subscriber may request waiting samples after the end
    this.publisher = new SubmissionPublisher<>(runtime.listeners(), config.bufferSize());
    this.iterators = new SubmissionPublisher<>(runtime.samplers(), config.bufferSize());
    this.sampler = new Sampler(config, List.of(publisher, iterators));
  }

  /** Starts the first reading, unless it was started before. */
  private void start() {
    synchronized (this) {
      if (started) {
        return;
      }
      started = true;
      next = System.nanoTime();
    }
    connection.add(this);
    scheduleTick();
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
              if (listenersDone) {
                return;
              }
              try {
                listener.accept(sample);
              } catch (RuntimeException | Error e) {
                listenerFailed(sample, e);
              }
            });
    start();
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
   * @param subscriber receives later samples, as many as it requests. An exception of its {@code
   *     onNext} is counted like a listener's, and ends its subscription only
   */
  @Override
  public void subscribe(Flow.Subscriber<? super Sample> subscriber) {
    publisher.subscribe(new Counted(this, Objects.requireNonNull(subscriber, "subscriber")));
    start();
  }

  /** A subscriber whose exceptions are counted; equal if the subscriber is. */
  private record Counted(Watch watch, Flow.Subscriber<? super Sample> subscriber)
      implements Flow.Subscriber<Sample> {
    @Override
    public void onSubscribe(Flow.Subscription subscription) {
      subscriber.onSubscribe(subscription);
    }

    @Override
    public void onNext(Sample sample) {
      try {
        subscriber.onNext(sample);
      } catch (RuntimeException | Error e) {
        watch.listenerFailed(sample, e);
        throw e;
      }
    }

    @Override
    public void onError(Throwable failure) {
      subscriber.onError(failure);
    }

    @Override
    public void onComplete() {
      subscriber.onComplete();
    }
  }

  /**
   * Returns a new iterator of the later samples, whose {@code hasNext} waits for the next sample or
   * the end of the watch. Only one thread at a time can use it. If it is slow, samples wait and are
   * dropped as for a listener, also after the loop has ended: close the watch then.
   *
   * <p>{@code hasNext} and {@code next} throw {@link java.io.UncheckedIOException} if the thread is
   * interrupted, whose flag stays set, and {@link IllegalStateException} if the watch has failed.
   */
  @Override
  public Iterator<Sample> iterator() {
    SubscriberIterator<Sample> iterator = new SubscriberIterator<>();
    iterators.subscribe(iterator);
    start();
    return iterator;
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
    return sampler.dropped();
  }

  /** Returns how often a listener or subscriber has thrown an exception on a sample. */
  public long listenerFailures() {
    return listenerFailures.get();
  }

  /**
   * Returns the last exception of a listener or subscriber; null if there was none. The first one
   * is logged.
   */
  public @Nullable Throwable listenerFailure() {
    return listenerFailure;
  }

  // --- readings, in the threads of the timer and the selector

  private synchronized void scheduleTick() {
    if (closed) {
      return;
    }
    try {
      long number = ++ticks;
      long wait = next - System.nanoTime();
      nextTick = runtime.timer().schedule(() -> tick(number), wait, TimeUnit.NANOSECONDS);
      scheduled = true;
    } catch (RejectedExecutionException e) {
      close(); // the runtime is closed
    }
  }

  /** Called with each new connection: values that were read before are no longer known. */
  synchronized void connected() {
    readAgain = !scheduled; // the reading may still fail with the connection before
    if (scheduled && nextTick != null && isFarAway()) {
      nextTick.cancel(false);
      next = System.nanoTime();
      scheduleTick(); // in place of the one before
    }
  }

  private boolean isFarAway() {
    return next - System.nanoTime() > FAR_AWAY;
  }

  /** Returns whether a tick is the last one that was scheduled, and then moves on to its next. */
  private synchronized boolean take(long number) {
    if (number != ticks) {
      return false;
    }
    scheduled = false;
    long period = config.period().toNanos();
    long late = (System.nanoTime() - next) / period;
    next += (late + 1) * period;
    missed.addAndGet(late);
    return true;
  }

  /** Starts a reading at its time, unless the last one still waits. */
  private void tick(long number) {
    if (!take(number)) {
      return;
    }
    if (waiting) {
      missed.incrementAndGet();
      scheduleTick();
    } else if (begin()) {
      polls.incrementAndGet();
      new WatchReading(exchange, connection, channel, sampler.variables(), new Begun()).start();
    }
  }

  private synchronized boolean begin() {
    reading = !closed;
    return reading;
  }

  /** A reading that has begun. */
  private final class Begun implements WatchReading.Listener {
    private final Instant time = Instant.now();
    private final long start = System.nanoTime();
    private final long missedBefore = missed.get();

    @Override
    public void read(List<Item> items) {
      Duration duration = Duration.ofNanos(System.nanoTime() - start);
      CrossComException failure = Sampler.failure(items);
      boolean lost = false;
      if (failure != null) {
        LOG.debug("a reading failed: {}", failure.getMessage());
        lost = failure instanceof CrossComClosedException;
        if (!lost) {
          failed.incrementAndGet();
        }
        lost |= connection.isClosed(); // or lost with reconnecting off
      }
      waiting = true;
      sampling.execute(() -> sample(items, duration));
      if (lost) {
        stop();
      }
      endReading(failure != null);
    }

    private void sample(List<Item> items, Duration duration) {
      waiting = false;
      try {
        sampler.add(items, time, start, duration, missedBefore);
      } catch (RuntimeException | Error e) {
        if (!outlives(e)) {
          end(e);
        }
      }
    }

    @Override
    public void broken(Throwable failure) {
      if (outlives(failure)) {
        endReading(true);
      } else {
        end(failure);
      }
    }
  }

  /** Returns whether the watch goes on after a failure of a reading: only if memory was short. */
  private boolean outlives(Throwable failure) {
    boolean shortOfMemory = failure instanceof OutOfMemoryError;
    if (shortOfMemory) {
      failed.incrementAndGet();
    }
    LOG.warn(shortOfMemory ? "a reading failed" : "a watch failed", failure);
    return shortOfMemory;
  }

  private void endReading(boolean failed) {
    synchronized (this) {
      reading = false;
      if (readAgain && failed && isFarAway()) {
        next = System.nanoTime() + SOON; // its sample is created first
      }
      readAgain = false;
      if (!closed) {
        scheduleTick();
        return;
      }
    }
    end(null);
  }

  /**
   * Ends the watch after the current reading. No listener is called with later or waiting samples;
   * subscribers and iterators get the waiting ones before the end.
   */
  @Override
  public void close() {
    listenersDone = true;
    stop();
  }

  /** Ends the watch after the current reading, whose sample is for listeners too. */
  private void stop() {
    synchronized (this) {
      closed = true;
      if (reading) {
        return;
      }
    }
    end(null);
  }

  /**
   * Ends the watch.
   *
   * @param failure the failure that ends it; null if it was closed
   */
  private void end(@Nullable Throwable failure) {
    synchronized (this) {
      closed = true;
      if (ended) {
        return;
      }
      ended = true;
      if (nextTick != null) {
        nextTick.cancel(false);
      }
    }
    connection.remove(this);
    sampling.execute(
        () -> {
          for (SubmissionPublisher<Sample> each : List.of(publisher, iterators)) {
            if (failure == null) {
              each.close();
            } else {
              each.closeExceptionally(failure);
            }
          }
        });
  }
}
