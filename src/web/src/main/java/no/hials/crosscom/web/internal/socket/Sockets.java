package no.hials.crosscom.web.internal.socket;

import com.fasterxml.jackson.databind.node.ObjectNode;
import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.Consumer;
import no.hials.crosscom.web.internal.http.BrowserSession;
import no.hials.crosscom.web.internal.http.HostCheck;
import no.hials.crosscom.web.internal.http.PageHandler;
import no.hials.crosscom.web.internal.http.Route;
import org.eclipse.jetty.http.HttpStatus;
import org.eclipse.jetty.server.Request;
import org.eclipse.jetty.server.Response;
import org.eclipse.jetty.server.Server;
import org.eclipse.jetty.util.Callback;
import org.eclipse.jetty.util.Fields;
import org.eclipse.jetty.websocket.server.ServerWebSocketContainer;

/** Opens the sockets of pages, and keeps track of the open sockets. */
public final class Sockets implements Route, AutoCloseable {
  /** The largest message of a page in bytes, large enough for a program of the robot. */
  static final int MAX_BYTES = 256 * 1024;

  private static final int MAX_SOCKETS = 256;

  /** Fewer than all, so that one browser does not shut out the others. */
  private static final int MAX_SOCKETS_OF_A_BROWSER = 64;

  /** A page sends a message every few seconds, even if it is hidden. */
  private static final Duration MAX_SILENCE = Duration.ofMinutes(2);

  private final ServerWebSocketContainer container;
  private final Commands commands;
  private final ExecutorService workers;
  private final Set<Viewer> viewers = ConcurrentHashMap.newKeySet();
  private final List<Consumer<Viewer>> atOpen = new CopyOnWriteArrayList<>();

  public Sockets(Server server, Commands commands) {
    container = ServerWebSocketContainer.ensure(server);
    container.setMaxTextMessageSize(MAX_BYTES);
    container.setMaxBinaryMessageSize(1);
    container.setMaxFrameSize(MAX_BYTES);
    container.setIdleTimeout(MAX_SILENCE);
    this.commands = commands;
    AtomicInteger number = new AtomicInteger();
    workers =
        Executors.newCachedThreadPool(
            task -> {
              Thread thread = new Thread(task, "web-command-" + number.incrementAndGet());
              thread.setDaemon(true);
              return thread;
            });
  }

  /** Adds a task that is called with each viewer whose socket opens. */
  public void atOpen(Consumer<Viewer> task) {
    atOpen.add(task);
  }

  /** Sends an event to all viewers, as {@link Viewer#send}. */
  public void broadcast(String key, ObjectNode event) {
    String text = event.toString();
    viewers.forEach(viewer -> viewer.sendText(key, text));
  }

  /** Closes the sockets of a browser whose session has ended. */
  public void end(BrowserSession browser) {
    viewers.stream()
        .filter(viewer -> viewer.browser() == browser)
        .forEach(viewer -> viewer.end("sent away"));
  }

  /** Returns the number of open sockets of a browser. */
  public long count(BrowserSession browser) {
    return viewers.stream().filter(viewer -> viewer.browser() == browser).count();
  }

  /** Returns the number of open sockets. */
  public int count() {
    return viewers.size();
  }

  /** Adds an open socket; returns why it cannot, or an empty text. */
  String add(Viewer viewer) {
    synchronized (viewers) {
      if (viewers.size() >= MAX_SOCKETS) {
        return "too many pages are open";
      }
      if (count(viewer.browser()) >= MAX_SOCKETS_OF_A_BROWSER) {
        return "this browser has " + MAX_SOCKETS_OF_A_BROWSER + " pages open already";
      }
      viewers.add(viewer);
    }
    atOpen.forEach(task -> task.accept(viewer));
    return "";
  }

  void remove(Viewer viewer) {
    viewers.remove(viewer);
  }

  @Override
  public boolean handle(
      BrowserSession browser, String rest, Request request, Response response, Callback callback) {
    Optional<String> page =
        Optional.ofNullable(Request.extractQueryParameters(request).get("page"))
            .map(Fields.Field::getValue);
    // a page of another site cannot read the token, and cannot forge its origin
    if (!rest.isEmpty()
        || !HostCheck.isOurOrigin(request)
        || page.filter(browser::hasPage).isEmpty()) {
      return PageHandler.refuse(
          response, callback, HttpStatus.FORBIDDEN_403, "Only our own page may open a socket.");
    }
    return container.upgrade(
        (upgrade, answer, unused) -> new Viewer(browser, commands, workers, this),
        request,
        response,
        callback);
  }

  @Override
  public void close() {
    workers.shutdownNow();
  }
}
