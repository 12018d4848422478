package no.hials.crosscom.web.internal.http;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import org.eclipse.jetty.http.HttpCookie;
import org.eclipse.jetty.http.HttpField;
import org.eclipse.jetty.http.HttpFields;
import org.eclipse.jetty.http.HttpHeader;
import org.eclipse.jetty.http.HttpMethod;
import org.eclipse.jetty.http.HttpStatus;
import org.eclipse.jetty.server.Handler;
import org.eclipse.jetty.server.Request;
import org.eclipse.jetty.server.Response;
import org.eclipse.jetty.util.Callback;
import org.eclipse.jetty.util.Fields;

/**
 * Serves the page: turns the token of a link into a session, and sends files to browsers with a
 * session.
 */
public final class PageHandler extends Handler.Abstract {
  private static final String TOKEN = "token";
  private static final String NO_SESSION =
      "This browser has no session. Open the link that 'jopenshowvar web' has printed, or ask"
          + " somebody with an open page for a link; each link works once.";
  private static final String HAS_SESSION =
      "This browser is already let in: open the address without '?token=...'.";

  /**
   * The answer to a link. A redirect would not work: after a link on another site, such as a web
   * mail, browsers send the cookie only when our own page loads the next one.
   */
  private static final String ENTRANCE =
      """
      <!DOCTYPE html>
      <html lang="en">
      <meta charset="utf-8">
      <meta http-equiv="refresh" content="0; url=/">
      <link rel="icon" href="/icon.svg" type="image/svg+xml">
      <title>JOpenShowVar</title>
      <a href="/">Open the page</a>
      """;

  private final Tokens tokens;
  private final HostCheck hosts;
  private final PageFiles files = new PageFiles();
  private final String policy;

  /** The routes by their paths. */
  private final Map<String, Route> routes = new LinkedHashMap<>();

  public PageHandler(Tokens tokens, HostCheck hosts) throws IOException {
    this.tokens = tokens;
    this.hosts = hosts;
    policy =
        "default-src 'none'; script-src 'self' 'sha256-"
            + files.importMapHash()
            + "'; style-src 'self'; connect-src 'self'; img-src 'self' data: blob:;"
            + " base-uri 'none'; form-action 'none'; frame-ancestors 'none'";
  }

  /**
   * Adds a route.
   *
   * @param path its path, or the beginning of its paths with a final slash: {@code /recordings/}
   */
  public void add(String path, Route route) {
    routes.put(path, route);
  }

  @Override
  public boolean handle(Request request, Response response, Callback callback) throws Exception {
    protect(response.getHeaders());
    if (!hosts.isOurs(request)) {
      return refuse(response, callback, HttpStatus.FORBIDDEN_403, "Not the host of this page.");
    }
    String path = Request.getPathInContext(request);
    if (path.equals("/") && HttpMethod.GET.is(request.getMethod())) {
      Fields.Field token = Request.extractQueryParameters(request).get(TOKEN);
      if (token != null) {
        return open(request, response, callback, token.getValue());
      }
    }
    Optional<BrowserSession> browser = session(request);
    if (browser.isEmpty()) {
      return refuse(response, callback, HttpStatus.FORBIDDEN_403, NO_SESSION);
    }
    for (Map.Entry<String, Route> route : routes.entrySet()) {
      String start = route.getKey();
      if (start.endsWith("/") ? path.startsWith(start) : path.equals(start)) {
        String rest = path.substring(start.length());
        return route.getValue().handle(browser.get(), rest, request, response, callback)
            || refuse(response, callback, HttpStatus.NOT_FOUND_404, "There is no such file.");
      }
    }
    if (!HttpMethod.GET.is(request.getMethod())) {
      return refuse(response, callback, HttpStatus.METHOD_NOT_ALLOWED_405, "Only GET is allowed.");
    }
    return path.equals("/")
        ? index(browser.get(), response, callback)
        : file(path, request, response, callback);
  }

  /** Sets the headers that keep foreign content out of the page. */
  private void protect(HttpFields.Mutable headers) {
    headers.put("Content-Security-Policy", policy);
    headers.put("X-Content-Type-Options", "nosniff");
    headers.put("Referrer-Policy", "no-referrer");
    headers.put("Cross-Origin-Opener-Policy", "same-origin");
    headers.put("Cross-Origin-Resource-Policy", "same-origin");
    headers.put(HttpHeader.CACHE_CONTROL, "no-store");
  }

  /** Turns the token of a link into the cookie of a session. */
  private boolean open(Request request, Response response, Callback callback, String token) {
    Optional<String> key = tokens.open(token);
    if (key.isEmpty()) {
      String reason =
          "This link is not valid, is too old, or was used before. "
              + (session(request).isEmpty() ? NO_SESSION : HAS_SESSION);
      return refuse(response, callback, HttpStatus.FORBIDDEN_403, reason);
    }
    HttpCookie cookie =
        HttpCookie.build(cookieName(request), key.get())
            .path("/")
            .httpOnly(true)
            .sameSite(HttpCookie.SameSite.STRICT)
            .secure(request.isSecure())
            .build();
    Response.addCookie(response, cookie);
    html(ENTRANCE, response, callback);
    return true;
  }

  private static void html(String page, Response response, Callback callback) {
    response.getHeaders().put(HttpHeader.CONTENT_TYPE, "text/html; charset=utf-8");
    response.write(true, ByteBuffer.wrap(page.getBytes(StandardCharsets.UTF_8)), callback);
  }

  /** Returns the name of the cookie. Browsers share cookies between all ports of a host. */
  private static String cookieName(Request request) {
    String name = "jopenshowvar-" + HostCheck.local(request).getPort();
    // the prefix keeps a server without TLS on this host from setting the cookie
    return request.isSecure() ? "__Host-" + name : name;
  }

  /** Returns the session of the browser that sent a request. */
  public Optional<BrowserSession> session(Request request) {
    String name = cookieName(request);
    return Request.getCookies(request).stream()
        .filter(cookie -> cookie.getName().equals(name))
        .findFirst()
        .flatMap(cookie -> tokens.session(cookie.getValue()));
  }

  private boolean index(BrowserSession browser, Response response, Callback callback) {
    html(files.index(browser.newPage()), response, callback);
    return true;
  }

  private boolean file(String path, Request request, Response response, Callback callback)
      throws IOException {
    Optional<PageFile> found = files.find(path);
    if (found.isEmpty()) {
      return refuse(response, callback, HttpStatus.NOT_FOUND_404, "There is no such file.");
    }
    PageFile file = found.get();
    HttpFields.Mutable headers = response.getHeaders();
    headers.put(HttpHeader.CACHE_CONTROL, "no-cache"); // browsers ask, and usually get a 304
    headers.put(HttpHeader.ETAG, file.tag());
    headers.put(HttpHeader.VARY, "Accept-Encoding");
    if (file.tag().equals(request.getHeaders().get(HttpHeader.IF_NONE_MATCH))) {
      response.setStatus(HttpStatus.NOT_MODIFIED_304);
      callback.succeeded();
      return true;
    }
    headers.put(HttpHeader.CONTENT_TYPE, file.type());
    HttpField accepted = request.getHeaders().getField(HttpHeader.ACCEPT_ENCODING);
    boolean zipped = accepted != null && accepted.contains("gzip");
    if (zipped) {
      headers.put(HttpHeader.CONTENT_ENCODING, "gzip");
    }
    response.write(true, file.content(zipped), callback);
    return true;
  }

  /** Answers a request that Jetty refuses or that fails, without any details. */
  public static boolean error(Request request, Response response, Callback callback) {
    HttpFields.Mutable headers = response.getHeaders();
    headers.put("Content-Security-Policy", "default-src 'none'");
    headers.put("X-Content-Type-Options", "nosniff");
    return refuse(response, callback, response.getStatus(), "The request cannot be answered.");
  }

  /** Answers with a sentence in plain text. */
  public static boolean refuse(Response response, Callback callback, int status, String reason) {
    response.setStatus(status);
    response.getHeaders().put(HttpHeader.CONTENT_TYPE, "text/plain; charset=utf-8");
    byte[] text = (reason + "\n").getBytes(StandardCharsets.UTF_8);
    response.write(true, ByteBuffer.wrap(text), callback);
    return true;
  }
}
