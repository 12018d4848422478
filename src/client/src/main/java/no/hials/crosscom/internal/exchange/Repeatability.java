package no.hials.crosscom.internal.exchange;

import no.hials.crosscom.protocol.Request;
import no.hials.crosscom.protocol.file.FileRequest.EndWriteRequest;
import no.hials.crosscom.protocol.variable.VariableRequest.BenchmarkReadRequest;

/** Whether a request can be repeated after the connection was lost. */
public enum Repeatability {
  /** It only reads: it can be repeated. */
  READ,
  /**
   * It changes nothing on the controller, but it depends on state of the connection or takes long:
   * it is not repeated.
   */
  NONE,
  /** It can change something: it is never repeated, and its outcome can be unknown. */
  CHANGE;

  public static Repeatability of(Request request) {
    return switch (request.type()) {
      case READ,
          READ_UTF16,
          READ_MULTIPLE,
          INFORMATION,
          FEATURES,
          LIST_DIRECTORY,
          FILE_PROPERTIES,
          FULL_NAME,
          KRC_NAME ->
          READ;
      case READ_CONTENT -> NONE;
      // before its end, a transfer only fills a buffer of the server
      // (docs/reference/c3-messages.md#file-content-29-and-30)
      case WRITE_CONTENT -> request instanceof EndWriteRequest ? CHANGE : NONE;
      case BENCHMARK -> request instanceof BenchmarkReadRequest ? NONE : CHANGE;
      default -> CHANGE;
    };
  }
}
