package no.hials.crosscom.internal.exchange;

import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.ThreadFactory;
import java.util.concurrent.ThreadPoolExecutor;
import java.util.concurrent.TimeUnit;

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

  /** Creates an executor whose threads end when idle for 1 s. */
  public static ThreadPoolExecutor pool(int threads, String name) {
    ThreadPoolExecutor pool =
        new ThreadPoolExecutor(
            threads, threads, 1, TimeUnit.SECONDS, new LinkedBlockingQueue<>(), named(name));
    pool.allowCoreThreadTimeOut(true);
    return pool;
  }

  /** Ends each thread of a pool as soon as it is idle. Later tasks still run. */
  public static void endIdle(ThreadPoolExecutor pool) {
    pool.setKeepAliveTime(1, TimeUnit.NANOSECONDS);
  }
}
