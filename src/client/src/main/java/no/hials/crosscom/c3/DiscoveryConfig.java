package no.hials.crosscom.c3;

import java.net.InetAddress;
import java.net.InterfaceAddress;
import java.net.NetworkInterface;
import java.net.SocketException;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Objects;
import java.util.Set;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;

/**
 * Where a {@link Discovery} asks, and how. Immutable; made by {@link #create}.
 *
 * @param targets the IPv4 addresses that are asked, of hosts or for broadcast; at least one
 * @param timeout how long to wait for answers, all of which is waited; 1 ms or more, default 1 s
 * @param localAddress the address of this machine to ask from; null (the default) for whichever
 *     leads to the target
 * @param legacy whether to ask in the legacy mode, which KUKAVARPROXY knows too; default true
 * @param standard whether to ask in the standard mode of C3 Bridge; default true
 * @param legacyPort the UDP port to ask in legacy mode, default 6999
 *     (docs/reference/wire-format.md#discovery)
 * @param legacyReplyPort the UDP port of this machine to which legacy mode answers, default 7000; 0
 *     for a free one, which no real server answers to
 * @param standardPort the UDP port to ask in standard mode, default 7000
 */
public record DiscoveryConfig(
    List<InetAddress> targets,
    Duration timeout,
    @Nullable InetAddress localAddress,
    boolean legacy,
    boolean standard,
    int legacyPort,
    int legacyReplyPort,
    int standardPort) {

  /** Checks every field. */
  public DiscoveryConfig {
    targets = List.copyOf(targets);
    check(!targets.isEmpty(), "at least one address to ask is needed, there are 0");
    check(
        timeout.compareTo(Duration.ofMillis(1)) >= 0
            && timeout.compareTo(Duration.ofMillis(Integer.MAX_VALUE)) <= 0,
        "time-out must be 1 to " + Integer.MAX_VALUE + " ms, is " + timeout);
    check(legacy || standard, "legacy or standard mode must be on, both are off");
    port("legacy port", legacyPort, 1);
    port("legacy reply port", legacyReplyPort, 0);
    port("standard port", standardPort, 1);
  }

  private static void port(String field, int value, int min) {
    check(value >= min && value <= 65_535, field + " must be " + min + " to 65535, is " + value);
  }

  private static void check(boolean holds, String rule) {
    if (!holds) {
      throw new IllegalArgumentException(rule);
    }
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
    return builder.build();
  }

  /** Collects the settings of a {@link DiscoveryConfig}. */
  public static final class Builder {
    private final Set<InetAddress> targets = new LinkedHashSet<>();
    private Duration timeout = Duration.ofSeconds(1);
    private @Nullable InetAddress localAddress;
    private boolean legacy = true;
    private boolean standard = true;
    private int legacyPort = 6999;
    private int legacyReplyPort = 7000;
    private int standardPort = 7000;

    private Builder() {}

    /**
     * Asks addresses.
     *
     * @param values IPv4 addresses, of hosts or for broadcast
     * @return this
     */
    public Builder addresses(InetAddress... values) {
      targets.addAll(Arrays.asList(values));
      return this;
    }

    /**
     * Asks all hosts that a network interface reaches by broadcast.
     *
     * @param value the interface
     * @return this
     */
    public Builder networkInterface(NetworkInterface value) {
      value.getInterfaceAddresses().stream()
          .map(InterfaceAddress::getBroadcast)
          .filter(Objects::nonNull)
          .forEach(targets::add);
      return this;
    }

    /**
     * Asks all hosts that any network interface of this machine reaches by broadcast, other than
     * loopback and those that are down.
     *
     * @return this
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

    /**
     * Sets how long to wait for answers.
     *
     * @param value 1 ms or more
     * @return this
     */
    public Builder timeout(Duration value) {
      timeout = value;
      return this;
    }

    /**
     * Sets the address of this machine to ask from.
     *
     * @param value an IPv4 address of an interface
     * @return this
     */
    public Builder localAddress(InetAddress value) {
      localAddress = value;
      return this;
    }

    /**
     * Sets whether to ask in the legacy mode.
     *
     * @param value false to find only C3 Bridge, and to leave the reply port alone
     * @return this
     */
    public Builder legacy(boolean value) {
      legacy = value;
      return this;
    }

    /**
     * Sets whether to ask in the standard mode of C3 Bridge.
     *
     * @param value true or false
     * @return this
     */
    public Builder standard(boolean value) {
      standard = value;
      return this;
    }

    /**
     * Sets the ports of the legacy mode.
     *
     * @param ask the UDP port to ask, 1 to 65535
     * @param reply the UDP port of this machine to which the answer comes; 0 for a free one
     * @return this
     */
    public Builder legacyPorts(int ask, int reply) {
      legacyPort = ask;
      legacyReplyPort = reply;
      return this;
    }

    /**
     * Sets the port of the standard mode.
     *
     * @param value the UDP port to ask, 1 to 65535
     * @return this
     */
    public Builder standardPort(int value) {
      standardPort = value;
      return this;
    }

    private DiscoveryConfig build() {
      return new DiscoveryConfig(
          List.copyOf(targets),
          timeout,
          localAddress,
          legacy,
          standard,
          legacyPort,
          legacyReplyPort,
          standardPort);
    }
  }
}
