package no.hials.crosscom.cell;

import java.io.Closeable;
import java.io.IOException;
import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.Collections;
import java.util.Comparator;
import java.util.List;
import java.util.PriorityQueue;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.function.BooleanSupplier;
import no.hials.crosscom.ConnectionEvent;
import no.hials.crosscom.CrossComException;
import no.hials.crosscom.Sample;
import no.hials.crosscom.WatchConfig;
import org.jspecify.annotations.Nullable;

/**
 * Reads the same variables of one or several controllers repeatedly, with a {@link
 * no.hials.crosscom.Watch} for each, until the user stops it or a limit is reached. A {@link
 * Listener} receives the samples in the thread that called {@link #run}.
 */
public final class Sampling implements Closeable {
  /**
   * The interval of calls of the listener if nothing happens, and the maximum delay of a signal.
   */
  private static final long TICK_MILLIS = 50;

  /** The maximum time to wait at the end for readings in progress. */
  private static final long MAX_MILLIS_TO_END = 3_000;

  /** The maximum time that a sample waits for earlier samples of other robots. */
  private static final Duration MAX_WAIT = Duration.ofSeconds(1);

  private final SamplingPlan plan;
  private final BlockingQueue<Event> queue = new LinkedBlockingQueue<>();
  private final List<SampledRobot> robots = new ArrayList<>();
  private @Nullable Instant start;

  /** The time of the last sample that the listener has received. */
  private Instant latest = Instant.EPOCH;

  private boolean changesOnly;

  /** The samples and connection events that earlier samples of other robots may precede. */
  private final PriorityQueue<Held> held = new PriorityQueue<>(Comparator.comparing(Held::time));

  private final List<Failure> failedToConnect = new ArrayList<>();

  /**
   * The variables to read, how often, and for how long.
   *
   * @param names the variables, each once
   * @param period the time from one reading to the next
   * @param length the maximum duration; null if there is no limit
   * @param count the maximum number of samples of each robot
   */
  public record SamplingPlan(
      List<String> names, Duration period, @Nullable Duration length, long count) {

    /** Returns after how many samples a robot has enough: as many as there are periods. */
    private long enough() {
      if (length == null) {
        return count;
      }
      long periods = length.dividedBy(period);
      return Math.min(count, length.equals(period.multipliedBy(periods)) ? periods : periods + 1);
    }
  }

  /**
   * A robot that could not be reached, or a variable that could not be read.
   *
   * @param label the text to print before the message
   * @param cause the reason
   */
  public record Failure(String label, CrossComException cause) {
    /** Returns the message for the user. */
    public String message() {
      return label + cause.getMessage();
    }
  }

  /** Receives samples and events. */
  public interface Listener {
    /** Called when a sample arrives. */
    void sampled(SampledRobot robot, Sample sample) throws IOException;

    /** Called when a connection is lost or restored. */
    void connectionChanged(SampledRobot robot, ConnectionEvent event) throws IOException;

    /**
     * Called at least every 50 ms.
     *
     * @return false if the user wants to stop
     */
    boolean tick() throws IOException;
  }

  /** An event from the threads of the client, handled in the thread that samples. */
  @FunctionalInterface
  interface Event {
    void handle(Listener listener) throws IOException;
  }

  /** A sample or a connection event of a robot that the listener has not received yet. */
  private record Held(SampledRobot robot, Instant time, Event event) {}

  private Sampling(SamplingPlan plan) {
    this.plan = plan;
  }

  /** Connects to robots; {@link #readFirst} returns those that cannot be reached. */
  public static Sampling open(SamplingPlan plan, List<Robot> robots, RobotConnection.Opener opener)
      throws IOException {
    Sampling sampling = new Sampling(plan);
    try {
      for (Robot robot : robots) {
        sampling.connect(robot, opener);
      }
      return sampling;
    } catch (IOException | RuntimeException e) {
      sampling.close();
      throw e;
    }
  }

  /**
   * Reads through a connection that is open, and stays open after {@link #close}. Its events come
   * by {@link #connectionChanged}.
   */
  public static Sampling through(RobotConnection connection, SamplingPlan plan) {
    Sampling sampling = new Sampling(plan);
    sampling.robots.add(SampledRobot.through(connection, sampling));
    return sampling;
  }

  /** Passes on an event of the connection of {@link #through}. Can be called by any thread. */
  public void connectionChanged(ConnectionEvent event) {
    robots.forEach(robot -> robot.pass(event));
  }

  private void connect(Robot robot, RobotConnection.Opener opener) throws IOException {
    try {
      robots.add(new SampledRobot(robot, opener, this));
    } catch (CrossComException e) {
      failedToConnect.add(new Failure(robot.label(), e));
    }
  }

  /** Returns the robots that could not be reached. */
  public List<Failure> failedToConnect() {
    return Collections.unmodifiableList(failedToConnect);
  }

  /** Returns the robots that are read. */
  public List<SampledRobot> robots() {
    return Collections.unmodifiableList(robots);
  }

  Duration period() {
    return plan.period();
  }

  /** Returns the time from the earliest sample of all robots to a point in time. */
  public Duration since(Instant time) {
    return start == null ? Duration.ZERO : Duration.between(start, time);
  }

  /**
   * Reads all variables once, so that a wrong name is reported before anything begins.
   *
   * @return the variables that could not be read
   * @throws IllegalArgumentException if a name cannot be sent
   */
  public List<Failure> readFirst() {
    List<Failure> failures = new ArrayList<>();
    for (SampledRobot robot : robots) {
      for (CrossComException failure : robot.readFirst(plan.names())) {
        failures.add(new Failure(robot.label(), failure));
      }
    }
    return failures;
  }

  /**
   * Reads until the user stops it or a limit is reached. The listener receives the samples of all
   * robots in the order of their times; a sample waits at most 1 s for earlier ones. If a reading
   * ends after the listener has received a later one, because the answer was slow or the robot had
   * to be connected again, its sample has the time of that one and the duration from there.
   *
   * @param changesOnly whether the listener gets only samples in which something changed, each one
   *     immediately, since the other robots may have no changes
   * @param isStopped returns whether the user wants to stop
   * @return whether it reached a limit while a connection was lost
   */
  public boolean run(boolean changesOnly, BooleanSupplier isStopped, Listener listener)
      throws IOException {
    this.changesOnly = changesOnly;
    WatchConfig config =
        WatchConfig.create(
            plan.names(),
            cfg -> cfg.period(plan.period()).changesOnly(changesOnly).bufferSize(65_536));
    Duration length = plan.length();
    long end = length == null ? Long.MAX_VALUE : length.toNanos();
    long begin = System.nanoTime();
    for (SampledRobot robot : robots) {
      robot.start(config);
    }
    boolean byUser = false;
    try {
      while (isActive() && !byUser && System.nanoTime() - begin < end) {
        handleNext(listener);
        byUser = !listener.tick() || isStopped.getAsBoolean();
      }
      finish(listener);
    } catch (InterruptedException e) {
      byUser = true;
      finishInterrupted(listener);
    }
    boolean lost = robots.stream().anyMatch(SampledRobot::isLost);
    return lost && !byUser;
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

  /** Delivers the samples read before the end. */
  private void finish(Listener listener) throws IOException, InterruptedException {
    robots.forEach(SampledRobot::stop);
    long begin = System.nanoTime();
    // a lost connection may take as long as its timeouts and then has no samples
    while (robots.stream().anyMatch(robot -> robot.isActive() && !robot.isLost())
        && System.nanoTime() - begin < TimeUnit.MILLISECONDS.toNanos(MAX_MILLIS_TO_END)) {
      handleNext(listener);
    }
    for (Event event = queue.poll(); event != null; event = queue.poll()) {
      event.handle(listener);
    }
    for (Held next = held.poll(); next != null; next = held.poll()) {
      next.event().handle(listener);
    }
  }

  private void handleNext(Listener listener) throws IOException, InterruptedException {
    Event event = queue.poll(TICK_MILLIS, TimeUnit.MILLISECONDS);
    if (event != null) {
      event.handle(listener);
    }
    for (Held next = held.peek(); next != null && isDue(next); next = held.peek()) {
      held.remove().event().handle(listener);
    }
  }

  /** Returns whether no robot can still have an earlier sample, or whether to wait no longer. */
  private boolean isDue(Held next) {
    return changesOnly
        || robots.stream().allMatch(r -> r == next.robot() || r.isPast(next.time()))
        || (start != null && next.time().plus(MAX_WAIT).isBefore(Instant.now()));
  }

  /** Passes an event from the threads of the client to the thread that samples. */
  void add(Event event) {
    queue.add(event);
  }

  /** Keeps an event until the samples before it have been delivered. */
  void hold(SampledRobot robot, Instant time, Event event) {
    held.add(new Held(robot, time, event));
  }

  void take(SampledRobot robot, Sample sample, Listener listener) throws IOException {
    if (robot.hasEnough()) {
      return;
    }
    Sample inOrder = changesOnly ? sample : inOrder(sample);
    if (start == null) {
      start = inOrder.time();
    }
    Duration length = plan.length();
    if (length != null && since(inOrder.time()).compareTo(length) >= 0) {
      robot.stopWithEnough();
      return;
    }
    robot.count(inOrder);
    listener.sampled(robot, inOrder);
    if (robot.samples() >= plan.enough()) {
      robot.stopWithEnough();
    }
  }

  private Sample inOrder(Sample sample) {
    Duration late = Duration.between(sample.time(), latest);
    if (late.isNegative() || late.isZero()) {
      latest = sample.time();
      return sample;
    }
    Duration rest = sample.duration().minus(late);
    return new Sample(
        sample.number(),
        latest,
        sample.nanoTime(),
        rest.isNegative() ? Duration.ZERO : rest,
        sample.readings(),
        sample.results(),
        sample.changed(),
        sample.missedPeriods(),
        sample.failedPolls());
  }

  @Override
  public void close() throws IOException {
    IOException failure = null;
    for (SampledRobot robot : robots) {
      try {
        robot.close();
      } catch (IOException e) {
        if (failure == null) {
          failure = e;
        } else {
          failure.addSuppressed(e);
        }
      }
    }
    if (failure != null) {
      throw failure;
    }
  }
}
