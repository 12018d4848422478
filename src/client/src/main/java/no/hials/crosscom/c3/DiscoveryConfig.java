package no.hials.crosscom.c3;

import java.net.InetAddress;
import java.net.InterfaceAddress;
import java.net.NetworkInterface;
import java.net.SocketException;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Set;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;

/**
 * The options of a {@link Discovery}. Immutable; created by {@link #create}. The {@link Builder}
 * describes the options.
 */
public final class DiscoveryConfig {
  private final List<InetAddress> targets;
  private final Options options;

  private DiscoveryConfig(Options options) {
    this.options = options;
    this.targets = List.copyOf(options.targets);
    check(!targets.isEmpty(), "at least one address to ask is needed, there are 0");
    check(options.legacy || options.standard, "legacy or standard mode must be on, both are off");
  }

  /**
   * Creates a configuration.
   *
   * @param settings sets the addresses to ask, and the options that differ from their defaults
   * @return the configuration
   * @throws IllegalArgumentException if there is no address to ask, or a value is out of range
   */
  public static DiscoveryConfig create(Consumer<Builder> settings) {
    Builder builder = new Builder();
    settings.accept(builder);
    Options options = builder.options;
    builder.options = new Options(); // a builder that is kept changes nothing
    return new DiscoveryConfig(options);
  }

  private static int port(String field, int value, int min) {
    check(value >= min && value <= 65_535, field + " must be " + min + " to 65535, is " + value);
    return value;
  }

  private static void check(boolean holds, String rule) {
    if (!holds) {
      throw new IllegalArgumentException(rule);
    }
  }

  /** Returns the IPv4 addresses to ask, of hosts or for broadcast. */
  public List<InetAddress> targets() {
    return targets;
  }

  /** Returns how long to wait for answers. */
  public Duration timeout() {
    return options.timeout;
  }

  /** Returns the address of this machine to ask from; null for the default. */
  public @Nullable InetAddress localAddress() {
    return options.localAddress;
  }

  /** Returns whether to ask in the legacy mode. */
  public boolean legacy() {
    return options.legacy;
  }

  /** Returns whether to ask in the standard mode of C3 Bridge. */
  public boolean standard() {
    return options.standard;
  }

  /** Returns the UDP port to ask in legacy mode. */
  public int legacyPort() {
    return options.legacyPort;
  }

  /** Returns the UDP port of this machine to which legacy mode answers; 0 for a free one. */
  public int legacyReplyPort() {
    return options.legacyReplyPort;
  }

  /** Returns the UDP port to ask in standard mode. */
  public int standardPort() {
    return options.standardPort;
  }

  /** Returns whether the other is a configuration with equal options. */
  @Override
  public boolean equals(@Nullable Object other) {
    return other instanceof DiscoveryConfig config && values().equals(config.values());
  }

  @Override
  public int hashCode() {
    return values().hashCode();
  }

  @Override
  public String toString() {
    return "DiscoveryConfig" + values();
  }

  private Map<String, @Nullable Object> values() {
    Map<String, @Nullable Object> values = new LinkedHashMap<>();
    values.put("targets", targets);
    values.put("timeout", options.timeout);
    values.put("localAddress", options.localAddress);
    values.put("legacy", options.legacy);
    values.put("legacyPort", options.legacyPort);
    values.put("legacyReplyPort", options.legacyReplyPort);
    values.put("standard", options.standard);
    values.put("standardPort", options.standardPort);
    return values;
  }

  /** The options as they were set. */
  private static final class Options {
    private final Set<InetAddress> targets = new LinkedHashSet<>();
    private Duration timeout = Duration.ofSeconds(1);
    private @Nullable InetAddress localAddress;
    private boolean legacy = true;
    private boolean standard = true;
    private int legacyPort = 6999;
    private int legacyReplyPort = 7000;
    private int standardPort = 7000;
  }

  /** Sets the options. Each method returns this builder. */
  public static final class Builder {
    private Options options = new Options();

    private Builder() {}

    // whom to ask

    /** Asks IPv4 addresses, of hosts or for broadcast. */
    public Builder addresses(InetAddress... values) {
      options.targets.addAll(Arrays.asList(values));
      return this;
    }

    /** Asks all hosts that a network interface reaches by broadcast. */
    public Builder networkInterface(NetworkInterface value) {
      value.getInterfaceAddresses().stream()
          .map(InterfaceAddress::getBroadcast)
          .filter(Objects::nonNull)
          .forEach(options.targets::add);
      return this;
    }

    /**
     * Asks all hosts that any network interface of this machine reaches by broadcast, other than
     * loopback and those that are down.
     *
     * @throws SocketException if the interfaces cannot be listed
     */
    public Builder allNetworkInterfaces() throws SocketException {
      List<NetworkInterface> usable = new ArrayList<>();
      for (NetworkInterface each : NetworkInterface.networkInterfaces().toList()) {
        if (each.isUp() && !each.isLoopback()) {
          usable.add(each);
        }
      }
      usable.forEach(this::networkInterface);
      return this;
    }

    /** Sets how long every discovery takes, 1 ms or more. The default is 1 s. */
    public Builder timeout(Duration value) {
      check(
          value.compareTo(Duration.ofMillis(1)) >= 0
              && value.compareTo(Duration.ofMillis(Integer.MAX_VALUE)) <= 0,
          "time-out must be 1 to " + Integer.MAX_VALUE + " ms, is " + value);
      options.timeout = value;
      return this;
    }

    /**
     * Sets the address of this machine to ask from, an IPv4 address of an interface. The default is
     * the address of the route to each target.
     */
    public Builder localAddress(InetAddress value) {
      options.localAddress = value;
      return this;
    }

    // modes

    /**
     * Sets whether to ask in the legacy mode, which KUKAVARPROXY supports too (the default); false
     * to find only C3 Bridge, and to leave the reply port alone.
     */
    public Builder legacy(boolean value) {
      options.legacy = value;
      return this;
    }

    /** Sets whether to ask in the standard mode of C3 Bridge (the default). */
    public Builder standard(boolean value) {
      options.standard = value;
      return this;
    }

    /**
     * Sets the ports of the legacy mode.
     *
     * @param ask the UDP port to ask, 1 to 65535; default 6999
     *     (docs/reference/wire-format.md#discovery)
     * @param reply the UDP port of this machine to which the answer comes, default 7000; 0 for a
     *     free one, which no real server answers to
     */
    public Builder legacyPorts(int ask, int reply) {
      options.legacyPort = port("legacy port", ask, 1);
      options.legacyReplyPort = port("legacy reply port", reply, 0);
      return this;
    }

    /** Sets the UDP port to ask in standard mode, 1 to 65535. The default is 7000. */
    public Builder standardPort(int value) {
      options.standardPort = port("standard port", value, 1);
      return this;
    }
  }
}
