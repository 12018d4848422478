package no.hials.crosscom.cli.base;

import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import org.jline.utils.ShutdownHooks;

/**
 * Lets a command run until the user stops it, by Ctrl-C (SIGINT) or SIGTERM, and then end in its
 * own way: with what it closes, and with its own exit code.
 *
 * <p>The JVM answers these signals by shutting down, so what waits here is a shutdown hook: a
 * thread that runs then, and ends the process when the command has come to its end.
 */
public final class StopSignal implements AutoCloseable {
  /** After this time the process ends even if the command does not. */
  private static final long MAX_SECONDS_TO_END = 10;

  /** The exit code; there when the program has done everything. */
  private static final CompletableFuture<Integer> EXIT = new CompletableFuture<>();

  /** Was never added, so that removing it does nothing. */
  private static final Thread NO_HOOK = new Thread("no-hook");

  private final CountDownLatch stopped = new CountDownLatch(1);
  private final Thread hook = new Thread(this::stop, "stop-signal");

  /** Watches for the signals from now on. */
  public StopSignal() {
    Runtime.getRuntime().addShutdownHook(hook);
  }

  private void stop() {
    stopped.countDown();
    try {
      int code = EXIT.get(MAX_SECONDS_TO_END, TimeUnit.SECONDS);
      if (code != ExitCode.STOPPED.code()) {
        // JLine's own hook gives terminals back, at the same time as this: it must not be cut off
        ShutdownHooks.runTasks();
        // the exit code of a shutdown is set already, 128 + the signal; this is the only way to
        // another
        Runtime.getRuntime().halt(code);
      }
    } catch (InterruptedException | ExecutionException | TimeoutException e) {
      // the shutdown continues
    }
  }

  /** Waits for a signal, or for an interrupt of this thread, which stays set. */
  public void await() {
    try {
      stopped.await();
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  /** Returns whether a signal came. */
  public boolean isStopped() {
    return stopped.getCount() == 0 || isShuttingDown();
  }

  /**
   * Returns whether the JVM shuts down; hooks cannot be changed from then on, which JLine needs.
   */
  public static boolean isShuttingDown() {
    try {
      Runtime.getRuntime().removeShutdownHook(NO_HOOK);
      return false;
    } catch (IllegalStateException e) {
      return true;
    }
  }

  /**
   * Ends an operation that cannot end by itself.
   *
   * @throws StoppedException if a signal came, or an interrupt of this thread, which stays set
   */
  public void check() {
    if (isStopped() || Thread.currentThread().isInterrupted()) {
      throw new StoppedException();
    }
  }

  /** Leaves the signals to the JVM again. */
  @Override
  public void close() {
    try {
      Runtime.getRuntime().removeShutdownHook(hook);
    } catch (IllegalStateException e) {
      // the shutdown is under way: the hook waits for exit
    }
  }

  /** Ends the process. */
  public static void exit(int code) {
    EXIT.complete(code);
    System.exit(code);
  }
}
