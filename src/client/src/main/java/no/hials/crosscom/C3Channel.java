package no.hials.crosscom;

import java.util.concurrent.CompletableFuture;
import no.hials.crosscom.internal.CancellableOperation;
import no.hials.crosscom.internal.MessageChannel;
import no.hials.crosscom.internal.exchange.MessageAnswer;
import no.hials.crosscom.internal.exchange.Repeatability;
import no.hials.crosscom.internal.exchange.Threads;
import no.hials.crosscom.protocol.Codec;
import no.hials.crosscom.protocol.ErrorCode;
import no.hials.crosscom.protocol.MessageType;
import no.hials.crosscom.protocol.Request;
import no.hials.crosscom.protocol.TypedResponse;
import no.hials.crosscom.protocol.program.ProgramRequest.ProgramSelectRequest;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** Sends the messages that only C3 Bridge supports. */
final class C3Channel implements MessageChannel {
  private static final Logger LOG = LoggerFactory.getLogger(C3Channel.class);

  private final ReconnectingConnection connection;
  private final ServerDetector detector;
  private final Threads threads;

  /** The channel of the client if all exchanges of this one take place on one connection. */
  private final @Nullable C3Channel origin;

  private @Nullable Connection pin;

  C3Channel(
      ReconnectingConnection connection,
      ServerDetector detector,
      Threads threads,
      @Nullable C3Channel origin) {
    this.connection = connection;
    this.detector = detector;
    this.threads = threads;
    this.origin = origin;
  }

  ServerDetector detector() {
    return detector;
  }

  @Override
  public MessageChannel onOneConnection() {
    return new C3Channel(connection, detector, threads, this);
  }

  @Override
  public <T> CompletableFuture<T> asyncTransfer(CancellableOperation<T> operation) {
    return threads.transfer(operation);
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

  /** A question about the server. */
  @FunctionalInterface
  interface Question<T> {
    T to(ServerDetector server) throws CrossComException;
  }

  /** Answers a question about the server, or reads from it as it can. */
  <T> T find(String what, Question<T> question) throws CrossComException {
    return find(what, question, question);
  }

  /**
   * Does the same.
   *
   * @param again asked instead if the connection breaks
   */
  <T> T find(String what, Question<T> question, Question<T> again) throws CrossComException {
    connection.acquire(MessageType.FEATURES, what);
    try {
      begin(what);
      return answer(question, again);
    } finally {
      connection.release();
    }
  }

  @Override
  public <R extends TypedResponse> R ask(Request request, Class<R> answer, String what)
      throws CrossComException {
    TypedResponse response = exchange(request, answer, what).response();
    if (!response.tail().success()) {
      int code = response.tail().code();
      throw new CrossComRefusedException(what, code, hint(request, code));
    }
    return answer.cast(response);
  }

  /** Explains the refusal of version 1.0 (docs/reference/c3-messages.md#program-control-10). */
  private static String hint(Request request, int code) {
    return request instanceof ProgramSelectRequest select
            && select.parameters().isEmpty()
            && code == ErrorCode.PROTOCOL.code()
        ? "; C3 Bridge 1.0 needs parameters that are not empty"
        : "";
  }

  /**
   * Sends a request like {@link #ask}, but also returns the answer of a failure, which may be of
   * another class.
   */
  MessageAnswer exchange(Request request, Class<? extends TypedResponse> answer, String what)
      throws CrossComException {
    byte[] frame = Codec.encode(request);
    MessageType type = request.type();
    Repeatability effect = Repeatability.of(request);
    Question<MessageAnswer> sent =
        server -> {
          server.require(type, what);
          checkPin(what);
          if (origin != null) {
            pin = connection.connection();
          }
          return connection.send(frame, type, effect, what, answer);
        };
    return effect == Repeatability.READ
        ? find(what, sent)
        : change(what, server -> server.require(type, what), sent);
  }

  /**
   * Does something that is not repeated.
   *
   * @param before a question about the server that is answered first, and repeated once if the
   *     connection breaks
   */
  <B, T> T change(String what, Question<B> before, Question<T> change) throws CrossComException {
    connection.acquire(MessageType.FEATURES, what);
    try {
      begin(what);
      answer(before, before);
      return change.to(detector);
    } finally {
      connection.release();
    }
  }

  private void begin(String what) throws CrossComException {
    connection.begin(MessageType.FEATURES, what);
    connection.checkOpen();
    checkPin(what);
    connection.makeUsable();
    checkPin(what);
  }

  /**
   * Asks the server, and repeats the question once if the connection breaks. This thread has the
   * turn.
   */
  private <T> T answer(Question<T> question, Question<T> again) throws CrossComException {
    try {
      return question.to(detector);
    } catch (CrossComConnectionLostException e) {
      if (pin != null || !connection.mayRepeat(Repeatability.READ)) {
        throw e;
      }
      LOG.debug("asking again on a new connection, since: {}", e.getMessage());
      connection.connect();
      return again.to(detector);
    }
  }

  private void checkPin(String what) throws CrossComConnectionLostException {
    Connection chosen = pin;
    if (chosen != null && (chosen != connection.connection() || chosen.isClosed())) {
      throw new CrossComConnectionLostException(
          "the "
              + what
              + " was not sent: its connection was lost, and the server forgot the requests before"
              + " it",
          null,
          false);
    }
  }
}
