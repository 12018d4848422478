package no.hials.crosscom.web.internal.http;

import java.net.InetSocketAddress;
import java.util.Collection;
import java.util.List;
import java.util.Set;
import no.hials.crosscom.web.PageAddress;
import org.eclipse.jetty.http.HttpHeader;
import org.eclipse.jetty.http.HttpScheme;
import org.eclipse.jetty.server.Request;

/**
 * Checks the names by which a browser calls this server. Another site can make its host name point
 * to this server (DNS rebinding), but its pages cannot change the headers {@code Host} and {@code
 * Origin}.
 */
public final class HostCheck {
  private static final Set<String> LOOPBACK =
      Set.of("127.0.0.1", "localhost", PageAddress.canonical("[::1]"));

  private final Set<String> names;

  /**
   * Creates a check.
   *
   * @param names the names of this server; on the loopback address its usual names are always
   *     allowed
   */
  public HostCheck(Collection<String> names) {
    this.names = Set.copyOf(names);
  }

  /** Returns whether the host is this server, and the origin, if there is one, our own page. */
  boolean isOurs(Request request) {
    String origin = request.getHeaders().get(HttpHeader.ORIGIN);
    return isOurHost(request) && (origin == null || isOurOrigin(request));
  }

  /** Returns whether a page of this server sent the request, by the origin that browsers send. */
  public static boolean isOurOrigin(Request request) {
    String origin = request.getHeaders().get(HttpHeader.ORIGIN);
    String host = request.getHeaders().get(HttpHeader.HOST);
    return origin != null && origin.equalsIgnoreCase(scheme(request).asString() + "://" + host);
  }

  private static HttpScheme scheme(Request request) {
    return request.isSecure() ? HttpScheme.HTTPS : HttpScheme.HTTP;
  }

  private boolean isOurHost(Request request) {
    List<String> hosts = request.getHeaders().getValuesList(HttpHeader.HOST);
    if (hosts.size() != 1) {
      return false;
    }
    String host = hosts.get(0);
    InetSocketAddress local = local(request);
    String port = ":" + local.getPort();
    if (host.endsWith(port)) {
      host = host.substring(0, host.length() - port.length());
    } else if (local.getPort() != scheme(request).getDefaultPort()) {
      return false;
    }
    String name = PageAddress.canonical(host);
    return names.contains(name)
        || (local.getAddress().isLoopbackAddress() && LOOPBACK.contains(name));
  }

  static InetSocketAddress local(Request request) {
    return (InetSocketAddress) request.getConnectionMetaData().getLocalSocketAddress();
  }
}
