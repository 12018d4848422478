package no.hials.crosscom.mock.internal;

import java.util.ArrayList;
import java.util.List;
import no.hials.crosscom.simulator.internal.ThreadJoiner;

/** The daemon threads of a server. Safe for use by several threads. */
public final class ServerThreads {
  /** Parsing needs little stack, because the depth of aggregates is limited. */
  private static final long STACK_BYTES = 256 * 1024;

  private final String prefix;

  /** The threads that may still run. */
  private final List<Thread> threads = new ArrayList<>();

  ServerThreads(String prefix) {
    this.prefix = prefix;
  }

  /** Starts a thread whose name ends with its role. */
  public synchronized Thread start(String role, Runnable task) {
    threads.removeIf(thread -> !thread.isAlive());
    Thread thread = new Thread(null, task, prefix + role, STACK_BYTES);
    thread.setDaemon(true);
    thread.start();
    threads.add(thread);
    return thread;
  }

  /** Interrupts all threads, which ends their pauses. */
  synchronized void interrupt() {
    threads.forEach(Thread::interrupt);
  }

  /** Waits until all have ended. */
  public void join() {
    List<Thread> ending;
    synchronized (this) {
      ending = List.copyOf(threads);
    }
    // they end soon, because their sockets are closed
    ending.forEach(ThreadJoiner::join);
  }
}
