package no.hials.crosscom.mock.internal;

import java.util.ArrayList;
import java.util.List;
import no.hials.crosscom.lang.TypeSwitch;
import no.hials.crosscom.mock.MockServerConfig;
import no.hials.crosscom.protocol.Codec;
import no.hials.crosscom.protocol.MalformedRequestException;
import no.hials.crosscom.protocol.MessageType;
import no.hials.crosscom.protocol.Request;
import no.hials.crosscom.protocol.Response;
import no.hials.crosscom.protocol.ServerType;
import no.hials.crosscom.protocol.Tail;
import no.hials.crosscom.protocol.file.FileRequest;
import no.hials.crosscom.protocol.program.ProgramRequest;
import no.hials.crosscom.protocol.server.ServerRequest;
import no.hials.crosscom.protocol.value.KrlArray;
import no.hials.crosscom.protocol.value.KrlInt;
import no.hials.crosscom.protocol.value.KrlSyntaxException;
import no.hials.crosscom.protocol.value.KrlValue;
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
import no.hials.crosscom.protocol.variable.VariableResponse.ReadArrayResponse;
import no.hials.crosscom.protocol.variable.VariableResponse.ValueResponse;
import no.hials.crosscom.simulator.Refusal;
import no.hials.crosscom.simulator.RefusedException;
import no.hials.crosscom.simulator.VariableTable;
import org.jspecify.annotations.Nullable;

/** Executes requests on a table of variables, as KUKAVARPROXY does on a controller. */
public final class KukavarproxyHandler implements RequestHandler {
  /** The longest value: the length field also counts function, value length and tail. */
  public static final int MAX_VALUE = Codec.MAX_FRAME_LENGTH - Codec.HEADER_LENGTH - 1 - 2 - 3;

  private static final int WORD = 0xFFFF;

  private static final TypeSwitch<KukavarproxyHandler, Request, Handled, RuntimeException>
      REQUESTS =
          TypeSwitch.create(
              Request.class,
              cases ->
                  cases
                      .on(ReadRequest.class, KukavarproxyHandler::read)
                      .on(WriteRequest.class, KukavarproxyHandler::write)
                      .on(ReadArrayRequest.class, KukavarproxyHandler::readArray)
                      .on(WriteArrayRequest.class, KukavarproxyHandler::writeArray)
                      .on(ReadUtf16Request.class, KukavarproxyHandler::unknown)
                      .on(WriteUtf16Request.class, KukavarproxyHandler::unknown)
                      .on(ReadMultipleRequest.class, KukavarproxyHandler::unknown)
                      .on(WriteMultipleRequest.class, KukavarproxyHandler::unknown)
                      .on(BenchmarkReadRequest.class, KukavarproxyHandler::unknown)
                      .on(BenchmarkWriteRequest.class, KukavarproxyHandler::unknown)
                      .on(ProgramRequest.class, KukavarproxyHandler::unknown)
                      .on(FileRequest.class, KukavarproxyHandler::unknown)
                      .on(ServerRequest.class, KukavarproxyHandler::unknown));

  private final VariableTable variables;
  private final MockServerConfig config;
  private final CodePage codePage;

  /** Creates the handler for all connections. */
  public KukavarproxyHandler(VariableTable variables, MockServerConfig config) {
    this.variables = variables;
    this.config = config;
    this.codePage = CodePage.of(config.codePage());
  }

  @Override
  public boolean knows(MessageType type) {
    return type.isKnownTo(ServerType.KUKAVARPROXY);
  }

  /** Assumed: a malformed request gets no answer. */
  @Override
  public @Nullable Response malformed(MalformedRequestException request) {
    return null;
  }

  @Override
  public Handled handle(Request request) {
    return REQUESTS.apply(this, request);
  }

  /** The dispatcher passes only requests of types that {@link #knows} accepts. */
  private Handled unknown(Request request) {
    throw new IllegalArgumentException("not a request for KUKAVARPROXY: " + request);
  }

  private static Handled answer(
      Request request, String value, Tail tail, @Nullable RefusedException refused) {
    return new Handled(new ValueResponse(request.id(), request.type(), value, tail), refused);
  }

  private Handled read(ReadRequest request) {
    if (isForServer(request)) {
      return answer(request, "PONG", Tail.SUCCESS, null);
    }
    try {
      String text = variables.read(codePage.decode(request.name()));
      if (config.trimValues()) {
        text = text.strip();
      }
      text = codePage.encode(text);
      checkLength(text.length());
      return answer(request, text, Tail.SUCCESS, null);
    } catch (RefusedException e) {
      return answer(request, "", config.failedRead().tail(), e);
    }
  }

  /** The name is case-sensitive (docs/reference/kukavarproxy.md#ping). */
  @Override
  public boolean isForServer(Request request) {
    return config.ping() && request instanceof ReadRequest read && read.name().equals("PING");
  }

  private static void checkLength(int bytes) throws RefusedException {
    if (bytes > MAX_VALUE) {
      throw new RefusedException(
          Refusal.TOO_LONG, "a value must have at most " + MAX_VALUE + " bytes, has " + bytes);
    }
  }

  private Handled write(WriteRequest request) {
    RefusedException refused = null;
    String echo = request.value();
    try {
      if (echo.length() > MAX_VALUE) {
        // only possible with a name that is too long for a variable
        echo = "";
        throw new RefusedException(Refusal.TOO_LONG, "the value must fit into the answer");
      }
      variables.write(
          codePage.decode(request.name()),
          codePage.decode(request.value()),
          config.maxAggregateLength());
    } catch (RefusedException e) {
      refused = e;
    }
    Tail tail = refused == null ? Tail.SUCCESS : config.failedWriteTail();
    return answer(request, echo, tail, refused);
  }

  private Handled readArray(ReadArrayRequest request) {
    try {
      KrlValue value = variables.readValue(request.name());
      // of a single element empty (docs/reference/wire-format.md#integer-arrays); the tail is
      // assumed
      List<Integer> words = value instanceof KrlArray ? words(value) : List.of();
      checkLength(2 * words.size());
      return new Handled(new ReadArrayResponse(request.id(), words, Tail.SUCCESS), null);
    } catch (RefusedException e) {
      // assumed: the same as for a failed read of a text
      return new Handled(
          new ReadArrayResponse(request.id(), List.of(), config.failedRead().tail()), e);
    }
  }

  private static List<Integer> words(KrlValue value) throws RefusedException {
    List<KrlValue> elements = value instanceof KrlArray array ? array.elements() : List.of(value);
    List<Integer> words = new ArrayList<>(elements.size());
    for (KrlValue element : elements) {
      if (!(element instanceof KrlInt number)) {
        throw new RefusedException(
            Refusal.WRONG_TYPE, "only INT can be read as 16-bit numbers, is " + element);
      }
      // assumed: the higher bits are cut off
      words.add(number.value() & WORD);
    }
    return words;
  }

  /**
   * Writes one element after the other. Assumed: the first refused element ends the write; the
   * elements before it stay written.
   */
  private Handled writeArray(WriteArrayRequest request) {
    String name = request.name().strip();
    if (name.endsWith("[]")) {
      name = name.substring(0, name.length() - 2);
    }
    RefusedException refused = null;
    try {
      for (int i = 0; i < request.elements().size(); i++) {
        String value = String.valueOf(request.elements().get(i));
        variables.write(name + "[" + (i + 1) + "]", value, 0);
      }
    } catch (RefusedException e) {
      refused = e;
    }
    Tail tail = refused == null ? Tail.SUCCESS : config.failedWriteTail();
    return answer(request, "", tail, refused);
  }

  /** Creates an answer with a given value and tail. */
  static Response answer(Request request, String value, Tail tail) {
    return switch (request.type()) {
      case READ_ARRAY -> new ReadArrayResponse(request.id(), wordsOrNone(value), tail);
      case WRITE_ARRAY -> new ValueResponse(request.id(), request.type(), value, tail);
      default -> C3Answers.scripted(request, value, tail);
    };
  }

  private static List<Integer> wordsOrNone(String value) {
    try {
      return words(KrlValue.parse(value));
    } catch (RefusedException | KrlSyntaxException e) {
      return List.of();
    }
  }
}
