package no.hials.crosscom.cell;

import java.io.Closeable;
import java.io.IOException;
import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Objects;
import java.util.concurrent.Flow;
import no.hials.crosscom.ConnectionEvent;
import no.hials.crosscom.CrossComException;
import no.hials.crosscom.KRL.KRLAny;
import no.hials.crosscom.Sample;
import no.hials.crosscom.VariableResult;
import no.hials.crosscom.Watch;
import no.hials.crosscom.WatchConfig;
import no.hials.crosscom.protocol.value.KrlValue;
import org.jspecify.annotations.Nullable;

/** A controller that a {@link Sampling} reads, and its counts of samples and failures. */
public final class SampledRobot implements Closeable {
  private final Robot robot;
  private final Sampling sampling;
  private final RobotConnection controller;
  private final boolean shared;
  private final Map<String, KrlValue> first = new LinkedHashMap<>();

  private @Nullable Watch watch;
  private boolean enough;
  private @Nullable Instant latest;
  private boolean ended;
  private long samples;
  private @Nullable Instant firstTime;
  private @Nullable Instant lastTime;
  private long reconnects;
  private long failedBeforeSample;
  private Duration greatestAccess = Duration.ZERO;
  private Duration sumOfAccess = Duration.ZERO;
  private @Nullable ConnectionEvent lost;

  /** Connects to a controller. */
  public SampledRobot(Robot robot, RobotConnection.Opener opener, Sampling sampling)
      throws IOException {
    this.robot = robot;
    this.sampling = sampling;
    this.controller = opener.open(robot, cfg -> cfg.listener(this::pass));
    this.shared = false;
  }

  private SampledRobot(RobotConnection connection, Sampling sampling) {
    this.robot = connection.robot();
    this.sampling = sampling;
    this.controller = connection;
    this.shared = true;
  }

  /** Creates a robot that is read through a connection of others. */
  static SampledRobot through(RobotConnection connection, Sampling sampling) {
    return new SampledRobot(connection, sampling);
  }

  /** Passes an event of the connection to the thread that samples. */
  void pass(ConnectionEvent event) {
    sampling.add(listener -> changed(event));
  }

  /** Returns the name; empty if the robot has no name. */
  public String name() {
    return robot.name();
  }

  /** Returns the text to print before a message about the robot. */
  public String label() {
    return robot.label();
  }

  /** Returns the name of a variable among those of other robots, such as {@code cell1:$OV_PRO}. */
  public String qualified(String variable) {
    return name().isEmpty() ? variable : name() + ":" + variable;
  }

  // the first reading

  /**
   * Reads the variables once, to test whether all can be read.
   *
   * @return the failures
   */
  public List<CrossComException> readFirst(List<String> names) {
    List<CrossComException> failures = new ArrayList<>();
    for (VariableResult result :
        controller.client().readVariables(names.stream().map(KRLAny::new).toList())) {
      CrossComException failure = result.failure();
      if (failure == null) {
        KRLAny variable = (KRLAny) result.variable();
        first.put(variable.getName(), Objects.requireNonNull(variable.getValue()));
      } else {
        failures.add(failure);
      }
    }
    return failures;
  }

  /** Returns the values that {@link #readFirst} read, by their names. */
  public Map<String, KrlValue> first() {
    return first;
  }

  // the watch

  void start(WatchConfig config) throws IOException {
    Watch started = controller.client().watch(config);
    started.subscribe(new Samples());
    watch = started;
  }

  private void changed(ConnectionEvent event) {
    count(event);
    sampling.hold(this, event.time(), listener -> listener.connectionChanged(this, event));
  }

  /** Receives the samples and the end of the watch. */
  private final class Samples implements Flow.Subscriber<Sample> {
    @Override
    public void onSubscribe(Flow.Subscription subscription) {
      subscription.request(Long.MAX_VALUE);
    }

    @Override
    public void onNext(Sample sample) {
      sampling.add(listener -> came(sample));
    }

    @Override
    public void onError(Throwable failure) {
      onComplete();
    }

    @Override
    public void onComplete() {
      sampling.add(listener -> ended = true);
    }
  }

  /** Ends the watch; samples it has already read still arrive. */
  void stop() {
    if (watch != null) {
      watch.close();
    }
  }

  /** Ends the watch; later samples are ignored. */
  void stopWithEnough() {
    enough = true;
    stop();
  }

  /** Returns whether more samples can arrive. */
  boolean isActive() {
    return !enough && !ended;
  }

  /** Returns whether later samples are ignored. */
  boolean hasEnough() {
    return enough;
  }

  /** Returns whether no sample of an earlier time can arrive. */
  boolean isPast(Instant time) {
    return !isActive() || isLost() || (latest != null && !latest.isBefore(time));
  }

  private void came(Sample sample) {
    latest = sample.time();
    sampling.hold(this, sample.time(), listener -> sampling.take(this, sample, listener));
  }

  // counts

  public void count(Sample sample) {
    samples++;
    if (firstTime == null) {
      firstTime = sample.time();
    }
    lastTime = sample.time();
    failedBeforeSample += sample.failedPolls();
    sumOfAccess = sumOfAccess.plus(sample.duration());
    if (sample.duration().compareTo(greatestAccess) > 0) {
      greatestAccess = sample.duration();
    }
  }

  public void count(ConnectionEvent event) {
    switch (event.kind()) {
      case LOST -> lost = event;
      case RECONNECTED -> {
        reconnects++;
        lost = null;
      }
      default -> {
        // other events do not change whether the robot is connected
      }
    }
  }

  /** Returns the number of samples. */
  long samples() {
    return samples;
  }

  /** Returns the number of failed readings. */
  private long failedReadings() {
    return watch == null ? 0 : watch.failedPolls();
  }

  /** Returns the number of failed readings since the last sample. */
  public long failedSinceSample() {
    return failedReadings() - failedBeforeSample;
  }

  private long missedPeriods() {
    return watch == null ? 0 : watch.missedPeriods();
  }

  private Duration meanAccess() {
    return samples == 0 ? Duration.ZERO : sumOfAccess.dividedBy(samples);
  }

  /** Returns a summary: samples, rate, access time, and failures. */
  public String summary() {
    Duration time =
        firstTime == null || lastTime == null
            ? Duration.ZERO
            : Duration.between(firstTime, lastTime);
    StringBuilder text = new StringBuilder(Printable.count(samples, "sample"));
    if (samples > 1 && time.compareTo(Duration.ZERO) > 0) {
      double rate = (samples - 1) * 1e9 / time.toNanos();
      text.append(String.format(Locale.ROOT, ", %.1f/s", rate));
    }
    text.append(", access ")
        .append(TimeText.roughMillis(meanAccess()))
        .append(" ms (at most ")
        .append(TimeText.roughMillis(greatestAccess))
        .append("), missed ")
        .append(missedPeriods())
        .append(", reconnects ")
        .append(reconnects);
    if (failedReadings() > 0) {
      text.append(", failed readings ").append(failedReadings());
    }
    return text.toString();
  }

  /** Returns the text of a connection event. */
  public static String text(ConnectionEvent event) {
    CrossComException cause = event.cause();
    return event.kind() == ConnectionEvent.ConnectionChange.RECONNECTED
        ? "connected again"
        : String.valueOf(cause == null ? "the connection is lost" : cause.getMessage());
  }

  /**
   * Returns whether the connection is lost now. Returns false after the last sample, even if the
   * event of the reconnection has not arrived yet.
   */
  public boolean isLost() {
    return lost != null && !enough;
  }

  @Override
  public void close() throws IOException {
    stop();
    if (!shared) {
      controller.close();
    }
  }
}
