package no.hials.crosscom.internal.exchange;

import java.util.concurrent.ThreadFactory;

/** Creates threads that do not keep the program alive. */
public final class DaemonThreads {
  private DaemonThreads() {}

  /** Returns a factory of threads of one name. */
  public static ThreadFactory named(String name) {
    return task -> {
      Thread thread = new Thread(task, name);
      thread.setDaemon(true);
      return thread;
    };
  }
}
