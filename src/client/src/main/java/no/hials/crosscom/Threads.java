package no.hials.crosscom;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.Executor;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.RejectedExecutionException;
import java.util.concurrent.SynchronousQueue;
import java.util.concurrent.ThreadFactory;
import java.util.concurrent.ThreadPoolExecutor;
import java.util.concurrent.TimeUnit;
import no.hials.crosscom.internal.CancellableOperation;
import no.hials.crosscom.internal.Cancellation;
import org.jspecify.annotations.Nullable;

/** The executors of a client, which run operations and the program's callbacks. */
final class Threads {
  /** The call of {@link #async} that a thread runs. */
  private static final ThreadLocal<@Nullable Running> RUNNING = new ThreadLocal<>();

  private record Running(Threads of, Cancellation call) {}

  private record Task<T extends @Nullable Object>(
      AsyncCall<T> call, CancellableOperation<T> operation) implements Runnable {
    @Override
    public void run() {
      call.run(operation);
    }
  }

  private final ThreadPoolExecutor async;
  private final ThreadPoolExecutor transfers;
  private final Executor callbacks;

  Threads(int port) {
    async = lazy("crosscom-async-" + port);
    transfers = lazy("crosscom-files-" + port);
    callbacks = forCallbacks("crosscom-callback-" + port);
  }

  /** Commits the call that this thread runs, if any; before each exchange of each client. */
  static void commitCall() {
    Running running = RUNNING.get();
    if (running != null) {
      running.call.commit();
    }
  }

  /**
   * Queues an operation, which its first exchange commits. If another one queues it, it is part of
   * that and runs at once: in the queue it would wait for the other to end.
   */
  <T extends @Nullable Object> CompletableFuture<T> async(CancellableOperation<T> operation) {
    Running running = RUNNING.get();
    if (running != null && running.of == this) {
      return submit(Runnable::run, operation);
    }
    return submit(
        async,
        call -> {
          RUNNING.set(new Running(this, call));
          try {
            return operation.run(call);
          } finally {
            RUNNING.remove();
          }
        });
  }

  /** Queues a transfer of a file, which commits itself. */
  <T> CompletableFuture<T> transfer(CancellableOperation<T> operation) {
    return submit(transfers, operation);
  }

  private <T extends @Nullable Object> CompletableFuture<T> submit(
      Executor executor, CancellableOperation<T> operation) {
    AsyncCall<T> call = new AsyncCall<>(callbacks);
    try {
      executor.execute(new Task<>(call, operation));
    } catch (RejectedExecutionException e) {
      call.refuse();
    }
    return call;
  }

  /** Runs no more operations; those that are queued fail, because the client is closed. */
  void shutdown() {
    for (ThreadPoolExecutor executor : List.of(transfers, async)) {
      executor.shutdown();
      List<Runnable> queued = new ArrayList<>();
      executor.getQueue().drainTo(queued); // the operation under way may wait for one of them
      queued.forEach(task -> ((Task<?>) task).call.refuse());
    }
  }

  /**
   * Creates an executor with a daemon thread for each task, for the program's code, where no task
   * may wait for another. Its threads end when idle, so it need not be shut down.
   */
  static Executor forCallbacks(String name) {
    return new ThreadPoolExecutor(
        0, Integer.MAX_VALUE, 1, TimeUnit.SECONDS, new SynchronousQueue<>(), daemons(name));
  }

  static ThreadFactory daemons(String name) {
    return task -> {
      Thread thread = new Thread(task, name);
      thread.setDaemon(true);
      return thread;
    };
  }

  /** Creates an executor with one daemon thread, which ends when idle. */
  static ThreadPoolExecutor lazy(String name) {
    ThreadPoolExecutor executor =
        new ThreadPoolExecutor(
            1, 1, 1, TimeUnit.SECONDS, new LinkedBlockingQueue<>(), daemons(name));
    executor.allowCoreThreadTimeOut(true);
    return executor;
  }
}
