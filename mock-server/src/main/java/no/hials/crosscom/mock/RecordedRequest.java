package no.hials.crosscom.mock;

import java.time.Instant;
import java.util.List;
import no.hials.crosscom.mock.internal.SealedSwitch;
import no.hials.crosscom.protocol.Request;
import no.hials.crosscom.protocol.variable.Assignment;
import no.hials.crosscom.protocol.variable.BenchmarkReadRequest;
import no.hials.crosscom.protocol.variable.BenchmarkWriteRequest;
import no.hials.crosscom.protocol.variable.ReadArrayRequest;
import no.hials.crosscom.protocol.variable.ReadMultipleRequest;
import no.hials.crosscom.protocol.variable.ReadRequest;
import no.hials.crosscom.protocol.variable.ReadUtf16Request;
import no.hials.crosscom.protocol.variable.VariableRequest;
import no.hials.crosscom.protocol.variable.WriteArrayRequest;
import no.hials.crosscom.protocol.variable.WriteMultipleRequest;
import no.hials.crosscom.protocol.variable.WriteRequest;
import no.hials.crosscom.protocol.variable.WriteUtf16Request;
import no.hials.crosscom.simulator.Refusal;
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

  private static final SealedSwitch<VariableRequest, List<String>> NAMES =
      SealedSwitch.<VariableRequest, List<String>>over(VariableRequest.class)
          .on(ReadRequest.class, read -> List.of(read.name()))
          .on(WriteRequest.class, write -> List.of(write.name()))
          .on(ReadArrayRequest.class, read -> List.of(read.name()))
          .on(WriteArrayRequest.class, write -> List.of(write.name()))
          .on(ReadUtf16Request.class, read -> List.of(read.name()))
          .on(WriteUtf16Request.class, write -> List.of(write.name()))
          .on(ReadMultipleRequest.class, ReadMultipleRequest::names)
          .on(WriteMultipleRequest.class, write -> names(write.assignments()))
          .on(BenchmarkReadRequest.class, BenchmarkReadRequest::names)
          .on(BenchmarkWriteRequest.class, write -> names(write.assignments()))
          .complete();

  /**
   * Gives the name of the variable.
   *
   * @return the name as the client sent it; empty if the request is for several, or for none
   */
  public String name() {
    List<String> names = names();
    return names.size() == 1 ? names.get(0) : "";
  }

  /**
   * Gives the names of the variables that are read or written.
   *
   * @return the names as the client sent them; none if the request is for something else, or the
   *     bytes are no message
   */
  public List<String> names() {
    return request instanceof VariableRequest access ? NAMES.apply(access) : List.of();
  }

  private static List<String> names(List<Assignment> assignments) {
    return assignments.stream().map(Assignment::name).toList();
  }

  /**
   * Gives the text to be written.
   *
   * @return the text as the client sent it, or null if this is not a write of one text
   */
  public @Nullable String value() {
    if (request instanceof WriteUtf16Request write) {
      return write.value();
    }
    return request instanceof WriteRequest write ? write.value() : null;
  }

  /**
   * Says whether the request asks for a change of variables.
   *
   * @return true for the writes of texts and of arrays, and of several variables
   */
  public boolean isWrite() {
    return request instanceof WriteRequest
        || request instanceof WriteArrayRequest
        || request instanceof WriteUtf16Request
        || request instanceof WriteMultipleRequest
        || request instanceof BenchmarkWriteRequest;
  }
}
