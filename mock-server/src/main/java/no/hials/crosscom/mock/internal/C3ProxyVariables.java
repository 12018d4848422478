package no.hials.crosscom.mock.internal;

import java.net.InetSocketAddress;
import java.time.Instant;
import java.time.temporal.ChronoUnit;
import java.util.Locale;
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
 * What C3 Bridge says of itself: its internal variables
 * (docs/reference/c3-messages.md#internal-variables), and the answers to messages 13 and 14.
 */
public final class C3ProxyVariables {
  private static final String PREFIX = "@PROXY_";
  private static final int HIGHEST_SHOWN = 63;

  private final MockServerConfig config;
  private final Supplier<InetSocketAddress> address;

  /**
   * Makes them.
   *
   * @param address where the server listens
   */
  public C3ProxyVariables(MockServerConfig config, Supplier<InetSocketAddress> address) {
    this.config = config;
    this.address = address;
  }

  /** Gives the value of a variable, or null if there is none of that name. */
  @Nullable String find(String name) {
    // variable names are case-insensitive, PING is not
    // (docs/reference/c3-messages.md#internal-variables)
    return name.equals("PING") ? "PONG" : findProxy(name);
  }

  /** As {@link #find}, but without {@code PING}: what may be asked by UDP, too. */
  @Nullable String findProxy(String name) {
    String key = name.toUpperCase(Locale.ROOT);
    if (!key.startsWith(PREFIX)) {
      return null;
    }
    return switch (key.substring(PREFIX.length())) {
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

  /** c3-vectors.tsv: 64 digits, the last that of message 0. */
  private String featureDigits() {
    StringBuilder digits = new StringBuilder();
    Features features = features();
    for (int type = HIGHEST_SHOWN; type >= 0; type--) {
      digits.append(features.types().contains(type) ? '1' : '0');
    }
    return digits.toString();
  }

  /** Gives the types that the server has, right or with the mistakes of its version. */
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
    // docs/reference/c3-messages.md#server-versions says since when these two are correct: they
    // were there before
    return type == MessageType.READ_MULTIPLE
        || type == MessageType.WRITE_MULTIPLE
        || hasRight(type);
  }

  boolean hasRight(MessageType type) {
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
