package no.hials.crosscom.gateway.internal.writing;

import java.time.Duration;
import java.util.concurrent.Executors;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.ScheduledFuture;
import java.util.concurrent.TimeUnit;
import java.util.function.LongSupplier;

/**
 * Notices that this process was frozen, by a beat that did not come. What arrives just after such a
 * pause can have waited in a buffer of the network, so that nobody knows how old it is.
 * Thread-safe.
 */
public final class Pauses implements AutoCloseable {
  /** The reason for the refusal of a write that arrives after a pause. */
  public static final String REASON =
      "the gateway was frozen for more than "
          + RobotThreads.LONGEST_WAIT.toSeconds()
          + " s just before, so that nobody knows how old it is";

  private static final long BEAT_MILLIS = 250;
  private static final Duration AFTER = Duration.ofSeconds(2);

  private final LongSupplier nanoTime;
  private final ScheduledExecutorService timer =
      Executors.newSingleThreadScheduledExecutor(
          task -> {
            Thread thread = new Thread(task, "gateway-beat");
            thread.setDaemon(true);
            return thread;
          });
  private long lastBeat;
  private long suspectUntil;

  /** Creates an object without beats of its own. */
  public Pauses(LongSupplier nanoTime) {
    this.nanoTime = nanoTime;
    lastBeat = nanoTime.getAsLong();
    suspectUntil = lastBeat;
  }

  /** Creates an object with regular beats. */
  public static Pauses start() {
    Pauses pauses = new Pauses(System::nanoTime);
    ScheduledFuture<?> unused =
        pauses.timer.scheduleWithFixedDelay(
            pauses::beat, BEAT_MILLIS, BEAT_MILLIS, TimeUnit.MILLISECONDS);
    return pauses;
  }

  /** Returns whether what arrives now may have waited while the process was frozen. */
  public synchronized boolean isJustOver() {
    // the first thread that runs again need not be that of the beats
    beat();
    return lastBeat - suspectUntil < 0;
  }

  synchronized void beat() {
    long now = nanoTime.getAsLong();
    if (now - lastBeat > RobotThreads.LONGEST_WAIT.toNanos()) {
      suspectUntil = now + AFTER.toNanos();
    }
    lastBeat = now;
  }

  @Override
  public void close() {
    timer.shutdownNow();
  }
}
