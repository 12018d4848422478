package no.hials.crosscom.control;

import java.time.Duration;
import java.util.concurrent.atomic.AtomicLong;
import no.hials.crosscom.simulator.Controller;

/**
 * Lets the time of a loop be that of a simulated controller, which passes only while the loop
 * waits: so every run is the same, however fast the computer is.
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

  /** Lets time pass for the loop, as if an access had taken it. */
  void pass(Duration time) {
    now.addAndGet(time.toNanos());
  }
}
