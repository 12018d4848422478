package no.hials.crosscom;

import java.io.EOFException;
import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.SocketException;
import java.net.SocketTimeoutException;
import java.net.StandardSocketOptions;
import java.net.UnknownHostException;
import java.nio.ByteBuffer;
import java.nio.channels.ClosedByInterruptException;
import java.nio.channels.SocketChannel;
import java.util.Arrays;
import java.util.function.Consumer;
import no.hials.crosscom.protocol.AnswerFrame;
import no.hials.crosscom.protocol.Codec;
import no.hials.crosscom.protocol.FrameReader;
import no.hials.crosscom.protocol.MalformedFrameException;
import no.hials.crosscom.protocol.MessageType;
import no.hials.crosscom.protocol.Response;
import no.hials.crosscom.protocol.ServerType;
import no.hials.crosscom.protocol.TypedResponse;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * One TCP connection and the exchanges on it. Not thread-safe: the client's turn guards it, except
 * {@link #close}.
 *
 * <p>The answer is read without a socket time-out, which would cost two more system calls an
 * exchange; instead the timer closes the socket when an exchange is overdue. A connection that
 * failed stays closed: a late answer on it could be taken for the answer to another request.
 */
final class Connection {
  private static final Logger LOG = LoggerFactory.getLogger(Connection.class);

  /** After this time without an exchange, the connection is checked first. */
  private static final long CHECK_AFTER_NANOS = 20_000_000;

  /** A connection that ends unanswered within this time was rejected by the server. */
  private static final long AT_ONCE_NANOS = 1_000_000_000;

  /** The number of bytes of a frame that the log shows. */
  private static final int LOGGED = 256;

  private final SocketChannel channel;
  private final FrameReader reader;
  private final Answer answer = new Answer();

  /** The bytes to send. Outside the heap, so that the channel need not copy them there. */
  private ByteBuffer out = ByteBuffer.allocateDirect(512);

  private final InetSocketAddress address;

  /** The remote address for messages. */
  private final String remote;

  private final int localPort;
  private final ExchangeDeadline deadline;
  private volatile boolean closed;
  private long lastEnd = System.nanoTime();

  /** The time of a check that no exchange has followed yet; otherwise 0. */
  private long checked;

  private boolean answered;

  private Connection(SocketChannel channel, ClientRuntime runtime) throws IOException {
    this.channel = channel;
    this.reader = new FrameReader(channel);
    this.address = (InetSocketAddress) channel.getRemoteAddress();
    // without the slash of InetSocketAddress.toString
    this.remote = address.toString().replaceFirst("^[^/]*/", "");
    this.localPort = channel.socket().getLocalPort();
    this.deadline = new ExchangeDeadline(runtime.timer(), this::expire);
  }

  /**
   * Connects.
   *
   * @param config the address and the times
   * @param started called with the channel before it connects, so that another thread can close it
   */
  static Connection open(ClientConfig config, Consumer<SocketChannel> started)
      throws CrossComConnectException {
    String where = config.host() + ":" + config.port();
    SocketChannel channel = null;
    try {
      channel = SocketChannel.open();
      started.accept(channel);
      channel.setOption(StandardSocketOptions.TCP_NODELAY, true);
      channel
          .socket()
          .connect(
              new InetSocketAddress(config.host(), config.port()),
              (int) config.connectTimeout().toMillis());
      Connection connection = new Connection(channel, config.runtime());
      LOG.debug("connected to {}, local port {}", connection.remote, connection.localPort);
      return connection;
    } catch (IOException e) {
      closeQuietly(channel);
      String why;
      if (e instanceof UnknownHostException) {
        why = "the host name is unknown";
      } else if (e instanceof SocketTimeoutException) {
        why = "no answer within " + config.connectTimeout().toMillis() + " ms";
      } else if (e instanceof ClosedByInterruptException) {
        why = "the thread was interrupted";
      } else {
        why = e.getMessage() == null ? e.getClass().getSimpleName() : e.getMessage();
      }
      throw new CrossComConnectException("could not connect to " + where + ": " + why, e);
    }
  }

  InetAddress remoteAddress() {
    return address.getAddress();
  }

  int localPort() {
    return localPort;
  }

  boolean isClosed() {
    return closed;
  }

  /**
   * Returns the end of the last exchange, or the time of connecting, by {@link System#nanoTime}.
   */
  long lastEnd() {
    return lastEnd;
  }

  /** Returns whether the server closed the connection soon after connecting, without an answer. */
  boolean wasClosedAtOnce() {
    return closed && !answered && System.nanoTime() - lastEnd < AT_ONCE_NANOS;
  }

  /** Returns whether the server has answered anything yet. */
  boolean hasAnswered() {
    return answered;
  }

  /** Sets how long an exchange may take; 0 for no limit. */
  void setTimeout(long nanos) {
    deadline.setLimit(nanos);
  }

  /**
   * Checks whether the server has closed the connection, or sent bytes that no request asked for.
   * Checks only if nothing was exchanged for a while, because it costs three system calls.
   *
   * @return null if the connection is usable; otherwise the reason, and the connection is closed
   */
  @Nullable CrossComException check() {
    checked = System.nanoTime();
    if (answered && checked - lastEnd < CHECK_AFTER_NANOS && reader.surplus() == 0) {
      return null;
    }
    checked = 0; // takes a while
    try {
      channel.configureBlocking(false);
      int count = reader.poll();
      if (count < 0) {
        throw new EOFException(endOfStream());
      }
      channel.configureBlocking(true);
    } catch (IOException e) {
      close();
      CrossComException foreign = foreign(e, false);
      return foreign != null
          ? foreign
          : new CrossComConnectionLostException(
              "the connection to " + remote + " broke while it was not used: " + reason(e),
              e,
              false);
    }
    if (reader.surplus() > 0) {
      close();
      CrossComException foreign = foreign(null, false);
      return foreign != null
          ? foreign
          : new CrossComProtocolException(
              "bytes came that no request had asked for: " + reader.surplusHex(), null, false);
    }
    return null;
  }

  private String endOfStream() {
    return answered
        ? "the server closed it"
        : "the server closed it before it had answered anything; it may have as many clients as it"
            + " takes (KUKAVARPROXY takes 10)";
  }

  private String reason(IOException e) {
    if (!answered && e instanceof SocketException) {
      return e.getMessage() + "; " + endOfStream(); // a reset instead of an orderly end
    }
    if (e instanceof ClosedByInterruptException) {
      return "the thread was interrupted";
    }
    return e.getMessage() == null ? e.getClass().getSimpleName() : e.getMessage();
  }

  /**
   * Sends a request and waits for its answer.
   *
   * @param frame begins with the request; its id is not sent
   * @param length the request's length
   * @param id the id to send instead
   * @param type its type
   * @param effect its effect on the controller
   * @param name the variable, or a phrase for the request, for error messages
   * @param waited how much of the time limit is over, in ns
   * @return the answer, valid until the next exchange
   */
  Answer exchange(
      byte[] frame,
      int length,
      int id,
      MessageType type,
      Repeatability effect,
      String name,
      long waited)
      throws CrossComException {
    boolean write = effect == Repeatability.CHANGE;
    if (out.capacity() < length) {
      out = ByteBuffer.allocateDirect(length);
    }
    out.clear().put(frame, 0, length).flip();
    Codec.setId(out, id);
    boolean trace = LOG.isTraceEnabled();
    if (trace) {
      byte[] sent = Arrays.copyOf(frame, length);
      Codec.setId(sent, id);
      LOG.trace("sending {}", MalformedFrameException.hex(sent, sent.length, LOGGED));
    }
    long timeout = deadline.limit();
    long start = checked != 0 ? checked : System.nanoTime();
    checked = 0;
    if (timeout > 0) {
      deadline.begin(start + timeout - waited);
    }
    try {
      while (out.hasRemaining()) {
        channel.write(out);
      }
      int answerLength = reader.next();
      if (answerLength < 0) {
        throw new EOFException(endOfStream());
      }
      long end = System.nanoTime();
      lastEnd = end;
      answer.set(reader.buffer(), answerLength, end - start);
    } catch (MalformedFrameException e) {
      deadline.end();
      throw violated(e, what(type, name), write);
    } catch (IOException e) {
      boolean expired = deadline.end();
      boolean byUs = closed && !expired;
      close();
      CrossComProtocolException foreign = foreign(e, write);
      if (foreign != null) {
        throw foreign;
      } else if (expired) {
        throw timedOut(what(type, name), write, timeout, waited, e);
      } else if (byUs) {
        throw new CrossComClosedException(
            "the client was closed during the " + what(type, name), e, write);
      }
      throw new CrossComConnectionLostException(
          "the connection to "
              + remote
              + " broke during the "
              + what(type, name)
              + ": "
              + reason(e),
          e,
          write);
    }
    if (deadline.end()) {
      close();
      throw timedOut(what(type, name), write, timeout, waited, null);
    }
    if (trace) {
      LOG.trace(
          "received {}", MalformedFrameException.hex(reader.buffer(), answerLength(), LOGGED));
    }
    check(id, type, name, write);
    answered = true;
    return answer;
  }

  /** Returns a phrase for a request. */
  static String what(MessageType type, String name) {
    return switch (type) {
      case READ -> "read of " + name;
      case WRITE -> "write of " + name;
      default -> name;
    };
  }

  /**
   * Sends a request and waits for its answer, which is a message.
   *
   * @param frame the request; its id is not sent
   * @param id the id to send instead
   * @param type its type
   * @param effect its effect on the controller
   * @param what a phrase for the request, for error messages
   * @param waited how much of the time limit is over, in ns
   * @param answerClass the class of a successful answer
   */
  MessageAnswer exchange(
      byte[] frame,
      int id,
      MessageType type,
      Repeatability effect,
      String what,
      long waited,
      Class<? extends TypedResponse> answerClass)
      throws CrossComException {
    long nanos = exchange(frame, frame.length, id, type, effect, what, waited).nanos();
    try {
      Response response =
          Codec.decodeResponse(
              Arrays.copyOf(reader.buffer(), answerLength()), ServerType.C3_BRIDGE);
      if (response instanceof TypedResponse typed
          && (answerClass.isInstance(typed) || !typed.tail().success())) {
        return new MessageAnswer(typed, nanos);
      }
      throw answer
          .frame()
          .malformed("must be a " + answerClass.getSimpleName() + ", is " + response);
    } catch (MalformedFrameException e) {
      throw violated(e, what, effect == Repeatability.CHANGE);
    }
  }

  private int answerLength() {
    return Codec.frameLength(reader.buffer(), 0);
  }

  private void check(int id, MessageType type, String name, boolean write)
      throws CrossComProtocolException {
    AnswerFrame frame = answer.frame();
    try {
      boolean unknown = frame.functionUnknown();
      if (frame.id() != id && !(unknown && frame.id() == 0)) {
        throw frame.malformed("id must be " + id + ", is " + frame.id());
      }
      if (unknown && type == MessageType.FEATURES) {
        return; // an answer too: this message also tells the servers apart
      }
      if (unknown) {
        throw frame.malformed("the server does not know function " + type.code());
      }
      if (frame.function() != type.code()) {
        throw frame.malformed("function must be " + type.code() + ", is " + frame.function());
      }
      if (type == MessageType.READ || type == MessageType.WRITE) {
        frame.openValue();
      }
    } catch (MalformedFrameException e) {
      throw violated(e, what(type, name), write);
    }
  }

  private CrossComProtocolException violated(
      MalformedFrameException e, String what, boolean write) {
    close();
    CrossComProtocolException foreign = foreign(e, write);
    return foreign != null
        ? foreign
        : new CrossComProtocolException(
            "the answer to the " + what + " is invalid: " + e.getMessage(), e, write);
  }

  /** Returns an exception that names the protocol of the server if that is another one. */
  private @Nullable CrossComProtocolException foreign(@Nullable IOException cause, boolean write) {
    String service = answered ? null : ForeignService.of(reader.buffer(), reader.received());
    return service == null
        ? null
        : new CrossComProtocolException(
            remote + " answered with " + service + ", not KUKAVARPROXY or C3 Bridge", cause, write);
  }

  private CrossComTimeoutException timedOut(
      String what, boolean write, long timeout, long waited, @Nullable IOException cause) {
    return new CrossComTimeoutException(
        "no answer to the "
            + what
            + " within "
            + timeout / 1_000_000
            + " ms"
            + (waited > 0
                ? ", of which it waited " + waited / 1_000_000 + " ms for other accesses to end"
                : "")
            + "; the connection is closed",
        cause,
        write);
  }

  /** Closes the socket, because an exchange is overdue. */
  private void expire() {
    LOG.debug("the exchange with {} is overdue, closing", remote);
    close();
  }

  void close() {
    if (!closed) {
      closed = true;
      try {
        channel.shutdownInput(); // ends a read under way even where closing alone is late to do so
      } catch (IOException e) {
        LOG.debug("ending the input failed", e);
      }
      closeQuietly(channel);
      deadline.stop();
      LOG.debug("closed the connection to {}, local port {}", remote, localPort);
    }
  }

  static void closeQuietly(@Nullable SocketChannel channel) {
    try {
      if (channel != null) {
        channel.close();
      }
    } catch (IOException e) {
      LOG.debug("closing the socket failed", e);
    }
  }
}
