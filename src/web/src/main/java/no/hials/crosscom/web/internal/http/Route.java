package no.hials.crosscom.web.internal.http;

import org.eclipse.jetty.server.Request;
import org.eclipse.jetty.server.Response;
import org.eclipse.jetty.util.Callback;

/** Answers the requests below one path, such as downloads. The browser has a session. */
@FunctionalInterface
public interface Route {
  /**
   * Answers a request, or returns false if there is nothing at its path.
   *
   * @param rest the path after that of the route
   */
  boolean handle(
      BrowserSession browser, String rest, Request request, Response response, Callback callback)
      throws Exception;
}
