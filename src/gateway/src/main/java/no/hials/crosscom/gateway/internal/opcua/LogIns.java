package no.hials.crosscom.gateway.internal.opcua;

import static org.eclipse.milo.opcua.stack.core.types.builtin.unsigned.Unsigned.uint;

import io.netty.channel.Channel;
import java.net.InetAddress;
import java.time.Duration;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.Semaphore;
import java.util.concurrent.TimeUnit;
import java.util.function.LongSupplier;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import org.eclipse.milo.opcua.sdk.server.OpcUaServer;
import org.eclipse.milo.opcua.sdk.server.Session;
import org.eclipse.milo.opcua.sdk.server.SessionListener;
import org.eclipse.milo.opcua.sdk.server.servicesets.impl.DefaultSessionServiceSet;
import org.eclipse.milo.opcua.stack.core.StatusCodes;
import org.eclipse.milo.opcua.stack.core.UaException;
import org.eclipse.milo.opcua.stack.core.types.builtin.DateTime;
import org.eclipse.milo.opcua.stack.core.types.builtin.NodeId;
import org.eclipse.milo.opcua.stack.core.types.structured.ActivateSessionRequest;
import org.eclipse.milo.opcua.stack.core.types.structured.ActivateSessionResponse;
import org.eclipse.milo.opcua.stack.core.types.structured.CloseSessionRequest;
import org.eclipse.milo.opcua.stack.core.types.structured.CloseSessionResponse;
import org.eclipse.milo.opcua.stack.core.types.structured.CreateSessionRequest;
import org.eclipse.milo.opcua.stack.core.types.structured.CreateSessionResponse;
import org.eclipse.milo.opcua.stack.core.types.structured.RequestHeader;
import org.eclipse.milo.opcua.stack.transport.server.ServiceRequestContext;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Answers each log-in, and ends sessions that are not logged in: Milo counts them as all others, so
 * that a client without a user could keep out the users. Thread-safe.
 */
final class LogIns extends DefaultSessionServiceSet {
  private static final Logger LOG = LoggerFactory.getLogger(LogIns.class);

  /** The maximum length of the name of a session: Milo cannot report a longer one. */
  private static final int LONGEST_NAME = 512;

  private static final Duration LONGEST_REPORT = Duration.ofSeconds(5);

  private final OpcUaServer server;
  private final Users users;
  private final LongSupplier nanoTime;

  /** The sessions that are not logged in, by their tokens. */
  private final Map<NodeId, Waiting> waiting = new ConcurrentHashMap<>();

  /** The connections with a step of a log-in, or of its end, that is not answered. */
  private final Set<Channel> busy = ConcurrentHashMap.newKeySet();

  /** For sessions that are being reported to Milo's listeners. */
  private final Semaphore turns = new Semaphore(4, true);

  /** These sessions, by their ids. */
  private final Map<NodeId, CompletableFuture<Void>> reports = new ConcurrentHashMap<>();

  /**
   * A session that is not logged in.
   *
   * @param context the request that has created it
   */
  private record Waiting(NodeId token, ServiceRequestContext context, long since) {}

  LogIns(OpcUaServer server, Users users, LongSupplier nanoTime) {
    super(server);
    this.server = server;
    this.users = users;
    this.nanoTime = nanoTime;
    server
        .getSessionManager()
        .addSessionListener(
            new SessionListener() {
              @Override
              public void onSessionCreated(Session session) {
                report(session.getSessionId()).complete(null);
              }
            });
  }

  /** A step of a log-in, or of its end. */
  private interface Step<T> {
    T run() throws UaException;
  }

  /**
   * Runs a step if its connection has no other one: clients wait for the answer, and a flood of
   * log-ins over one connection must not occupy the threads and keep out the others.
   */
  private <T> T only(ServiceRequestContext context, Step<T> step) throws UaException {
    if (!busy.add(context.getChannel())) {
      throw new UaException(StatusCodes.Bad_TooManyOperations);
    }
    try {
      return step.run();
    } catch (RuntimeException e) {
      throw new UaException(StatusCodes.Bad_InvalidArgument, e);
    } finally {
      busy.remove(context.getChannel());
    }
  }

  @Override
  public CreateSessionResponse onCreateSession(
      ServiceRequestContext context, CreateSessionRequest request) throws UaException {
    return only(context, () -> createInTurn(context, request));
  }

  /**
   * Creates a session, and answers when it is reported, with few others at a time. Milo creates the
   * diagnostics of one session after the other then, and keeps all that wait for it, also those
   * that have ended.
   */
  private CreateSessionResponse createInTurn(
      ServiceRequestContext context, CreateSessionRequest request) throws UaException {
    String name = request.getSessionName();
    if (name != null && name.length() > LONGEST_NAME) {
      throw new UaException(StatusCodes.Bad_InvalidArgument);
    }
    turns.acquireUninterruptibly();
    try {
      if (!context.getChannel().isOpen()) {
        throw new UaException(StatusCodes.Bad_ConnectionClosed);
      }
      CreateSessionResponse response = create(context, request);
      awaitReport(response.getSessionId());
      // nobody can end it before
      NodeId token = response.getAuthenticationToken();
      waiting.put(token, new Waiting(token, context, nanoTime.getAsLong()));
      return response;
    } finally {
      turns.release();
    }
  }

  private void awaitReport(NodeId session) {
    report(session)
        .completeOnTimeout(null, LONGEST_REPORT.toMillis(), TimeUnit.MILLISECONDS)
        .join();
    reports.remove(session);
  }

  /** Returns the future that completes when a session has been reported. */
  private CompletableFuture<Void> report(NodeId session) {
    return reports.computeIfAbsent(session, it -> new CompletableFuture<>());
  }

  private synchronized CreateSessionResponse create(
      ServiceRequestContext context, CreateSessionRequest request) throws UaException {
    endAll(it -> it.context().getChannel().equals(context.getChannel()));
    long limit = server.getConfig().getLimits().getMaxSessions().longValue();
    while (server.getSessionManager().getCurrentSessionCount().longValue() >= limit
        && !waiting.isEmpty()) {
      end(oldestOfMost());
    }
    return super.onCreateSession(context, request);
  }

  /** Returns the oldest session of the addresses that have most of those that are not logged in. */
  private Waiting oldestOfMost() {
    Map<InetAddress, List<Waiting>> addresses =
        waiting.values().stream()
            .collect(Collectors.groupingBy(it -> it.context().clientAddress()));
    int most = addresses.values().stream().mapToInt(List::size).max().orElseThrow();
    return addresses.values().stream()
        .filter(it -> it.size() == most)
        .flatMap(List::stream)
        .min(Comparator.comparing(Waiting::since))
        .orElseThrow();
  }

  // Milo would never remove a session that is closed during its log-in, so only one runs at a time

  @Override
  public CloseSessionResponse onCloseSession(
      ServiceRequestContext context, CloseSessionRequest request) throws UaException {
    return only(context, () -> close(context, request));
  }

  private synchronized CloseSessionResponse close(
      ServiceRequestContext context, CloseSessionRequest request) throws UaException {
    CloseSessionResponse response = super.onCloseSession(context, request);
    waiting.remove(request.getRequestHeader().getAuthenticationToken());
    return response;
  }

  @Override
  public ActivateSessionResponse onActivateSession(
      ServiceRequestContext context, ActivateSessionRequest request) throws UaException {
    return only(context, () -> activate(context, request));
  }

  private synchronized ActivateSessionResponse activate(
      ServiceRequestContext context, ActivateSessionRequest request) throws UaException {
    ActivateSessionResponse response;
    try {
      response = super.onActivateSession(context, request);
    } catch (RuntimeException e) {
      users.refuse(
          context.clientAddress(),
          "a client with an invalid log-in (" + Users.printable(e.toString()) + ")");
      throw new UaException(StatusCodes.Bad_IdentityTokenInvalid, e);
    }
    if (waiting.remove(request.getRequestHeader().getAuthenticationToken()) != null) {
      Session session = server.getSessionManager().getSession(context, request.getRequestHeader());
      LOG.info("OPC UA: session {} from {}", name(session), session.getClientAddress());
    }
    Connections.loggedIn(context);
    return response;
  }

  /** Returns the name that the client of a session has chosen, for the log. */
  static String name(Session session) {
    String name = session.getSessionName();
    return name == null ? "" : Users.printable(name);
  }

  /** Ends the sessions without a connection, and those that wait longer than a time. */
  synchronized void endUnused(Duration longest) {
    long now = nanoTime.getAsLong();
    endAll(it -> !it.context().getChannel().isOpen() || now - it.since() > longest.toNanos());
  }

  private void endAll(Predicate<Waiting> condition) {
    waiting.values().stream().filter(condition).forEach(this::end);
  }

  /** Ends a session as if its client did. */
  private void end(Waiting session) {
    if (waiting.remove(session.token()) == null) {
      return;
    }
    RequestHeader header =
        new RequestHeader(session.token(), DateTime.now(), uint(0), uint(0), "", uint(0), null);
    try {
      close(session.context(), new CloseSessionRequest(header, true));
    } catch (UaException e) {
      // its client or its time-out has ended it
    }
  }
}
