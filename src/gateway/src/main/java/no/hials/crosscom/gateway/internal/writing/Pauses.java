package no.hials.crosscom.gateway.internal.writing;

import java.time.Duration;
import java.util.concurrent.Executors;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.ScheduledFuture;
import java.util.concurrent.TimeUnit;
import java.util.function.Supplier;
import no.hials.crosscom.cell.DaemonThreadFactory;
import no.hials.crosscom.cell.Moment;
import no.hials.crosscom.gateway.Lasting;

/**
 * Notices that this process was frozen, by a beat that did not come, or the machine suspended, by
 * its clock, which then looks as if it was set forward. What arrives just after such a pause can
 * have waited in a buffer of the network, so that nobody knows how old it is. Thread-safe.
 */
public final class Pauses implements AutoCloseable {
  private static final long BEAT_MILLIS = 250;

  /** Two beats. A shorter pause is one of the scheduler. */
  private static final Duration SHORTEST = Duration.ofMillis(2 * BEAT_MILLIS);

  private static final Duration AFTER = Duration.ofSeconds(2);

  private final Supplier<Moment> clock;
  private final ScheduledExecutorService timer =
      Executors.newSingleThreadScheduledExecutor(DaemonThreadFactory.named("gateway-beat"));
  private Moment lastBeat;
  private Duration length = Duration.ZERO;

  /** The end of the time after a pause, by {@link Moment#nanos}. */
  private long suspectUntil;

  /** Creates an object without beats of its own. */
  public Pauses(Supplier<Moment> clock) {
    this.clock = clock;
    lastBeat = clock.get();
    suspectUntil = lastBeat.nanos();
  }

  /** Creates an object with regular beats. */
  public static Pauses start() {
    Pauses pauses = new Pauses(Moment::now);
    ScheduledFuture<?> unused =
        pauses.timer.scheduleWithFixedDelay(
            Lasting.task(pauses::beat), BEAT_MILLIS, BEAT_MILLIS, TimeUnit.MILLISECONDS);
    return pauses;
  }

  /** Returns how long what arrives now may have waited while the process was frozen, or zero. */
  public synchronized Duration justOver() {
    // the first thread that runs again need not be that of the beats
    beat();
    return lastBeat.nanos() - suspectUntil < 0 ? length : Duration.ZERO;
  }

  /** Returns the reason for the refusal of a write that can be too old because of a pause. */
  public static String reason(Duration pause) {
    return "the gateway was frozen for %.1f s just before it arrived, so that it can be too old"
        .formatted(pause.toMillis() / 1000.0);
  }

  synchronized void beat() {
    Moment now = clock.get();
    Duration pause = Duration.ofNanos(now.nanosSince(lastBeat));
    if (pause.compareTo(SHORTEST) > 0) {
      boolean again = lastBeat.nanos() - suspectUntil < 0;
      length = again ? length.plus(pause) : pause;
      suspectUntil = now.nanos() + AFTER.toNanos();
    }
    lastBeat = now;
  }

  @Override
  public void close() {
    timer.shutdownNow();
  }
}
