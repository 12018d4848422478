package no.hials.crosscom;

import java.util.concurrent.ScheduledThreadPoolExecutor;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;

/**
 * The threads that clients share. A program with several clients needs only one runtime; {@link
 * #shared} is used unless a configuration names another.
 *
 * <p>All threads are daemons, start when they are needed, and end soon after they are not:
 *
 * <ul>
 *   <li>{@code crosscom-timer-N} ends exchanges that are overdue.
 * </ul>
 */
public final class ClientRuntime implements AutoCloseable {
  private static final AtomicInteger COUNT = new AtomicInteger();
  private static final ClientRuntime SHARED = new ClientRuntime();

  private final ScheduledThreadPoolExecutor timer;

  private ClientRuntime() {
    int number = COUNT.incrementAndGet();
    timer = new ScheduledThreadPoolExecutor(1, Threads.daemons("crosscom-timer-" + number));
    timer.setRemoveOnCancelPolicy(true);
    timer.setKeepAliveTime(1, TimeUnit.SECONDS);
    timer.allowCoreThreadTimeOut(true);
  }

  /** Returns the runtime of this process, which need not be closed. */
  public static ClientRuntime shared() {
    return SHARED;
  }

  /** Creates a runtime. */
  public static ClientRuntime create() {
    return new ClientRuntime();
  }

  ScheduledThreadPoolExecutor timer() {
    return timer;
  }

  /** Ends the threads; clients that still use the runtime fail. */
  @Override
  public void close() {
    timer.shutdownNow();
  }
}
