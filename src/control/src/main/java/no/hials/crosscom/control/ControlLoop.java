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
 * Moves a robot by a {@link Law}: once in each period it reads the position of the robot, calls the
 * law and writes one structure, which a KRL program follows.
 *
 * <p><b>It moves a machine.</b> Before the first command, the loop checks the operating mode, the
 * state of the robot program, the limits, the watchdog, and that no other client sends a heartbeat
 * ({@link LoopConfig.Builder#takeover}). While it runs, it checks each command against the limits
 * of {@link Safety}. A violated limit, an exception or a failed access ends the loop: it writes the
 * command to stand once, if the connection allows, and nothing after that. {@link #stopReason} then
 * returns the reason. A loop does not start again, and a write is never repeated. A read that the
 * client repeats on a new connection has not failed if the value is fresh enough ({@link
 * Safety#maxFeedbackAge}).
 *
 * <p>If the command to stand could not be written, the watchdog stops the program on the
 * controller, since the heartbeat has ended. The watchdog stays armed except after a planned end,
 * so the program stops after every other end.
 *
 * <p>Without the dead-man or with input that is too old, the robot stands still and the law is not
 * called. The loop continues and moves the robot again when both are back.
 *
 * <p>Cycles start at fixed times without drift. A cycle is skipped and counted if the previous
 * cycle is still running at its time; skipped cycles are not made up.
 *
 * <p>Threads: a loop runs the daemon thread {@code crosscom-control-N}, which calls the law and the
 * input device and uses the client. Other code may use the client at the same time, but its
 * accesses delay the loop. All methods are thread-safe.
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

  /** The state of a loop. */
  public enum Status {
    /** It calls the law and moves the robot. */
    MOVING,
    /** The robot stands still, because nobody holds the dead-man or the input is too old. */
    HOLDING,
    /** It has ended. */
    STOPPED
  }

  /**
   * Checks the controller and starts a loop. It blocks until the checks are done: about 15
   * accesses, and up to a second until the watchdog has seen the heartbeat. If the watchdog is on,
   * it first watches for a part of its time whether another client sends a heartbeat.
   *
   * @param client the connection; it stays open when the loop ends
   * @param config the settings
   * @param law computes the commands; implements one kind of law
   * @return the running loop; the caller must close it
   * @throws ControlRefusedException if a check failed; no motion was written
   */
  public static ControlLoop start(CrossComClient client, LoopConfig config, Law law)
      throws ControlRefusedException {
    return start(client, config, law, LoopTime.REAL);
  }

  static ControlLoop start(CrossComClient client, LoopConfig config, Law law, LoopTime time)
      throws ControlRefusedException {
    Objects.requireNonNull(client, "client");
    Objects.requireNonNull(config, "config");
    Objects.requireNonNull(law, "law");
    Channel channel = new Channel(client, config.writeIf());
    return start(config, channel, Space.of(law, config, channel), time);
  }

  private static <P> ControlLoop start(
      LoopConfig config, Channel channel, Space<P> space, LoopTime time)
      throws ControlRefusedException {
    Target target = space.followed;
    Safety safety = config.safety();
    Heartbeat heartbeat = new Heartbeat(channel, time, safety.watchdog());
    heartbeat.observe();
    Guard guard = Preflight.check(channel, safety, space instanceof Space.Cartesian);
    space.checkOther(guard);
    if (space.scalesIncrements()) {
      channel.read(channel.override);
    }
    FeedbackAge age = new FeedbackAge(channel, time, safety);
    age.start();
    heartbeat.checkAlone(config.takeover());
    if (heartbeat.start()) {
      LOG.warn(
          "the watchdog was on before this loop, as after an unplanned end;"
              + " it stays on after this loop, and then stops the program");
    }
    ControlLoop loop =
        new ControlLoop(
            new Runner<>(
                config,
                target,
                channel,
                space,
                guard,
                heartbeat,
                age,
                channel.readsTogether(),
                time));
    LOG.debug("started control of {} every {}", target.name(), config.period());
    loop.thread.start();
    return loop;
  }

  private void run() {
    StopReason reason = runner.run();
    if (reason.isPlanned()) {
      LOG.debug("ended control: {}", reason.message());
    } else {
      LOG.warn("stopped the robot: {}", reason.message());
      LOG.debug("the cause of the stop was {}", reason.kind(), reason.cause());
    }
    // an interrupted thread cannot start an access, and the robot would continue to move
    Thread.interrupted();
    try {
      toldToStand = runner.halt(reason);
    } catch (ControlRefusedException | RuntimeException | Error e) {
      LOG.warn("the robot could not be told to stand: {}", e.getMessage());
    } finally {
      end.complete(reason);
    }
  }

  /** Returns the state of the loop. */
  public Status status() {
    if (end.isDone()) {
      return Status.STOPPED;
    }
    return runner.isHolding() ? Status.HOLDING : Status.MOVING;
  }

  /** Returns why the loop has ended, or empty if it is still running. */
  public Optional<StopReason> stopReason() {
    return Optional.ofNullable(end.getNow(null));
  }

  /**
   * Returns whether the command to stand was written at the end. Without it, the robot moves on to
   * its last target, or by its last increment until the watchdog stops it.
   *
   * @return true if the zeros, or the position of the robot, were written
   */
  public boolean toldToStand() {
    return toldToStand;
  }

  /**
   * Returns a future of the reason why the loop has ended.
   *
   * @return a new future; its dependent stages run on the thread of the loop, after the command to
   *     stand
   */
  public CompletableFuture<StopReason> ended() {
    return end.copy();
  }

  /**
   * Waits until the loop has ended.
   *
   * @return the reason
   * @throws InterruptedException if the wait was interrupted; the loop continues
   */
  public StopReason await() throws InterruptedException {
    try {
      return end.get();
    } catch (ExecutionException e) {
      throw new AssertionError("a loop never ends without a reason", e);
    }
  }

  /** Requests the end of the loop without waiting for it. */
  public void stop() {
    runner.askToStop();
    LockSupport.unpark(thread);
  }

  /** Ends the loop and waits until it has written the command to stand. */
  @Override
  public void close() {
    stop();
    if (Thread.currentThread() != thread) {
      end.join();
    }
  }

  /** Returns the measurements so far. */
  public LoopStatistics statistics() {
    return runner.meter().statistics();
  }

  /** Returns the last cycles; always the same object. */
  public Trace trace() {
    return runner.trace();
  }
}
