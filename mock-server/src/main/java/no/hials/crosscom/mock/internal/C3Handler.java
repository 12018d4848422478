package no.hials.crosscom.mock.internal;

import no.hials.crosscom.protocol.ErrorCode;
import no.hials.crosscom.protocol.MalformedRequestException;
import no.hials.crosscom.protocol.MessageType;
import no.hials.crosscom.protocol.Request;
import no.hials.crosscom.protocol.Response;
import no.hials.crosscom.protocol.Tail;
import no.hials.crosscom.protocol.server.FeaturesResponse;
import no.hials.crosscom.protocol.server.InformationResponse;

/** Executes requests as C3 Bridge does, in one of its versions (docs/reference/c3-messages.md). */
public final class C3Handler implements RequestHandler {
  private final C3ProxyVariables bridge;
  private final C3VariableHandler variables;
  private final C3ProgramHandler control;
  private final C3FileHandler files;

  public C3Handler(
      C3ProxyVariables bridge,
      C3VariableHandler variables,
      C3ProgramHandler control,
      C3FileHandler files) {
    this.bridge = bridge;
    this.variables = variables;
    this.control = control;
    this.files = files;
  }

  @Override
  public boolean knows(MessageType type) {
    return bridge.has(type);
  }

  @Override
  public Outcome handle(Request request) {
    int id = request.id();
    return switch (request.type()) {
      case READ, WRITE, READ_UTF16, WRITE_UTF16, READ_MULTIPLE, WRITE_MULTIPLE, BENCHMARK ->
          variables.handle(request);
      case PROGRAM_CONTROL, MOTION, PENDANT_KEY, CONFIRM_ALL ->
          new Outcome(control.handle(request), null);
      case INFORMATION ->
          new Outcome(new InformationResponse(id, bridge.information(), Tail.SUCCESS), null);
      case FEATURES -> new Outcome(new FeaturesResponse(id, bridge.features(), Tail.SUCCESS), null);
      default -> {
        control.watchFiles();
        yield new Outcome(files.handle(request), null);
      }
    };
  }

  /** Types 0 and 1 have no codes but 0 and 1 (docs/reference/c3-messages.md#error-codes). */
  @Override
  public Response malformed(MalformedRequestException request) {
    MessageType type = request.type();
    return switch (type) {
      case READ, WRITE -> C3Answers.empty(request.id(), type, request.fields(), Tail.FAILURE_ZERO);
      case READ_UTF16,
          WRITE_UTF16,
          READ_MULTIPLE,
          WRITE_MULTIPLE,
          PROGRAM_CONTROL,
          MOTION,
          PENDANT_KEY,
          BENCHMARK ->
          C3Answers.empty(request.id(), type, request.fields(), C3Answers.tail(ErrorCode.PROTOCOL));
      default -> files.malformed(request);
    };
  }

  /**
   * C3 Bridge asks the controller for PING first
   * (docs/reference/c3-messages.md#internal-variables).
   */
  @Override
  public boolean isForServer(Request request) {
    return request.type() == MessageType.INFORMATION || request.type() == MessageType.FEATURES;
  }

  @Override
  public void close() {
    files.close();
  }
}
