package no.hials.crosscom.mock.internal;

import no.hials.crosscom.protocol.MalformedRequestException;
import no.hials.crosscom.protocol.MessageType;
import no.hials.crosscom.protocol.Request;
import no.hials.crosscom.protocol.Response;
import no.hials.crosscom.simulator.RefusedException;
import org.jspecify.annotations.Nullable;

/**
 * Executes the requests of a connection as one of the servers does. Called by one thread at a time.
 */
public interface RequestHandler extends AutoCloseable {

  /**
   * What came of a request.
   *
   * @param response the answer; null if the server closes the connection instead
   * @param refused why the controller refused the access, if it did
   */
  record Outcome(@Nullable Response response, @Nullable RefusedException refused) {}

  /** Says whether the server knows a type, so that a request of it can be executed at all. */
  boolean knows(MessageType type);

  /** Executes a request of a type that the server knows. */
  Outcome handle(Request request);

  /** Answers a request of a type that the server knows whose fields are malformed, or does not. */
  @Nullable Response malformed(MalformedRequestException request);

  /** Says whether the server answers a request without asking the controller, so in no time. */
  boolean isForServer(Request request);

  /** Ends the connection. */
  @Override
  default void close() {}
}
