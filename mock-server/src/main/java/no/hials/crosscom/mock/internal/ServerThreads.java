package no.hials.crosscom.mock.internal;

import java.util.ArrayList;
import java.util.List;
import no.hials.crosscom.simulator.internal.core.ThreadJoiner;

/** The threads of a server: all daemons. Safe for use by several threads. */
public final class ServerThreads {
  /** Parsing takes little stack, since the depth of aggregates is limited. */
  private static final long STACK_BYTES = 256 * 1024;

  private final String prefix;

  /** All that may still run; dead ones are removed now and then. */
  private final List<Thread> threads = new ArrayList<>();

  ServerThreads(String prefix) {
    this.prefix = prefix;
  }

  public synchronized Thread start(String role, Runnable task) {
    threads.removeIf(thread -> !thread.isAlive());
    Thread thread = new Thread(null, task, prefix + role, STACK_BYTES);
    thread.setDaemon(true);
    thread.start();
    threads.add(thread);
    return thread;
  }

  /** Ends what waits for a time. */
  synchronized void interrupt() {
    threads.forEach(Thread::interrupt);
  }

  /** Waits until all have ended. */
  public void join() {
    List<Thread> ending;
    synchronized (this) {
      ending = List.copyOf(threads);
    }
    // they end soon: their sockets are closed
    ending.forEach(ThreadJoiner::join);
  }
}
