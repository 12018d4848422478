package no.hials.crosscom.simulator.internal.core;

/** Waits for threads of the server. */
public final class ThreadJoiner {
  private ThreadJoiner() {}

  /**
   * Waits until a thread has ended, without giving up: it is for one that ends soon. An interrupt
   * is kept for afterwards. Does nothing on that thread itself, which may close the server, too.
   *
   * @param thread the thread
   */
  public static void join(Thread thread) {
    boolean interrupted = false;
    while (thread != Thread.currentThread() && thread.isAlive()) {
      try {
        thread.join();
      } catch (InterruptedException e) {
        interrupted = true;
      }
    }
    if (interrupted) {
      Thread.currentThread().interrupt();
    }
  }
}
