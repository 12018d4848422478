package no.hials.crosscom.web.internal.model;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import no.hials.crosscom.web.internal.http.BrowserSession;
import no.hials.crosscom.web.internal.http.PageHandler;
import no.hials.crosscom.web.internal.http.Route;
import org.eclipse.jetty.http.HttpHeader;
import org.eclipse.jetty.http.HttpMethod;
import org.eclipse.jetty.http.HttpStatus;
import org.eclipse.jetty.io.Content;
import org.eclipse.jetty.server.Request;
import org.eclipse.jetty.server.Response;
import org.eclipse.jetty.util.Callback;

/**
 * Serves the shapes of the robot's links from a folder, one STL file per link
 * (docs/reference/robots.md#shapes). Every role may load them.
 */
public final class ShapeFiles implements Route {
  static final List<String> LINKS = List.of("base", "a1", "a2", "a3", "a4", "a5", "a6", "tool");

  /** The largest file, which a browser reads without a noticeable pause. */
  static final long MAX_BYTES = 8L * 1024 * 1024;

  private static final String SUFFIX = ".stl";

  private final Optional<Path> folder;

  public ShapeFiles(Optional<Path> folder) {
    this.folder = folder;
  }

  /** Returns the links that have a file. */
  List<String> links() {
    return LINKS.stream().filter(link -> file(link).isPresent()).toList();
  }

  /** Returns the file of a link; empty without one. */
  private Optional<Path> file(String link) {
    // only the names of links, so that no path leads out of the folder
    return LINKS.contains(link)
        ? folder.map(it -> it.resolve(link + SUFFIX)).filter(Files::isRegularFile)
        : Optional.empty();
  }

  @Override
  public boolean handle(
      BrowserSession browser, String rest, Request request, Response response, Callback callback)
      throws IOException {
    Optional<Path> file =
        rest.endsWith(SUFFIX)
            ? file(rest.substring(0, rest.length() - SUFFIX.length()))
            : Optional.empty();
    if (file.isEmpty() || !HttpMethod.GET.is(request.getMethod())) {
      return false;
    }
    long bytes = Files.size(file.get());
    if (bytes > MAX_BYTES) {
      String reason = rest + " may have at most " + MAX_BYTES + " bytes, has " + bytes;
      return PageHandler.refuse(response, callback, HttpStatus.PAYLOAD_TOO_LARGE_413, reason);
    }
    response.getHeaders().put(HttpHeader.CONTENT_TYPE, "model/stl");
    Content.copy(Content.Source.from(file.get()), response, callback);
    return true;
  }
}
