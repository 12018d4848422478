package no.hials.crosscom.gateway.internal.broker;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Iterator;
import java.util.concurrent.TimeUnit;
import org.jspecify.annotations.Nullable;

/**
 * Tasks for the thread of a session, which other threads add without waiting. The number of waiting
 * updates is limited: above the limit, the oldest tasks with updates are dropped. Thread-safe.
 */
final class Inbox {
  /** After this time, an update is stored rather than kept in memory. */
  private static final long LONGEST_WAIT = TimeUnit.SECONDS.toNanos(2);

  private final int limit;
  private final Deque<Task> tasks = new ArrayDeque<>();
  private int updates;

  /**
   * A task.
   *
   * @param updates the number of its updates; 0 for a task that is never dropped
   * @param addedAt the time in nanoseconds
   */
  record Task(int updates, Runnable action, long addedAt) {}

  Inbox(int limit) {
    this.limit = limit;
  }

  /** Adds a task, and returns the number of updates that were dropped to make room. */
  synchronized int add(int more, Runnable action) {
    tasks.add(new Task(more, action, System.nanoTime()));
    updates += more;
    int dropped = 0;
    for (Iterator<Task> all = tasks.iterator(); updates > limit && all.hasNext(); ) {
      Task task = all.next();
      if (task.updates > 0) {
        all.remove();
        updates -= task.updates;
        dropped += task.updates;
      }
    }
    return dropped;
  }

  /** Removes and returns the oldest task, or null. */
  synchronized @Nullable Runnable poll() {
    Task task = tasks.poll();
    if (task == null) {
      return null;
    }
    updates -= task.updates;
    return task.action;
  }

  /** Returns whether the waiting updates exceed half of the limit, or the oldest waits too long. */
  synchronized boolean isLate() {
    Task oldest = tasks.peek();
    return updates > limit / 2
        || (oldest != null && System.nanoTime() - oldest.addedAt > LONGEST_WAIT);
  }

  /** Runs the tasks that wait. */
  void runAll() {
    for (Runnable task = poll(); task != null; task = poll()) {
      task.run();
    }
  }
}
