package no.hials.crosscom;

import java.util.List;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.Executor;
import java.util.concurrent.ScheduledThreadPoolExecutor;
import java.util.concurrent.SynchronousQueue;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.Consumer;
import no.hials.crosscom.ConnectionEvent.ChangeReason;
import no.hials.crosscom.internal.exchange.DaemonPool;
import no.hials.crosscom.internal.exchange.DaemonThreads;
import no.hials.crosscom.internal.exchange.GrowingPool;
import no.hials.crosscom.internal.exchange.SelectorLoop;

/**
 * The threads that clients share. A program with several clients needs only one runtime; {@link
 * #shared} is used unless {@link ClientConfig.Builder#runtime} names another.
 *
 * <p>All threads are daemons and start when they are needed, where N is the number of the runtime:
 *
 * <ul>
 *   <li>{@code crosscom-timer-N} ends exchanges that are overdue, wakes idle connections, and
 *       starts the readings of watches. It runs until the runtime is closed.
 *   <li>{@code crosscom-io-N} connects, does the exchanges of watches, and keeps idle connections
 *       alive. It runs until the runtime is closed, too.
 *   <li>{@code crosscom-resolver-N}, at most four, find the addresses of host names.
 *   <li>{@code crosscom-sampler-N}, at most two, create the samples of watches, which calls the
 *       constructors of the program's records, and hand them to iterators. If both are blocked,
 *       watches miss periods.
 *   <li>{@code crosscom-listener-N} call listeners and subscribers. There are at most 16, and more
 *       while calls wait for threads that are blocked: up to twice as many every 20 ms, at most
 *       {@link Builder#listenerThreads}. If all of them are blocked, further calls wait, which is
 *       logged once as a warning; watches, their iterators and all futures go on.
 *   <li>{@code crosscom-callback-N}, at most {@link Builder#callbackThreads}, run the functions
 *       that follow on the future of an asynchronous call or of {@link CrossComClient#connected}.
 *       If all of them are blocked, the thread that ran the call does so, or for a future without a
 *       call a thread of listeners.
 * </ul>
 *
 * <p>While the system cannot start a thread, what it would run waits, which is logged as a warning.
 */
public final class ClientRuntime implements AutoCloseable {
  private static final AtomicInteger COUNT = new AtomicInteger();
  private static final ClientRuntime SHARED = create(cfg -> {});

  private final ScheduledThreadPoolExecutor timer;
  private final SelectorLoop loop;
  private final DaemonPool resolver;
  private final DaemonPool samplers;
  private final GrowingPool listeners;
  private final DaemonPool callbacks;
  private final Set<ReconnectingConnection> connections = ConcurrentHashMap.newKeySet();
  private volatile boolean closed;

  private ClientRuntime(Builder options) {
    int number = COUNT.incrementAndGet();
    timer = new ScheduledThreadPoolExecutor(1, DaemonThreads.named("crosscom-timer-" + number));
    timer.setRemoveOnCancelPolicy(true);
    loop = new SelectorLoop("crosscom-io-" + number, timer);
    resolver = new DaemonPool(4, "crosscom-resolver-" + number, timer);
    samplers = new DaemonPool(2, "crosscom-sampler-" + number, timer);
    listeners = new GrowingPool(options.listenerThreads, "crosscom-listener-" + number, timer);
    callbacks =
        new DaemonPool(
            0,
            options.callbackThreads,
            new SynchronousQueue<>(),
            DaemonThreads.named("crosscom-callback-" + number),
            (task, pool) -> {
              if (task instanceof Completion) {
                listeners.execute(task);
              } else {
                task.run();
              }
            },
            timer);
  }

  /** Returns the runtime of this process, which is never closed. */
  public static ClientRuntime shared() {
    return SHARED;
  }

  /**
   * Creates a runtime.
   *
   * @param settings sets the options that differ from their defaults
   * @return the runtime; the caller closes it
   * @throws IllegalArgumentException if a value is out of its range
   */
  public static ClientRuntime create(Consumer<Builder> settings) {
    Builder builder = new Builder();
    settings.accept(builder);
    return new ClientRuntime(builder);
  }

  ScheduledThreadPoolExecutor timer() {
    return timer;
  }

  SelectorLoop loop() {
    return loop;
  }

  Executor resolver() {
    return resolver;
  }

  /** Returns the executor that creates samples. */
  Executor samplers() {
    return samplers;
  }

  /** Returns the executor of listeners; a task never runs in the thread that submits it. */
  Executor listeners() {
    return listeners;
  }

  /** Returns the executor of functions that follow on a future. */
  Executor callbacks() {
    return callbacks;
  }

  /** A task that the thread that submits it must not run, such as that of the selector. */
  private record Completion(Runnable task) implements Runnable {
    @Override
    public void run() {
      task.run();
    }
  }

  /** Completes a future that no call completes; never in this thread. */
  void complete(Runnable completion) {
    callbacks.execute(new Completion(completion));
  }

  /** Closes a connection when this is closed. */
  void add(ReconnectingConnection connection) {
    connections.add(connection);
    if (closed) {
      connection.close(ChangeReason.RUNTIME_CLOSED);
    }
  }

  boolean isClosed() {
    return closed;
  }

  void remove(ReconnectingConnection connection) {
    connections.remove(connection);
  }

  /**
   * Closes the clients that use this runtime and their watches, and ends its threads as soon as
   * their tasks are done. No client can connect with it later. The shared runtime stays open.
   */
  @Override
  public void close() {
    if (this == SHARED) {
      return;
    }
    closed = true;
    List.copyOf(connections).forEach(connection -> connection.close(ChangeReason.RUNTIME_CLOSED));
    resolver.shutdown();
    samplers.endIdleThreads();
    callbacks.endIdleThreads();
    listeners.endIdleThreads();
    timer.shutdownNow();
    loop.close();
  }

  /** Sets the options. Each method sets one option and returns this builder. */
  public static final class Builder {
    private int listenerThreads = 256;
    private int callbackThreads = 32;

    private Builder() {}

    /** Sets the maximum number of threads that call listeners, 1 to 1000. The default is 256. */
    public Builder listenerThreads(int value) {
      listenerThreads = check("listener", value);
      return this;
    }

    /**
     * Sets the maximum number of threads that run the functions on a future, 1 to 1000. The default
     * is 32.
     */
    public Builder callbackThreads(int value) {
      callbackThreads = check("callback", value);
      return this;
    }

    private static int check(String kind, int value) {
      if (value < 1 || value > 1000) {
        throw new IllegalArgumentException(kind + " threads must be 1 to 1000, are " + value);
      }
      return value;
    }
  }
}
