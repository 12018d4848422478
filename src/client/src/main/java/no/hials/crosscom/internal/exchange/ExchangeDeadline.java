package no.hials.crosscom.internal.exchange;

import java.util.concurrent.Future;
import java.util.concurrent.RejectedExecutionException;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicLong;
import org.jspecify.annotations.Nullable;

/**
 * The time limit of the exchanges of one connection.
 *
 * <p>A task of the timer for every exchange would cost more than the exchange. So the timer looks
 * after the connection about once in a time limit: an exchange that began meanwhile is due later.
 * The timer stops after such a time without an exchange; the next exchange starts it again. An
 * exchange creates no objects otherwise.
 */
public final class ExchangeDeadline {
  /** No exchange is under way. */
  private static final long NONE = Long.MIN_VALUE;

  /** The exchange under way was overdue. */
  private static final long EXPIRED = Long.MIN_VALUE + 1;

  /** Added to the present for a time that no exchange reaches. */
  private static final long NEVER = Long.MAX_VALUE / 2;

  private final ScheduledExecutorService timer;
  private final Runnable expired;

  /** When the exchange under way is overdue, by {@link System#nanoTime}; NONE or EXPIRED. */
  private final AtomicLong due = new AtomicLong(NONE);

  /** When the timer looks next, by {@link System#nanoTime}. */
  private volatile long nextLook = System.nanoTime() + NEVER;

  private volatile long limit;

  // guarded by this
  private @Nullable Future<?> task;
  private boolean stopped;

  /** Whether there was no exchange at the last look; used only by the timer. */
  private boolean idle;

  /**
   * Creates the limit of a connection.
   *
   * @param expired called by a thread of the timer when an exchange is overdue
   */
  public ExchangeDeadline(ScheduledExecutorService timer, Runnable expired) {
    this.timer = timer;
    this.expired = expired;
  }

  /** Sets the limit of the next exchanges, in ns; 0 for none. */
  public void setLimit(long nanos) {
    limit = nanos;
  }

  /** Returns the limit of an exchange, in ns; 0 for none. */
  public long limit() {
    return limit;
  }

  /** Begins an exchange, which is overdue at a time by {@link System#nanoTime}. */
  public void begin(long dueAt) {
    due.set(dueAt);
    if (dueAt - nextLook < 0) {
      lookAt(dueAt);
    }
  }

  /** Ends an exchange, and returns whether it was overdue. */
  public boolean end() {
    return due.getAndSet(NONE) == EXPIRED;
  }

  /** Stops the timer. */
  public synchronized void stop() {
    stopped = true;
    if (task != null) {
      task.cancel(false);
    }
  }

  private synchronized void lookAt(long time) {
    if (stopped) {
      return;
    }
    if (task != null) {
      task.cancel(false);
    }
    nextLook = time;
    try {
      task = timer.schedule(this::look, time - System.nanoTime(), TimeUnit.NANOSECONDS);
    } catch (RejectedExecutionException e) {
      expired.run(); // the runtime is closed
    }
  }

  private void look() {
    long now = System.nanoTime();
    long time = due.get();
    if (time == NONE) {
      rest(now);
    } else if (time != EXPIRED && time - now > 0) {
      idle = false;
      lookAt(time);
    } else if (time != EXPIRED && due.compareAndSet(time, EXPIRED)) {
      expired.run();
    }
  }

  /** Looks once more after a time without an exchange; then only after the next exchange begins. */
  private synchronized void rest(long now) {
    if (!idle) {
      idle = true;
      lookAt(now + limit);
      return;
    }
    idle = false;
    task = null;
    nextLook = now + NEVER;
    long time = due.get();
    if (time != NONE) {
      lookAt(time); // an exchange began meanwhile
    }
  }
}
