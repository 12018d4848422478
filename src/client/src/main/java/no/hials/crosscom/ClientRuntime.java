package no.hials.crosscom;

import java.util.List;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.ScheduledThreadPoolExecutor;
import java.util.concurrent.ThreadPoolExecutor;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.Consumer;

/**
 * The threads that clients share. A program with several clients needs only one runtime; {@link
 * #shared} is used unless {@link ClientConfig.Builder#runtime} names another.
 *
 * <p>All threads are daemons and start when they are needed, where N is the number of the runtime:
 *
 * <ul>
 *   <li>{@code crosscom-timer-N} ends exchanges that are overdue, and wakes idle connections.
 *   <li>{@code crosscom-io-N} connects, and does the exchanges of watches and idle connections. It
 *       runs until the runtime is closed.
 *   <li>{@code crosscom-resolver-N}, at most four, find the addresses of host names.
 *   <li>{@code crosscom-callback-N}, at most {@link Builder#callbackThreads}, run the program's
 *       code: listeners, subscribers, and functions that follow on a future. Code that blocks keeps
 *       its thread from others.
 * </ul>
 */
public final class ClientRuntime implements AutoCloseable {
  private static final AtomicInteger COUNT = new AtomicInteger();
  private static final ClientRuntime SHARED = create(cfg -> {});

  private final ScheduledThreadPoolExecutor timer;
  private final SelectorLoop loop;
  private final ThreadPoolExecutor resolver;
  private final ThreadPoolExecutor callbacks;
  private final Set<ReconnectingConnection> connections = ConcurrentHashMap.newKeySet();

  private ClientRuntime(int callbackThreads) {
    int number = COUNT.incrementAndGet();
    timer = new ScheduledThreadPoolExecutor(1, Threads.daemons("crosscom-timer-" + number));
    timer.setRemoveOnCancelPolicy(true);
    timer.setKeepAliveTime(1, TimeUnit.SECONDS);
    timer.allowCoreThreadTimeOut(true);
    loop = new SelectorLoop("crosscom-io-" + number);
    resolver = pool(4, "crosscom-resolver-" + number);
    callbacks = pool(callbackThreads, "crosscom-callback-" + number);
  }

  private static ThreadPoolExecutor pool(int threads, String name) {
    ThreadPoolExecutor pool =
        new ThreadPoolExecutor(
            threads,
            threads,
            1,
            TimeUnit.SECONDS,
            new LinkedBlockingQueue<>(),
            Threads.daemons(name));
    pool.allowCoreThreadTimeOut(true);
    return pool;
  }

  /** Returns the runtime of this process, which need not be closed. */
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
    return new ClientRuntime(builder.callbackThreads);
  }

  ScheduledThreadPoolExecutor timer() {
    return timer;
  }

  SelectorLoop loop() {
    return loop;
  }

  ThreadPoolExecutor resolver() {
    return resolver;
  }

  /** Returns the executor of the program's code. */
  ThreadPoolExecutor callbacks() {
    return callbacks;
  }

  void add(ReconnectingConnection connection) {
    connections.add(connection);
  }

  void remove(ReconnectingConnection connection) {
    connections.remove(connection);
  }

  /** Closes the clients that use this runtime, and ends its threads. */
  @Override
  public void close() {
    List.copyOf(connections).forEach(ReconnectingConnection::close);
    resolver.shutdown();
    timer.shutdownNow();
    loop.close();
  }

  /** Sets the options. Each method sets one option and returns this builder. */
  public static final class Builder {
    private int callbackThreads = 32;

    private Builder() {}

    /** Sets the maximum number of threads that run the program's code, 1 to 1000. Default 32. */
    public Builder callbackThreads(int value) {
      if (value < 1 || value > 1000) {
        throw new IllegalArgumentException("callback threads must be 1 to 1000, are " + value);
      }
      callbackThreads = value;
      return this;
    }
  }
}
