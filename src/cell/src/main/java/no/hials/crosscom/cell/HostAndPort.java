package no.hials.crosscom.cell;

import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.jspecify.annotations.Nullable;

/**
 * The address of a controller as users write it: {@code HOST}, {@code HOST:PORT}, an IPv6 address,
 * or {@code [IPV6]:PORT}.
 *
 * @param host name or address, without brackets
 * @param port the port; null if the text names none
 */
public record HostAndPort(String host, @Nullable Integer port) {
  /** An IPv6 address needs brackets before a port, since it has colons itself. */
  private static final Pattern WITH_PORT = Pattern.compile("([^:]*|\\[.*]):([^:/]+)");

  /** A name or an IPv4 address, or an IPv6 address, which has two colons at least. */
  private static final Pattern HOST =
      Pattern.compile("[^\\s/:\\[\\]]+|(?=.*:.*:)[\\p{XDigit}:.]+(?:%[^\\s/:]+)?");

  /**
   * Parses a text.
   *
   * @throws IllegalArgumentException if it has another form, or the port is not 1 to 65535
   */
  public static HostAndPort parse(String text) {
    Matcher form = WITH_PORT.matcher(text);
    String host = form.matches() ? form.group(1) : text;
    if (host.startsWith("[") && host.endsWith("]")) {
      host = host.substring(1, host.length() - 1);
    }
    if (!HOST.matcher(host).matches()) {
      throw new IllegalArgumentException(
          "must be HOST, HOST:PORT or [IPV6]:PORT, is '" + text + "'");
    }
    return new HostAndPort(host, form.matches() ? port(form.group(2)) : null);
  }

  /**
   * Parses an address to listen on.
   *
   * @param usual the port if the text names none; the port 0 in the text is a free one
   * @throws IllegalArgumentException if it has another form, or the port is not 0 to 65535
   */
  public static HostAndPort listening(String text, int usual) {
    if (text.matches("\\d+")) {
      // Java would take the number for an address
      throw new IllegalArgumentException(
          "must be HOST or HOST:PORT, such as 127.0.0.1:" + text + ", is '" + text + "'");
    }
    if (text.endsWith(":0")) {
      return new HostAndPort(parse(text.substring(0, text.length() - 2)).host(), 0);
    }
    HostAndPort parsed = parse(text);
    return new HostAndPort(parsed.host(), parsed.portOr(null, usual));
  }

  private static int port(String text) {
    try {
      return SettingText.port(text);
    } catch (IllegalArgumentException e) {
      throw new IllegalArgumentException("the port " + e.getMessage(), e);
    }
  }

  /**
   * Returns the port, which the text or another setting names.
   *
   * @param other the port of the other setting; null if it names none
   * @param usual the port if neither names one
   * @throws IllegalArgumentException if both name a port, and they differ
   */
  public int portOr(@Nullable Integer other, int usual) {
    if (port != null && other != null && !port.equals(other)) {
      throw new IllegalArgumentException(
          "names the port " + port + ", but the port is set to " + other);
    }
    return port != null ? port : other != null ? other : usual;
  }
}
