package no.hials.crosscom.gateway.internal.writing;

import java.time.Duration;
import java.util.Map;
import java.util.concurrent.ArrayBlockingQueue;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.RejectedExecutionException;
import java.util.concurrent.ThreadPoolExecutor;
import java.util.concurrent.TimeUnit;
import no.hials.crosscom.cell.DaemonThreadFactory;

/**
 * A thread for each robot that is written to, with a queue, so that a slow robot delays no other
 * one. A task that it does not take throws {@link RejectedExecutionException} with the reason.
 * Thread-safe.
 */
public final class RobotThreads {
  /** The maximum number of writes that wait for a robot. */
  public static final int MAX_WAITING = 16;

  /** A write that waited longer, for example for a robot that did not answer, is out of date. */
  public static final Duration LONGEST_WAIT = Duration.ofSeconds(5);

  /** The reason for the refusal of a write that waited longer. */
  public static final String TOO_LATE =
      "it waited more than " + LONGEST_WAIT.toSeconds() + " s for others to end";

  /** The time for the running writes when the gateway ends. */
  private static final Duration LONGEST_END = Duration.ofSeconds(2);

  private static final long IDLE_SECONDS = 10;

  private final String prefix;
  private final Map<String, ThreadPoolExecutor> threads = new ConcurrentHashMap<>();

  /**
   * Creates an object without threads.
   *
   * @param prefix the names of its threads, before that of the robot
   */
  public RobotThreads(String prefix) {
    this.prefix = prefix;
  }

  /** Returns the thread of a robot, which ends when it has had nothing to do for some time. */
  public ExecutorService of(String robot) {
    return threads.computeIfAbsent(robot, this::create);
  }

  private ThreadPoolExecutor create(String robot) {
    ThreadPoolExecutor executor =
        new ThreadPoolExecutor(
            1,
            1,
            IDLE_SECONDS,
            TimeUnit.SECONDS,
            new ArrayBlockingQueue<>(MAX_WAITING),
            DaemonThreadFactory.named(prefix + robot),
            (task, pool) -> {
              throw new RejectedExecutionException(
                  pool.isShutdown() ? "the gateway ends" : MAX_WAITING + " commands are waiting");
            }) {
          @Override
          public void execute(Runnable task) {
            try {
              super.execute(task);
            } catch (OutOfMemoryError e) {
              remove(task);
              throw new RejectedExecutionException("no thread can be started", e);
            }
          }
        };
    executor.allowCoreThreadTimeOut(true);
    return executor;
  }

  /** Ends the thread of a robot after the tasks that it has. */
  public void end(String robot) {
    ThreadPoolExecutor executor = threads.remove(robot);
    if (executor != null) {
      executor.shutdown();
    }
  }

  /** Ends all threads after the tasks that they have, and waits a short time for them. */
  public void end() {
    long end = System.nanoTime() + LONGEST_END.toNanos();
    threads.values().forEach(ThreadPoolExecutor::shutdown);
    try {
      for (ThreadPoolExecutor executor : threads.values()) {
        boolean unused = executor.awaitTermination(end - System.nanoTime(), TimeUnit.NANOSECONDS);
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }
}
