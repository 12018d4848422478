package no.hials.crosscom.mock.internal;

import java.time.Duration;
import java.util.concurrent.locks.LockSupport;

/** Waits for times far below a millisecond, the resolution of {@link Thread#sleep}. */
final class Pause {
  private Pause() {}

  static void of(Duration time) throws InterruptedException {
    ofNanos(time.toNanos());
  }

  static void ofNanos(long nanos) throws InterruptedException {
    if (nanos <= 0) {
      return;
    }
    long end = System.nanoTime() + nanos;
    long left = nanos;
    while (left > 0) {
      LockSupport.parkNanos(left);
      if (Thread.interrupted()) {
        throw new InterruptedException("interrupted in a pause of " + nanos + " ns");
      }
      left = end - System.nanoTime();
    }
  }
}
