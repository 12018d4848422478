package no.hials.crosscom.gateway.internal.opcua;

import io.prometheus.metrics.core.metrics.Counter;
import java.io.IOException;
import java.io.InterruptedIOException;
import java.time.Duration;
import java.util.List;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.Future;
import java.util.concurrent.RejectedExecutionException;
import java.util.function.BooleanSupplier;
import java.util.function.LongSupplier;
import no.hials.crosscom.CrossComClosedException;
import no.hials.crosscom.CrossComConnectException;
import no.hials.crosscom.CrossComException;
import no.hials.crosscom.CrossComTimeoutException;
import no.hials.crosscom.cell.OtherValueException;
import no.hials.crosscom.cell.feed.LateWriteException;
import no.hials.crosscom.cell.feed.RefusedWriteException;
import no.hials.crosscom.cell.feed.RobotFeed;
import no.hials.crosscom.gateway.GatewayContext;
import no.hials.crosscom.gateway.internal.writing.Pauses;
import no.hials.crosscom.gateway.internal.writing.RobotThreads;
import no.hials.crosscom.protocol.value.KrlValue;
import org.eclipse.milo.opcua.stack.core.StatusCodes;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Writes for clients, on a thread for each robot that is written to, one value at a time. A write
 * is never repeated.
 */
final class RobotWrites {
  private static final Logger LOG = LoggerFactory.getLogger(RobotWrites.class);

  private static final String TOO_LATE = "not written: " + RobotThreads.TOO_LATE;

  private final GatewayContext context;
  private final LongSupplier nanoTime;
  private final Pauses pauses;
  private final Counter results;
  private final RobotThreads threads = new RobotThreads("opcua-write-");
  private volatile boolean closed;

  /**
   * When a request has arrived.
   *
   * @param sent the time at which it may have been sent
   * @param pause how long the gateway was frozen just before, or zero
   */
  record Arrival(long sent, Duration pause) {}

  /**
   * A request of a client, with one or more writes.
   *
   * @param who the user, for the audit log
   * @param latest the time up to which its writes may begin
   * @param givenUp the time at which the client stops waiting for the answer
   * @param isWanted whether its session still exists
   * @param pause how long the gateway was frozen just before the request arrived, or zero
   */
  record Request(String who, long latest, long givenUp, BooleanSupplier isWanted, Duration pause) {}

  RobotWrites(GatewayContext context) {
    this(context, System::nanoTime, Pauses.start());
  }

  RobotWrites(GatewayContext context, LongSupplier nanoTime, Pauses pauses) {
    this.context = context;
    this.nanoTime = nanoTime;
    this.pauses = pauses;
    results =
        context
            .health()
            .counter("opcua_writes", "Writes of OPC UA clients by their results", "result");
    List.of("done", "failed", "refused", "unknown").forEach(results::initLabelValues);
  }

  /** Returns whether the gateway has a robot. */
  boolean hasRobot(String name) {
    return context.robot(name) != null;
  }

  /** Returns the arrival of a request that arrives now. */
  Arrival arrival() {
    Duration pause = pauses.justOver();
    // it may have been sent before the pause
    return new Arrival(nanoTime.getAsLong() - pause.toNanos(), pause);
  }

  /**
   * Returns a request.
   *
   * @param timeout how long the client waits for its answer; zero if it does not tell
   */
  static Request request(Arrival arrival, User user, Duration timeout, BooleanSupplier isWanted) {
    long latest = arrival.sent() + RobotThreads.LONGEST_WAIT.toNanos();
    return new Request(
        "opcua:" + user.name(),
        latest,
        timeout.isZero() ? latest : arrival.sent() + timeout.toNanos(),
        isWanted,
        arrival.pause());
  }

  /** Writes a value, waits for the result, and returns its status. */
  long write(Request request, ValueNode node, @Nullable Object value) {
    String robot = node.access().robot();
    String variable = node.access().variable();
    KrlValue now = node.krlValue();
    if (now == null) {
      // its type is unknown
      return StatusCodes.Bad_WaitingForInitialData;
    }
    String text;
    try {
      text = UaValues.toKrl(value, now);
    } catch (IllegalArgumentException e) {
      refuse(
          request,
          robot,
          variable,
          String.valueOf(value),
          "%s: %s was not written: %s".formatted(robot, variable, e.getMessage()));
      return StatusCodes.Bad_OutOfRange;
    }
    return text == null ? StatusCodes.Bad_TypeMismatch : write(request, robot, variable, text);
  }

  /** Writes the text of a value, waits for the result, and returns its status. */
  long write(Request request, String robot, String variable, String text) {
    try {
      Future<Long> result =
          threads.of(robot).submit(() -> writeNow(request, robot, variable, text));
      return result.get();
    } catch (RejectedExecutionException e) {
      return closed
          ? writeNow(request, robot, variable, text) // which refuses it
          : StatusCodes.Bad_TooManyOperations;
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      return StatusCodes.Bad_Timeout;
    } catch (ExecutionException e) {
      LOG.warn("OPC UA: {} of {}", variable, robot, e.getCause());
      return StatusCodes.Bad_InternalError;
    }
  }

  private long writeNow(Request request, String robotName, String variable, String text) {
    RobotFeed robot = context.robot(robotName);
    if (closed || robot == null) {
      String reason =
          closed ? "not written: the gateway ends" : "not written: its connection was closed";
      refuse(request, robotName, variable, text, reason);
      return closed ? StatusCodes.Bad_Shutdown : StatusCodes.Bad_NodeIdUnknown;
    }
    if (!request.isWanted().getAsBoolean()) {
      refuse(
          request, robotName, variable, text, "not written: the session of the client has ended");
      return StatusCodes.Bad_SessionClosed;
    }
    long now = nanoTime.getAsLong();
    boolean isLate = now - request.latest() >= 0 || now - request.givenUp() >= 0;
    if (isLate && !request.pause().isZero()) {
      refuse(request, robotName, variable, text, "not written: " + Pauses.reason(request.pause()));
      return StatusCodes.Bad_RequestTimeout;
    }
    if (now - request.latest() > 0) {
      refuse(request, robotName, variable, text, TOO_LATE);
      return StatusCodes.Bad_TooManyOperations;
    }
    if (now - request.givenUp() > 0) {
      refuse(request, robotName, variable, text, "not written: the client no longer waits for it");
      return StatusCodes.Bad_RequestTimeout;
    }
    try {
      Duration sendWithin =
          Duration.ofNanos(Math.min(request.latest() - now, request.givenUp() - now));
      context.writes().write(request.who(), context.plant(), robot, variable, text, sendWithin);
      results.labelValues("done").inc();
      return StatusCodes.Good;
    } catch (IOException | IllegalArgumentException e) {
      boolean unknown =
          e instanceof InterruptedIOException
              || e instanceof OtherValueException
              || (e instanceof CrossComException failure && failure.isOutcomeUnknown());
      results
          .labelValues(
              unknown ? "unknown" : e instanceof RefusedWriteException ? "refused" : "failed")
          .inc();
      log(request, robotName, variable, text, String.valueOf(e.getMessage()));
      if (e instanceof LateWriteException) {
        return request.givenUp() - request.latest() < 0
            ? StatusCodes.Bad_RequestTimeout
            : StatusCodes.Bad_TooManyOperations;
      }
      return status(e, unknown);
    }
  }

  private void refuse(
      Request request, String robotName, String variable, String text, String reason) {
    results.labelValues("refused").inc();
    RobotFeed robot = context.robot(robotName);
    if (robot == null) {
      context.writes().refused(request.who(), robotName, variable, text, reason);
    } else {
      context.writes().refused(request.who(), robot, variable, text, reason);
    }
    log(request, robotName, variable, text, reason);
  }

  private static void log(
      Request request, String robot, String variable, String text, String reason) {
    LOG.warn(
        "{}: the write {} = {} to {} failed: {}", request.who(), variable, text, robot, reason);
  }

  /** Returns the status of a failure: docs/reference/opcua.md#writing. */
  private static long status(Exception e, boolean unknown) {
    if (unknown) {
      return e instanceof CrossComTimeoutException
          ? StatusCodes.Bad_Timeout
          : StatusCodes.Bad_CommunicationError;
    }
    if (e instanceof RefusedWriteException || e instanceof IllegalArgumentException) {
      return StatusCodes.Bad_OutOfRange;
    }
    if (e instanceof CrossComTimeoutException) {
      // it only waited for the readings of the robot, and was not sent
      return StatusCodes.Bad_ResourceUnavailable;
    }
    if (e instanceof CrossComClosedException) {
      // the configuration has removed or changed the robot in the meantime
      return StatusCodes.Bad_NodeIdUnknown;
    }
    return e instanceof CrossComConnectException
        ? StatusCodes.Bad_NoCommunication
        : StatusCodes.Bad_DeviceFailure;
  }

  /** Ends the thread of a removed robot, after the write in progress. */
  void removed(String robot) {
    threads.end(robot);
  }

  /** Refuses all writes from now on, and waits a short time for a running one. */
  void close() {
    closed = true;
    pauses.close();
    threads.end();
  }
}
