package no.hials.crosscom.web.internal.http;

import java.net.InetSocketAddress;
import java.util.Locale;
import java.util.Set;
import org.eclipse.jetty.http.HttpHeader;
import org.eclipse.jetty.server.Request;

/**
 * Checks the names by which a browser calls this server. A page of another site can make the name
 * of its own host lead here (DNS rebinding); it cannot change the headers {@code Host} and {@code
 * Origin}.
 */
public final class HostCheck {
  private static final Set<String> LOOPBACK = Set.of("127.0.0.1", "localhost", "[::1]");

  private HostCheck() {}

  /** Returns whether the host is this one, and the origin, if there is one, is our own page. */
  static boolean isOurs(Request request) {
    String origin = request.getHeaders().get(HttpHeader.ORIGIN);
    return isOurHost(request) && (origin == null || isOurOrigin(request));
  }

  /** Returns whether a page of this server sent the request, as browsers say of a WebSocket. */
  public static boolean isOurOrigin(Request request) {
    String origin = request.getHeaders().get(HttpHeader.ORIGIN);
    String host = request.getHeaders().get(HttpHeader.HOST);
    return origin != null && origin.equalsIgnoreCase("http://" + host);
  }

  private static boolean isOurHost(Request request) {
    if (request.getHeaders().getValuesList(HttpHeader.HOST).size() != 1) {
      return false;
    }
    String host = request.getHeaders().get(HttpHeader.HOST).toLowerCase(Locale.ROOT);
    int port =
        ((InetSocketAddress) request.getConnectionMetaData().getLocalSocketAddress()).getPort();
    return LOOPBACK.stream().anyMatch(name -> host.equals(name + ":" + port))
        || (port == 80 && LOOPBACK.contains(host));
  }
}
