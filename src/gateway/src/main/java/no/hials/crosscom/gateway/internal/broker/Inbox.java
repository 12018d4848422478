package no.hials.crosscom.gateway.internal.broker;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Iterator;
import org.jspecify.annotations.Nullable;

/**
 * Tasks for the thread of a session, which other threads add without waiting. Tasks with updates
 * are bounded by the number of their updates: the oldest go. Thread-safe.
 */
final class Inbox {
  private final int limit;
  private final Deque<Task> tasks = new ArrayDeque<>();
  private int updates;

  /** A task with so many updates; 0 for one that is never dropped. */
  record Task(int updates, Runnable action) {}

  Inbox(int limit) {
    this.limit = limit;
  }

  /** Adds a task, and returns the number of updates that were dropped for it. */
  synchronized int add(int more, Runnable action) {
    tasks.add(new Task(more, action));
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

  /** Returns the oldest task; null if there is none. */
  synchronized @Nullable Runnable poll() {
    Task task = tasks.poll();
    if (task == null) {
      return null;
    }
    updates -= task.updates;
    return task.action;
  }

  /** Returns whether the room for updates is more than half used. */
  synchronized boolean isHalfFull() {
    return updates > limit / 2;
  }
}
