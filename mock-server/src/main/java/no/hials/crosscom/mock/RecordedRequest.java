package no.hials.crosscom.mock;

import java.time.Instant;
import no.hials.crosscom.protocol.ReadArrayRequest;
import no.hials.crosscom.protocol.ReadRequest;
import no.hials.crosscom.protocol.Request;
import no.hials.crosscom.protocol.WriteArrayRequest;
import no.hials.crosscom.protocol.WriteRequest;
import org.jspecify.annotations.Nullable;

/**
 * A request that a server has received.
 *
 * @param number from 1, in the order in which the server served all its clients' requests
 * @param connection the connection it came by, from 1, in the order in which they were accepted
 * @param time when it was taken for serving
 * @param request the message; null if the bytes are none, or of a function that the server has not
 * @param hex the bytes in hex if there is no message, else null; beyond 256 bytes the rest is only
 *     counted
 * @param refusal why the controller refused the access; null if it did not, if the request never
 *     reached it, and in what a predicate for faults sees, which is asked before
 */
public record RecordedRequest(
    long number,
    int connection,
    Instant time,
    @Nullable Request request,
    @Nullable String hex,
    @Nullable Refusal refusal) {

  /**
   * Gives the name of the variable.
   *
   * @return the name as the client sent it, empty if the bytes are no message
   */
  public String name() {
    if (request instanceof ReadRequest read) {
      return read.name();
    }
    if (request instanceof WriteRequest write) {
      return write.name();
    }
    if (request instanceof ReadArrayRequest read) {
      return read.name();
    }
    if (request instanceof WriteArrayRequest write) {
      return write.name();
    }
    return "";
  }

  /**
   * Gives the text to be written.
   *
   * @return the text as the client sent it, or null if this is not a write of text
   */
  public @Nullable String value() {
    return request instanceof WriteRequest write ? write.value() : null;
  }

  /**
   * Says whether the request asks for a change of the controller.
   *
   * @return true for the writes of texts and of arrays
   */
  public boolean isWrite() {
    return request instanceof WriteRequest || request instanceof WriteArrayRequest;
  }

  RecordedRequest refusedFor(Refusal reason) {
    return new RecordedRequest(number, connection, time, request, hex, reason);
  }
}
