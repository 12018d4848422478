package no.hials.crosscom.mock.internal;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Supplier;
import no.hials.crosscom.lang.KrlError;
import no.hials.crosscom.lang.Statement.MotionKind;
import no.hials.crosscom.lang.TypeSwitch;
import no.hials.crosscom.protocol.ErrorCode;
import no.hials.crosscom.protocol.PlainResponse;
import no.hials.crosscom.protocol.Response;
import no.hials.crosscom.protocol.Tail;
import no.hials.crosscom.protocol.TypedResponse;
import no.hials.crosscom.protocol.Version;
import no.hials.crosscom.protocol.code.Code;
import no.hials.crosscom.protocol.code.Interpreter;
import no.hials.crosscom.protocol.code.MotionType;
import no.hials.crosscom.protocol.code.PendantKey;
import no.hials.crosscom.protocol.code.ProgramCommand;
import no.hials.crosscom.protocol.code.ProgramState;
import no.hials.crosscom.protocol.program.ProgramRequest;
import no.hials.crosscom.protocol.program.ProgramRequest.MotionRequest;
import no.hials.crosscom.protocol.program.ProgramRequest.PendantKeyRequest;
import no.hials.crosscom.protocol.program.ProgramRequest.ProgramControlRequest;
import no.hials.crosscom.protocol.program.ProgramRequest.ProgramSelectRequest;
import no.hials.crosscom.protocol.program.ProgramResponse;
import no.hials.crosscom.protocol.server.ServerRequest;
import no.hials.crosscom.protocol.value.KrlStruct;
import no.hials.crosscom.protocol.value.KrlSyntaxException;
import no.hials.crosscom.protocol.value.KrlValue;
import no.hials.crosscom.simulator.Controller;
import no.hials.crosscom.simulator.JogCoordinates;
import no.hials.crosscom.simulator.KrlExecutionException;
import no.hials.crosscom.simulator.KrlFileException;
import no.hials.crosscom.simulator.ProgramControl;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Executes the requests of C3 Bridge for programs, motions and keys: types 10 to 12 and 63.
 *
 * <p>Measured are {@code ARGUMENT} for an invalid interpreter or position and {@code
 * NOT_IMPLEMENTED} for an unknown command or key. Assumed are {@code ARGUMENT} for other invalid
 * arguments, {@code ACCESS} if the state of the controller forbids the request, and {@code GENERAL}
 * if a program is missing or has errors or a position is out of reach.
 */
public final class C3ProgramHandler {
  private static final Logger LOG = LoggerFactory.getLogger(C3ProgramHandler.class);

  private static final int AXES = 12;
  private static final TypeSwitch<C3ProgramHandler, ProgramRequest, Response, RuntimeException>
      REQUESTS =
          TypeSwitch.create(
              ProgramRequest.class,
              cases ->
                  cases
                      .on(ProgramControlRequest.class, C3ProgramHandler::answer)
                      .on(ProgramSelectRequest.class, C3ProgramHandler::answer)
                      .on(MotionRequest.class, C3ProgramHandler::answer)
                      .on(PendantKeyRequest.class, C3ProgramHandler::answer));

  /** Version 1.0 refuses empty parameters (docs/reference/c3-messages.md#program-control-10). */
  private static final Version PARAMETERS_OPTIONAL = new Version(1, 1, 0);

  private final Supplier<Controller> controller;
  private final Version version;

  private final Object jogLock = new Object();

  /** The connection whose jog key is pressed; under {@link #jogLock}. */
  private @Nullable Object jogging;

  /** Creates the handler for all connections. */
  public C3ProgramHandler(Supplier<Controller> controller, Version version) {
    this.controller = controller;
    this.version = version;
  }

  /** Creates the controller before the files change, because it watches them. */
  void watchFiles() {
    Controller unused = controller.get();
  }

  /** Loads and compiles a program before the turn of its selection, which reports the errors. */
  void load(String name) {
    try {
      Controller machine = controller.get();
      String program = machine.loadFromFiles(name);
      List<KrlError> errors = machine.check(program);
      if (!errors.isEmpty() && machine.programs().contains(program)) {
        LOG.warn("{} has errors: {}", program, new KrlFileException(errors).getMessage());
      }
    } catch (KrlFileException | IllegalStateException e) {
      LOG.debug("{} cannot be loaded: {}", name, e.getMessage());
    }
  }

  /** An operation that the controller can refuse. */
  private interface Work {
    ErrorCode run() throws KrlFileException, KrlExecutionException;
  }

  /**
   * Executes a request.
   *
   * @param connection the connection that it came on
   */
  Response handle(ProgramRequest request, Object connection) {
    return request instanceof PendantKeyRequest key && isJog(key)
        ? jog(key, connection)
        : REQUESTS.apply(this, request);
  }

  private Response jog(PendantKeyRequest key, Object connection) {
    synchronized (jogLock) {
      Response response = REQUESTS.apply(this, key);
      if (response instanceof TypedResponse answer && answer.tail().success()) {
        jogging = key.released() ? null : connection;
      }
      return response;
    }
  }

  private static boolean isJog(PendantKeyRequest request) {
    return request.key().is(PendantKey.JOG) || request.key().is(PendantKey.MOUSE);
  }

  /** Releases the jog key if a connection that ends has pressed it. */
  void ended(Object connection) {
    synchronized (jogLock) {
      if (jogging == connection) {
        jogging = null;
        try {
          controller.get().releaseJog();
        } catch (IllegalStateException e) {
          LOG.debug("the server was closed while a jog key was pressed");
        }
      }
    }
  }

  private Response answer(ProgramControlRequest request) {
    return answer(request, request.command().number(), () -> control(request));
  }

  private Response answer(ProgramSelectRequest request) {
    return answer(request, request.command().number(), () -> select(request));
  }

  private Response answer(MotionRequest request) {
    return answer(request, request.motion().number(), () -> move(request));
  }

  private Response answer(PendantKeyRequest request) {
    return answer(request, request.key().number(), () -> press(request));
  }

  /** Answers type 63. */
  PlainResponse confirmAll(ServerRequest request) {
    controller.get().confirmAll();
    return new PlainResponse(request.id(), request.type(), Tail.SUCCESS);
  }

  private static Response answer(ProgramRequest request, int repeated, Work work) {
    ErrorCode code;
    String why = "";
    try {
      code = work.run();
    } catch (IllegalStateException e) {
      code = ErrorCode.ACCESS;
      why = e.getMessage();
    } catch (IllegalArgumentException e) {
      code = ErrorCode.ARGUMENT;
      why = e.getMessage();
    } catch (KrlFileException e) {
      code = ErrorCode.GENERAL;
      why = e.getMessage();
    } catch (KrlExecutionException e) {
      code =
          e.number() == KrlExecutionException.WRONG_TYPE ? ErrorCode.ARGUMENT : ErrorCode.GENERAL;
      why = e.getMessage();
    }
    if (code != ErrorCode.SUCCESS) {
      LOG.debug("{} refused: {} {}", request, code, why);
    }
    return new ProgramResponse(request.id(), request.type(), repeated, C3Answers.tail(code));
  }

  // type 10

  private ProgramControl interpreter(Code<Interpreter> number) {
    return number
        .known()
        .map(
            known ->
                known == Interpreter.ROBOT ? controller.get().robot() : controller.get().submit())
        .orElseThrow(
            () -> new IllegalArgumentException("the interpreter must be 0 or 1, is " + number));
  }

  private ErrorCode control(ProgramControlRequest request) {
    ProgramCommand command = request.command().known().orElse(null);
    if (command == null) {
      return ErrorCode.NOT_IMPLEMENTED;
    }
    ProgramControl program = interpreter(request.interpreter());
    switch (command) {
      case RESET -> program.reset();
      case START -> program.start();
      case STOP -> program.stop();
      case CANCEL -> program.cancel();
      default -> throw new IllegalArgumentException("unknown command: " + command);
    }
    return ErrorCode.SUCCESS;
  }

  /** Assumed: selects in the robot interpreter; force stops an active program first. */
  private ErrorCode select(ProgramSelectRequest request) throws KrlFileException {
    if (request.parameters().isEmpty() && version.compareTo(PARAMETERS_OPTIONAL) < 0) {
      return ErrorCode.PROTOCOL;
    }
    if (request.name().isBlank()) {
      throw new IllegalArgumentException("the name of a program must not be blank");
    }
    List<KrlValue> parameters = parameters(request.parameters());
    ProgramControl robot = controller.get().robot();
    if (request.force() && robot.state() == ProgramState.ACTIVE) {
      robot.stop();
    }
    robot.select(controller.get().loadFromFiles(request.name()), parameters);
    if (request.command().is(ProgramCommand.RUN)) {
      robot.start();
    }
    return ErrorCode.SUCCESS;
  }

  /** Parses values that are separated by commas (assumed). */
  private static List<KrlValue> parameters(String text) {
    List<KrlValue> values = new ArrayList<>();
    if (text.isBlank()) {
      return values;
    }
    int depth = 0;
    boolean quoted = false;
    int start = 0;
    for (int i = 0; i < text.length(); i++) {
      char c = text.charAt(i);
      quoted ^= c == '"';
      if (!quoted && c == '{') {
        depth++;
      } else if (!quoted && c == '}') {
        depth--;
      } else if (!quoted && c == ',' && depth == 0) {
        values.add(value(text.substring(start, i)));
        start = i + 1;
      }
    }
    values.add(value(text.substring(start)));
    return values;
  }

  private static KrlValue value(String text) {
    try {
      return KrlValue.parse(text.strip());
    } catch (KrlSyntaxException e) {
      throw new IllegalArgumentException(e.getMessage(), e);
    }
  }

  // type 11

  private ErrorCode move(MotionRequest request) throws KrlExecutionException {
    MotionType type = request.motion().known().orElse(null);
    if (type == null) {
      return ErrorCode.NOT_IMPLEMENTED;
    }
    if (!(value(request.position()) instanceof KrlStruct position)) {
      throw new IllegalArgumentException(
          "the position must be a structure, is '" + request.position() + "'");
    }
    controller.get().move(MotionKind.valueOf(type.name()), position);
    return ErrorCode.SUCCESS;
  }

  // type 12

  /**
   * Assumed: as on the pendant, the start key must be held in T1 and T2, and the robot can be
   * jogged only in these, with {@code $OV_JOG}. The numbers 1 to 6 stand for A1 to A6, or for X, Y,
   * Z, A, B and C in the coordinates selected on the pendant; those of the 6D mouse never for axes,
   * but for {@code $BASE} instead. The numbers from 7 on stand for E1 and the following. When the
   * connection that pressed a jog key ends, the key is released.
   */
  private ErrorCode press(PendantKeyRequest request) throws KrlExecutionException {
    PendantKey key = request.key().known().orElse(null);
    if (key == null) {
      return ErrorCode.NOT_IMPLEMENTED;
    }
    return switch (key) {
      case START -> startKey(request);
      case STOP -> stopKey(request);
      case JOG -> jog(request, controller.get().jogCoordinates());
      // only the release itself reaches the controller, not the number of the axis
      // (docs/reference/c3-messages.md#pendant-keys-12)
      case MOUSE -> request.released() ? releaseJog() : jog(request, mouseCoordinates());
    };
  }

  private ErrorCode startKey(PendantKeyRequest request) {
    Code<Interpreter> number = new Code<>(Interpreter.class, request.number());
    ProgramControl program = interpreter(number);
    // 0 is forward (docs/reference/c3-messages.md#pendant-keys-12)
    if (request.direction() && !request.released()) {
      return ErrorCode.NOT_IMPLEMENTED;
    }
    if (!request.released()) {
      program.start();
    } else if (number.is(Interpreter.ROBOT) && controller.get().mode().manual()) {
      program.stop();
    }
    return ErrorCode.SUCCESS;
  }

  private ErrorCode stopKey(PendantKeyRequest request) {
    ProgramControl program = interpreter(new Code<>(Interpreter.class, request.number()));
    if (!request.released()) {
      program.stop();
    }
    return ErrorCode.SUCCESS;
  }

  private JogCoordinates mouseCoordinates() {
    JogCoordinates selected = controller.get().jogCoordinates();
    return selected == JogCoordinates.AXIS ? JogCoordinates.BASE : selected;
  }

  private ErrorCode jog(PendantKeyRequest request, JogCoordinates coordinates)
      throws KrlExecutionException {
    requireAxis(request);
    if (request.released()) {
      return releaseJog();
    }
    controller.get().jog(coordinates, request.number(), request.direction());
    return ErrorCode.SUCCESS;
  }

  private ErrorCode releaseJog() {
    controller.get().releaseJog();
    return ErrorCode.SUCCESS;
  }

  private static void requireAxis(PendantKeyRequest request) {
    if (request.number() < 1 || request.number() > AXES) {
      throw new IllegalArgumentException(
          "the axis must be 1 to " + AXES + ", is " + request.number());
    }
  }
}
