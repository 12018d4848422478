package no.hials.crosscom.internal.exchange;

import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.RejectedExecutionException;
import java.util.concurrent.RejectedExecutionHandler;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.ScheduledFuture;
import java.util.concurrent.ThreadFactory;
import java.util.concurrent.ThreadPoolExecutor;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicBoolean;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * A pool of daemon threads, which end when idle for 1 s. While the system cannot start a thread for
 * a task, the task waits in the queue, and the pool tries again every 100 ms; if the queue does not
 * take it, the handler of rejected tasks does.
 */
public final class DaemonPool extends ThreadPoolExecutor {
  private static final Logger LOG = LoggerFactory.getLogger(DaemonPool.class);

  private static final long RETRY_MILLIS = 100;

  /** The shortest time between two warnings. */
  private static final long WARNING_NANOS = 60_000_000_000L;

  private final ScheduledExecutorService timer;
  private final AtomicBoolean retrying = new AtomicBoolean();
  private volatile long nextWarning = System.nanoTime();

  /**
   * Creates a pool without threads.
   *
   * @param few as many threads start before a task is queued
   * @param most as many start if the queue takes no more tasks
   * @param timer makes the next attempts while the system starts no thread; its thread runs already
   */
  public DaemonPool(
      int few,
      int most,
      BlockingQueue<Runnable> queue,
      ThreadFactory factory,
      RejectedExecutionHandler handler,
      ScheduledExecutorService timer) {
    super(few, most, 1, TimeUnit.SECONDS, queue, factory, handler);
    this.timer = timer;
    if (few > 0) {
      allowCoreThreadTimeOut(true);
    }
  }

  /** Creates a pool with a limit of threads and without a limit of tasks. */
  public DaemonPool(int threads, String name, ScheduledExecutorService timer) {
    this(
        threads,
        threads,
        new LinkedBlockingQueue<>(),
        DaemonThreads.named(name),
        new AbortPolicy(),
        timer);
  }

  @Override
  public void execute(Runnable task) {
    try {
      super.execute(task);
    } catch (OutOfMemoryError e) {
      if (getQueue().contains(task) || getQueue().offer(task)) {
        tryLater(e);
      } else {
        getRejectedExecutionHandler().rejectedExecution(task, this);
      }
    }
  }

  private void tryLater(OutOfMemoryError why) {
    if (!retrying.compareAndSet(false, true)) {
      return;
    }
    long now = System.nanoTime();
    if (now - nextWarning >= 0) {
      nextWarning = now + WARNING_NANOS;
      LOG.warn("tasks wait, because no thread can be started: {}", why.getMessage());
    }
    try {
      ScheduledFuture<?> unused =
          timer.schedule(this::tryAgain, RETRY_MILLIS, TimeUnit.MILLISECONDS);
    } catch (RejectedExecutionException e) {
      LOG.debug("the runtime is closed");
    } catch (OutOfMemoryError e) {
      LOG.debug("the timer tries again as soon as it has a thread itself");
    }
  }

  private void tryAgain() {
    retrying.set(false); // first, since a task may be queued at any time
    if (!getQueue().isEmpty()) {
      try {
        boolean unused = prestartCoreThread(); // also false if there are enough
      } catch (OutOfMemoryError e) {
        tryLater(e);
      }
    }
  }

  /** Ends each thread as soon as it is idle. Later tasks still run. */
  public void endIdleThreads() {
    setKeepAliveTime(1, TimeUnit.NANOSECONDS);
  }
}
