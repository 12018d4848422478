package no.hials.crosscom;

import java.io.EOFException;
import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.SocketException;
import java.nio.ByteBuffer;
import java.nio.channels.AsynchronousCloseException;
import java.nio.channels.CancelledKeyException;
import java.nio.channels.ClosedByInterruptException;
import java.nio.channels.SelectionKey;
import java.nio.channels.SocketChannel;
import java.util.Arrays;
import no.hials.crosscom.internal.VariableName;
import no.hials.crosscom.internal.exchange.ExchangeAnswer;
import no.hials.crosscom.internal.exchange.ExchangeDeadline;
import no.hials.crosscom.internal.exchange.ExchangeEvent;
import no.hials.crosscom.internal.exchange.ForeignService;
import no.hials.crosscom.internal.exchange.MessageAnswer;
import no.hials.crosscom.internal.exchange.Repeatability;
import no.hials.crosscom.internal.exchange.SelectorLoop;
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
 * One TCP connection and the exchanges on it. Not thread-safe: the {@link Turn} guards it, except
 * {@link #close}.
 *
 * <p>A thread that waits for an answer reads the channel itself, which is fastest. An asynchronous
 * exchange registers the channel with the {@link SelectorLoop}, where it stays until a thread wants
 * to wait again: so a channel that only one side uses is never handed over.
 *
 * <p>The answer is read without a socket time-out, which would cost two more system calls an
 * exchange; instead the timer closes the socket when an exchange is overdue. A connection that
 * failed stays closed: a late answer on it could be taken for the answer to another request.
 *
 * <p>The class is long because both ways of an exchange share its state and its failures.
 */
final class Connection implements SelectorLoop.Selectable {
  private static final Logger LOG = LoggerFactory.getLogger(Connection.class);

  /** After this time without an exchange, the connection is checked first. */
  private static final long CHECK_AFTER_NANOS = 20_000_000;

  /** A connection that ends unanswered within this time was rejected by the server. */
  private static final long AT_ONCE_NANOS = 1_000_000_000;

  /** The number of bytes of a frame that the log shows. */
  private static final int LOGGED = 256;

  private final SocketChannel channel;
  private final SelectorLoop loop;
  private final FrameReader reader;
  private final ExchangeAnswer answer = new ExchangeAnswer();

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

  /** The key of the channel; null while threads use it. */
  private volatile @Nullable SelectionKey key;

  private final Current current = new Current();

  /** Recorded for each exchange while the flight recorder runs. */
  private final ExchangeEvent event = new ExchangeEvent();

  /** The exchange under way or, between exchanges, the last one. */
  private static final class Current {
    private MessageType type = MessageType.READ;
    private String name = "";
    private boolean write;
    private int id;
    private long waited;
    private long timeout;
    private long start;

    /** Receives the result of an asynchronous exchange; null if a thread waits for the answer. */
    private @Nullable AnswerHandler handler;

    String what() {
      return Connection.what(type, name);
    }
  }

  /** Receives the result of an asynchronous exchange, in the thread of the loop. */
  interface AnswerHandler {
    /** Called with the answer, which is valid until the next exchange. */
    void answered(ExchangeAnswer answer);

    /** Called if there is no valid answer. */
    void failed(CrossComException failure);
  }

  /**
   * Creates the connection of a channel.
   *
   * @param channel is connected
   * @param key the channel's key in the loop; null if threads use the channel
   */
  Connection(SocketChannel channel, ClientRuntime runtime, @Nullable SelectionKey key)
      throws IOException {
    this.channel = channel;
    this.loop = runtime.loop();
    this.key = key;
    this.reader = new FrameReader(channel);
    this.address = (InetSocketAddress) channel.getRemoteAddress();
    // without the slash of InetSocketAddress.toString
    this.remote = address.toString().replaceFirst("^[^/]*/", "");
    this.localPort = channel.socket().getLocalPort();
    this.deadline = new ExchangeDeadline(runtime.timer(), this::expire);
    LOG.debug("connected to {}, local port {}", remote, localPort);
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
      boolean blocks = channel.isBlocking();
      if (blocks) {
        channel.configureBlocking(false);
      }
      if (reader.poll() < 0) {
        throw new EOFException(endOfStream(false));
      }
      if (blocks) {
        channel.configureBlocking(true);
      }
    } catch (IOException e) {
      close();
      CrossComException foreign = foreign(e, false);
      return foreign != null
          ? foreign
          : new CrossComConnectionLostException(
              "the connection to "
                  + remote
                  + " broke "
                  + (answered ? "while it was not used: " : "before the first request: ")
                  + reason(e, false),
              e,
              false);
    }
    if (reader.surplus() > 0) {
      close();
      CrossComException foreign = foreign(null, false);
      return foreign != null
          ? foreign
          : new CrossComProtocolException(
              "the server sent bytes without a request: " + reader.printSurplus(), null, false);
    }
    return null;
  }

  /**
   * Describes the end of the connection.
   *
   * @param exchanging whether an exchange is under way
   */
  private String endOfStream(boolean exchanging) {
    boolean read = current.type == MessageType.READ || current.type == MessageType.READ_UTF16;
    String tooLong =
        exchanging && read && VariableName.isWhole(current.name)
            ? "; C3 Bridge does so if the value is too long for an answer"
            : "";
    return answered
        ? "the server closed it" + tooLong
        : "the server closed it before it answered anything; it may have too many clients"
            + " (KUKAVARPROXY takes 10)"
            + tooLong;
  }

  private String reason(IOException e, boolean exchanging) {
    if (!answered && e instanceof SocketException) {
      // a reset instead of an orderly end
      return e.getMessage() + "; " + endOfStream(exchanging);
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
  ExchangeAnswer exchange(
      byte[] frame,
      int length,
      int id,
      MessageType type,
      Repeatability effect,
      String name,
      long waited)
      throws CrossComException {
    begin(frame, length, id, type, effect, name, waited);
    try {
      if (key != null) {
        takeOver();
      }
      while (out.hasRemaining()) {
        channel.write(out);
      }
      return received(reader.next());
    } catch (IOException e) {
      throw broken(e);
    }
  }

  private void begin(
      byte[] frame,
      int length,
      int id,
      MessageType type,
      Repeatability effect,
      String name,
      long waited) {
    current.type = type;
    current.name = name;
    current.write = effect == Repeatability.CHANGE;
    current.id = id;
    current.waited = waited;
    current.timeout = deadline.limit();
    if (out.capacity() < length) {
      out = ByteBuffer.allocateDirect(length);
    }
    out.clear().put(frame, 0, length).flip();
    Codec.setId(out, id);
    if (LOG.isTraceEnabled()) {
      byte[] sent = Arrays.copyOf(frame, length);
      Codec.setId(sent, id);
      LOG.trace("sending {}", MalformedFrameException.hex(sent, sent.length, LOGGED));
    }
    event.begin();
    current.start = checked != 0 ? checked : System.nanoTime();
    checked = 0;
    if (current.timeout > 0) {
      deadline.begin(current.start + current.timeout - waited);
    }
  }

  private void record(boolean withAnswer) {
    event.end();
    if (event.shouldCommit()) {
      event.set(remote, current.what(), current.waited, out.limit(), withAnswer);
      event.commit();
    }
  }

  /** Ends an exchange whose answer has arrived. */
  private ExchangeAnswer received(int length) throws IOException {
    if (length < 0) {
      throw new EOFException(endOfStream(true));
    }
    long end = System.nanoTime();
    record(true);
    lastEnd = end;
    if (deadline.end()) {
      close();
      throw timedOut(null);
    }
    try {
      answer.set(reader.buffer(), length, end - current.start);
    } catch (MalformedFrameException e) {
      throw violated(e);
    }
    if (LOG.isTraceEnabled()) {
      LOG.trace("received {}", MalformedFrameException.hex(reader.buffer(), length, LOGGED));
    }
    check(current.id, current.type);
    answered = true;
    return answer;
  }

  /** Returns the failure of the exchange under way, whose connection is closed. */
  private CrossComException broken(IOException e) {
    if (e instanceof CrossComException failure) {
      return failure;
    }
    record(false);
    boolean expired = deadline.end();
    if (e instanceof MalformedFrameException malformed) {
      return violated(malformed);
    }
    boolean byUs = closed && !expired && !(e instanceof ClosedByInterruptException);
    close();
    CrossComProtocolException foreign = foreign(e, current.write);
    if (foreign != null) {
      return foreign;
    }
    if (expired) {
      return timedOut(e);
    }
    if (byUs) {
      return new CrossComClosedException(
          "the client was closed during the " + current.what(), e, current.write);
    }
    return new CrossComConnectionLostException(
        "the connection to "
            + remote
            + " broke during the "
            + current.what()
            + ": "
            + reason(e, true),
        e,
        current.write);
  }

  /** Takes the channel from the loop, so that this thread can wait for it. */
  private void takeOver() throws IOException {
    SelectionKey own = key;
    if (own != null) {
      key = null;
      own.cancel();
      channel.configureBlocking(true);
    }
  }

  // --- by the loop

  /**
   * Sends a request; the loop calls the handler later. Called by the loop.
   *
   * @param handler receives the answer
   */
  void exchangeAsync(
      byte[] frame,
      int length,
      int id,
      MessageType type,
      Repeatability effect,
      String name,
      long waited,
      AnswerHandler handler) {
    begin(frame, length, id, type, effect, name, waited);
    try {
      if (key == null) {
        key = loop.register(channel, 0, this);
      }
    } catch (IOException e) {
      handler.failed(broken(e));
      return;
    }
    current.handler = handler;
    ready();
  }

  @Override
  public void ready() {
    AnswerHandler handler = current.handler;
    SelectionKey own = key;
    if (own == null) {
      return; // a thread uses the channel
    }
    try {
      if (handler == null) {
        own.interestOps(0); // bytes that no exchange waits for, or the end of the stream
        return;
      }
      if (out.hasRemaining()) {
        channel.write(out);
        own.interestOps(out.hasRemaining() ? SelectionKey.OP_WRITE : SelectionKey.OP_READ);
        return;
      }
      int length = reader.advance();
      if (length != 0) {
        // still interested in reading: the next exchange then need not say so again
        ExchangeAnswer received = received(length);
        current.handler = null;
        handler.answered(received);
      }
    } catch (IOException e) {
      current.handler = null;
      handler.failed(broken(e));
    } catch (CancelledKeyException e) {
      fail(); // closed by another thread
    }
  }

  /** Fails the exchange under way, because its channel was closed. */
  private void fail() {
    AnswerHandler handler = current.handler;
    if (handler != null) {
      current.handler = null;
      handler.failed(broken(new AsynchronousCloseException()));
    }
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
    return message(exchange(frame, frame.length, id, type, effect, what, waited), answerClass);
  }

  /**
   * Decodes an answer that is a message.
   *
   * @param from the answer to the last exchange
   * @param answerClass the class of a successful answer
   */
  MessageAnswer message(ExchangeAnswer from, Class<? extends TypedResponse> answerClass)
      throws CrossComProtocolException {
    try {
      Response response =
          Codec.decodeResponse(
              Arrays.copyOf(reader.buffer(), answerLength()), ServerType.C3_BRIDGE);
      if (response instanceof TypedResponse typed
          && (answerClass.isInstance(typed) || !typed.tail().success())) {
        return new MessageAnswer(typed, from.nanos());
      }
      throw answer
          .frame()
          .malformed("must be a " + answerClass.getSimpleName() + ", is " + response);
    } catch (MalformedFrameException e) {
      throw violated(e);
    }
  }

  private int answerLength() {
    return Codec.frameLength(reader.buffer(), 0);
  }

  private void check(int id, MessageType type) throws CrossComProtocolException {
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
      throw violated(e);
    }
  }

  private CrossComProtocolException violated(MalformedFrameException e) {
    close();
    CrossComProtocolException foreign = foreign(e, current.write);
    return foreign != null
        ? foreign
        : new CrossComProtocolException(
            "the answer to the " + current.what() + " is invalid: " + e.getMessage(),
            e,
            current.write);
  }

  /** Returns an exception that names the protocol of the server if that is another one. */
  private @Nullable CrossComProtocolException foreign(@Nullable IOException cause, boolean write) {
    String service = answered ? null : ForeignService.of(reader.buffer(), reader.received());
    return service == null
        ? null
        : new CrossComProtocolException(
            remote + " answered with " + service + ", not KUKAVARPROXY or C3 Bridge", cause, write);
  }

  private CrossComTimeoutException timedOut(@Nullable IOException cause) {
    long waited = current.waited;
    return new CrossComTimeoutException(
        "no answer to the "
            + current.what()
            + " within "
            + current.timeout / 1_000_000
            + " ms"
            + (waited > 0
                ? ", of which it waited " + waited / 1_000_000 + " ms for other accesses to end"
                : "")
            + (reader.surplus() > 0 ? ", only the bytes " + reader.printSurplus() : "")
            + "; the connection is closed",
        cause,
        current.write);
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
      if (key != null || channel.isRegistered()) {
        loop.execute(this::fail); // the selector also has to let go of the socket
      }
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
