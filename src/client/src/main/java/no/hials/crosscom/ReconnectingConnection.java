package no.hials.crosscom;

import java.nio.channels.SocketChannel;
import java.time.Instant;
import java.util.concurrent.RejectedExecutionException;
import java.util.concurrent.ThreadPoolExecutor;
import java.util.concurrent.locks.LockSupport;
import no.hials.crosscom.ConnectionEvent.ConnectionChange;
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
 * <p>The {@link Turn} guards an exchange and the use of its answer.
 *
 * <p>Its daemon threads are {@code crosscom-keepalive-PORT}, and {@code crosscom-events-PORT} while
 * there are events for the listener. Each connection has a {@code crosscom-watchdog-PORT}.
 */
final class ReconnectingConnection {
  private static final Logger LOG = LoggerFactory.getLogger(ReconnectingConnection.class);

  private final ClientConfig config;
  private final Turn turn = new Turn();
  private final ThreadPoolExecutor events;
  private final @Nullable Thread keeper;
  private final byte[] ping = Codec.encode(new ReadRequest(0, "PING"));
  private volatile Connection connection;
  private volatile long timeoutNanos;
  private volatile boolean closed;

  /** The channel that is connecting, if any, so that it can be closed. */
  private volatile @Nullable SocketChannel connecting;

  // guarded by the turn
  private int lastId;
  private @Nullable CrossComException lostBy;
  private int failedAttempts;
  private long nextAttempt;

  ReconnectingConnection(ClientConfig config) throws CrossComConnectException {
    this.config = config;
    this.timeoutNanos = config.requestTimeout().toNanos();
    this.connection = Connection.open(config, channel -> {});
    connection.setTimeout(timeoutNanos);
    this.events = Threads.lazy("crosscom-events-" + config.port());
    if (config.keepAlive().isZero()) {
      keeper = null;
    } else {
      keeper = new Thread(this::keepAlive, "crosscom-keepalive-" + config.port());
      keeper.setDaemon(true);
    }
  }

  /** Starts the keep-alive thread. */
  void start() {
    tell(ConnectionChange.CONNECTED, null);
    if (keeper != null) {
      keeper.start();
    }
  }

  /**
   * Waits until this thread may use the connection, at most the request time-out.
   *
   * @param type the type of the request, for error messages
   * @param name the variable, or a phrase for the request, for error messages
   */
  void acquire(MessageType type, String name) throws CrossComException {
    turn.acquire(type, name, timeoutNanos);
  }

  /** Lets the next thread use the connection. */
  void release() {
    turn.release();
  }

  Connection connection() {
    return connection;
  }

  boolean isClosed() {
    return closed || (!config.reconnect() && connection.isClosed());
  }

  long timeoutNanos() {
    return timeoutNanos;
  }

  void setTimeout(long nanos) {
    timeoutNanos = nanos;
    connection.setTimeout(nanos);
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
  Answer exchange(byte[] frame, int length, MessageType type, String name)
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
    if (timeoutNanos > 0 && turn.waited() >= timeoutNanos) {
      throw Turn.late(Connection.what(type, name), timeoutNanos);
    }
    Threads.commitCall();
  }

  /**
   * Sends a request on the current connection, and waits for its answer. This thread has the turn.
   */
  Answer send(byte[] frame, int length, MessageType type, Repeatability effect, String name)
      throws CrossComException {
    boolean known = connection.hasAnswered();
    try {
      Answer answer =
          connection.exchange(frame, length, nextId(), type, effect, name, turn.waited());
      if (!known) {
        failedAttempts = 0; // a server that only accepts and closes has rejected us
      }
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
    try {
      return connection.exchange(frame, nextId(), type, effect, what, turn.waited(), answerClass);
    } catch (CrossComException e) {
      lost(e);
      throw e;
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
    checkOpen();
    if (connection.isClosed()) {
      if (!config.reconnect()) {
        throw new CrossComConnectionLostException(
            "the connection failed, and reconnecting is off: " + lostBy(), lostBy, false);
      }
    } else {
      CrossComException broken = connection.check();
      if (broken == null) {
        return;
      }
      lost(broken);
      if (!config.reconnect() || connection.wasClosedAtOnce()) {
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
    connect();
  }

  private String lostBy() {
    return lostBy == null ? "closed" : String.valueOf(lostBy.getMessage());
  }

  private void lost(CrossComException why) {
    if (closed) {
      return;
    }
    lostBy = why;
    if (why instanceof CrossComConnectionLostException && connection.wasClosedAtOnce()) {
      delayNextAttempt();
    }
    tell(ConnectionChange.LOST, why);
  }

  private void delayNextAttempt() {
    failedAttempts++;
    long backoff =
        Math.min(
            config.reconnectBackoff().toNanos() << Math.min(failedAttempts - 1, 16),
            config.maxReconnectBackoff().toNanos());
    nextAttempt = System.nanoTime() + backoff;
  }

  /** Connects again. */
  void connect() throws CrossComException {
    Connection made;
    try {
      made = Connection.open(config, this::connecting);
    } catch (CrossComConnectException e) {
      if (closed) {
        throw new CrossComClosedException("the client was closed while it connected", e, false);
      }
      lostBy = e;
      delayNextAttempt();
      tell(ConnectionChange.RECONNECT_FAILED, e);
      throw e;
    } finally {
      connecting = null;
    }
    connection = made;
    made.setTimeout(timeoutNanos);
    if (closed) {
      made.close(); // the program closed the client while this connected
      throw new CrossComClosedException("the client is closed", null, false);
    }
    tell(ConnectionChange.RECONNECTED, null);
  }

  private void connecting(SocketChannel channel) {
    connecting = channel;
    if (closed) {
      Connection.closeQuietly(channel);
    }
  }

  /** Uses the connection when it was idle for a while, and reconnects when it is lost. */
  private void keepAlive() {
    while (!closed) {
      long wait;
      try {
        acquire(MessageType.READ, "PING");
      } catch (CrossComException e) {
        continue; // others use the connection
      }
      try {
        wait = nextDuty();
        if (wait <= 0 && !closed) {
          makeUsable();
          send(ping, ping.length, MessageType.READ, Repeatability.READ, "PING");
        }
      } catch (CrossComException e) {
        LOG.debug("keeping the connection failed: {}", e.getMessage());
        wait = 0;
      } finally {
        release();
      }
      // waiting for the turn may have used up the wake-up of close(), so it is asked again
      if (wait > 0 && !closed) {
        LockSupport.parkNanos(this, wait);
      } else if (!config.reconnect() && connection.isClosed()) {
        return;
      }
    }
  }

  /** Returns the time until the connection has to be used or made. */
  private long nextDuty() {
    long now = System.nanoTime();
    if (connection.isClosed() && failedAttempts > 0) {
      return nextAttempt - now;
    }
    return connection.lastEnd() + config.keepAlive().toNanos() - now;
  }

  private void tell(ConnectionChange kind, @Nullable CrossComException cause) {
    ConnectionListener listener = config.listener();
    if (listener == ClientConfig.NO_LISTENER) {
      return;
    }
    ConnectionEvent event = new ConnectionEvent(kind, Instant.now(), cause);
    try {
      events.execute(
          () -> {
            try {
              listener.connectionChanged(event);
            } catch (RuntimeException | Error e) {
              LOG.warn("the connection listener failed on {}", event, e);
            }
          });
    } catch (RejectedExecutionException e) {
      LOG.debug("not told, the client is closed: {}", event);
    }
  }

  /** Closes for good; an exchange under way fails. Closing again does nothing. */
  void close() {
    if (closed) {
      return;
    }
    closed = true;
    connection.close();
    Connection.closeQuietly(connecting);
    if (keeper != null) {
      LockSupport.unpark(keeper);
    }
    tell(ConnectionChange.CLOSED, null);
    events.shutdown();
  }
}
