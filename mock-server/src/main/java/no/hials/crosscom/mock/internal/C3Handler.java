package no.hials.crosscom.mock.internal;

import no.hials.crosscom.lang.TypeSwitch;
import no.hials.crosscom.protocol.ErrorCode;
import no.hials.crosscom.protocol.MalformedRequestException;
import no.hials.crosscom.protocol.MessageType;
import no.hials.crosscom.protocol.Request;
import no.hials.crosscom.protocol.Response;
import no.hials.crosscom.protocol.Tail;
import no.hials.crosscom.protocol.file.FileRequest;
import no.hials.crosscom.protocol.program.ProgramRequest;
import no.hials.crosscom.protocol.program.ProgramRequest.ProgramSelectRequest;
import no.hials.crosscom.protocol.server.ServerRequest;
import no.hials.crosscom.protocol.server.ServerResponse.FeaturesResponse;
import no.hials.crosscom.protocol.server.ServerResponse.InformationResponse;
import no.hials.crosscom.protocol.variable.VariableRequest;

/** Executes requests as a version of C3 Bridge does (docs/reference/c3-messages.md). */
public final class C3Handler implements RequestHandler {
  private static final TypeSwitch<C3Handler, Request, Handled, RuntimeException> REQUESTS =
      TypeSwitch.create(
          Request.class,
          cases ->
              cases
                  .on(VariableRequest.class, (it, request) -> it.variables.handle(request))
                  .on(
                      ProgramRequest.class,
                      (it, request) -> new Handled(it.control.handle(request, it), null))
                  .on(FileRequest.class, C3Handler::answer)
                  .on(ServerRequest.class, C3Handler::answer));

  private final C3ProxyVariables bridge;
  private final C3VariableHandler variables;
  private final C3ProgramHandler control;
  private final C3FileHandler files;

  /** Creates the handler of one connection. */
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
  public void prepare(Request request) {
    if (request instanceof ProgramSelectRequest select) {
      control.load(select.name());
    }
  }

  @Override
  public Handled handle(Request request) {
    return REQUESTS.apply(this, request);
  }

  private Handled answer(FileRequest request) {
    control.watchFiles();
    return new Handled(files.handle(request), null);
  }

  private Handled answer(ServerRequest request) {
    int id = request.id();
    Response response =
        switch (request.type()) {
          case INFORMATION -> new InformationResponse(id, bridge.information(), Tail.SUCCESS);
          case FEATURES -> new FeaturesResponse(id, bridge.features(), Tail.SUCCESS);
          default -> control.confirmAll(request);
        };
    return new Handled(response, null);
  }

  /** Types 0 and 1 have only the codes 0 and 1 (docs/reference/c3-messages.md#error-codes). */
  @Override
  public Response malformed(MalformedRequestException request) {
    MessageType type = request.type();
    return switch (type) {
      case READ, WRITE -> C3Answers.empty(request.id(), type, request.fields(), Tail.FAILURE_ZERO);
      case WRITE_CONTENT, READ_CONTENT -> files.malformed(request);
      default ->
          C3Answers.empty(request.id(), type, request.fields(), C3Answers.tail(ErrorCode.PROTOCOL));
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
    control.ended(this);
    files.close();
  }
}
