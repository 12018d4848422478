package no.hials.crosscom.cell;

import java.nio.charset.Charset;
import java.time.Duration;
import java.util.function.Consumer;
import no.hials.crosscom.ClientConfig;
import no.hials.crosscom.protocol.ServerType;
import org.jspecify.annotations.Nullable;

/**
 * A robot controller that the user chose, not connected yet.
 *
 * @param name the user's name for it, such as {@code cell1}; empty if it has no name
 * @param host name or address; null for a simulated controller
 * @param port TCP port on the host
 * @param timeout limit for connecting and for each answer; null for the client's own limits
 * @param readOnlyBy the setting that makes it read-only, such as {@code
 *     JOPENSHOWVAR_READ_ONLY=true}; null if writes are allowed
 * @param server the server of a simulated controller, or the known type of a real one; null if it
 *     is detected
 * @param charset the charset of texts on KUKAVARPROXY; null for the client's own
 */
public record Robot(
    String name,
    @Nullable String host,
    int port,
    @Nullable Duration timeout,
    @Nullable String readOnlyBy,
    @Nullable ServerType server,
    @Nullable Charset charset) {

  /** Does not reconnect, so that a command reports the loss of its connection. */
  public static final Consumer<ClientConfig.Builder> ONE_SHOT =
      cfg -> cfg.reconnect(false).keepAlive(Duration.ZERO);

  /** Reconnects automatically, for commands that keep running. */
  public static final Consumer<ClientConfig.Builder> LASTING = cfg -> {};

  /** Returns the text to print before a line about this robot: empty if it has no name. */
  public String label() {
    return name.isEmpty() ? "" : name + ": ";
  }

  /** Returns this robot with the address of the server that simulates it. */
  public Robot at(String simulatedHost, int simulatedPort) {
    return new Robot(name, simulatedHost, simulatedPort, timeout, readOnlyBy, null, charset);
  }
}
