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
      // KUKAVARPROXY answers empty or failure (docs/reference/c3-messages.md#internal-variables)
      type =
          C3_BRIDGE.equalsIgnoreCase(read(askType, "@PROXY_TYPE"))
              ? ServerType.C3_BRIDGE
              : ServerType.KUKAVARPROXY;
    }
    return type;
  }

  private String read(byte[] frame, String name) throws CrossComException {
    AnswerFrame answer =
        link.send(frame, frame.length, MessageType.READ, Repeatability.READ, name).frame();
    return answer.success() ? answer.toString().strip() : "";
  }

  @Nullable Version version() throws CrossComException {
    if (type() == ServerType.C3_BRIDGE && !versionAsked) {
      version = Versions.parse(read(askVersion, "@PROXY_VERSION"));
      versionAsked = true;
    }
    return version;
  }

  Features features() throws CrossComException {
    if (type() == ServerType.KUKAVARPROXY) {
      return KUKAVARPROXY;
    }
    if (features == null) {
      String what = "request for the server's features";
      TypedResponse response =
          link.send(
                  askFeatures,
                  MessageType.FEATURES,
                  Repeatability.READ,
                  what,
                  FeaturesResponse.class)
              .response();
      if (!(response instanceof FeaturesResponse known) || !response.tail().success()) {
        throw new CrossComRefusedException(what, response.tail().code());
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
