package no.hials.crosscom.cli;

import java.io.Closeable;
import java.io.IOException;
import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.Flow;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import no.hials.crosscom.ConnectionEvent;
import no.hials.crosscom.CrossComException;
import no.hials.crosscom.Sample;
import no.hials.crosscom.WatchConfig;
import no.hials.crosscom.protocol.ServerType;
import org.jspecify.annotations.Nullable;

/**
 * Reads the same variables of one or several controllers again and again, by a {@link
 * no.hials.crosscom.Watch} for each, until the user stops it or it has enough. What the watches
 * give comes to a {@link Listener} in the thread that called {@link #run}.
 */
final class Sampling implements Closeable {
  /** How often the listener is called if nothing happens, and how soon a signal is noticed. */
  private static final long TICK_MILLIS = 50;

  /** How long a reading under way may take when it ends; longer only if the connection is lost. */
  private static final long MAX_MILLIS_TO_END = 3_000;

  private final ConsoleCommand command;
  private final SamplingOptions options;
  private final Queue queue = new Queue();
  private final List<SampledRobot> robots = new ArrayList<>();
  private @Nullable Instant start;

  /** The gravest failure to connect. */
  private ExitCode connected = ExitCode.DONE;

  /** Takes what is read. */
  interface Listener {
    /** Takes a sample. */
    void sampled(SampledRobot robot, Sample sample) throws IOException;

    /** Takes what became of a connection. */
    void connectionChanged(SampledRobot robot, ConnectionEvent event) throws IOException;

    /**
     * Is called at least every 50 ms.
     *
     * @return false if the user wants no more
     */
    boolean tick() throws IOException;
  }

  /** What comes from the threads of the client. */
  sealed interface Event {
    SampledRobot robot();
  }

  /** A sample came. */
  record Sampled(SampledRobot robot, Sample sample) implements Event {}

  /** Something became of a connection. */
  record ConnectionChanged(SampledRobot robot, ConnectionEvent event) implements Event {}

  /** A watch gives no more samples. */
  record Ended(SampledRobot robot, long lastNumber) implements Event {}

  /** Brings the events from the threads of the client to the one of the command. */
  static final class Queue {
    private final BlockingQueue<Event> events = new LinkedBlockingQueue<>();

    void add(Event event) {
      events.add(event);
    }

    @Nullable Event next(long millis) throws InterruptedException {
      return events.poll(millis, TimeUnit.MILLISECONDS);
    }
  }

  /**
   * Tells when a watch has ended, and what it gave last: its listener, which hears nothing of the
   * end, may be behind.
   */
  static final class End implements Flow.Subscriber<Sample> {
    private final SampledRobot robot;
    private final Queue queue;
    private long lastNumber;

    End(SampledRobot robot, Queue queue) {
      this.robot = robot;
      this.queue = queue;
    }

    @Override
    public void onSubscribe(Flow.Subscription subscription) {
      subscription.request(Long.MAX_VALUE);
    }

    @Override
    public void onNext(Sample sample) {
      lastNumber = sample.number();
    }

    @Override
    public void onError(Throwable failure) {
      onComplete();
    }

    @Override
    public void onComplete() {
      queue.add(new Ended(robot, lastNumber));
    }
  }

  private Sampling(ConsoleCommand command, SamplingOptions options) {
    this.command = command;
    this.options = options;
  }

  /** Connects to all controllers that the user chose; one that cannot be reached is printed. */
  static Sampling open(
      ConsoleCommand command, ControllerOptions controllerOptions, SamplingOptions options)
      throws IOException {
    options.check(command);
    Sampling sampling = new Sampling(command, options);
    try {
      for (Robot target : controllerOptions.targets(command, ServerType.KUKAVARPROXY)) {
        sampling.connect(target);
      }
      return sampling;
    } catch (IOException | RuntimeException e) {
      sampling.close();
      throw e;
    }
  }

  private void connect(Robot target) throws IOException {
    try {
      robots.add(new SampledRobot(target, queue));
    } catch (CrossComException e) {
      command.console().failure(target.label(), e, command.isVerbose());
      connected = connected.orGraver(ExitCode.ofFailedRead(e));
    }
  }

  List<SampledRobot> robots() {
    return robots;
  }

  Duration period() {
    return options.period();
  }

  /** Gives how much time has passed between the first sample of all and a time. */
  Duration since(Instant time) {
    return start == null ? Duration.ZERO : Duration.between(start, time);
  }

  /**
   * Reads all variables once, so that a name that is wrong is told before anything begins.
   *
   * @return the gravest failure, also to connect; all are printed
   */
  ExitCode readFirst() {
    ExitCode result = connected;
    for (SampledRobot robot : robots) {
      List<CrossComException> failures;
      try {
        failures = robot.readFirst(options.names());
      } catch (IllegalArgumentException e) {
        // a name that cannot be sent
        throw command.wrongUsage(String.valueOf(e.getMessage()));
      }
      for (CrossComException failure : failures) {
        result = result.orGraver(ExitCode.ofFailedRead(failure));
      }
      failures.stream()
          .map(failure -> robot.label() + failure.getMessage())
          .distinct()
          .forEach(command.console()::error);
    }
    return result;
  }

  /**
   * Reads until it is stopped, or has enough.
   *
   * @param changesOnly whether the listener gets only samples in which something changed
   * @return {@link ExitCode#LOST} if it ended by itself while a connection was lost
   */
  ExitCode run(boolean changesOnly, StopSignal stop, Listener listener) throws IOException {
    WatchConfig config =
        WatchConfig.create(
            options.names(),
            cfg -> cfg.period(options.period()).changesOnly(changesOnly).bufferSize(65_536));
    Duration length = options.length();
    long end = length == null ? Long.MAX_VALUE : length.toNanos();
    long begin = System.nanoTime();
    robots.forEach(robot -> robot.start(config));
    boolean byUser = false;
    try {
      while (isActive() && !byUser && System.nanoTime() - begin < end) {
        take(queue.next(TICK_MILLIS), listener);
        byUser = !listener.tick() || stop.isStopped();
      }
      finish(listener);
    } catch (InterruptedException e) {
      byUser = true;
      finishInterrupted(listener);
    }
    boolean lost = robots.stream().anyMatch(SampledRobot::isLost);
    return lost && !byUser ? ExitCode.LOST : ExitCode.DONE;
  }

  private boolean isActive() {
    return robots.stream().anyMatch(SampledRobot::isActive);
  }

  private void finishInterrupted(Listener listener) throws IOException {
    try {
      finish(listener);
    } catch (InterruptedException e) {
      // twice is enough
    }
    Thread.currentThread().interrupt();
  }

  /** Takes what was read before the end. */
  private void finish(Listener listener) throws IOException, InterruptedException {
    robots.forEach(SampledRobot::stop);
    long begin = System.nanoTime();
    // one that is lost may take as long as its time-outs, and then has nothing to give
    while (robots.stream().anyMatch(robot -> robot.isActive() && !robot.isLost())
        && System.nanoTime() - begin < TimeUnit.MILLISECONDS.toNanos(MAX_MILLIS_TO_END)) {
      take(queue.next(TICK_MILLIS), listener);
    }
    Event event = queue.next(0);
    while (event != null) {
      take(event, listener);
      event = queue.next(0);
    }
  }

  private void take(@Nullable Event event, Listener listener) throws IOException {
    if (event instanceof Sampled sampled) {
      take(sampled.robot(), sampled.sample(), listener);
    } else if (event instanceof ConnectionChanged changed) {
      changed.robot().count(changed.event());
      listener.connectionChanged(changed.robot(), changed.event());
    } else if (event instanceof Ended ended) {
      ended.robot().endsWith(ended.lastNumber());
    }
  }

  private void take(SampledRobot robot, Sample sample, Listener listener) throws IOException {
    if (!robot.isActive()) {
      return;
    }
    robot.came(sample);
    if (start == null) {
      start = sample.time();
    }
    Duration length = options.length();
    if (length != null && since(sample.time()).compareTo(length) >= 0) {
      robot.stopWithEnough();
      return;
    }
    robot.count(sample);
    listener.sampled(robot, sample);
    if (robot.samples() >= options.count()) {
      robot.stopWithEnough();
    }
  }

  @Override
  public void close() throws IOException {
    IOException failure = null;
    for (SampledRobot robot : robots) {
      try {
        robot.close();
      } catch (IOException e) {
        failure = e;
      }
    }
    if (failure != null) {
      throw failure;
    }
  }
}
