package no.hials.crosscom.web;

import java.io.IOException;
import java.net.InetAddress;
import java.util.ArrayList;
import java.util.List;
import no.hials.crosscom.web.internal.audit.AuditCommands;
import no.hials.crosscom.web.internal.audit.AuditLog;
import no.hials.crosscom.web.internal.http.PageHandler;
import no.hials.crosscom.web.internal.http.Tokens;
import no.hials.crosscom.web.internal.jog.JogCommands;
import no.hials.crosscom.web.internal.model.ModelCommands;
import no.hials.crosscom.web.internal.model.ShapeFiles;
import no.hials.crosscom.web.internal.recordings.RecordingCommands;
import no.hials.crosscom.web.internal.robot.RobotSessions;
import no.hials.crosscom.web.internal.socket.Commands;
import no.hials.crosscom.web.internal.socket.Sockets;
import no.hials.crosscom.web.internal.teach.TeachCommands;
import no.hials.crosscom.web.internal.variables.VariableCommands;
import no.hials.crosscom.web.internal.variables.WatchListCommands;
import org.eclipse.jetty.server.HttpConfiguration;
import org.eclipse.jetty.server.HttpConnectionFactory;
import org.eclipse.jetty.server.Server;
import org.eclipse.jetty.server.ServerConnector;
import org.eclipse.jetty.util.thread.QueuedThreadPool;

/**
 * Serves the web page of some robots on the loopback address. It has one connection to each robot,
 * however many pages are open.
 */
public final class WebServer implements AutoCloseable {
  private static final int MOST_THREADS = 32;
  private static final int MOST_HEADER_BYTES = 8 * 1024;
  private static final long IDLE_MILLIS = 30_000;

  private final Server server;
  private final ServerConnector connector;
  private final Tokens tokens = new Tokens();

  /** The resources that are closed with the server, the last one first. */
  private final List<AutoCloseable> parts = new ArrayList<>();

  private WebServer(WebConfig config) throws IOException {
    QueuedThreadPool threads = new QueuedThreadPool(MOST_THREADS);
    threads.setName("web");
    threads.setDaemon(true);
    server = new Server(threads);
    connector = connector(config.port());
    server.addConnector(connector);
    connector.open(); // before the robots are asked, since another program may have the port
    parts.add(server::stop);
  }

  private ServerConnector connector(int port) {
    HttpConfiguration http = new HttpConfiguration();
    http.setSendServerVersion(false);
    http.setRequestHeaderSize(MOST_HEADER_BYTES);
    ServerConnector result = new ServerConnector(server, 1, 1, new HttpConnectionFactory(http));
    result.setHost(InetAddress.getLoopbackAddress().getHostAddress());
    result.setPort(port);
    result.setIdleTimeout(IDLE_MILLIS);
    return result;
  }

  /**
   * Connects to the robots and starts the server.
   *
   * @throws IOException if the port is in use, or a simulated robot cannot be started
   */
  public static WebServer start(WebConfig config) throws IOException {
    WebServer server = new WebServer(config);
    try {
      server.run(config);
      return server;
    } catch (IOException | RuntimeException e) {
      server.close();
      throw e;
    } catch (Exception e) {
      server.close();
      throw new IOException(e);
    }
  }

  private void run(WebConfig config) throws Exception {
    AuditLog audit = new AuditLog(config.folder());
    RobotSessions robots = RobotSessions.open(config, audit);
    parts.add(robots);
    Commands commands = new Commands();
    Sockets sockets = new Sockets(server, commands);
    parts.add(sockets);
    PageHandler pages = new PageHandler(tokens);
    pages.add("/socket", sockets);
    server.setHandler(pages);
    sockets.atOpen(robots::show);
    // a feature adds its commands here
    robots.addTo(commands);
    new AuditCommands(audit, sockets).addTo(commands);
    VariableCommands variables = new VariableCommands(robots, audit, sockets);
    variables.addTo(commands);
    variables.preload();
    new WatchListCommands(config.folder(), sockets).addTo(commands);
    ShapeFiles shapes = new ShapeFiles(config.shapes());
    pages.add("/shapes/", shapes);
    new ModelCommands(robots, shapes).addTo(commands);
    new TeachCommands(robots, audit).addTo(commands);
    RecordingCommands recordings = new RecordingCommands(config.folder(), robots, audit, sockets);
    parts.add(recordings);
    pages.add("/recordings/", recordings.files());
    recordings.addTo(commands);
    JogCommands jog = new JogCommands(robots, audit, sockets, config);
    parts.add(jog);
    sockets.atOpen(jog::show);
    jog.addTo(commands);
    server.start();
  }

  /** Returns the port on the loopback address. */
  public int port() {
    return connector.getLocalPort();
  }

  /** Returns a new link, which lets one browser in. */
  public String link(Role role) {
    return "http://" + connector.getHost() + ":" + port() + "/?token=" + tokens.newLink(role);
  }

  @Override
  public void close() throws IOException {
    IOException failure = null;
    for (int i = parts.size() - 1; i >= 0; i--) {
      try {
        parts.get(i).close();
      } catch (IOException e) {
        failure = e;
      } catch (Exception e) {
        failure = new IOException(e);
      }
    }
    parts.clear();
    if (failure != null) {
      throw failure;
    }
  }
}
