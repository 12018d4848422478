package no.hials.crosscom;

import no.hials.crosscom.protocol.MessageType;
import no.hials.crosscom.protocol.ServerType;
import no.hials.crosscom.protocol.Version;
import no.hials.crosscom.protocol.server.Features;
import org.jspecify.annotations.Nullable;

/**
 * The type, version and features of a server.
 *
 * @param type its type, by its answer to {@code @PROXY_TYPE}
 *     (docs/reference/c3-messages.md#internal-variables)
 * @param version its version, by its answer to {@code @PROXY_VERSION}; null if it has none, as
 *     KUKAVARPROXY
 * @param features the messages that it supports; for KUKAVARPROXY 0 to 3
 *     (docs/reference/wire-format.md#requests)
 */
public record Server(ServerType type, @Nullable Version version, Features features) {

  /** Returns whether the server supports a message. */
  public boolean knows(MessageType message) {
    return features.has(message);
  }
}
