package no.hials.crosscom;

import java.util.concurrent.CompletableFuture;
import java.util.concurrent.Executor;
import java.util.concurrent.LinkedBlockingQueue;
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
  private static final ThreadLocal<@Nullable Cancellation> CALL = new ThreadLocal<>();

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
    Cancellation call = CALL.get();
    if (call != null) {
      call.commit();
    }
  }

  /** Queues an operation, which its first exchange commits. */
  <T extends @Nullable Object> CompletableFuture<T> async(CancellableOperation<T> operation) {
    return AsyncCall.submit(
        async,
        callbacks,
        call -> {
          CALL.set(call);
          try {
            return operation.run(call);
          } finally {
            CALL.remove();
          }
        });
  }

  /** Queues a transfer of a file, which commits itself. */
  <T> CompletableFuture<T> transfer(CancellableOperation<T> operation) {
    return AsyncCall.submit(transfers, callbacks, operation);
  }

  /** Runs no more operations; those that are queued fail soon, because the client is closed. */
  void shutdown() {
    transfers.shutdown();
    async.shutdown();
  }

  /**
   * Creates an executor with a daemon thread for each task, for the program's code, where no task
   * may wait for another. Its threads end when idle, so it need not be shut down.
   */
  static Executor forCallbacks(String name) {
    return new ThreadPoolExecutor(
        0, Integer.MAX_VALUE, 1, TimeUnit.SECONDS, new SynchronousQueue<>(), daemons(name));
  }

  private static ThreadFactory daemons(String name) {
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
