package no.hials.crosscom.web;

import java.io.IOException;
import java.net.BindException;
import java.time.Clock;
import java.util.ArrayList;
import java.util.List;
import no.hials.crosscom.cell.AuditLog;
import no.hials.crosscom.web.internal.access.AccessCommands;
import no.hials.crosscom.web.internal.audit.AuditCommands;
import no.hials.crosscom.web.internal.http.HostCheck;
import no.hials.crosscom.web.internal.http.PageHandler;
import no.hials.crosscom.web.internal.http.Tokens;
import no.hials.crosscom.web.internal.jog.JogCommands;
import no.hials.crosscom.web.internal.model.ModelCommands;
import no.hials.crosscom.web.internal.model.ShapeFiles;
import no.hials.crosscom.web.internal.programs.CheckCommands;
import no.hials.crosscom.web.internal.programs.InputOutputCommands;
import no.hials.crosscom.web.internal.programs.MessageCommands;
import no.hials.crosscom.web.internal.programs.PageProgramCommands;
import no.hials.crosscom.web.internal.recordings.RecordingCommands;
import no.hials.crosscom.web.internal.robot.RobotSessions;
import no.hials.crosscom.web.internal.socket.Commands;
import no.hials.crosscom.web.internal.socket.Sockets;
import no.hials.crosscom.web.internal.teach.TeachCommands;
import no.hials.crosscom.web.internal.variables.VariableCommands;
import no.hials.crosscom.web.internal.variables.WatchListCommands;
import org.eclipse.jetty.server.ConnectionFactory;
import org.eclipse.jetty.server.HttpConfiguration;
import org.eclipse.jetty.server.HttpConnectionFactory;
import org.eclipse.jetty.server.SecureRequestCustomizer;
import org.eclipse.jetty.server.Server;
import org.eclipse.jetty.server.ServerConnector;
import org.eclipse.jetty.server.SslConnectionFactory;
import org.eclipse.jetty.util.ssl.SslContextFactory;
import org.eclipse.jetty.util.thread.QueuedThreadPool;

/**
 * Serves the web page of some robots, on the loopback address or with TLS. It has one connection to
 * each robot, however many pages are open.
 */
public final class WebServer implements AutoCloseable {
  private static final int MAX_THREADS = 32;
  private static final int MAX_HEADER_BYTES = 8 * 1024;
  private static final long IDLE_MILLIS = 30_000;

  /** The password of a key store in memory, which nobody else reads. */
  private static final String PASSWORD = "in memory";

  private final PageAddress address;
  private final boolean secure;
  private final Server server;
  private final ServerConnector connector;
  private final Tokens tokens;

  /** The resources that are closed with the server, the last one first. */
  private final List<AutoCloseable> parts = new ArrayList<>();

  private WebServer(WebConfig config, Clock clock) throws IOException {
    QueuedThreadPool threads = new QueuedThreadPool(MAX_THREADS);
    threads.setName("web");
    threads.setDaemon(true);
    server = new Server(threads);
    address = config.address();
    tokens = new Tokens(clock);
    secure = config.certificate().isPresent();
    connector = connector(config);
    server.addConnector(connector);
    listen(); // before connecting to the robots, since another program may have the port
    parts.add(server::stop);
  }

  private void listen() throws IOException {
    try {
      connector.open();
    } catch (IOException e) { // Jetty puts its own text around the cause
      throw e.getCause() instanceof BindException cause ? cause : e;
    }
  }

  private ServerConnector connector(WebConfig config) {
    HttpConfiguration http = new HttpConfiguration();
    http.setSendServerVersion(false);
    http.setRequestHeaderSize(MAX_HEADER_BYTES);
    ServerConnector result =
        config
            .certificate()
            .map(it -> new ServerConnector(server, 1, 1, tls(it, http)))
            .orElseGet(() -> new ServerConnector(server, 1, 1, new HttpConnectionFactory(http)));
    result.setHost(config.address().address().getHostAddress());
    result.setPort(config.port());
    result.setIdleTimeout(IDLE_MILLIS);
    return result;
  }

  /** Returns the protocols of a server with a certificate, the first one first. */
  private static ConnectionFactory[] tls(ServerCertificate certificate, HttpConfiguration http) {
    SslContextFactory.Server context = new SslContextFactory.Server();
    context.setKeyStore(certificate.keyStore(PASSWORD.toCharArray()));
    context.setKeyStorePassword(PASSWORD);
    context.setIncludeProtocols("TLSv1.3", "TLSv1.2");
    context.setRenegotiationAllowed(false);
    // HostCheck compares the names; the browser judges a certificate that lacks one
    http.addCustomizer(new SecureRequestCustomizer(false));
    HttpConnectionFactory inner = new HttpConnectionFactory(http);
    return new ConnectionFactory[] {new SslConnectionFactory(context, inner.getProtocol()), inner};
  }

  /**
   * Connects to the robots and starts the server.
   *
   * @throws BindException if the port is in use
   * @throws IOException if a simulated robot cannot be started
   */
  public static WebServer start(WebConfig config) throws IOException {
    return start(config, Clock.systemUTC());
  }

  /** Starts the server with the clock by which links expire. */
  static WebServer start(WebConfig config, Clock clock) throws IOException {
    WebServer server = new WebServer(config, clock);
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
    PageHandler pages = new PageHandler(tokens, new HostCheck(address.names()));
    pages.add("/socket", sockets);
    server.setHandler(pages);
    server.setErrorHandler(PageHandler::error);
    sockets.atOpen(robots::show);
    String fingerprint = config.certificate().map(ServerCertificate::fingerprint).orElse("");
    List<String> origins = address.names().stream().map(this::origin).toList();
    new AccessCommands(tokens, sockets, audit, origins, address.isLoopback(), fingerprint)
        .addTo(commands);
    robots.addTo(commands);
    new AuditCommands(audit, sockets).addTo(commands);
    VariableCommands variables = new VariableCommands(robots, audit, sockets);
    variables.addTo(commands);
    variables.preload();
    new WatchListCommands(config.folder(), sockets).addTo(commands);
    ShapeFiles shapes = new ShapeFiles(config.shapes());
    pages.add("/shapes/", shapes);
    new ModelCommands(robots, shapes).addTo(commands);
    new TeachCommands(robots, audit, sockets).addTo(commands);
    RecordingCommands recordings = new RecordingCommands(config.folder(), robots, audit, sockets);
    parts.add(recordings);
    pages.add("/recordings/", recordings.files());
    recordings.addTo(commands);
    JogCommands jog = new JogCommands(robots, audit, sockets, config);
    parts.add(jog);
    sockets.atOpen(jog::show);
    jog.addTo(commands);
    new PageProgramCommands(robots, audit).addTo(commands);
    new MessageCommands(robots, audit).addTo(commands);
    new InputOutputCommands(robots, audit, variables::catalogue).addTo(commands);
    new CheckCommands(robots).addTo(commands);
    server.start();
  }

  /** Returns the port of the page. */
  public int port() {
    return connector.getLocalPort();
  }

  /** Returns a new link, which lets one browser in. */
  public String link(Role role) {
    return origin() + "/?token=" + tokens.newLink(role);
  }

  /** Returns the origin of the page, as browsers send it. */
  String origin() {
    return origin(address.names().get(0));
  }

  private String origin(String name) {
    return (secure ? "https://" : "http://") + name + ":" + port();
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
