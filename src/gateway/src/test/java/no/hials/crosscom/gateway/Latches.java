package no.hials.crosscom.gateway;

import java.util.concurrent.CountDownLatch;

/** Waiting in code that cannot throw an InterruptedException, such as a fault. */
public final class Latches {
  private Latches() {}

  /** Waits until a latch is open or the thread is interrupted, which it then still is. */
  public static void await(CountDownLatch latch) {
    try {
      latch.await();
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }
}
