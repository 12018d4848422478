package no.hials.crosscom.control;

import java.util.Objects;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.locks.LockSupport;
import no.hials.crosscom.CrossComClient;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Moves a robot by a {@link Law}: once in each period it reads where the robot is, asks the law and
 * writes one structure, which a KRL program follows.
 *
 * <p><b>It moves a machine.</b> Before anything is written, the operating mode, the state of the
 * robot's program, the limits and the watchdog are checked; while it runs, every command passes the
 * limits of {@link Safety}. Whatever breaks one, any exception, and any access that fails ends the
 * loop: the robot is told once to stand, if the connection allows, and nothing is written after
 * that. {@link #stopReason} then says which limit it was. A loop does not start again; a write is
 * never repeated. A reading that the client repeats on a new connection, as it does unless told not
 * to reconnect, has not failed if it is fresh enough ({@link Safety#maxFeedbackAge}).
 *
 * <p>If the robot could not be told to stand, it is the watchdog's turn: without heartbeat the
 * program on the controller stops. Except after a planned end, the watchdog stays armed, so that
 * the program stops after any other end too.
 *
 * <p>Without the dead-man, or with input that is too old, the robot stands and the law is not
 * asked; the loop goes on and moves again when both are back.
 *
 * <p>Cycles begin at fixed times without drift. One whose time has come before the one before has
 * ended is left out and counted, never made up for.
 *
 * <p>Threads: a loop runs the daemon thread {@code crosscom-control-N}, which calls the law and the
 * input device and uses the client. The client can be used for other things meanwhile, at the cost
 * of the loop's time. All methods here may be called by any thread.
 */
public final class ControlLoop implements AutoCloseable {
  private static final Logger LOG = LoggerFactory.getLogger(ControlLoop.class);
  private static final AtomicInteger COUNT = new AtomicInteger();

  private final Runner<?> runner;
  private final Thread thread;
  private final CompletableFuture<StopReason> end = new CompletableFuture<>();
  private volatile boolean toldToStand;

  private ControlLoop(Runner<?> runner) {
    this.runner = runner;
    this.thread = new Thread(this::run, "crosscom-control-" + COUNT.incrementAndGet());
    thread.setDaemon(true);
  }

  /** What a loop is doing. */
  public enum Status {
    /** It asks the law and moves the robot. */
    MOVING,
    /** It lets the robot stand, because nobody holds the dead-man or the input is too old. */
    HOLDING,
    /** It has ended. */
    STOPPED
  }

  /**
   * Checks the controller and starts a loop. It blocks until the checks are done: about ten
   * accesses, and up to a second until the watchdog has seen the heartbeat.
   *
   * @param client the connection; it stays open when the loop ends
   * @param config what the loop is to do
   * @param law decides where the robot is to go
   * @return the loop, which runs already; it is to be closed
   * @throws ControlRefusedException if a check failed; nothing was written that moves a robot
   */
  public static ControlLoop start(CrossComClient client, LoopConfig config, Law law)
      throws ControlRefusedException {
    return start(client, config, law, LoopTime.REAL);
  }

  static ControlLoop start(CrossComClient client, LoopConfig config, Law law, LoopTime time)
      throws ControlRefusedException {
    Objects.requireNonNull(law, "law");
    Target target = config.target() == null ? Target.standard(law) : config.target();
    Channel channel = new Channel(client);
    Space<?> space = Space.of(law, config, channel, target.name());
    return start(config, target, channel, space, time);
  }

  private static <P> ControlLoop start(
      LoopConfig config, Target target, Channel channel, Space<P> space, LoopTime time)
      throws ControlRefusedException {
    Safety safety = config.safety();
    Guard guard = Preflight.check(channel, safety, space instanceof Space.Cartesian);
    Heartbeat heartbeat = new Heartbeat(channel, time, safety.watchdog());
    heartbeat.start();
    if (heartbeat.wasOn()) {
      LOG.warn(
          "the watchdog was on before this loop, as after one whose end was not planned;"
              + " it stays on when this one has ended, and stops the program then");
    }
    ControlLoop loop =
        new ControlLoop(new Runner<>(config, target, channel, space, guard, heartbeat, time));
    LOG.debug("control of {} starts, every {}", target.name(), config.period());
    loop.thread.start();
    return loop;
  }

  private void run() {
    StopReason reason = runner.run();
    if (reason.isPlanned()) {
      LOG.debug("control ends: {}", reason.message());
    } else {
      LOG.warn("control stops the robot: {}", reason.message());
      LOG.debug("the reason of the stop was {}", reason.kind(), reason.cause());
    }
    // an access refuses to begin in an interrupted thread, and the robot would go on moving
    Thread.interrupted();
    try {
      toldToStand = runner.halt(reason);
    } catch (ControlRefusedException | RuntimeException | Error e) {
      LOG.warn("the robot could not be told to stand: {}", e.getMessage());
    } finally {
      end.complete(reason);
    }
  }

  /**
   * Says what the loop is doing.
   *
   * @return the status
   */
  public Status status() {
    if (end.isDone()) {
      return Status.STOPPED;
    }
    return runner.isHolding() ? Status.HOLDING : Status.MOVING;
  }

  /**
   * Says why the loop has ended.
   *
   * @return the reason; nothing if it has not ended
   */
  public Optional<StopReason> stopReason() {
    return Optional.ofNullable(end.getNow(null));
  }

  /**
   * Says whether the robot was told to stand at the end. If not, it goes on to its last target, or
   * with its last increment until the watchdog stops it.
   *
   * @return true if the zeros, or the position where it was, were written
   */
  public boolean toldToStand() {
    return toldToStand;
  }

  /**
   * Gives the reason of the end when it comes.
   *
   * @return a future of the caller's own; what depends on it runs on the loop's thread, after the
   *     robot was told to stand
   */
  public CompletableFuture<StopReason> ended() {
    return end.copy();
  }

  /**
   * Waits until the loop has ended.
   *
   * @return why it has
   * @throws InterruptedException if the waiting was interrupted; the loop goes on
   */
  public StopReason await() throws InterruptedException {
    try {
      return end.get();
    } catch (ExecutionException e) {
      throw new AssertionError("it is completed by a reason only", e);
    }
  }

  /** Asks the loop to end, and does not wait for it. */
  public void stop() {
    runner.askToStop();
    LockSupport.unpark(thread);
  }

  /** Ends the loop, and waits until the robot has been told to stand. */
  @Override
  public void close() {
    stop();
    if (Thread.currentThread() != thread) {
      end.join();
    }
  }

  /**
   * Gives what was measured so far.
   *
   * @return the numbers
   */
  public LoopStatistics statistics() {
    return runner.meter().statistics();
  }

  /**
   * Gives the last cycles.
   *
   * @return always the same object
   */
  public Trace trace() {
    return runner.trace();
  }
}
