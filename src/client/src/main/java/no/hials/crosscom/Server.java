package no.hials.crosscom;

import no.hials.crosscom.protocol.MessageType;
import no.hials.crosscom.protocol.ServerType;
import no.hials.crosscom.protocol.Version;
import no.hials.crosscom.protocol.server.Features;
import org.jspecify.annotations.Nullable;

/**
 * What the client found out about the server.
 *
 * @param type what it is, by its answer to {@code @PROXY_TYPE}
 *     (docs/reference/c3-messages.md#internal-variables)
 * @param version its version, by its answer to {@code @PROXY_VERSION}; null if it gives none, as
 *     KUKAVARPROXY
 * @param features the messages that it knows; for KUKAVARPROXY 0 to 3
 *     (docs/reference/wire-format.md#requests)
 */
public record Server(ServerType type, @Nullable Version version, Features features) {

  /**
   * Says whether the server knows a message.
   *
   * @param message any
   * @return true if so
   */
  public boolean knows(MessageType message) {
    return features.has(message);
  }
}
