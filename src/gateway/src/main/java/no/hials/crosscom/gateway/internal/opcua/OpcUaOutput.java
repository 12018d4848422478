package no.hials.crosscom.gateway.internal.opcua;

import static org.eclipse.milo.opcua.sdk.server.OpcUaServerConfig.USER_TOKEN_POLICY_ANONYMOUS;
import static org.eclipse.milo.opcua.stack.core.types.builtin.unsigned.Unsigned.uint;

import io.prometheus.metrics.core.metrics.Gauge;
import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.ScheduledThreadPoolExecutor;
import java.util.function.LongSupplier;
import no.hials.crosscom.cell.DaemonThreadFactory;
import no.hials.crosscom.cell.feed.RobotFeed;
import no.hials.crosscom.cell.feed.Update;
import no.hials.crosscom.gateway.GatewayContext;
import no.hials.crosscom.gateway.Output;
import org.eclipse.milo.opcua.sdk.core.AccessLevel;
import org.eclipse.milo.opcua.sdk.server.EndpointConfig;
import org.eclipse.milo.opcua.sdk.server.OpcUaServer;
import org.eclipse.milo.opcua.sdk.server.OpcUaServerConfig;
import org.eclipse.milo.opcua.sdk.server.Session;
import org.eclipse.milo.opcua.sdk.server.SessionListener;
import org.eclipse.milo.opcua.sdk.server.nodes.UaVariableNode;
import org.eclipse.milo.opcua.stack.core.NodeIds;
import org.eclipse.milo.opcua.stack.core.security.SecurityPolicy;
import org.eclipse.milo.opcua.stack.core.types.builtin.DateTime;
import org.eclipse.milo.opcua.stack.core.types.builtin.LocalizedText;
import org.eclipse.milo.opcua.stack.core.types.builtin.unsigned.UByte;
import org.eclipse.milo.opcua.stack.core.types.enumerated.MessageSecurityMode;
import org.eclipse.milo.opcua.stack.core.types.enumerated.UserTokenType;
import org.eclipse.milo.opcua.stack.core.types.structured.AccessLevelExType;
import org.eclipse.milo.opcua.stack.core.types.structured.BuildInfo;
import org.eclipse.milo.opcua.stack.core.types.structured.UserTokenPolicy;
import org.eclipse.milo.opcua.stack.transport.server.tcp.OpcTcpServerTransport;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** The server: its end points, its address space, and its sessions. */
final class OpcUaOutput implements Output {
  private static final Logger LOG = LoggerFactory.getLogger(OpcUaOutput.class);
  private static final String PRODUCT_URI = "urn:jopenshowvar:gateway";
  private static final List<SecurityPolicy> POLICIES =
      List.of(
          SecurityPolicy.Basic256Sha256,
          SecurityPolicy.Aes128_Sha256_RsaOaep,
          SecurityPolicy.Aes256_Sha256_RsaPss);

  private final OpcUaSettings settings;
  private final GatewayContext context;
  private final Users users;
  private final RobotWrites writes;
  private final Gauge sessions;
  private final Pki pki;
  private final int port;
  private final RequestThreads executor = new RequestThreads(DaemonThreadFactory.named("opcua"));
  private final ScheduledExecutorService timer = timer();
  private final Connections connections;
  private final OpcUaServer server;
  private final CompanionTypes types;
  private final RobotsNamespace namespace;
  private final Subscriptions subscriptions;

  /** Whether the server was started, also if it could not listen. */
  private volatile boolean started;

  private final Map<String, RobotNodes> robots = new ConcurrentHashMap<>();

  OpcUaOutput(OpcUaSettings settings, GatewayContext context) throws IOException {
    this(settings, context, System::nanoTime);
  }

  /**
   * Starts a server.
   *
   * @param nanoTime the time by which it ends connections that are not used
   */
  OpcUaOutput(OpcUaSettings settings, GatewayContext context, LongSupplier nanoTime)
      throws IOException {
    this.settings = settings;
    this.context = context;
    users =
        new Users(
            settings,
            context
                .health()
                .counter("opcua_logins_refused", "Log-ins that the OPC UA server has refused"));
    sessions = context.health().gauge("opcua_sessions", "Sessions of OPC UA clients");
    port = freePort();
    pki = Pki.open(context.folder().resolve("opcua").resolve("pki"), settings.host());
    writes = new RobotWrites(context);
    WriteOrder order = new WriteOrder(writes, executor);
    connections = new Connections(nanoTime);
    server =
        new OpcUaServer(
            config(),
            profile -> order.transport(new OpcTcpServerTransport(connections.transport(executor))));
    protectDiagnostics();
    connections.watch(server, users);
    server.addServiceSet("/", order.services(server));
    types = new CompanionTypes(server);
    namespace = new RobotsNamespace(server, types, writes, order);
    subscriptions = new Subscriptions(server);
    types.startup();
    namespace.startup();
    server.updateReferenceTypeTree();
    server.updateObjectTypeTree();
    server.getSessionManager().addSessionListener(new Sessions());
  }

  /**
   * Returns the configured port, or a free one for 0. Checks it here, because the server does not
   * report why it cannot listen.
   */
  private int freePort() throws IOException {
    try (ServerSocket socket =
        new ServerSocket(settings.port(), 1, InetAddress.getByName(settings.host()))) {
      return socket.getLocalPort();
    } catch (IOException e) {
      throw new IOException(
          "[opcua] cannot listen on "
              + settings.host()
              + ":"
              + settings.port()
              + ": "
              + e.getMessage(),
          e);
    }
  }

  /** Makes the switch of the diagnostics read-only, since Milo lets everybody write it. */
  private void protectDiagnostics() {
    server
        .getAddressSpaceManager()
        .getManagedNode(NodeIds.Server_ServerDiagnostics_EnabledFlag)
        .map(UaVariableNode.class::cast)
        .ifPresent(
            flag -> {
              UByte level = AccessLevel.toValue(AccessLevel.READ_ONLY);
              flag.setAccessLevel(level);
              flag.setUserAccessLevel(level);
              flag.setAccessLevelEx(new AccessLevelExType(uint(level.intValue())));
            });
  }

  @Override
  public void ready() throws IOException {
    started = true;
    try {
      server.startup().get();
      LOG.info("OPC UA: opc.tcp://{}:{}", settings.host(), port);
    } catch (ExecutionException e) {
      throw new IOException(
          "[opcua] cannot listen on " + settings.host() + ":" + port + ": is the port in use?", e);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new IOException("interrupted", e);
    }
  }

  /** Returns an executor for tasks at a time. That of Milo keeps sessions that have ended. */
  private static ScheduledExecutorService timer() {
    ScheduledThreadPoolExecutor timer =
        new ScheduledThreadPoolExecutor(2, DaemonThreadFactory.named("opcua-timer"));
    timer.setRemoveOnCancelPolicy(true);
    return timer;
  }

  private OpcUaServerConfig config() {
    return OpcUaServerConfig.builder()
        .setApplicationName(LocalizedText.english("JOpenShowVar gateway"))
        .setApplicationUri(pki.applicationUri())
        .setProductUri(PRODUCT_URI)
        .setBuildInfo(
            new BuildInfo(
                PRODUCT_URI, "JOpenShowVar", "JOpenShowVar gateway", version(), "", DateTime.now()))
        .setCertificateManager(pki.manager())
        .setIdentityValidator(users.validator())
        .setEndpoints(endpoints())
        .setExecutor(executor)
        .setScheduledExecutor(timer)
        .setLimits(new Subscriptions.Limits())
        .build();
  }

  private static String version() {
    String version = OpcUaOutput.class.getPackage().getImplementationVersion();
    return version == null ? "" : version;
  }

  private Set<EndpointConfig> endpoints() {
    Set<EndpointConfig> endpoints = new LinkedHashSet<>();
    for (SecurityPolicy policy : POLICIES) {
      endpoints.add(
          endpoint()
              .setSecurityPolicy(policy)
              .setSecurityMode(MessageSecurityMode.SignAndEncrypt)
              .build());
    }
    if (settings.allowNone()) {
      endpoints.add(endpoint().build());
    } else {
      // clients ask here for the other end points; it allows no sessions
      endpoints.add(endpoint().setPath("/discovery").build());
    }
    return endpoints;
  }

  private EndpointConfig.Builder endpoint() {
    String host = settings.host();
    boolean any = host.equals("0.0.0.0") || host.equals("::");
    return EndpointConfig.newBuilder()
        .setBindAddress(host)
        .setBindPort(port)
        .setHostname(any ? Pki.computerName() : host)
        .setPath("")
        .setCertificate(pki.certificate())
        .setSecurityPolicy(SecurityPolicy.None)
        .setSecurityMode(MessageSecurityMode.None)
        .addTokenPolicies(tokens().toArray(UserTokenPolicy[]::new));
  }

  private List<UserTokenPolicy> tokens() {
    List<UserTokenPolicy> tokens = new ArrayList<>();
    if (settings.anonymous()) {
      tokens.add(USER_TOKEN_POLICY_ANONYMOUS);
    }
    if (users.hasPasswords()) {
      tokens.add(token("username", UserTokenType.UserName));
    }
    if (users.hasCertificates()) {
      tokens.add(token("certificate", UserTokenType.Certificate));
    }
    return tokens;
  }

  /** Returns a way to log in that is encrypted even if the connection is not. */
  private static UserTokenPolicy token(String id, UserTokenType type) {
    return new UserTokenPolicy(id, type, null, null, SecurityPolicy.Basic256Sha256.getUri());
  }

  private final class Sessions implements SessionListener {
    @Override
    public void onSessionCreated(Session session) {
      sessions.set(sessions());
    }

    @Override
    public void onSessionClosed(Session session) {
      sessions.set(sessions());
      subscriptions.end(session);
      if (session.getIdentity() != null) {
        LOG.info("OPC UA: session {} has ended", LogIns.name(session));
      }
    }
  }

  /** Returns the port that it listens on. */
  int port() {
    return port;
  }

  /**
   * Returns the number of sessions. Milo does not report one that ends while its diagnostics are
   * being created.
   */
  int sessions() {
    return server.getSessionManager().getCurrentSessionCount().intValue();
  }

  /** Returns the number of nodes of robots. */
  int nodes() {
    return namespace.getNodeManager().getNodeIds().size();
  }

  /** Returns the number of references from and to the nodes of robots. */
  int references() {
    return namespace.getNodeManager().getReferenceMap().values().stream()
        .mapToInt(Collection::size)
        .sum();
  }

  @Override
  public void added(RobotFeed robot) {
    robots.put(robot.name(), new RobotNodes(namespace, robot, context));
  }

  @Override
  public void updated(RobotFeed robot, List<Update> updates) {
    RobotNodes nodes = robots.get(robot.name());
    if (nodes != null) {
      updates.forEach(nodes::put);
    }
  }

  @Override
  public void removed(RobotFeed robot) {
    RobotNodes nodes = robots.remove(robot.name());
    if (nodes != null) {
      nodes.remove();
    }
    writes.removed(robot.name());
  }

  @Override
  public void endWrites() {
    writes.close();
  }

  @Override
  public void close() {
    endWrites();
    subscriptions.shutdown();
    connections.shutdown();
    if (started) {
      server.shutdown().join();
    }
    namespace.shutdown();
    types.shutdown();
    timer.shutdownNow();
    executor.shutdown();
    sessions.set(0);
    try {
      pki.close();
    } catch (IOException e) {
      LOG.warn("OPC UA: {}", e.getMessage());
    }
    LOG.info("OPC UA: opc.tcp://{}:{} has ended", settings.host(), port);
  }
}
