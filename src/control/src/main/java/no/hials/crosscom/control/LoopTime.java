package no.hials.crosscom.control;

import java.util.concurrent.locks.LockSupport;

/** The time that a loop lives by; a test lets the time of a simulated controller be it. */
interface LoopTime {
  /** The computer's. */
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

  /** Gives the time, ns from some time on. */
  long nanoTime();

  /** Waits until a time; may come back earlier. */
  void awaitUntil(long nanoTime);
}
