package no.hials.crosscom.gateway;

import java.util.concurrent.CountDownLatch;
import no.hials.crosscom.mock.Fault;
import no.hials.crosscom.mock.MockServer;

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

  /**
   * Makes a server keep writes without an answer until they are released.
   *
   * @return counted down when the first one arrives
   */
  public static CountDownLatch holdWrites(MockServer server, CountDownLatch released) {
    CountDownLatch arrived = new CountDownLatch(1);
    server.fault(
        request -> {
          if (request.isWrite()) {
            arrived.countDown();
          }
          return request.isWrite();
        },
        Fault.hold(released));
    return arrived;
  }
}
