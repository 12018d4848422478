package no.hials.crosscom.cli.base;

import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.concurrent.atomic.AtomicBoolean;
import org.jline.utils.ShutdownHooks;
import org.jline.utils.Signals;
import org.jspecify.annotations.Nullable;

/**
 * Lets a command run until the user stops it by Ctrl-C (SIGINT) or SIGTERM, or until its terminal
 * is closed (SIGHUP). The command then closes its resources and chooses the exit code, except that
 * of SIGHUP.
 *
 * <p>The JVM shuts down at these signals, so this class adds a shutdown hook, a thread that waits
 * for the end of the command and then ends the process.
 */
public final class StopSignal implements AutoCloseable {
  /** After this time the process ends even if the command does not. */
  private static final long MAX_SECONDS_TO_END = 10;

  private static final String HANG_UP = "HUP";

  /** The JVM's exit code after SIGHUP: 128 + the number of the signal. */
  private static final int HUNG_UP_CODE = 128 + 1;

  /** The exit code; completed when the program has done everything. */
  private static final CompletableFuture<Integer> EXIT = new CompletableFuture<>();

  /** Was never added, so that removing it does nothing. */
  private static final Thread NO_HOOK = new Thread("no-hook");

  private final CountDownLatch stopped = new CountDownLatch(1);
  private final Thread hook = new Thread(this::stop, "stop-signal");
  private final AtomicBoolean hungUp = new AtomicBoolean();

  /** The previous handler of SIGHUP. */
  private final @Nullable Object hangUpBefore;

  /** Watches for the signals from now on. */
  public StopSignal() {
    Runtime.getRuntime().addShutdownHook(hook);
    // a hook cannot find out which signal it was
    hangUpBefore = Signals.register(HANG_UP, this::hangUp);
  }

  private void hangUp() {
    hungUp.set(true);
    System.exit(HUNG_UP_CODE);
  }

  private void stop() {
    stopped.countDown();
    try {
      int code = EXIT.get(MAX_SECONDS_TO_END, TimeUnit.SECONDS);
      if (code != ExitCode.STOPPED.code() && !hungUp.get()) {
        // JLine's own hook, which runs at the same time, restores terminals: let it finish
        ShutdownHooks.runTasks();
        // a shutdown by a signal has the exit code 128 + the signal; only halt can change it
        Runtime.getRuntime().halt(code);
      }
    } catch (InterruptedException | ExecutionException | TimeoutException e) {
      // the shutdown continues
    }
  }

  /** Waits for a signal or an interrupt of this thread, and keeps the interrupt flag set. */
  public void await() {
    try {
      stopped.await();
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  /** Returns whether a signal arrived. */
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
   * Throws an exception if the user has stopped the command, for operations that cannot end early.
   *
   * @throws StoppedException if a signal arrived or this thread was interrupted; the interrupt flag
   *     stays set
   */
  public void check() {
    if (isStopped() || Thread.currentThread().isInterrupted()) {
      throw new StoppedException();
    }
  }

  /** Leaves the signals to the JVM again. */
  @Override
  public void close() {
    Signals.unregister(HANG_UP, hangUpBefore);
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
