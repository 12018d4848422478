package no.hials.crosscom.control;

import java.util.concurrent.locks.LockSupport;

/** The clock of a loop; tests use the time of a simulated controller. */
interface LoopTime {
  /** The clock of the computer. */
  LoopTime REAL =
      new LoopTime() {
        @Override
        public long nanoTime() {
          return System.nanoTime();
        }

        @Override
        public void awaitUntil(long nanoTime) {
          LockSupport.parkNanos(this, nanoTime - System.nanoTime());
        }
      };

  /** Returns the time in ns, from an arbitrary origin. */
  long nanoTime();

  /** Waits until a time; may return earlier. */
  void awaitUntil(long nanoTime);
}
