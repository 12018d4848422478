package no.hials.crosscom.internal.exchange;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.channels.ClosedSelectorException;
import java.nio.channels.SelectionKey;
import java.nio.channels.Selector;
import java.nio.channels.SocketChannel;
import java.util.ArrayList;
import java.util.List;
import java.util.Queue;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.Executor;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.locks.LockSupport;
import java.util.concurrent.locks.ReentrantLock;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Waits for many channels in one daemon thread, which starts with the first task. No task may block
 * or run code of the program.
 */
public final class SelectorLoop implements Executor {
  /** The pause after a failure of the system, which would otherwise repeat at once. */
  private static final long PAUSE_NANOS = 100_000_000;

  private static final Logger LOG = LoggerFactory.getLogger(SelectorLoop.class);

  /** The user of a channel. */
  @FunctionalInterface
  public interface Selectable {
    /** Called by the loop when the channel is ready. */
    void ready();
  }

  private final DaemonPool threads;
  private final Queue<Runnable> tasks = new ConcurrentLinkedQueue<>();

  /** The users of channels that are ready, until they have been called. */
  private List<Selectable> ready = new ArrayList<>();

  private @Nullable Selector selector;

  private volatile @Nullable Thread thread;
  private volatile boolean closed;

  /** Whether the thread has ended, so that tasks run in the threads that queue them. */
  private volatile boolean ended;

  private final ReentrantLock remaining = new ReentrantLock();

  /**
   * Creates a loop without a thread.
   *
   * @param name the name of its thread
   * @param timer makes the next attempts while the system starts no thread; its thread runs already
   */
  public SelectorLoop(String name, ScheduledExecutorService timer) {
    this.threads = new DaemonPool(1, name, timer);
  }

  /** Runs a task in the thread of the loop, after the tasks before it. */
  @Override
  public void execute(Runnable task) {
    tasks.add(task);
    if (ended) {
      runRemaining();
    } else if (Thread.currentThread() != thread) {
      start().wakeup();
    }
  }

  private synchronized Selector start() {
    if (selector == null) {
      try {
        selector = Selector.open();
      } catch (IOException e) {
        throw new UncheckedIOException(e);
      }
      threads.execute(this::run);
    }
    return selector;
  }

  /** Takes over a channel. Called by the loop. */
  public SelectionKey register(SocketChannel channel, int operations, Selectable user)
      throws IOException {
    Selector own = start();
    channel.configureBlocking(false);
    try {
      if (channel.isRegistered()) {
        own.selectNow(this::collect); // removes the key that a thread has cancelled
      }
      return channel.register(own, operations, user);
    } catch (ClosedSelectorException e) {
      throw new IOException("the runtime is closed", e);
    }
  }

  private void collect(SelectionKey key) {
    if (key.isValid()) {
      ready.add((Selectable) key.attachment());
    }
  }

  private void run() {
    thread = Thread.currentThread();
    Selector own = start();
    while (!closed) {
      try {
        if (ready.isEmpty()) {
          own.select(this::collect);
        }
      } catch (IOException e) {
        LOG.warn("waiting for channels failed", e);
        LockSupport.parkNanos(PAUSE_NANOS);
      }
      List<Selectable> users = ready;
      ready = new ArrayList<>(users.size());
      users.forEach(user -> runSafely(user::ready));
      runTasks();
    }
    try {
      own.close();
    } catch (IOException e) {
      LOG.debug("closing the selector failed", e);
    }
    ended = true;
    runRemaining();
  }

  /** Runs the tasks that come after the end, such as the failure of an exchange under way. */
  private void runRemaining() {
    if (!remaining.isHeldByCurrentThread()) {
      remaining.lock();
      try {
        runTasks();
      } finally {
        remaining.unlock();
      }
    }
  }

  private void runTasks() {
    for (Runnable task = tasks.poll(); task != null; task = tasks.poll()) {
      runSafely(task);
    }
  }

  private static void runSafely(Runnable task) {
    try {
      task.run();
    } catch (RuntimeException | Error e) {
      LOG.error("a task of the connections failed", e);
    }
  }

  /** Ends the thread. */
  public synchronized void close() {
    closed = true;
    if (selector != null) {
      selector.wakeup();
    }
  }
}
