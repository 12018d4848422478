package no.hials.crosscom.control;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import no.hials.crosscom.KRL.KRLVariable;
import no.hials.crosscom.control.Space.Quantity;
import no.hials.crosscom.control.StopReason.StopKind;
import no.hials.crosscom.control.input.Input;
import org.jspecify.annotations.Nullable;

/**
 * The cycles of a loop, all on one thread.
 *
 * @param <P> the type of position of the law
 */
final class Runner<P> {
  /**
   * Increments below this, mm or degrees, are rounding errors: no robot resolves them, and their
   * text would be as long as 1.23457E-17.
   */
  private static final double NEGLIGIBLE = 1e-6;

  private static final double[] ZEROS = new double[6];

  /** A check of a variable that is read in some cycles. */
  private record Check(KRLVariable variable, Verdict verdict) {}

  /** Checks the value that was read. */
  private interface Verdict {
    void check() throws ControlRefusedException;
  }

  private final LoopConfig config;
  private final Safety safety;
  private final Target target;
  private final Channel channel;
  private final Space<P> space;
  private final Guard guard;
  private final Heartbeat heartbeat;
  private final FeedbackAge age;
  private final LoopTime time;
  private final Meter meter;
  private final Trace trace;
  private final Feedback<P> feedback;
  private final long period;

  /** The time between checks. */
  private final long checkInterval;

  /** Whether there are limits of the axes in a Cartesian law, or of the tool in a joint law. */
  private final boolean otherIsLimited;

  /** Whether these are read in each cycle, in the same message. */
  private final boolean otherEachCycle;

  /** The checks that take turns, one in a cycle. */
  private final List<Check> checks;

  private final double[] differences;

  private volatile boolean stopAsked;
  private volatile boolean holding;

  private long start;
  private long nextCheck;
  private int check;
  private long lastBegin;
  private boolean begun;

  /** The number of periods in which the law moved the robot. */
  private long lawPeriods;

  /** The desired position of the previous cycle; null if the law was not called. */
  private @Nullable P previous;

  /** The absolute target that holds the robot; null while it moves. */
  private double @Nullable [] held;

  Runner(
      LoopConfig config,
      Target target,
      Channel channel,
      Space<P> space,
      Guard guard,
      Heartbeat heartbeat,
      FeedbackAge age,
      boolean readsTogether,
      LoopTime time) {
    this.config = config;
    this.safety = config.safety();
    this.target = target;
    this.channel = channel;
    this.space = space;
    this.guard = guard;
    this.heartbeat = heartbeat;
    this.age = age;
    this.time = time;
    this.period = config.period().toNanos();
    this.otherIsLimited = space instanceof Space.Cartesian || safety.workspace() != null;
    this.otherEachCycle = readsTogether && otherIsLimited;
    this.checks = checks();
    this.checkInterval = safety.checkInterval().toNanos() / checks.size();
    this.meter = new Meter(space.quantities);
    this.trace = new Trace(space.names, config.traceLength());
    this.feedback = new Feedback<>(space, safety, meter);
    this.differences = new double[space.quantities.size()];
  }

  private List<Check> checks() {
    List<Check> all = new ArrayList<>();
    all.add(new Check(channel.mode, () -> channel.checkMode(safety)));
    all.add(new Check(channel.program, channel::checkProgram));
    if (heartbeat.isOn()) {
      all.add(new Check(heartbeat.limit, heartbeat::checkLimit));
      all.add(new Check(heartbeat.seen, heartbeat::checkSeen));
    }
    if (space.scalesIncrements()) {
      all.add(new Check(channel.override, () -> {}));
    }
    Check other = new Check(space.otherFeedback, () -> space.checkOther(guard));
    if (!otherIsLimited) {
      all.add(other);
    } else if (!otherEachCycle) {
      // after each of them, since an axis can turn by 15 degrees in the interval of the checks
      return all.stream().flatMap(it -> Stream.of(it, other)).toList();
    }
    return List.copyOf(all);
  }

  Meter meter() {
    return meter;
  }

  Trace trace() {
    return trace;
  }

  boolean isHolding() {
    return holding;
  }

  void askToStop() {
    stopAsked = true;
  }

  /** Runs until there is a reason to stop. */
  StopReason run() {
    try {
      return cycles();
    } catch (ControlRefusedException e) {
      return e.reason();
    } catch (RuntimeException | Error e) {
      return new StopReason(StopKind.ERROR, "the loop failed: " + e, e);
    }
  }

  private StopReason cycles() throws ControlRefusedException {
    start = time.nanoTime();
    nextCheck = start;
    long next = start;
    long elapsed = 1;
    while (!stopAsked) {
      long now = time.nanoTime();
      if (now < next) {
        time.awaitUntil(next);
        continue;
      }
      if (!config.duration().isZero() && now - start >= config.duration().toNanos()) {
        long left = start + config.duration().toNanos() - next;
        meter.missed(Math.max(0, -Math.floorDiv(-left, period)), false); // rounded up
        return new StopReason(
            StopKind.TIME_OVER, "the time of " + config.duration().toMillis() + " ms is over");
      }
      long accessNanos = cycle(now, now - next, elapsed);
      long end = time.nanoTime();
      // a cycle whose time has passed is skipped, never made up
      long missed = Math.max(0, (end - next) / period);
      if (missed > 0) {
        meter.missed(missed, accessNanos >= period);
      }
      elapsed = missed + 1;
      next += elapsed * period;
    }
    return new StopReason(StopKind.ASKED, "the loop was asked to stop");
  }

  /** Runs a cycle and returns the time of its accesses. */
  private long cycle(long begin, long late, long elapsed) throws ControlRefusedException {
    long sinceLast = begun ? begin - lastBegin : 0;
    lastBegin = begin;
    begun = true;
    meter.began(sinceLast, late);
    heartbeat.checkInTime(); // before the checks that would find only what the watchdog did
    boolean beat = heartbeat.isDue();
    // in a slow loop a beat is due each time, which must not delay the checks forever
    read(begin - nextCheck >= (beat ? checkInterval : 0), beat, begin);
    long readEnd = time.nanoTime();
    long readNanos = readEnd - begin;
    P actual = space.actual();
    space.check(guard, actual, true);
    feedback.check(actual, readEnd);
    Input input = input();
    double[] sent = input == null ? hold(actual) : move(actual, input, elapsed, begin);
    space.setTarget(sent);
    long writeBegin = time.nanoTime();
    channel.write(space.target(), beat ? heartbeat.next() : null);
    long end = time.nanoTime();
    long writeNanos = end - writeBegin;
    meter.accessed(readNanos, writeNanos, end - begin - readNanos - writeNanos);
    trace.add(
        (begin - start) / 1e9,
        sinceLast / 1e6,
        readNanos / 1e6,
        writeNanos / 1e6,
        input != null,
        space.numbers(previous == null ? actual : previous),
        sent,
        space.numbers(actual));
    return readNanos + writeNanos;
  }

  private void read(boolean withCheck, boolean beat, long begin) throws ControlRefusedException {
    boolean overdue = age.isOverdue();
    Check now = withCheck && !overdue ? nextCheck(begin) : null;
    // a clock with an access of its own waits for a cycle that needs no other
    boolean free = !withCheck && !beat;
    boolean withClock = age.isReadTogether() || overdue || (free && age.isDue());
    List<KRLVariable> wanted = new ArrayList<>();
    wanted.add(space.feedback);
    if (withClock) {
      wanted.add(age.clock); // just after the position
    }
    if (otherEachCycle) {
      wanted.add(space.otherFeedback);
    }
    if (now != null) {
      wanted.add(now.variable());
    }
    channel.read(wanted);
    checkReading(begin);
    if (withClock) {
      age.check(space.feedback.getName());
    }
    if (otherEachCycle) {
      space.checkOther(guard);
    }
    if (now != null) {
      now.verdict().check();
    }
  }

  private Check nextCheck(long begin) {
    // at fixed times: a delay by each heartbeat would keep a check at one time after heartbeats
    nextCheck = Math.max(nextCheck + checkInterval, begin);
    check = (check + 1) % checks.size();
    return checks.get(check);
  }

  private void checkReading(long begin) throws ControlRefusedException {
    checkAge("the time of reading %s must be at most %s %s, is %s", begin);
  }

  private void checkAge(String words, long begin) throws ControlRefusedException {
    double limit = safety.maxFeedbackAge().toNanos() / 1e6;
    double age = (time.nanoTime() - begin) / 1e6;
    Guard.checkAtMost(StopKind.STALE_FEEDBACK, words, space.feedback.getName(), limit, "ms", age);
  }

  /** Returns the input; null if the robot must stand. */
  private @Nullable Input input() throws ControlRefusedException {
    if (config.input() == null) {
      return Input.NONE;
    }
    Input input;
    try {
      input = config.input().read();
    } catch (Throwable e) { // see the law
      throw new ControlRefusedException(
          new StopReason(StopKind.INPUT, "the input device failed: " + e, e));
    }
    if (!input.deadMan()) {
      return null;
    }
    long age = time.nanoTime() - input.nanoTime();
    if (age < 0) { // for example from another clock: it would be fresh forever
      throw new ControlRefusedException(
          StopKind.INPUT,
          "the time of the input must be from System.nanoTime, is "
              + -age / 1_000_000
              + " ms ahead of it");
    }
    return age <= safety.maxInputAge().toNanos() ? input : null;
  }

  private double[] move(P actual, Input input, long elapsed, long begin)
      throws ControlRefusedException {
    boolean first = previous == null;
    if (!first) {
      lawPeriods += elapsed;
    }
    State state =
        new State(
            lawPeriods * period / 1e9,
            period / 1e9,
            channel.joints(),
            channel.frame(),
            space.scalesIncrements() ? channel.incrementFactor() : 1,
            input);
    P desired = ask(state, actual);
    checkAge("the age of %s after the law must be at most %s %s, is %s", begin);
    P from = previous == null || space.isVelocity ? actual : previous;
    checkStep(from, desired, space.isVelocity || first ? 1 : elapsed);
    space.check(guard, desired, false);
    previous = desired;
    held = null;
    holding = false;
    feedback.setCommanded(desired);
    if (!target.increment()) {
      return space.numbers(desired);
    }
    double part = config.part(space.isVelocity) * state.incrementFactor();
    double[] increment = space.increment(actual, desired, part);
    if (space.cut(increment)) {
      meter.cut();
    }
    for (int i = 0; i < increment.length; i++) {
      if (Math.abs(increment[i]) < NEGLIGIBLE) {
        increment[i] = 0;
      }
    }
    return increment;
  }

  private P ask(State state, P actual) throws ControlRefusedException {
    P desired;
    try {
      desired = space.ask(state, actual);
    } catch (Throwable e) { // other languages than Java have no checked exceptions
      throw new ControlRefusedException(new StopReason(StopKind.LAW, "the law failed: " + e, e));
    }
    if (desired == null) {
      throw new ControlRefusedException(
          StopKind.LAW, "the law must return a command, returned null");
    }
    return desired;
  }

  private void checkStep(P from, P to, long periods) throws ControlRefusedException {
    space.differences(from, to, differences);
    for (int i = 0; i < differences.length; i++) {
      Quantity quantity = space.quantities.get(i);
      MotionLimits limits = quantity.limits();
      Guard.checkAtMost(
          StopKind.STEP,
          "the step of %s in one cycle must be at most %s %s, is %s",
          quantity.name(),
          limits.step(),
          quantity.unit(),
          differences[i]);
      double speed = differences[i] / (periods * period / 1e9);
      Guard.checkAtMost(
          StopKind.SPEED,
          "the speed of %s must be at most %s %s/s, is %s",
          quantity.name(),
          limits.speed(),
          quantity.unit(),
          speed);
    }
  }

  private double[] hold(P actual) {
    meter.held();
    holding = true;
    previous = null;
    feedback.setCommanded(null);
    if (target.increment()) {
      return ZEROS;
    }
    if (held == null) {
      held = space.numbers(actual); // once, so that the robot does not drift
    }
    return held;
  }

  /**
   * Writes the command to stand, once.
   *
   * @return whether it was written
   */
  boolean halt(StopReason reason) throws ControlRefusedException {
    if (target.increment()) {
      space.setTarget(ZEROS);
    } else if (reason.kind() == StopKind.STALLED_FEEDBACK) {
      return false; // the position of the robot is not known; it stops at its last target
    } else {
      channel.read(space.feedback);
      space.setTarget(space.numbers(space.actual()));
    }
    channel.writeLast(space.target());
    if (reason.isPlanned()) {
      heartbeat.end();
    }
    return true;
  }
}
