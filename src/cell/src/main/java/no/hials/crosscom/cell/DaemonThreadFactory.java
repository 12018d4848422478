package no.hials.crosscom.cell;

import java.util.concurrent.ThreadFactory;

/** Creates threads for executors that do not keep the program alive. */
public final class DaemonThreadFactory {
  private DaemonThreadFactory() {}

  /** Returns a factory of daemon threads of one name. */
  public static ThreadFactory named(String name) {
    return task -> {
      Thread thread = new Thread(task, name);
      thread.setDaemon(true);
      return thread;
    };
  }
}
