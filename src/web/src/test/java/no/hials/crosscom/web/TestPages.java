package no.hials.crosscom.web;

import java.io.IOException;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse;
import java.nio.file.Path;
import java.security.GeneralSecurityException;
import java.security.KeyStore;
import java.time.Clock;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import java.util.function.Consumer;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import javax.net.ssl.SSLContext;
import javax.net.ssl.TrustManagerFactory;
import no.hials.crosscom.cell.Robot;
import no.hials.crosscom.cell.RobotConnection;
import no.hials.crosscom.mock.Fault;
import no.hials.crosscom.mock.MockServer;
import no.hials.crosscom.protocol.ServerType;
import no.hials.crosscom.simulator.KrlFileException;

/** A web server with one simulated robot called {@code mock}, and browsers without a screen. */
public final class TestPages implements AutoCloseable {
  private static final Pattern TOKEN = Pattern.compile("socket-token\" content=\"([^\"]+)\"");

  private final HttpClient http;
  private final WebServer web;
  private final boolean simulated;
  private MockServer controller;

  /** Starts the simulated controller. */
  @FunctionalInterface
  private interface Simulation {
    MockServer start(ServerType type) throws IOException;
  }

  private TestPages(
      boolean simulated,
      ServerType type,
      Path folder,
      Simulation simulation,
      Consumer<WebConfig.Builder> settings,
      Clock clock)
      throws IOException {
    this.simulated = simulated;
    Robot robot = new Robot("mock", null, 0, null, null, type, null);
    WebConfig config =
        WebConfig.create(
            cfg ->
                settings.accept(
                    cfg.robots(List.of(robot))
                        .port(0)
                        .folder(folder)
                        .opener(
                            (one, client) -> {
                              controller = simulation.start(type);
                              return new RobotConnection(
                                  one,
                                  RobotConnection.open(
                                          one.at(controller.host(), controller.port()), client)
                                      .client(),
                                  simulated ? controller : null);
                            })));
    http = config.certificate().map(TestPages::trusting).orElseGet(HttpClient::newHttpClient);
    web = WebServer.start(config, clock);
  }

  /** Returns a client that trusts one certificate only. */
  private static HttpClient trusting(ServerCertificate certificate) {
    try {
      KeyStore trusted = KeyStore.getInstance("PKCS12");
      trusted.load(null, null);
      char[] password = {};
      trusted.setCertificateEntry("page", certificate.keyStore(password).getCertificate("page"));
      TrustManagerFactory managers =
          TrustManagerFactory.getInstance(TrustManagerFactory.getDefaultAlgorithm());
      managers.init(trusted);
      SSLContext context = SSLContext.getInstance("TLS");
      context.init(null, managers.getTrustManagers(), null);
      return HttpClient.newBuilder().sslContext(context).build();
    } catch (GeneralSecurityException | IOException e) {
      throw new AssertionError(e);
    }
  }

  /** Starts a server with a robot on C3 Bridge. */
  public static TestPages start(Path folder) throws IOException {
    return start(ServerType.C3_BRIDGE, folder, cfg -> {});
  }

  /** Starts a server with a robot. */
  public static TestPages start(ServerType type, Path folder, Consumer<WebConfig.Builder> settings)
      throws IOException {
    return new TestPages(true, type, folder, TestPages::simulate, settings, Clock.systemUTC());
  }

  /**
   * Starts a server with a robot that looks like a real one: of which it knows the address only.
   */
  public static TestPages startRemote(
      ServerType type, Path folder, Consumer<WebConfig.Builder> settings) throws IOException {
    return new TestPages(false, type, folder, TestPages::simulate, settings, Clock.systemUTC());
  }

  /** Starts a server with such a robot on C3 Bridge that has a data list before it connects. */
  public static TestPages startRemote(Path folder, String file, String list) throws IOException {
    return new TestPages(
        false,
        ServerType.C3_BRIDGE,
        folder,
        type -> {
          MockServer server = simulate(type);
          try {
            server.controller().load(file, list);
          } catch (KrlFileException e) {
            throw new IOException(e);
          }
          return server;
        },
        cfg -> {},
        Clock.systemUTC());
  }

  private static MockServer simulate(ServerType type) throws IOException {
    return MockServer.start(cfg -> cfg.server(type));
  }

  /** Starts a server with a robot on C3 Bridge, and a clock for the ends of links. */
  public static TestPages start(Path folder, Clock clock) throws IOException {
    return new TestPages(true, ServerType.C3_BRIDGE, folder, TestPages::simulate, cfg -> {}, clock);
  }

  /** Returns the simulated controller. */
  public MockServer controller() {
    return controller;
  }

  /**
   * Lets the controller not answer requests for a variable until it is released.
   *
   * @return counted down by the first of these requests
   */
  public CountDownLatch hold(String variable, CountDownLatch released) {
    CountDownLatch asked = new CountDownLatch(1);
    controller.fault(
        request -> {
          boolean held = request.names().contains(variable);
          if (held) {
            asked.countDown();
          }
          return held;
        },
        Fault.hold(released));
    return asked;
  }

  /** Returns the server under test. */
  public WebServer web() {
    return web;
  }

  /** Returns the address of a path. */
  public URI at(String path) {
    return URI.create(origin() + path);
  }

  /** Sends a request with headers, each a name and a value. */
  public HttpResponse<String> get(URI address, String... headers)
      throws IOException, InterruptedException {
    HttpRequest.Builder request = HttpRequest.newBuilder(address);
    if (headers.length > 0) {
      request.headers(headers);
    }
    return http.send(request.build(), HttpResponse.BodyHandlers.ofString());
  }

  /** Returns the cookie of a new browser that came by a link. */
  public String login(Role role) throws IOException, InterruptedException {
    String cookie =
        get(URI.create(web.link(role))).headers().firstValue("set-cookie").orElseThrow();
    return cookie.substring(0, cookie.indexOf(';'));
  }

  /** Returns the token for the socket of a page that a browser loads. */
  public String pageToken(String cookie) throws IOException, InterruptedException {
    Matcher token = TOKEN.matcher(get(at("/"), "Cookie", cookie).body());
    if (!token.find()) {
      throw new AssertionError("the page has no token");
    }
    return token.group(1);
  }

  /** Opens the socket of a new page in a new browser. */
  public TestSocket open(Role role) throws IOException, InterruptedException {
    return open(login(role));
  }

  /** Opens the socket of a new page in a browser. */
  public TestSocket open(String cookie) throws IOException, InterruptedException {
    return TestSocket.open(http, origin(), cookie, pageToken(cookie), origin());
  }

  /** Returns the origin of our own page. */
  public String origin() {
    return web.origin();
  }

  @Override
  public void close() throws IOException {
    web.close();
    if (!simulated) {
      controller.close();
    }
  }
}
