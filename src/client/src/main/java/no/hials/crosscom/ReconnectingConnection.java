package no.hials.crosscom;

import java.io.IOException;
import java.time.Instant;
import java.util.Objects;
import java.util.Set;
import java.util.concurrent.CancellationException;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.Future;
import java.util.concurrent.RejectedExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import no.hials.crosscom.Connection.AnswerHandler;
import no.hials.crosscom.ConnectionEvent.ChangeReason;
import no.hials.crosscom.ConnectionEvent.ConnectionChange;
import no.hials.crosscom.internal.exchange.CallbackFuture;
import no.hials.crosscom.internal.exchange.ExchangeAnswer;
import no.hials.crosscom.internal.exchange.MessageAnswer;
import no.hials.crosscom.internal.exchange.Repeatability;
import no.hials.crosscom.internal.exchange.SelectorLoop;
import no.hials.crosscom.internal.exchange.SerialExecutor;
import no.hials.crosscom.internal.exchange.Threads;
import no.hials.crosscom.protocol.AnswerFrame;
import no.hials.crosscom.protocol.Codec;
import no.hials.crosscom.protocol.MessageType;
import no.hials.crosscom.protocol.TypedResponse;
import no.hials.crosscom.protocol.variable.VariableRequest.ReadRequest;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Connects again after a connection broke, keeps an idle connection alive, and calls the listener.
 *
 * <p>The {@link Turn} guards an exchange and the use of its answer. A thread that has the turn uses
 * the connection itself. An asynchronous operation that has it runs in the thread of the {@link
 * SelectorLoop}.
 *
 * <p>The class is long because threads and asynchronous operations share the state of the
 * connection.
 */
final class ReconnectingConnection {
  private static final Logger LOG = LoggerFactory.getLogger(ReconnectingConnection.class);

  private static final long NEVER = Long.MAX_VALUE;

  private static final String NOT_ALLOWED = "an access is not allowed now (accessIf)";

  private final ClientConfig config;
  private final ClientRuntime runtime;
  private final SelectorLoop loop;
  private final Turn turn = new Turn();
  private final ExchangeMeter meter = new ExchangeMeter();
  private final SerialExecutor events;
  private final byte[] ping = Codec.encode(new ReadRequest(0, "PING"));

  /** Null until the client has connected for the first time. */
  private volatile @Nullable Connection connection;

  /** Completed while connected; set with the turn. */
  private volatile CompletableFuture<@Nullable Void> connected;

  /** Read again with each connection, and end with the client. */
  private final Set<Watch> watches = ConcurrentHashMap.newKeySet();

  private volatile long timeoutNanos;
  private volatile boolean closed;
  private volatile boolean started;

  /** The attempt to connect under way, if any. */
  private volatile @Nullable CompletableFuture<Connection> connecting;

  /** Whether to connect in the background; until there is a connection. */
  private volatile boolean wanted;

  /** The next use of an idle connection, or the next attempt; guarded by {@link #uses}. */
  private @Nullable Future<?> nextUse;

  private final Object uses = new Object();

  // guarded by the turn
  private int lastId;
  private @Nullable CrossComException lostBy;
  private int failedAttempts;
  private long nextAttempt;

  /** Whether {@link #connected} is that of the current connection. */
  private boolean usable;

  ReconnectingConnection(ClientConfig config) {
    this.config = config;
    this.runtime = config.runtime();
    this.loop = runtime.loop();
    this.timeoutNanos = config.requestTimeout().toNanos();
    this.events = new SerialExecutor(runtime.listeners());
    this.connected = new CallbackFuture<>(runtime.callbacks());
  }

  /** Connects for the first time. No other thread knows this object yet. */
  void connectFirst() throws CrossComException {
    connect();
    connected.complete(null);
    tell(ConnectionChange.CONNECTED, ChangeReason.NONE, null);
  }

  /** Returns a future that is completed as soon as there is a connection, and connects for it. */
  CompletableFuture<@Nullable Void> connected() {
    CompletableFuture<@Nullable Void> waiting = connected;
    if (isClosed()) {
      CompletableFuture<@Nullable Void> failed = waiting.newIncompleteFuture();
      failed.completeExceptionally(closedFailure());
      return failed;
    }
    if (!waiting.isDone()) {
      wanted = true;
      scheduleUse(0);
    }
    return waiting.copy();
  }

  private CrossComClosedException closedFailure() {
    return new CrossComClosedException(
        closed ? "the client is closed" : "the connection failed, and reconnecting is off",
        null,
        false);
  }

  /** Starts the timer, which connects if there is no connection yet. */
  void start() {
    started = true;
    runtime.add(this);
    wanted = connection == null;
    scheduleUse(timeToNextUse());
  }

  /**
   * Waits until this thread may use the connection, at most the request time-out.
   *
   * @param type the type of the request, for error messages
   * @param name the variable, or a phrase for the request, for error messages
   */
  void acquire(MessageType type, String name) throws CrossComException {
    try {
      turn.acquire(type, name, timeoutNanos);
    } catch (CrossComTimeoutException e) {
      meter.timedOutInQueue();
      throw e;
    }
  }

  /** Returns the statistics of all exchanges. */
  ClientStatistics statistics() {
    return meter.snapshot();
  }

  /** Lets the next thread use the connection. */
  void release() {
    turn.release();
  }

  /** Returns the current connection, which may be closed; null before the first one. */
  @Nullable Connection connection() {
    return connection;
  }

  boolean isClosed() {
    Connection last = connection;
    return closed || (!config.reconnect() && last != null && last.isClosed());
  }

  private Connection current() {
    return Objects.requireNonNull(connection, "not connected");
  }

  long timeoutNanos() {
    return timeoutNanos;
  }

  void setTimeout(long nanos) {
    timeoutNanos = nanos;
    Connection last = connection;
    if (last != null) {
      last.setTimeout(nanos);
    }
  }

  /**
   * Sends a request and waits for its answer. This thread has the turn.
   *
   * <p>If the connection breaks, a read is repeated once on a new connection. A write never is.
   *
   * @param frame begins with the request, whose id does not matter
   * @param length the request's length
   * @param type its type
   * @param name the variable, for error messages
   * @return the answer, valid until the next exchange
   */
  ExchangeAnswer exchange(byte[] frame, int length, MessageType type, String name)
      throws CrossComException {
    begin(type, name);
    makeUsable();
    Repeatability effect = type == MessageType.WRITE ? Repeatability.CHANGE : Repeatability.READ;
    try {
      return send(frame, length, type, effect, name);
    } catch (CrossComConnectionLostException e) {
      if (!mayRepeat(effect)) {
        throw e;
      }
      LOG.debug("repeating the read of {} on a new connection", name);
      connect();
      return send(frame, length, type, effect, name);
    }
  }

  /** Returns whether a request may be repeated on a new connection. */
  boolean mayRepeat(Repeatability effect) {
    return effect == Repeatability.READ
        && config.reconnect()
        && !Thread.currentThread().isInterrupted();
  }

  /** Begins an operation, unless its thread is interrupted or its call was cancelled. */
  void begin(MessageType type, String name) throws CrossComException {
    if (Thread.currentThread().isInterrupted()) {
      // an exchange would close the connection, and could not say whether anything was sent
      throw Turn.interrupted(Connection.what(type, name));
    }
    if (isLate()) {
      throw late(Connection.what(type, name));
    }
    Threads.checkCall();
  }

  /** Returns whether the turn came after the time-out. */
  private boolean isLate() {
    return timeoutNanos > 0 && turn.waited() >= timeoutNanos;
  }

  private CrossComException late(String what) {
    meter.timedOutInQueue();
    return Turn.late(what, timeoutNanos);
  }

  /**
   * Sends a request on the current connection, and waits for its answer. This thread has the turn.
   */
  ExchangeAnswer send(byte[] frame, int length, MessageType type, Repeatability effect, String name)
      throws CrossComException {
    checkAllowed();
    Threads.commitCall();
    Connection used = current();
    boolean known = used.hasAnswered();
    try {
      ExchangeAnswer answer =
          used.exchange(frame, length, nextId(), type, effect, name, turn.waited());
      if (!known) {
        failedAttempts = 0; // a server that only accepts and closes has rejected us
      }
      count(type, answer);
      return answer;
    } catch (CrossComException e) {
      lost(e);
      throw e;
    }
  }

  /**
   * Does the same for a request whose answer is a message. Before such a request the server was
   * detected, so the connection has answered already.
   */
  MessageAnswer send(
      byte[] frame,
      MessageType type,
      Repeatability effect,
      String what,
      Class<? extends TypedResponse> answerClass)
      throws CrossComException {
    checkAllowed();
    Threads.commitCall();
    try {
      MessageAnswer answer =
          current().exchange(frame, nextId(), type, effect, what, turn.waited(), answerClass);
      meter.answered(turn.waited(), answer.nanos(), answer.response().tail().success());
      return answer;
    } catch (CrossComException e) {
      lost(e);
      throw e;
    }
  }

  /** Decodes the answer to the last exchange, which is a message. */
  MessageAnswer message(ExchangeAnswer answer, Class<? extends TypedResponse> answerClass)
      throws CrossComException {
    try {
      return current().message(answer, answerClass);
    } catch (CrossComException e) {
      lost(e);
      throw e;
    }
  }

  private void count(MessageType type, ExchangeAnswer answer) {
    AnswerFrame frame = answer.frame();
    boolean refused = !frame.success() || (type == MessageType.READ && frame.isEmpty());
    meter.answered(turn.waited(), answer.nanos(), !refused);
  }

  /** Closes the connection and throws if the condition of each access does not hold. */
  private void checkAllowed() throws CrossComConnectException {
    if (!config.accessIf().getAsBoolean()) {
      current().close();
      CrossComConnectException failure = new CrossComConnectException(NOT_ALLOWED, null);
      lost(failure);
      throw failure;
    }
  }

  private int nextId() {
    lastId = (lastId + 1) & 0xFFFF;
    return lastId;
  }

  /** Throws if the client is closed. */
  void checkOpen() throws CrossComClosedException {
    if (closed) {
      throw new CrossComClosedException("the client is closed", null, false);
    }
  }

  /** Reconnects if the server has closed the connection. */
  void makeUsable() throws CrossComException {
    if (mustConnect()) {
      connect();
    }
  }

  /** Returns whether there is no usable connection; throws if there will be none. */
  private boolean mustConnect() throws CrossComException {
    checkOpen();
    Connection last = connection;
    if (last != null && last.isClosed()) {
      if (!config.reconnect()) {
        throw new CrossComConnectionLostException(
            "the connection failed, and reconnecting is off: " + lostBy(), lostBy, false);
      }
    } else if (last != null) {
      CrossComException broken = last.check();
      if (broken == null) {
        return false;
      }
      lost(broken);
      if (!config.reconnect() || last.wasClosedAtOnce()) {
        throw broken;
      }
    }
    long wait = nextAttempt - System.nanoTime();
    if (failedAttempts > 0 && wait > 0) {
      throw new CrossComConnectException(
          "not connected, and the next attempt is in "
              + (wait / 1_000_000 + 1)
              + " ms; the last one: "
              + lostBy(),
          lostBy);
    }
    return true;
  }

  private String lostBy() {
    return lostBy == null ? "closed" : lostBy.reason();
  }

  private void lost(CrossComException why) {
    if (closed) {
      return;
    }
    lostBy = why;
    meter.failed(why);
    if (usable) {
      usable = false;
      connected = new CallbackFuture<>(runtime.callbacks());
    }
    ChangeReason reason = ChangeReason.of(why);
    if (why instanceof CrossComConnectionLostException && current().wasClosedAtOnce()) {
      delayNextAttempt();
      if (reason != ChangeReason.INTERRUPTED) {
        reason = ChangeReason.REJECTED;
      }
    }
    tell(ConnectionChange.LOST, reason, why);
  }

  private void delayNextAttempt() {
    failedAttempts++;
    long backoff =
        Math.min(
            config.reconnectBackoff().toNanos() << Math.min(failedAttempts - 1, 16),
            config.maxReconnectBackoff().toNanos());
    nextAttempt = System.nanoTime() + backoff;
  }

  /** Connects. */
  void connect() throws CrossComException {
    CompletableFuture<Connection> attempt = attempt();
    try {
      adopt(attempt.get());
    } catch (InterruptedException e) {
      if (!attempt.cancel(false) && !attempt.isCompletedExceptionally()) {
        attempt.join().close();
      }
      Thread.currentThread().interrupt();
      throw connectFailed(new IOException("the thread was interrupted", e));
    } catch (ExecutionException | CancellationException e) {
      throw connectFailed(e);
    }
  }

  private CompletableFuture<Connection> attempt() {
    if (!config.accessIf().getAsBoolean()) {
      return CompletableFuture.failedFuture(new IOException(NOT_ALLOWED));
    }
    CompletableFuture<Connection> attempt = ConnectAttempt.start(config);
    connecting = attempt;
    if (closed) {
      attempt.cancel(false);
    }
    return attempt;
  }

  private CrossComException connectFailed(Throwable e) {
    connecting = null;
    if (closed) {
      return new CrossComClosedException("the client was closed while it connected", e, false);
    }
    Throwable cause = e instanceof ExecutionException ? e.getCause() : null;
    CrossComConnectException failure = ConnectAttempt.failure(config, cause == null ? e : cause);
    lostBy = failure;
    delayNextAttempt();
    if (started) {
      tell(ConnectionChange.RECONNECT_FAILED, ChangeReason.of(failure), failure);
    }
    return failure;
  }

  private void adopt(Connection made) throws CrossComClosedException {
    connecting = null;
    boolean first = connection == null;
    connection = made;
    usable = true;
    wanted = false;
    made.setTimeout(timeoutNanos);
    if (closed) {
      made.close(); // the program closed the client while this connected
      throw new CrossComClosedException("the client is closed", null, false);
    }
    if (started) {
      if (!first) {
        meter.reconnected();
      }
      tell(
          first ? ConnectionChange.CONNECTED : ConnectionChange.RECONNECTED,
          ChangeReason.NONE,
          null);
      watches.forEach(Watch::connected);
      CompletableFuture<@Nullable Void> waiting = connected;
      runtime.complete(() -> waiting.complete(null));
    }
  }

  // --- asynchronous operations, in the thread of the loop

  /** Calls an operation when it has the turn. It ends with {@link #endAsync}. */
  void beginAsync(Runnable operation) {
    turn.acquireAsync(() -> loop.execute(operation));
  }

  /** Ends the turn of an asynchronous operation. */
  void endAsync() {
    turn.releaseAsync();
  }

  /**
   * Connects if there is no usable connection. The operation has the turn.
   *
   * @param then called once there is one
   * @param failed called instead with the failure
   */
  void connectedAsync(Runnable then, Consumer<CrossComException> failed) {
    boolean usable;
    try {
      if (isLate()) {
        throw late("exchange");
      }
      usable = !mustConnect();
    } catch (CrossComException e) {
      failed.accept(e);
      return;
    }
    if (usable) {
      then.run();
    } else {
      connectAsync(then, failed);
    }
  }

  /** Connects like {@link #connectedAsync}, also if the time of the next attempt has not come. */
  void connectAsync(Runnable then, Consumer<CrossComException> failed) {
    CompletableFuture<Void> unused =
        attempt()
            .handleAsync(
                (made, failure) -> {
                  try {
                    if (made == null) {
                      throw connectFailed(failure);
                    }
                    adopt(made);
                  } catch (CrossComException e) {
                    failed.accept(e);
                    return null;
                  }
                  then.run();
                  return null;
                },
                loop);
  }

  /**
   * Sends a request on the current connection. The operation has the turn.
   *
   * @param handler called once, still with the turn
   */
  void sendAsync(
      byte[] frame,
      int length,
      MessageType type,
      Repeatability effect,
      String name,
      AnswerHandler handler) {
    try {
      checkAllowed();
    } catch (CrossComConnectException e) {
      handler.failed(e);
      return;
    }
    Connection used = current();
    boolean known = used.hasAnswered();
    used.exchangeAsync(
        frame,
        length,
        nextId(),
        type,
        effect,
        name,
        turn.waited(),
        new AnswerHandler() {
          @Override
          public void answered(ExchangeAnswer answer) {
            if (!known) {
              failedAttempts = 0;
            }
            count(type, answer);
            handler.answered(answer);
          }

          @Override
          public void failed(CrossComException failure) {
            lost(failure);
            handler.failed(failure);
          }
        });
  }

  /** Uses the connection when it was idle for a while, and reconnects when it is lost. */
  private void useIdle() {
    if (closed || timeToNextUse() > 0) {
      endUse();
      return;
    }
    AnswerHandler end =
        new AnswerHandler() {
          @Override
          public void answered(ExchangeAnswer answer) {
            endUse();
          }

          @Override
          public void failed(CrossComException failure) {
            LOG.debug("keeping the connection failed: {}", failure.getMessage());
            endUse();
          }
        };
    connectedAsync(
        () -> sendAsync(ping, ping.length, MessageType.READ, Repeatability.NONE, "PING", end),
        end::failed);
  }

  private void endUse() {
    long wait = timeToNextUse();
    endAsync();
    scheduleUse(Math.max(wait, 1));
  }

  /** Replaces the time of the next use, so that there is one at most. */
  private void scheduleUse(long nanos) {
    synchronized (uses) {
      cancelUse();
      if (closed || nanos == NEVER) {
        return;
      }
      try {
        nextUse =
            runtime.timer().schedule(() -> beginAsync(this::useIdle), nanos, TimeUnit.NANOSECONDS);
      } catch (RejectedExecutionException e) {
        LOG.debug("the runtime is closed");
      }
    }
  }

  private void cancelUse() {
    synchronized (uses) {
      Future<?> next = nextUse;
      if (next != null) {
        next.cancel(false);
      }
    }
  }

  /** Returns the time until the connection has to be used or made; {@link #NEVER} if it has not. */
  private long timeToNextUse() {
    long now = System.nanoTime();
    Connection last = connection;
    boolean keep = !config.keepAlive().isZero();
    if (last == null || last.isClosed()) {
      if (isClosed() || !(wanted || keep)) {
        return NEVER;
      } else if (wanted || failedAttempts > 0) {
        return failedAttempts > 0 ? nextAttempt - now : 0;
      }
    }
    return last != null && keep ? last.lastEnd() + config.keepAlive().toNanos() - now : NEVER;
  }

  private void tell(ConnectionChange kind, ChangeReason reason, @Nullable CrossComException cause) {
    ConnectionListener listener = config.listener();
    if (listener == ClientConfig.NO_LISTENER) {
      return;
    }
    ConnectionEvent event = new ConnectionEvent(kind, Instant.now(), reason, cause);
    events.execute(
        () -> {
          try {
            listener.connectionChanged(event);
          } catch (RuntimeException | Error e) {
            LOG.warn("the connection listener failed on {}", event, e);
          }
        });
  }

  /** Closes a watch when this is closed. */
  void add(Watch watch) {
    watches.add(watch);
    if (isClosed()) {
      watch.close();
    }
  }

  void remove(Watch watch) {
    watches.remove(watch);
  }

  /** Closes for good; an exchange under way fails. Closing again does nothing. */
  void close(ChangeReason reason) {
    if (closed) {
      return;
    }
    closed = true;
    Connection last = connection;
    if (last != null) {
      last.close();
    }
    CompletableFuture<Connection> attempt = connecting;
    if (attempt != null) {
      attempt.cancel(false);
    }
    cancelUse();
    watches.forEach(Watch::close);
    runtime.remove(this);
    CompletableFuture<@Nullable Void> pending = connected;
    runtime.complete(() -> pending.completeExceptionally(closedFailure()));
    tell(ConnectionChange.CLOSED, reason, null);
  }
}
