package no.hials.crosscom.mock.internal;

import no.hials.crosscom.protocol.MalformedRequestException;
import no.hials.crosscom.protocol.MessageType;
import no.hials.crosscom.protocol.Request;
import no.hials.crosscom.protocol.Response;
import no.hials.crosscom.simulator.RefusedException;
import org.jspecify.annotations.Nullable;

/**
 * Executes the requests of a connection as one of the servers does. Called by one thread at a time,
 * except for {@link #prepare}.
 */
public interface RequestHandler extends AutoCloseable {

  /**
   * The result of a request.
   *
   * @param response the answer; null if the server closes the connection instead
   * @param refused the reason why the controller refused the access, if it did
   */
  record Handled(@Nullable Response response, @Nullable RefusedException refused) {}

  /** Returns whether the server knows a type. */
  boolean knows(MessageType type);

  /**
   * Does the work of a request that takes long and needs no turn, such as loading programs. Called
   * before {@link #handle}, while other connections are served.
   */
  default void prepare(Request request) {}

  /** Executes a request of a type that the server knows. */
  Handled handle(Request request);

  /** Returns the answer to a request of a known type with malformed fields, null for none. */
  @Nullable Response malformed(MalformedRequestException request);

  /** Returns whether the server answers a request itself, without the controller's latency. */
  boolean isForServer(Request request);

  /** Releases the resources of the connection. */
  @Override
  default void close() {}
}
