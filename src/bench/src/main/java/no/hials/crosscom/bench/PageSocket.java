package no.hials.crosscom.bench;

import java.io.IOException;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse;
import java.net.http.WebSocket;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** Opens the socket of the web page, as a browser does. */
final class PageSocket {
  private static final Pattern TOKEN = Pattern.compile("socket-token\" content=\"([^\"]+)\"");

  private PageSocket() {}

  /** Loads the page by a link, and opens its socket, which may go through a proxy. */
  static WebSocket open(
      HttpClient http, HttpClient proxied, String link, WebSocket.Listener listener)
      throws IOException, InterruptedException {
    URI address = URI.create(link);
    String cookie =
        http.send(HttpRequest.newBuilder(address).build(), HttpResponse.BodyHandlers.discarding())
            .headers()
            .firstValue("set-cookie")
            .orElseThrow()
            .replaceFirst(";.*", "");
    HttpResponse<String> page =
        http.send(
            HttpRequest.newBuilder(address.resolve("/")).header("Cookie", cookie).build(),
            HttpResponse.BodyHandlers.ofString());
    Matcher token = TOKEN.matcher(page.body());
    if (!token.find()) {
      throw new IOException("the page has no token for its socket");
    }
    return proxied
        .newWebSocketBuilder()
        .header("Cookie", cookie)
        .header("Origin", "http://" + address.getAuthority())
        .buildAsync(
            URI.create("ws://" + address.getAuthority() + "/socket?page=" + token.group(1)),
            listener)
        .join();
  }
}
