package no.hials.crosscom.internal.exchange;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.Executor;
import java.util.concurrent.RejectedExecutionException;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.ThreadPoolExecutor;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.Supplier;
import no.hials.crosscom.internal.CancellableOperation;
import no.hials.crosscom.internal.Cancellation;
import org.jspecify.annotations.Nullable;

/** The executors of a client, which run operations and the program's callbacks. */
public final class Threads {
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
  private final int maxPending;
  private final Executor callbacks;
  private final Executor completions;
  private final Supplier<? extends Exception> closed;
  private final AtomicInteger pending = new AtomicInteger();

  /**
   * Creates the executors.
   *
   * @param port the server's port, for the names of the threads
   * @param timer makes the next attempts while the system starts no thread; its thread runs already
   * @param maxPending the maximum number of calls that have not ended
   * @param callbacks runs the functions on the futures of calls
   * @param completions completes the futures of calls that do not run, in another thread
   * @param closed creates the failure of a call if the client is closed
   */
  public Threads(
      int port,
      ScheduledExecutorService timer,
      int maxPending,
      Executor callbacks,
      Executor completions,
      Supplier<? extends Exception> closed) {
    this.async = new DaemonPool(1, "crosscom-async-" + port, timer);
    this.transfers = new DaemonPool(1, "crosscom-files-" + port, timer);
    this.maxPending = maxPending;
    this.callbacks = callbacks;
    this.completions = completions;
    this.closed = closed;
  }

  /** Throws if the call that this thread runs, if any, was cancelled. */
  public static void checkCall() {
    Running running = RUNNING.get();
    if (running != null) {
      running.call.check();
    }
  }

  /**
   * Commits the call that this thread runs, if any: directly before each exchange of each client.
   */
  public static void commitCall() {
    Running running = RUNNING.get();
    if (running != null) {
      running.call.commit();
    }
  }

  /**
   * Does an exchange of the client's own, which is not part of the call that this thread runs: the
   * call can still be cancelled after it.
   */
  public static <T, E extends Exception> T outsideCall(Exchange<T, E> exchange) throws E {
    Running running = RUNNING.get();
    if (running == null) {
      return exchange.run();
    }
    RUNNING.remove();
    try {
      return exchange.run();
    } finally {
      RUNNING.set(running);
    }
  }

  /**
   * An exchange with the server.
   *
   * @param <T> the answer
   * @param <E> the failure
   */
  @FunctionalInterface
  public interface Exchange<T, E extends Exception> {
    T run() throws E;
  }

  /**
   * Queues an operation, which its first exchange commits. If another one queues it, it is part of
   * that and runs at once: in the queue it would wait for the other to end.
   */
  public <T extends @Nullable Object> CompletableFuture<T> async(
      CancellableOperation<T> operation) {
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

  /** Queues a transfer of a file, which decides itself until when it can be cancelled. */
  public <T> CompletableFuture<T> transfer(CancellableOperation<T> operation) {
    return submit(transfers, operation);
  }

  private <T extends @Nullable Object> CompletableFuture<T> submit(
      Executor executor, CancellableOperation<T> operation) {
    if (pending.incrementAndGet() > maxPending) {
      pending.decrementAndGet();
      return CompletableFuture.failedFuture(
          new RejectedExecutionException(
              "the client's maxPendingCalls is "
                  + maxPending
                  + ", and as many calls have not ended; nothing was sent"));
    }
    AsyncCall<T> call = new AsyncCall<>(callbacks, pending::decrementAndGet);
    Task<T> task = new Task<>(call, operation);
    if (executor instanceof ThreadPoolExecutor pool) {
      call.onCancel(() -> pool.remove(task));
    }
    try {
      executor.execute(task);
    } catch (RejectedExecutionException e) {
      call.refuse(completions, closed.get());
    }
    return call;
  }

  /** Runs no more operations; those that are queued fail, because the client is closed. */
  public void shutdown() {
    for (ThreadPoolExecutor executor : List.of(transfers, async)) {
      executor.shutdown();
      List<Runnable> queued = new ArrayList<>();
      executor.getQueue().drainTo(queued); // the operation under way may wait for one of them
      queued.forEach(task -> ((Task<?>) task).call.refuse(completions, closed.get()));
    }
  }
}
