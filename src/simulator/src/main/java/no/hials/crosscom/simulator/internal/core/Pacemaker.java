package no.hials.crosscom.simulator.internal.core;

import java.util.concurrent.locks.LockSupport;
import no.hials.crosscom.simulator.SimulationClock;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** Runs the cycles of a controller at the pace of its clock, on its own thread. */
public final class Pacemaker implements AutoCloseable {
  private static final Logger log = LoggerFactory.getLogger(Pacemaker.class);
  private static final double CYCLE_NANOS = ControllerCore.CYCLE_MILLIS * 1e6;

  /** The most cycles that are caught up with; more are skipped rather than run in a rush. */
  private static final double MAX_LAG_CYCLES = 20;

  private final ControllerCore core;
  private final double factor;
  private final boolean unlimited;
  private final Thread thread;
  private volatile boolean closed;

  /** Whether a failed cycle has been logged; only the thread uses it. */
  private boolean failed;

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
    double due = System.nanoTime() + period;
    try {
      while (!closed) {
        if (unlimited && core.busy()) {
          cycle();
          due = System.nanoTime() + period;
          continue;
        }
        double ahead = due - System.nanoTime();
        if (ahead > 0) {
          LockSupport.parkNanos((long) ahead);
        } else {
          cycle();
          due = Math.max(due, System.nanoTime() - MAX_LAG_CYCLES * period) + period;
        }
      }
    } catch (RuntimeException e) {
      // an error in the simulation itself, which the core has shown as a message
      log.error("the simulated controller has stopped", e);
    }
  }

  private void cycle() {
    try {
      core.cycle();
    } catch (VirtualMachineError e) {
      // such as too little memory, perhaps because of another thread: the core has stopped the
      // robot
      if (!failed) {
        failed = true;
        log.error("a cycle of the simulated controller failed", e);
      }
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
