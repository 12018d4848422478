package no.hials.crosscom;

import java.util.concurrent.Callable;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.Executor;
import java.util.concurrent.ThreadPoolExecutor;
import java.util.concurrent.locks.ReentrantLock;
import no.hials.crosscom.internal.CancellableOperation;
import no.hials.crosscom.internal.MessageChannel;
import no.hials.crosscom.protocol.Codec;
import no.hials.crosscom.protocol.MessageType;
import no.hials.crosscom.protocol.Request;
import no.hials.crosscom.protocol.TypedResponse;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** The way of the messages that only C3 Bridge knows. */
final class C3Channel implements MessageChannel {
  private static final Logger LOG = LoggerFactory.getLogger(C3Channel.class);

  private final ReconnectingConnection link;
  private final ServerDetector detection;
  private final ReentrantLock lock;
  private final ThreadPoolExecutor async;
  private final ThreadPoolExecutor transfers;
  private final Executor callbacks;

  /** Whether all exchanges take place on one connection. */
  private final boolean pinned;

  private @Nullable Connection pin;

  C3Channel(
      ReconnectingConnection link,
      ThreadPoolExecutor async,
      ThreadPoolExecutor transfers,
      Executor callbacks) {
    this(link, new ServerDetector(link), async, transfers, callbacks, false);
  }

  private C3Channel(
      ReconnectingConnection link,
      ServerDetector detection,
      ThreadPoolExecutor async,
      ThreadPoolExecutor transfers,
      Executor callbacks,
      boolean pinned) {
    this.link = link;
    this.detection = detection;
    this.lock = link.lock();
    this.async = async;
    this.transfers = transfers;
    this.callbacks = callbacks;
    this.pinned = pinned;
  }

  @Override
  public MessageChannel onOneConnection() {
    return new C3Channel(link, detection, async, transfers, callbacks, true);
  }

  @Override
  public <T extends @Nullable Object> CompletableFuture<T> async(Callable<T> operation) {
    return AsyncCall.submit(async, callbacks, link, operation);
  }

  @Override
  public <T> CompletableFuture<T> asyncTransfer(CancellableOperation<T> operation) {
    return TransferCall.submit(transfers, callbacks, operation);
  }

  @Override
  public CrossComTransferException transferFailed(
      String what, String file, long bytes, String why) {
    return new CrossComTransferException(what, file, bytes, why);
  }

  @Override
  public void require(MessageType type, String what) throws CrossComException {
    find(what, server -> server.require(type, what));
  }

  /** What is asked about the server. */
  @FunctionalInterface
  interface Question<T> {
    T to(ServerDetector server) throws CrossComException;
  }

  /** Finds out something about the server. */
  <T> T find(String what, Question<T> question) throws CrossComException {
    lock.lock();
    try {
      begin(what);
      return answer(question);
    } finally {
      lock.unlock();
    }
  }

  @Override
  public <R extends TypedResponse> R ask(Request request, Class<R> answer, String what)
      throws CrossComException {
    TypedResponse response = exchange(request, answer, what).response();
    if (!response.tail().success()) {
      throw new CrossComRefusedException(what, response.tail().code());
    }
    return answer.cast(response);
  }

  /**
   * Does what {@link #ask} does, but gives an answer that says failure too, which may be of another
   * class.
   */
  MessageAnswer exchange(Request request, Class<? extends TypedResponse> answer, String what)
      throws CrossComException {
    byte[] frame = Codec.encode(request);
    MessageType type = request.type();
    Repeatability effect = Repeatability.of(request);
    lock.lock();
    try {
      begin(what);
      Question<MessageAnswer> sent =
          server -> {
            server.require(type, what);
            checkPin(what);
            if (pinned) {
              pin = link.connection();
            }
            return link.send(frame, type, effect, what, answer);
          };
      if (effect == Repeatability.READ) {
        return answer(sent);
      }
      answer(server -> server.require(type, what)); // may be repeated, but what follows may not
      return sent.to(detection);
    } finally {
      lock.unlock();
    }
  }

  private void begin(String what) throws CrossComException {
    link.begin(what);
    link.checkOpen();
    checkPin(what);
    link.makeUsable();
    checkPin(what);
  }

  /** Asks, and asks once again if the connection breaks meanwhile. The lock is held. */
  private <T> T answer(Question<T> question) throws CrossComException {
    try {
      return question.to(detection);
    } catch (CrossComConnectionLostException e) {
      if (pin != null || !link.mayRepeat(Repeatability.READ)) {
        throw e;
      }
      LOG.debug("asking again on a new connection, since: {}", e.getMessage());
      link.connect();
      return question.to(detection);
    }
  }

  private void checkPin(String what) throws CrossComConnectionLostException {
    Connection chosen = pin;
    if (chosen != null && (chosen != link.connection() || chosen.isClosed())) {
      throw new CrossComConnectionLostException(
          "the "
              + what
              + " was not sent: the connection that it belongs to was lost, and the server forgot"
              + " what came before",
          null,
          false);
    }
  }
}
