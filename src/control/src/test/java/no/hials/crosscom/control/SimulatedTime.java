package no.hials.crosscom.control;

import java.time.Duration;
import java.util.concurrent.atomic.AtomicLong;
import no.hials.crosscom.simulator.Controller;

/**
 * The time of a simulated controller as the clock of a loop. It passes only while the loop waits,
 * so runs do not depend on the speed of the computer.
 */
final class SimulatedTime implements LoopTime {
  private static final long CYCLE = Duration.ofMillis(12).toNanos();

  private final Controller controller;
  private final AtomicLong now = new AtomicLong(CYCLE);
  private long simulated = CYCLE;

  SimulatedTime(Controller controller) {
    this.controller = controller;
  }

  @Override
  public long nanoTime() {
    return now.get();
  }

  @Override
  public void awaitUntil(long nanoTime) {
    now.set(nanoTime);
    while (simulated + CYCLE <= nanoTime) {
      controller.step(Duration.ofNanos(CYCLE));
      simulated += CYCLE;
    }
  }

  /** Advances the time of the loop, as an access does. */
  void pass(Duration time) {
    now.addAndGet(time.toNanos());
  }
}
