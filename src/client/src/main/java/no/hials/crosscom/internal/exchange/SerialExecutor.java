package no.hials.crosscom.internal.exchange;

import java.util.Queue;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.Executor;
import java.util.concurrent.atomic.AtomicInteger;

/** Runs tasks in threads of another executor, one after the other. */
public final class SerialExecutor implements Executor {
  private final Executor threads;
  private final Queue<Runnable> tasks = new ConcurrentLinkedQueue<>();
  private final AtomicInteger count = new AtomicInteger();

  public SerialExecutor(Executor threads) {
    this.threads = threads;
  }

  /**
   * Queues a task.
   *
   * @param task throws nothing
   */
  @Override
  public void execute(Runnable task) {
    tasks.add(task);
    if (count.getAndIncrement() == 0) {
      threads.execute(this::drain);
    }
  }

  private void drain() {
    do {
      tasks.remove().run();
    } while (count.decrementAndGet() > 0);
  }
}
