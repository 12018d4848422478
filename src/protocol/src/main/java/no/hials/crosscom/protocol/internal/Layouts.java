package no.hials.crosscom.protocol.internal;

import java.util.EnumMap;
import java.util.HashMap;
import java.util.Map;
import java.util.Objects;
import no.hials.crosscom.protocol.MalformedFrameException;
import no.hials.crosscom.protocol.MessageType;
import no.hials.crosscom.protocol.PlainResponse;
import no.hials.crosscom.protocol.Request;
import no.hials.crosscom.protocol.ServerType;
import no.hials.crosscom.protocol.Tail;
import no.hials.crosscom.protocol.TextResponse;
import no.hials.crosscom.protocol.TypedResponse;

/**
 * The layouts of all messages: their fields between the function byte and the end of a request or
 * the tail of an answer.
 *
 * <p>A message is written by its class and read by its type, since some types have several classes,
 * and some classes serve several types.
 */
public final class Layouts {
  static final Layouts ALL = new Layouts();

  final Map<Class<?>, Writer<?>> writers = new HashMap<>();
  final Map<Class<?>, MessageType> types = new HashMap<>();
  final Map<MessageType, RequestReader> requests = new EnumMap<>(MessageType.class);
  final Map<MessageType, AnswerReader> answers = new EnumMap<>(MessageType.class);

  /** Writes a message's fields. */
  @FunctionalInterface
  interface Writer<M> {
    void write(M message, FieldWriter out);
  }

  /** Reads the fields of a request, whose id is read already. */
  @FunctionalInterface
  interface RequestReader {
    Request read(int id, FieldReader in) throws MalformedFrameException;
  }

  /** Reads the fields of an answer, whose id and tail are read already. */
  @FunctionalInterface
  interface AnswerReader {
    TypedResponse read(int id, FieldReader in, Tail tail) throws MalformedFrameException;
  }

  private Layouts() {
    VariableLayouts.addTo(this);
    ProgramLayouts.addTo(this);
    FileLayouts.addTo(this);
    ServerLayouts.addTo(this);
    writer(PlainResponse.class, (m, out) -> {});
    writer(TextResponse.class, (m, out) -> out.wide(m.text()));
  }

  <M> void writer(Class<M> message, Writer<M> writer) {
    writers.put(message, writer);
  }

  /** Adds a class that serves only one type. */
  <M> void writer(MessageType type, Class<M> message, Writer<M> writer) {
    types.put(message, type);
    writer(message, writer);
  }

  void request(MessageType type, RequestReader reader) {
    requests.put(type, reader);
  }

  <M extends Request> void request(
      MessageType type, Class<M> message, Writer<M> writer, RequestReader reader) {
    writer(type, message, writer);
    request(type, reader);
  }

  void answer(MessageType type, AnswerReader reader) {
    answers.put(type, reader);
  }

  <M extends TypedResponse> void answer(
      MessageType type, Class<M> message, Writer<M> writer, AnswerReader reader) {
    writer(type, message, writer);
    answer(type, reader);
  }

  void plainAnswer(MessageType type) {
    answer(type, (id, in, tail) -> new PlainResponse(id, type, tail));
  }

  void textAnswer(MessageType type) {
    answer(type, (id, in, tail) -> new TextResponse(id, type, in.wide("text"), tail));
  }

  /** Returns the type of a class of messages that serves only one type. */
  public static MessageType type(Class<?> message) {
    return known(ALL.types, message);
  }

  /** Writes the fields of a request or an answer. */
  @SuppressWarnings("unchecked") // request and answer pair each class with its writer
  public static <M> void write(M message, FieldWriter out) {
    ((Writer<M>) known(ALL.writers, message.getClass())).write(message, out);
  }

  /** Reads the fields of a request. */
  public static Request readRequest(MessageType type, int id, FieldReader in)
      throws MalformedFrameException {
    return known(ALL.requests, type).read(id, in);
  }

  /**
   * Reads the fields of an answer. A failed answer of C3 Bridge may have none
   * (docs/reference/c3-messages.md#file-content-29-and-30, row "29 data without fields"); assumed
   * of every type.
   */
  public static TypedResponse readAnswer(MessageType type, int id, FieldReader in, Tail tail)
      throws MalformedFrameException {
    return in.isEmpty() && !tail.success() && !type.isKnownTo(ServerType.KUKAVARPROXY)
        ? new PlainResponse(id, type, tail)
        : known(ALL.answers, type).read(id, in, tail);
  }

  private static <K, V> V known(Map<K, V> layouts, K message) {
    return Objects.requireNonNull(layouts.get(message), () -> "no layout of " + message);
  }
}
