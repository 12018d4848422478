package no.hials.crosscom.simulator.internal;

/** Waits for threads to end. */
public final class ThreadJoiner {
  private ThreadJoiner() {}

  /**
   * Waits until a thread has ended, even if interrupted, for a thread that ends soon. The interrupt
   * flag is restored. Returns at once if called on that thread itself.
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
