package no.hials.crosscom;

import java.util.stream.Collectors;
import no.hials.crosscom.internal.Versions;
import no.hials.crosscom.protocol.AnswerFrame;
import no.hials.crosscom.protocol.Codec;
import no.hials.crosscom.protocol.MessageType;
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

  private static final String FEATURES_REQUEST = "request for the server's features";

  private static final Features KUKAVARPROXY =
      new Features(
          ServerType.KUKAVARPROXY.types().stream()
              .map(MessageType::code)
              .collect(Collectors.toSet()));

  private final ReconnectingConnection link;
  private final byte[] askType = Codec.encode(new ReadRequest(0, "@PROXY_TYPE"));
  private final byte[] askVersion = Codec.encode(new ReadRequest(0, "@PROXY_VERSION"));
  private final byte[] askFeatures = Codec.encode(new ServerRequest(0, MessageType.FEATURES));

  /** The connection of the server that the other fields describe. */
  private @Nullable Connection of;

  private @Nullable ServerType type;
  private @Nullable Version version;
  private boolean versionAsked;
  private @Nullable Features features;

  ServerDetector(ReconnectingConnection link) {
    this.link = link;
  }

  ServerType type() throws CrossComException {
    if (of != link.connection()) {
      of = link.connection();
      type = null;
      version = null;
      versionAsked = false;
      features = null;
    }
    if (type == null) {
      type = isC3Bridge() ? ServerType.C3_BRIDGE : ServerType.KUKAVARPROXY;
    }
    return type;
  }

  /**
   * Asks for the type. A failure does not show it: old KUKAVARPROXYs always fail, and C3 Bridge may
   * fail once; but only C3 Bridge knows message 14 (docs/reference/servers.md).
   */
  private boolean isC3Bridge() throws CrossComException {
    AnswerFrame answer = send(askType, MessageType.READ, "@PROXY_TYPE");
    return answer.success()
        ? C3_BRIDGE.equalsIgnoreCase(answer.toString().strip())
        : !send(askFeatures, MessageType.FEATURES, FEATURES_REQUEST).functionUnknown();
  }

  private AnswerFrame send(byte[] frame, MessageType message, String name)
      throws CrossComException {
    return link.send(frame, frame.length, message, Repeatability.READ, name).frame();
  }

  @Nullable Version version() throws CrossComException {
    if (type() == ServerType.C3_BRIDGE && !versionAsked) {
      AnswerFrame answer = send(askVersion, MessageType.READ, "@PROXY_VERSION");
      version = answer.success() ? Versions.parse(answer.toString().strip()) : null;
      versionAsked = true;
    }
    return version;
  }

  Features features() throws CrossComException {
    if (type() == ServerType.KUKAVARPROXY) {
      return KUKAVARPROXY;
    }
    if (features == null) {
      TypedResponse response =
          link.send(
                  askFeatures,
                  MessageType.FEATURES,
                  Repeatability.READ,
                  FEATURES_REQUEST,
                  FeaturesResponse.class)
              .response();
      if (!(response instanceof FeaturesResponse known) || !response.tail().success()) {
        throw new CrossComRefusedException(FEATURES_REQUEST, response.tail().code());
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
