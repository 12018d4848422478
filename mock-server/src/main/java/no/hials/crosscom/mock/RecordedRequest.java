package no.hials.crosscom.mock;

import java.time.Instant;
import java.util.List;
import no.hials.crosscom.lang.TypeSwitch;
import no.hials.crosscom.protocol.Request;
import no.hials.crosscom.protocol.variable.Assignment;
import no.hials.crosscom.protocol.variable.VariableRequest;
import no.hials.crosscom.protocol.variable.VariableRequest.BenchmarkReadRequest;
import no.hials.crosscom.protocol.variable.VariableRequest.BenchmarkWriteRequest;
import no.hials.crosscom.protocol.variable.VariableRequest.ReadArrayRequest;
import no.hials.crosscom.protocol.variable.VariableRequest.ReadMultipleRequest;
import no.hials.crosscom.protocol.variable.VariableRequest.ReadRequest;
import no.hials.crosscom.protocol.variable.VariableRequest.ReadUtf16Request;
import no.hials.crosscom.protocol.variable.VariableRequest.WriteArrayRequest;
import no.hials.crosscom.protocol.variable.VariableRequest.WriteMultipleRequest;
import no.hials.crosscom.protocol.variable.VariableRequest.WriteRequest;
import no.hials.crosscom.protocol.variable.VariableRequest.WriteUtf16Request;
import no.hials.crosscom.simulator.Refusal;
import org.jspecify.annotations.Nullable;

/**
 * A request that a server has received.
 *
 * @param number from 1, in the order in which the server served the requests of all clients
 * @param connection the number of the connection, from 1, in the order in which they were accepted
 * @param time the time when the server started to serve the request
 * @param request the message; null if the bytes are not a message or its function is not supported
 * @param hex the bytes in hex if there is no message, otherwise null; of more than 64 bytes the
 *     rest is only counted
 * @param refusal the reason why the controller refused the access; null without a refusal, if the
 *     request did not reach the controller, and while a fault is chosen, which happens earlier
 */
public record RecordedRequest(
    long number,
    int connection,
    Instant time,
    @Nullable Request request,
    @Nullable String hex,
    @Nullable Refusal refusal) {

  private static final TypeSwitch<RecordedRequest, VariableRequest, Accessed, RuntimeException>
      ACCESSED =
          TypeSwitch.create(
              VariableRequest.class,
              cases ->
                  cases
                      .on(ReadRequest.class, (it, read) -> read(List.of(read.name())))
                      .on(WriteRequest.class, (it, write) -> written(List.of(write.name())))
                      .on(ReadArrayRequest.class, (it, read) -> read(List.of(read.name())))
                      .on(WriteArrayRequest.class, (it, write) -> written(List.of(write.name())))
                      .on(ReadUtf16Request.class, (it, read) -> read(List.of(read.name())))
                      .on(WriteUtf16Request.class, (it, write) -> written(List.of(write.name())))
                      .on(ReadMultipleRequest.class, (it, read) -> read(read.names()))
                      .on(
                          WriteMultipleRequest.class,
                          (it, write) -> written(names(write.assignments())))
                      .on(BenchmarkReadRequest.class, (it, read) -> read(read.names()))
                      .on(
                          BenchmarkWriteRequest.class,
                          (it, write) -> written(names(write.assignments()))));

  /** The variables that a request accesses. */
  private record Accessed(List<String> names, boolean isWritten) {}

  private static Accessed read(List<String> names) {
    return new Accessed(names, false);
  }

  private static Accessed written(List<String> names) {
    return new Accessed(names, true);
  }

  private Accessed accessed() {
    return request instanceof VariableRequest access
        ? ACCESSED.apply(this, access)
        : read(List.of());
  }

  /**
   * Returns the name of the variable as the client sent it, empty if the request is not for exactly
   * one.
   */
  public String name() {
    List<String> names = names();
    return names.size() == 1 ? names.get(0) : "";
  }

  /**
   * Returns the names of the variables to read or write as the client sent them, empty if there are
   * none.
   */
  public List<String> names() {
    return accessed().names();
  }

  private static List<String> names(List<Assignment> assignments) {
    return assignments.stream().map(Assignment::name).toList();
  }

  /** Returns the text to write as the client sent it, null if this is not a write of one text. */
  public @Nullable String value() {
    if (request instanceof WriteUtf16Request write) {
      return write.value();
    }
    return request instanceof WriteRequest write ? write.value() : null;
  }

  /** Returns whether the request writes variables: a text, an array or several. */
  public boolean isWrite() {
    return accessed().isWritten();
  }
}
