package no.hials.crosscom.internal;

import java.util.concurrent.CompletableFuture;
import no.hials.crosscom.CrossComConnectionLostException;
import no.hials.crosscom.CrossComException;
import no.hials.crosscom.CrossComProtocolException;
import no.hials.crosscom.CrossComRefusedException;
import no.hials.crosscom.CrossComTransferException;
import no.hials.crosscom.CrossComUnsupportedException;
import no.hials.crosscom.protocol.MessageType;
import no.hials.crosscom.protocol.Request;
import no.hials.crosscom.protocol.TypedResponse;

/**
 * Sends the messages that only C3 Bridge supports. Thread-safe: exchanges take place one at a time.
 */
public interface MessageChannel {

  /**
   * Sends a request and waits for its answer, for the request time-out at most.
   *
   * <p>If the connection breaks, a request that only reads (types 4, 6, 13, 14, 21 and 26 to 28) is
   * repeated once on a new connection. No other request is repeated, and if it can have changed
   * something, the exception says that its outcome is unknown.
   *
   * @param request the request, whose id does not matter
   * @param answer the class of a successful answer
   * @param what a noun phrase that error messages print after "the", such as {@code selection of
   *     program /R1/MAIN}
   * @return the answer, which is a success
   * @throws CrossComUnsupportedException if the server does not support the message; nothing was
   *     sent
   * @throws CrossComRefusedException if the answer is a failure, with its code
   * @throws CrossComProtocolException if the received bytes are not the answer; the connection is
   *     closed
   * @throws CrossComException if the exchange fails
   */
  <R extends TypedResponse> R ask(Request request, Class<R> answer, String what)
      throws CrossComException;

  /**
   * Creates a channel whose exchanges all use one connection, for state that the server keeps from
   * one message to the next, such as the content that messages 29 and 30 transfer. The first
   * exchange chooses the connection; once it is lost, each further exchange fails with {@link
   * CrossComConnectionLostException} before anything is sent. Nothing is repeated. Exchanges of
   * other threads may take place in between. Not thread-safe.
   */
  MessageChannel onOneConnection();

  /**
   * Throws a {@link CrossComUnsupportedException} if the server does not support a message.
   *
   * @param what as for {@link #ask}
   */
  void require(MessageType type, String what) throws CrossComException;

  /**
   * Runs an operation of many exchanges in the client's thread for transfers, one at a time. The
   * result can be cancelled until the operation takes effect.
   */
  <T> CompletableFuture<T> asyncTransfer(CancellableOperation<T> operation);

  /**
   * Creates the exception for a transfer that failed although the exchanges succeeded.
   *
   * @param what as for {@link #ask}
   * @param file the file on the controller
   * @param bytes the number of bytes transferred
   * @param why the rule that broke, expected and actual
   */
  CrossComTransferException transferFailed(String what, String file, long bytes, String why);
}
