package no.hials.crosscom.gateway;

import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** Tasks that a timer repeats as long as the gateway runs. */
public final class Lasting {
  private static final Logger LOG = LoggerFactory.getLogger(Lasting.class);

  private Lasting() {}

  /**
   * Returns a task whose failures are logged. A timer never runs a task again that has thrown an
   * exception or an error, such as one of memory.
   */
  public static Runnable task(Runnable task) {
    return () -> {
      try {
        task.run();
      } catch (RuntimeException | Error e) {
        log(e);
      }
    };
  }

  private static void log(Throwable failure) {
    try {
      LOG.error("a repeated task failed", failure);
    } catch (RuntimeException | Error e) {
      // perhaps there is no memory for the log either
    }
  }
}
