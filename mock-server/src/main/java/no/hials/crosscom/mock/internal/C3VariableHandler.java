package no.hials.crosscom.mock.internal;

import java.util.ArrayList;
import java.util.List;
import no.hials.crosscom.lang.Access;
import no.hials.crosscom.lang.TypeSwitch;
import no.hials.crosscom.mock.MockServerConfig;
import no.hials.crosscom.mock.internal.RequestHandler.Handled;
import no.hials.crosscom.protocol.ErrorCode;
import no.hials.crosscom.protocol.Request;
import no.hials.crosscom.protocol.Response;
import no.hials.crosscom.protocol.Tail;
import no.hials.crosscom.protocol.TextResponse;
import no.hials.crosscom.protocol.code.Code;
import no.hials.crosscom.protocol.variable.AccessResult;
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
import no.hials.crosscom.protocol.variable.VariableResponse.BenchmarkResponse;
import no.hials.crosscom.protocol.variable.VariableResponse.MultipleResponse;
import no.hials.crosscom.protocol.variable.VariableResponse.ValueResponse;
import no.hials.crosscom.simulator.Refusal;
import no.hials.crosscom.simulator.RefusedException;
import no.hials.crosscom.simulator.VariableTable;
import org.jspecify.annotations.Nullable;

/** Executes the requests of C3 Bridge for variables: types 0, 1, 4 to 7 and 17. */
public final class C3VariableHandler {
  private static final long U32 = 0xFFFF_FFFFL;

  /**
   * The maximum number of variables of a benchmark (docs/reference/c3-messages.md#benchmark-17).
   */
  private static final int BENCHMARKED = 10;

  /** The maximum number of iterations in an answer (docs/reference/c3-messages.md#benchmark-17). */
  private static final long MAX_ITERATIONS = 0xFFFF_FFFEL;

  private static final int NANOS_PER_MILLI = 1_000_000;

  private static final TypeSwitch<C3VariableHandler, VariableRequest, Handled, RuntimeException>
      REQUESTS =
          TypeSwitch.create(
              VariableRequest.class,
              cases ->
                  cases
                      .on(ReadRequest.class, C3VariableHandler::read)
                      .on(WriteRequest.class, C3VariableHandler::write)
                      .on(ReadArrayRequest.class, C3VariableHandler::unknown)
                      .on(WriteArrayRequest.class, C3VariableHandler::unknown)
                      .on(ReadUtf16Request.class, C3VariableHandler::read)
                      .on(WriteUtf16Request.class, C3VariableHandler::write)
                      .on(ReadMultipleRequest.class, C3VariableHandler::read)
                      .on(WriteMultipleRequest.class, C3VariableHandler::write)
                      .on(BenchmarkReadRequest.class, C3VariableHandler::benchmark)
                      .on(BenchmarkWriteRequest.class, C3VariableHandler::benchmark));

  private final VariableTable variables;
  private final C3ProxyVariables internal;
  private final MockServerConfig config;
  private final CodePage codePage;

  /** Creates the handler for all connections. */
  public C3VariableHandler(
      VariableTable variables, C3ProxyVariables internal, MockServerConfig config) {
    this.variables = variables;
    this.internal = internal;
    this.config = config;
    this.codePage = CodePage.of(config.codePage());
  }

  /**
   * The result of one access.
   *
   * @param value the value that was read or is echoed
   * @param code the error code
   * @param refused the reason of a refusal
   */
  private record Result(String value, ErrorCode code, @Nullable RefusedException refused) {
    Result(String value) {
      this(value, ErrorCode.SUCCESS, null);
    }
  }

  /**
   * Messages 2 and 3 are KUKAVARPROXY's. The dispatcher passes only requests of types that {@link
   * C3Handler#knows} accepts.
   */
  private Handled unknown(Request request) {
    throw new IllegalArgumentException("not a request for C3 Bridge: " + request);
  }

  Handled handle(VariableRequest request) {
    return REQUESTS.apply(this, request);
  }

  // one access

  private Result read(String name) {
    try {
      String text = variables.read(name);
      return new Result(config.trimValues() ? text.strip() : text);
    } catch (RefusedException e) {
      // the controller is asked first (docs/reference/c3-messages.md#internal-variables)
      String own = config.ping() ? internal.find(name) : internal.findProxy(name);
      return own == null ? new Result("", code(name), e) : new Result(own);
    }
  }

  /** Returns the text that was sent, even if it was refused. */
  private Result write(String name, String value) {
    try {
      variables.write(name, value, config.maxAggregateLength());
      return new Result(value);
    } catch (RefusedException e) {
      return new Result(value, isReadOnly(name) ? ErrorCode.ACCESS : code(name), e);
    }
  }

  /** Measured for an empty name (docs/reference/c3-messages.md#error-codes), else assumed. */
  private static ErrorCode code(String name) {
    return name.isEmpty() ? ErrorCode.ARGUMENT : ErrorCode.GENERAL;
  }

  /** Decides the code for any value (docs/reference/c3-messages.md#error-codes). */
  private boolean isReadOnly(String name) {
    String variable = name.strip().split("[.\\[]", 2)[0];
    return variables
        .describe(variable)
        .filter(declared -> declared.access() == Access.READ_ONLY)
        .isPresent();
  }

  // types 0, 1, 4 and 5

  private Handled read(ReadRequest request) {
    Result result = read(codePage.decode(request.name()));
    String value = codePage.encode(result.value());
    if (value.length() > KukavarproxyHandler.MAX_VALUE) {
      return tooLong();
    }
    Tail tail = result.refused() == null ? Tail.SUCCESS : config.failedRead().tail();
    return new Handled(
        new ValueResponse(request.id(), request.type(), value, tail), result.refused());
  }

  private static Handled tooLong() {
    return new Handled(
        null, new RefusedException(Refusal.TOO_LONG, "the value must fit into the answer"));
  }

  private Handled write(WriteRequest request) {
    Result result = write(codePage.decode(request.name()), codePage.decode(request.value()));
    boolean done = result.refused() == null;
    return new Handled(
        new ValueResponse(
            request.id(),
            request.type(),
            done ? codePage.encode(result.value()) : "",
            done ? Tail.SUCCESS : config.failedWriteTail()),
        result.refused());
  }

  private Handled read(ReadUtf16Request request) {
    Result result = read(request.name());
    if (2 + 2L * result.value().length() > C3Answers.FIELDS) {
      return tooLong();
    }
    return text(request, result.value(), result.code(), result.refused());
  }

  private Handled write(WriteUtf16Request request) {
    Result result = write(request.name(), request.value());
    // the value that was sent, not the value that the controller stored
    // (docs/reference/c3-messages.md#one-variable-0-1-4-and-5)
    String value = result.refused() == null ? result.value() : "";
    return text(request, value, result.code(), result.refused());
  }

  private static Handled text(
      Request request, String value, ErrorCode code, @Nullable RefusedException refused) {
    return new Handled(
        new TextResponse(request.id(), request.type(), value, C3Answers.tail(code)), refused);
  }

  // types 6 and 7

  private Handled read(ReadMultipleRequest request) {
    if (!internal.supportsCorrectly(request.type())) {
      // see MockServerConfig.version
      return empty(request, ErrorCode.NOT_IMPLEMENTED, null);
    }
    Batch batch = new Batch();
    for (String name : request.names()) {
      batch.add(read(name));
    }
    return batch.answer(request);
  }

  private Handled write(WriteMultipleRequest request) {
    if (!internal.supportsCorrectly(request.type())) {
      // see MockServerConfig.version
      return empty(request, ErrorCode.NOT_IMPLEMENTED, null);
    }
    Batch batch = new Batch();
    for (Assignment item : request.assignments()) {
      Result written = write(item.name(), item.value());
      batch.add(written.refused() == null ? readBack(item) : written);
    }
    if (request.assignments().size() < request.count()) {
      // the items of a truncated batch are written, then the answer has code 9
      // (docs/reference/c3-messages.md#several-variables-6-and-7)
      return empty(request, ErrorCode.PROTOCOL, batch.refused);
    }
    return batch.answer(request);
  }

  /**
   * Returns the value that was stored, empty if it cannot be read
   * (docs/reference/c3-messages.md#several-variables-6-and-7).
   */
  private Result readBack(Assignment item) {
    return new Result(read(item.name()).value());
  }

  private static Handled empty(
      Request request, ErrorCode code, @Nullable RefusedException refused) {
    Tail tail = C3Answers.tail(code);
    return new Handled(C3Answers.empty(request.id(), request.type(), new byte[0], tail), refused);
  }

  /** The results of several accesses. */
  private static final class Batch {
    private final List<AccessResult> results = new ArrayList<>();
    private long length = 1;
    private @Nullable RefusedException refused;

    void add(Result result) {
      results.add(new AccessResult(Code.of(result.code()), result.value()));
      length += 1 + 2 + 2L * result.value().length();
      if (refused == null) {
        refused = result.refused();
      }
    }

    Handled answer(Request request) {
      if (length > C3Answers.FIELDS) {
        // the items of type 7 are written (docs/reference/c3-messages.md#several-variables-6-and-7)
        return empty(request, ErrorCode.LONG_ANSWER, tooLong().refused());
      }
      // code 0 and flag false if some failed; assumed: also if all failed
      // (docs/reference/c3-messages.md#several-variables-6-and-7)
      Tail tail = refused == null ? Tail.SUCCESS : Tail.FAILURE_ZERO;
      return new Handled(
          new MultipleResponse(request.id(), request.type(), results, tail), refused);
    }
  }

  // type 17

  /** One access of a benchmark. */
  private interface Trial {
    Result run();
  }

  private Handled benchmark(BenchmarkReadRequest request) {
    List<Trial> trials = new ArrayList<>();
    request.names().forEach(name -> trials.add(() -> read(name)));
    return benchmark(request, false, request.iterations(), trials);
  }

  private Handled benchmark(BenchmarkWriteRequest request) {
    List<Trial> trials = new ArrayList<>();
    request.assignments().forEach(item -> trials.add(() -> write(item.name(), item.value())));
    return benchmark(request, true, request.iterations(), trials);
  }

  /**
   * A refused access does not end the run, which is a success
   * (docs/reference/c3-messages.md#benchmark-17). The end of the server ends it.
   */
  private static Handled benchmark(Request request, boolean write, long asked, List<Trial> all) {
    List<Trial> trials = all.subList(0, Math.min(BENCHMARKED, all.size()));
    long iterations = Math.min(asked, MAX_ITERATIONS);
    RefusedException refused = null;
    long start = millis();
    for (long i = 0; i < iterations && !trials.isEmpty(); i++) {
      for (Trial trial : trials) {
        RefusedException found = trial.run().refused();
        refused = refused == null ? found : refused;
      }
      if (Thread.currentThread().isInterrupted()) {
        break;
      }
    }
    long stop = millis();
    Response response =
        new BenchmarkResponse(
            request.id(),
            write,
            trials.size(),
            iterations,
            start,
            stop,
            (stop - start) & U32,
            Tail.SUCCESS);
    return new Handled(response, refused);
  }

  /** Returns the time since an arbitrary moment, in 32 bits as Windows does. */
  private static long millis() {
    return (System.nanoTime() / NANOS_PER_MILLI) & U32;
  }
}
