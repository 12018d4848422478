package no.hials.crosscom;

import java.util.Optional;
import no.hials.crosscom.protocol.MessageType;
import no.hials.crosscom.protocol.ServerType;
import no.hials.crosscom.protocol.Version;
import org.jspecify.annotations.Nullable;

/**
 * Thrown if the server does not support an operation, for example programs, motions and files on
 * KUKAVARPROXY. Nothing was sent; the connection can be used.
 */
public final class CrossComUnsupportedException extends CrossComException {
  private static final long serialVersionUID = 1L;

  private final MessageType needed;
  private final ServerType server;

  CrossComUnsupportedException(
      String what, MessageType needed, ServerType server, @Nullable Version version) {
    super(
        "this server does not support the "
            + what
            + ": it needs C3 Bridge Interface"
            + needed.since().map(since -> " " + since + " or later").orElse("")
            + " (message "
            + needed.code()
            + "), the server is "
            + (server == ServerType.KUKAVARPROXY ? "KUKAVARPROXY" : "C3 Bridge Interface")
            + (version == null ? "" : " " + version),
        null,
        false);
    this.needed = needed;
    this.server = server;
  }

  /** Returns the message that the server does not support. */
  public MessageType getNeededMessage() {
    return needed;
  }

  /** Returns the first version with the message (docs/reference/c3-messages.md#server-versions). */
  public Optional<Version> getNeededVersion() {
    return needed.since();
  }

  /** Returns the type of the server. */
  public ServerType getServer() {
    return server;
  }
}
