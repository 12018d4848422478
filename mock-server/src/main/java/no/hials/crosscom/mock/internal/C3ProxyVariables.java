package no.hials.crosscom.mock.internal;

import java.net.InetSocketAddress;
import java.time.Instant;
import java.time.temporal.ChronoUnit;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.Supplier;
import no.hials.crosscom.mock.MockServerConfig;
import no.hials.crosscom.protocol.MessageType;
import no.hials.crosscom.protocol.ServerType;
import no.hials.crosscom.protocol.Version;
import no.hials.crosscom.protocol.code.BuildType;
import no.hials.crosscom.protocol.code.Code;
import no.hials.crosscom.protocol.server.Features;
import no.hials.crosscom.protocol.server.ServerInformation;
import no.hials.crosscom.protocol.server.SystemTime;
import org.jspecify.annotations.Nullable;

/**
 * The information of C3 Bridge about itself: its internal variables
 * (docs/reference/c3-messages.md#internal-variables), and the answers to messages 13 and 14.
 */
public final class C3ProxyVariables {
  private static final String PREFIX = "@PROXY_";
  private static final int HIGHEST_SHOWN = 63;

  private final MockServerConfig config;
  private final Supplier<InetSocketAddress> address;

  /**
   * Creates the proxy variables of one server.
   *
   * @param address the address on which the server listens
   */
  public C3ProxyVariables(MockServerConfig config, Supplier<InetSocketAddress> address) {
    this.config = config;
    this.address = address;
  }

  /**
   * Returns the value of a variable, null if there is no variable of the name. The names are
   * case-sensitive (docs/reference/c3-messages.md#internal-variables).
   */
  @Nullable String find(String name) {
    return name.equals("PING") ? "PONG" : findProxy(name);
  }

  /** Returns the same as {@link #find} without {@code PING}, which UDP does not answer. */
  @Nullable String findProxy(String name) {
    if (!name.startsWith(PREFIX)) {
      return null;
    }
    return switch (name.substring(PREFIX.length())) {
      case "TYPE" -> "C3 BRIDGE INTERFACE";
      case "VERSION" -> config.version() + " (OPEN SOURCE)";
      case "FEATURES" -> featureDigits();
      case "HOSTNAME" -> config.computerName();
      case "TIME" -> Instant.now().truncatedTo(ChronoUnit.SECONDS).toString();
      case "ADDRESS" -> address.get().getAddress().getHostAddress();
      case "PORT" -> String.valueOf(address.get().getPort());
      case "ENABLED" -> "TRUE";
      default -> null;
    };
  }

  /**
   * Returns 64 digits, the last one for message 0
   * (docs/reference/c3-messages.md#internal-variables).
   */
  private String featureDigits() {
    StringBuilder digits = new StringBuilder();
    Features features = features();
    for (int type = HIGHEST_SHOWN; type >= 0; type--) {
      digits.append(features.types().contains(type) ? '1' : '0');
    }
    return digits.toString();
  }

  /** Returns the types that the server knows, with or without the bugs of its version. */
  Features features() {
    Set<Integer> types = new TreeSet<>();
    for (MessageType type : ServerType.C3_BRIDGE.types()) {
      if (has(type)) {
        types.add(type.code());
      }
    }
    return new Features(types);
  }

  boolean has(MessageType type) {
    // the first versions had these two, with wrong values
    // (docs/reference/c3-messages.md#server-versions)
    return type == MessageType.READ_MULTIPLE
        || type == MessageType.WRITE_MULTIPLE
        || supportsCorrectly(type);
  }

  boolean supportsCorrectly(MessageType type) {
    return type.since().filter(since -> since.compareTo(config.version()) <= 0).isPresent();
  }

  ServerInformation information() {
    Version version = config.version();
    return new ServerInformation(
        version.major(),
        version.minor(),
        Code.of(BuildType.OPEN_SOURCE),
        SystemTime.of(Instant.now()),
        config.computerName());
  }
}
