package no.hials.crosscom;

import java.util.Objects;
import java.util.stream.Collectors;
import no.hials.crosscom.internal.Versions;
import no.hials.crosscom.internal.exchange.ExchangeAnswer;
import no.hials.crosscom.internal.exchange.Repeatability;
import no.hials.crosscom.internal.exchange.Threads;
import no.hials.crosscom.protocol.AnswerFrame;
import no.hials.crosscom.protocol.Codec;
import no.hials.crosscom.protocol.MessageType;
import no.hials.crosscom.protocol.Request;
import no.hials.crosscom.protocol.ServerType;
import no.hials.crosscom.protocol.TypedResponse;
import no.hials.crosscom.protocol.Version;
import no.hials.crosscom.protocol.server.Features;
import no.hials.crosscom.protocol.server.ServerRequest;
import no.hials.crosscom.protocol.server.ServerResponse.FeaturesResponse;
import no.hials.crosscom.protocol.variable.VariableRequest.ReadRequest;
import org.jspecify.annotations.Nullable;

/**
 * Detects the type, version and features of the server, once per connection and only on demand: a
 * new connection may lead to another server. All methods may send on the current connection; the
 * lock of the link is held.
 */
final class ServerDetector {
  /**
   * The answer of C3 Bridge to {@code @PROXY_TYPE}
   * (docs/reference/c3-messages.md#internal-variables).
   */
  private static final String C3_BRIDGE = "C3 BRIDGE INTERFACE";

  /** The first version of C3 Bridge; its messages need no further question. */
  private static final Version FIRST = new Version(1, 0, 0);

  private static final Features KUKAVARPROXY =
      new Features(
          ServerType.KUKAVARPROXY.types().stream()
              .map(MessageType::code)
              .collect(Collectors.toSet()));

  private final ReconnectingConnection link;

  /** The type if it is configured; null if the server is asked for it. */
  private final @Nullable ServerType configured;

  /** The connection of the server that the other fields describe. */
  private @Nullable Connection of;

  private @Nullable ServerType type;
  private boolean typeUnclear;
  private @Nullable Version version;
  private boolean versionAsked;
  private @Nullable Features features;

  /** A request that finds something out about the server. */
  enum Question {
    /** Asks for the type. */
    TYPE(new ReadRequest(0, "@PROXY_TYPE"), "@PROXY_TYPE"),
    /** Asks for the version of C3 Bridge. */
    VERSION(new ReadRequest(0, "@PROXY_VERSION"), "@PROXY_VERSION"),
    /** Asks for the messages that the server supports. */
    FEATURES(new ServerRequest(0, MessageType.FEATURES), "request for the server's features");

    @SuppressWarnings("ImmutableEnumChecker") // nobody changes it
    private final byte[] frame;

    private final MessageType message;
    private final String phrase;

    Question(Request request, String phrase) {
      this.frame = Codec.encode(request);
      this.message = request.type();
      this.phrase = phrase;
    }

    /** Returns the request, which is not to be changed. */
    byte[] frame() {
      return frame;
    }

    MessageType message() {
      return message;
    }

    /** Returns the variable, or a phrase for the request. */
    String phrase() {
      return phrase;
    }
  }

  ServerDetector(ReconnectingConnection link, @Nullable ServerType configured) {
    this.link = link;
    this.configured = configured;
  }

  /**
   * Returns the next question to ask.
   *
   * <p>A failure does not show the type: old KUKAVARPROXYs always fail, and C3 Bridge may fail
   * once; but only C3 Bridge knows message 14 (docs/reference/servers.md#abilities-of-each-server).
   *
   * @param withVersion whether the version is needed too
   * @return null if all is known
   */
  @Nullable Question question(boolean withVersion) {
    if (of != link.connection()) {
      of = link.connection();
      type = configured;
      typeUnclear = false;
      version = null;
      versionAsked = false;
      features = null;
    }
    if (type == null) {
      return typeUnclear ? Question.FEATURES : Question.TYPE;
    }
    return withVersion && type == ServerType.C3_BRIDGE && !versionAsked ? Question.VERSION : null;
  }

  /**
   * Takes the answer to the last question.
   *
   * @throws CrossComRefusedException if it leaves the type unclear
   */
  void answered(Question question, AnswerFrame answer) throws CrossComRefusedException {
    if (question == Question.VERSION) {
      version = answer.success() ? Versions.parse(answer.toString().strip()) : null;
      versionAsked = true;
    } else if (question == Question.FEATURES) {
      if (answer.functionUnknown()) {
        type = ServerType.KUKAVARPROXY;
      } else if (answer.success()) {
        type = ServerType.C3_BRIDGE;
      } else {
        throw new CrossComRefusedException(
            question.phrase,
            answer.code(),
            "; it also failed to answer @PROXY_TYPE, so that its type is unknown: set it in"
                + " ClientConfig (server), or for jopenshowvar in config.toml (server of the"
                + " robot)");
      }
    } else if (!answer.success()) {
      typeUnclear = true;
    } else {
      boolean bridge = C3_BRIDGE.equalsIgnoreCase(answer.toString().strip());
      type = bridge ? ServerType.C3_BRIDGE : ServerType.KUKAVARPROXY;
    }
  }

  private void ask(boolean withVersion) throws CrossComException {
    for (Question next = question(withVersion); next != null; next = question(withVersion)) {
      answered(next, ask(next).frame());
    }
  }

  /** Sends a question on the current connection. */
  private ExchangeAnswer ask(Question question) throws CrossComException {
    byte[] frame = question.frame;
    return Threads.outsideCall(
        () ->
            link.send(frame, frame.length, question.message, Repeatability.READ, question.phrase));
  }

  ServerType type() throws CrossComException {
    ask(false);
    return Objects.requireNonNull(type);
  }

  @Nullable Version version() throws CrossComException {
    ask(true);
    return version;
  }

  Features features() throws CrossComException {
    if (type() == ServerType.KUKAVARPROXY) {
      return KUKAVARPROXY;
    }
    if (features == null) {
      TypedResponse response =
          link.message(ask(Question.FEATURES), FeaturesResponse.class).response();
      if (!(response instanceof FeaturesResponse known) || !response.tail().success()) {
        throw new CrossComRefusedException(Question.FEATURES.phrase, response.tail().code());
      }
      features = known.features();
    }
    return features;
  }

  Server server() throws CrossComException {
    return new Server(type(), version(), features());
  }

  /** Returns whether the server supports a message without the errors of early versions. */
  boolean supportsCorrectly(MessageType message) throws CrossComException {
    if (type() == ServerType.KUKAVARPROXY) {
      return message.isKnownTo(ServerType.KUKAVARPROXY);
    }
    Version since = message.since().orElse(null);
    if (since == null || since.equals(FIRST)) {
      return since != null;
    }
    Version own = version();
    return own != null && own.compareTo(since) >= 0;
  }

  /**
   * Throws if the server does not support a message, or supports it with errors. The features
   * cannot show this for types 6 and 7, which early versions had with errors
   * (docs/reference/c3-messages.md#server-versions).
   */
  MessageType require(MessageType message, String what) throws CrossComException {
    ServerType server = type();
    boolean known =
        server == ServerType.C3_BRIDGE
            && (supportsCorrectly(message)
                || (!hasWrongVersions(message) && features().has(message)));
    if (!known) {
      throw new CrossComUnsupportedException(what, message, server, version());
    }
    return message;
  }

  private static boolean hasWrongVersions(MessageType message) {
    return message == MessageType.READ_MULTIPLE || message == MessageType.WRITE_MULTIPLE;
  }
}
