package no.hials.crosscom.web;

import java.net.Inet4Address;
import java.net.Inet6Address;
import java.net.InetAddress;
import java.net.NetworkInterface;
import java.net.SocketException;
import java.net.UnknownHostException;
import java.util.Comparator;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.regex.Pattern;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** The address on which the page is served, and the names by which browsers may call it. */
public final class PageAddress {
  private static final Logger LOG = LoggerFactory.getLogger(PageAddress.class);
  private static final Pattern NAME = Pattern.compile("[a-z0-9]([a-z0-9.-]*[a-z0-9])?");
  private static final Pattern IPV6 = Pattern.compile("(?=.*:.*:)[0-9a-f:.]+");

  private final InetAddress address;
  private final List<String> names;

  private PageAddress(InetAddress address, Set<String> names) {
    this.address = address;
    this.names = List.copyOf(names);
  }

  /** Returns the loopback address. */
  public static PageAddress loopback() {
    InetAddress address = InetAddress.getLoopbackAddress();
    return new PageAddress(address, Set.of(name(address)));
  }

  /**
   * Returns an address.
   *
   * @param hosts first the address to listen on, or a name of it; then other names of this computer
   * @throws UnknownHostException if the first one has no address
   * @throws IllegalArgumentException if one is neither a name nor an address
   */
  public static PageAddress of(List<String> hosts) throws UnknownHostException {
    if (hosts.isEmpty()) {
      return loopback();
    }
    Set<String> names = new LinkedHashSet<>();
    String first = parse(hosts.get(0));
    InetAddress address = InetAddress.getByName(first);
    if (address.isAnyLocalAddress()) {
      addAddressesOfThisComputer(names, address instanceof Inet6Address);
    } else {
      names.add(first);
      names.add(name(address));
    }
    for (String other : hosts.subList(1, hosts.size())) {
      names.add(parse(other));
    }
    return new PageAddress(address, names);
  }

  /** Returns a name in lower case, or an address as {@link #name} returns it. */
  private static String parse(String host) throws UnknownHostException {
    String text = host.toLowerCase(Locale.ROOT);
    String plain =
        text.startsWith("[") && text.endsWith("]") ? text.substring(1, text.length() - 1) : text;
    if (IPV6.matcher(plain).matches()) {
      return name(InetAddress.getByName("[" + plain + "]"));
    }
    if (!NAME.matcher(text).matches()) {
      throw new IllegalArgumentException("'" + host + "' is neither a name nor an address");
    }
    return text;
  }

  /**
   * Adds the addresses that browsers on other computers can use, IPv4 first, since people can type
   * them. IPv6 addresses change every day on many computers, so they are added only on request.
   */
  private static void addAddressesOfThisComputer(Set<String> names, boolean ipv6) {
    try {
      NetworkInterface.networkInterfaces()
          .flatMap(NetworkInterface::inetAddresses)
          .filter(it -> !it.isLoopbackAddress() && !it.isLinkLocalAddress())
          .filter(it -> ipv6 || it instanceof Inet4Address)
          .sorted(Comparator.comparing(Inet6Address.class::isInstance))
          .forEach(it -> names.add(name(it)));
    } catch (SocketException e) {
      LOG.warn("cannot list the addresses of this computer, so links use the loopback address", e);
    }
    if (names.isEmpty()) {
      names.add(name(InetAddress.getLoopbackAddress()));
    }
  }

  /** Returns an address as links show it: an IPv6 address in brackets, without its zone. */
  private static String name(InetAddress address) {
    String text = address.getHostAddress();
    return address instanceof Inet4Address ? text : "[" + text.replaceFirst("%.*", "") + "]";
  }

  /**
   * Returns the host that a header {@code Host} names, in the form of {@link #names}.
   *
   * @param host a name or an address, in any form
   */
  public static String canonical(String host) {
    try {
      return parse(host);
    } catch (IllegalArgumentException | UnknownHostException e) {
      return "";
    }
  }

  /** Returns the address to listen on. */
  public InetAddress address() {
    return address;
  }

  /** Returns the names that browsers may use, the one for links first; IPv6 in brackets. */
  public List<String> names() {
    return names;
  }

  /** Returns whether only this computer reaches the address. */
  public boolean isLoopback() {
    return address.isLoopbackAddress();
  }
}
