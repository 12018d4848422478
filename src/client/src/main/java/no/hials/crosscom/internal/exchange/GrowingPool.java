package no.hials.crosscom.internal.exchange;

import java.util.concurrent.Executor;
import java.util.concurrent.Future;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.RejectedExecutionException;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.ThreadPoolExecutor;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicInteger;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Threads for tasks that may block. A few threads run the tasks; while tasks wait for more than 20
 * ms, a thread starts for each of them, but the number of threads at most doubles every 20 ms. A
 * thread ends after 1 s without tasks, or at once if a few others are idle.
 *
 * <p>The timer starts these threads, because the pool may not get another task.
 */
public final class GrowingPool implements Executor {
  private static final Logger LOG = LoggerFactory.getLogger(GrowingPool.class);

  private static final int FEW = 16;
  private static final long PATIENCE_NANOS = 20_000_000;

  /** After this a person should know that all threads are blocked. */
  private static final long LONG_NANOS = 1_000_000_000;

  /**
   * Starts a thread, because the queue refuses it; does nothing if there are as many as allowed.
   */
  private enum Starter implements Runnable {
    START;

    @Override
    public void run() {}
  }

  private final Waiting queue;
  private final DaemonPool threads;
  private final ScheduledExecutorService timer;
  private final String name;
  private final AtomicBoolean checking = new AtomicBoolean();

  /** Used by the timer only. */
  private boolean warned;

  /**
   * Creates a pool without threads.
   *
   * @param most the maximum number of threads
   * @param name the name of each thread
   */
  public GrowingPool(int most, String name, ScheduledExecutorService timer) {
    int few = Math.min(FEW, most);
    this.queue = new Waiting(few);
    this.timer = timer;
    this.name = name;
    this.threads =
        new DaemonPool(
            few,
            most,
            queue,
            DaemonThreads.named(name),
            new ThreadPoolExecutor.DiscardPolicy(),
            timer);
  }

  /** A task and the time since when it waits, by {@link System#nanoTime}. */
  private record Task(Runnable task, long since) implements Runnable {
    @Override
    public void run() {
      task.run();
    }
  }

  /** The tasks that wait, and the threads that wait for tasks. */
  private static final class Waiting extends LinkedBlockingQueue<Runnable> {
    private static final long serialVersionUID = 1L;

    private final int few;
    private final AtomicInteger idle = new AtomicInteger();

    Waiting(int few) {
      this.few = few;
    }

    @Override
    public boolean offer(Runnable task) {
      return task != Starter.START && super.offer(task);
    }

    @Override
    public @Nullable Runnable poll(long timeout, TimeUnit unit) throws InterruptedException {
      try {
        return idle.incrementAndGet() > few ? null : super.poll(timeout, unit);
      } finally {
        idle.decrementAndGet();
      }
    }
  }

  /** Queues a task. The calling thread never runs it. */
  @Override
  public void execute(Runnable task) {
    threads.execute(new Task(task, System.nanoTime()));
    if (!queue.isEmpty()) {
      checkLater();
    }
  }

  private void checkLater() {
    if (checking.compareAndSet(false, true)) {
      try {
        Future<?> unused = timer.schedule(this::check, PATIENCE_NANOS, TimeUnit.NANOSECONDS);
      } catch (RejectedExecutionException e) {
        checking.set(false); // closed: the threads that there are run the rest
      } catch (OutOfMemoryError e) {
        LOG.debug("the timer checks as soon as it has a thread itself");
      }
    }
  }

  private void check() {
    checking.set(false);
    if (queue.peek() instanceof Task oldest) {
      long waited = System.nanoTime() - oldest.since;
      if (waited >= PATIENCE_NANOS) {
        for (int i = Math.min(queue.size(), threads.getPoolSize()); i > 0; i--) {
          threads.execute(Starter.START);
        }
      }
      if (waited >= LONG_NANOS
          && !warned
          && threads.getPoolSize() == threads.getMaximumPoolSize()) {
        warned = true;
        LOG.warn(
            "all {} threads {} are blocked, and {} tasks wait",
            threads.getPoolSize(),
            name,
            queue.size());
      }
      checkLater();
    }
  }

  /** Ends each thread as soon as it is idle. Later tasks still run. */
  public void endIdleThreads() {
    threads.endIdleThreads();
  }
}
