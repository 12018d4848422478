package no.hials.crosscom.gateway.internal.broker;

import io.prometheus.metrics.core.metrics.Counter;
import java.io.IOException;
import java.time.Duration;
import java.util.List;
import java.util.concurrent.RejectedExecutionException;
import java.util.function.Consumer;
import java.util.function.LongSupplier;
import no.hials.crosscom.cell.feed.RefusedWriteException;
import no.hials.crosscom.cell.feed.RobotFeed;
import no.hials.crosscom.gateway.GatewayContext;
import no.hials.crosscom.gateway.internal.writing.Pauses;
import no.hials.crosscom.gateway.internal.writing.RobotThreads;
import no.hials.crosscom.protocol.value.KrlString;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Executes commands of other systems, one at a time for each robot, on a thread for each robot that
 * has commands. No command is repeated. Thread-safe.
 */
public final class CommandQueue implements AutoCloseable {
  private static final Logger LOG = LoggerFactory.getLogger(CommandQueue.class);
  private static final int LONGEST_VALUE = 4096;

  private static final String TOO_LATE = "not executed: " + RobotThreads.TOO_LATE;
  private static final String EXPIRED =
      "not executed: it expired while it waited for others to end";
  private static final String ENDS = "not executed: the gateway ends";

  private final GatewayContext context;
  private final LongSupplier nanoTime;
  private final Pauses pauses;
  private final Counter counter;
  private final RobotThreads threads = new RobotThreads("mqtt-commands-");
  private volatile boolean closed;

  /** Creates a queue that writes with the permissions of the gateway. */
  public CommandQueue(GatewayContext context) {
    this(context, System::nanoTime, Pauses.start());
  }

  CommandQueue(GatewayContext context, LongSupplier nanoTime, Pauses pauses) {
    this.context = context;
    this.nanoTime = nanoTime;
    this.pauses = pauses;
    this.counter =
        context.health().counter("mqtt_commands", "Commands from topics, by result", "result");
    List.of("done", "failed", "refused").forEach(counter::initLabelValues);
  }

  /** Counts and returns a refusal. */
  public String refused(String who, String robot, String variable, String reason) {
    counter.labelValues("refused").inc();
    LOG.warn("{}: {} {}: {}", who, robot, variable, reason);
    return reason;
  }

  /**
   * Executes a command later. Does not block.
   *
   * @param who the sender, for the audit log
   * @param value the value as KRL writes it; a text without quotes if the variable has a text
   * @param expiry how long the command may wait; null if it does not tell
   * @param result called with {@code done} or the reason, at once if the command is refused
   */
  public void execute(
      String who,
      String robot,
      String variable,
      String value,
      @Nullable Duration expiry,
      Consumer<String> result) {
    if (closed) {
      result.accept(refused(who, robot, variable, ENDS));
      return;
    }
    RobotFeed feed = context.robot(robot);
    if (feed == null) {
      String reason =
          context.plant().robots().containsKey(robot)
              ? "not executed: the gateway is starting the robot"
              : "no robot is named " + robot;
      result.accept(refused(who, robot, variable, reason));
      return;
    }
    if (value.length() > LONGEST_VALUE) {
      result.accept(
          refused(
              who, robot, variable, "the value has more than " + LONGEST_VALUE + " characters"));
      return;
    }
    if (expiry != null && expiry.isZero()) {
      result.accept(refuse(who, feed, variable, value, "not executed: it had expired"));
      return;
    }
    Duration longest =
        expiry != null && expiry.compareTo(RobotThreads.LONGEST_WAIT) < 0
            ? expiry
            : RobotThreads.LONGEST_WAIT;
    Duration pause = pauses.justOver();
    if (pause.compareTo(longest) >= 0) {
      result.accept(refuse(who, feed, variable, value, "not executed: " + Pauses.reason(pause)));
      return;
    }
    long latest = nanoTime.getAsLong() + longest.minus(pause).toNanos();
    String late = longest.equals(RobotThreads.LONGEST_WAIT) ? TOO_LATE : EXPIRED;
    try {
      threads
          .of(robot)
          .execute(() -> result.accept(executeNow(who, feed, variable, value, latest, late)));
    } catch (RejectedExecutionException e) {
      result.accept(refused(who, robot, variable, "not executed: " + e.getMessage()));
    }
  }

  private String executeNow(
      String who, RobotFeed feed, String variable, String value, long latest, String late) {
    if (closed) {
      return refuse(who, feed, variable, value, ENDS);
    }
    long left = latest - nanoTime.getAsLong();
    if (left <= 0) {
      return refuse(who, feed, variable, value, late);
    }
    return write(who, feed, variable, value, Duration.ofNanos(left));
  }

  /** Counts and returns a refusal, with a line in the audit log. */
  public String refuse(String who, RobotFeed feed, String variable, String value, String reason) {
    context.writes().refused(who, feed, variable, value, reason);
    return refused(who, feed.name(), variable, reason);
  }

  private String write(
      String who, RobotFeed feed, String variable, String value, Duration sendWithin) {
    String text;
    try {
      text = toKrl(feed, variable, value);
    } catch (IllegalArgumentException e) {
      return refuse(who, feed, variable, value, "not executed: " + e.getMessage());
    }
    try {
      context.writes().write(who, context.plant(), feed, variable, text, sendWithin);
      counter.labelValues("done").inc();
      return "done";
    } catch (RefusedWriteException | IllegalArgumentException e) {
      return refused(who, feed.name(), variable, String.valueOf(e.getMessage()));
    } catch (IOException e) {
      counter.labelValues("failed").inc();
      LOG.warn("{}: {} {}: {}", who, feed.name(), variable, e.getMessage());
      return String.valueOf(e.getMessage());
    }
  }

  private static String toKrl(RobotFeed feed, String variable, String value) {
    String text = value.strip();
    boolean isText = feed.lastValue(variable).filter(KrlString.class::isInstance).isPresent();
    return isText && !text.startsWith("\"") ? new KrlString(value).print() : text;
  }

  /** Refuses the commands that wait, and waits a short time for a running one. */
  @Override
  public void close() {
    closed = true;
    pauses.close();
    threads.end();
  }
}
