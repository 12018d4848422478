package no.hials.crosscom.simulator.internal.core;

import java.util.concurrent.locks.LockSupport;
import no.hials.crosscom.simulator.SimulationClock;
import no.hials.crosscom.simulator.internal.ThreadJoiner;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** Runs the cycles of a controller at the pace of its clock, on its own thread. */
public final class Pacemaker implements AutoCloseable {
  private static final Logger LOG = LoggerFactory.getLogger(Pacemaker.class);
  private static final double CYCLE_NANOS = ControllerCore.CYCLE_MILLIS * 1e6;

  /** The maximum number of cycles to catch up; more are skipped rather than run in a rush. */
  private static final double MAX_LAG_CYCLES = 20;

  private final ControllerCore core;
  private final double factor;
  private final boolean unlimited;
  private final Thread thread;
  private volatile boolean closed;

  // the rest is used by the thread alone

  /** The time of the next cycle, in ns. */
  private double due;

  /** The first error of a cycle; null if there was none. */
  private @Nullable VirtualMachineError failure;

  private boolean failureLogged;

  /**
   * Starts the thread.
   *
   * @param clock the pace; not stepped
   */
  public Pacemaker(ControllerCore core, SimulationClock clock, String threadName) {
    this.core = core;
    unlimited = clock instanceof SimulationClock.Unlimited;
    factor = unlimited ? 1 : ((SimulationClock.Running) clock).factor();
    thread = new Thread(this::run, threadName);
    thread.setDaemon(true);
    thread.start();
  }

  private void run() {
    double period = CYCLE_NANOS / factor;
    due = System.nanoTime() + period;
    try {
      while (!closed) {
        waitOrRun(period);
      }
    } catch (RuntimeException e) {
      // an error in the simulation itself, which the core has shown as a message
      LOG.error("the simulated controller has stopped", e);
    }
  }

  /** Waits until the next cycle is due, or runs it. */
  private void waitOrRun(double period) {
    try {
      if (unlimited && core.busy()) {
        cycle();
        due = System.nanoTime() + period;
        return;
      }
      double ahead = due - System.nanoTime();
      if (ahead > 0) {
        LockSupport.parkNanos((long) ahead);
      } else {
        cycle();
        due = Math.max(due, System.nanoTime() - MAX_LAG_CYCLES * period) + period;
      }
    } catch (VirtualMachineError e) {
      // such as too little memory, perhaps because of another thread; nothing is allocated here,
      // and the next cycle that works logs it
      failure = failure == null ? e : failure;
      due = System.nanoTime() + period;
    }
  }

  private void cycle() {
    core.cycle();
    if (failure != null && !failureLogged) {
      LOG.error("a cycle of the simulated controller failed", failure);
      failureLogged = true;
    }
  }

  /** Stops the thread, and waits until the current cycle has ended. */
  @Override
  public void close() {
    closed = true;
    LockSupport.unpark(thread);
    ThreadJoiner.join(thread);
  }
}
