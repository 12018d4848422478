package no.hials.crosscom.mock;

import java.io.IOException;
import java.net.InetSocketAddress;
import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.function.Predicate;
import java.util.function.Supplier;
import java.util.stream.Stream;
import no.hials.crosscom.mock.internal.C3FileHandler;
import no.hials.crosscom.mock.internal.C3Handler;
import no.hials.crosscom.mock.internal.C3ProgramHandler;
import no.hials.crosscom.mock.internal.C3ProxyVariables;
import no.hials.crosscom.mock.internal.C3VariableHandler;
import no.hials.crosscom.mock.internal.ConnectionAcceptor;
import no.hials.crosscom.mock.internal.DiscoveryAnswers;
import no.hials.crosscom.mock.internal.DiscoveryResponder;
import no.hials.crosscom.mock.internal.FaultScript;
import no.hials.crosscom.mock.internal.KukavarproxyHandler;
import no.hials.crosscom.mock.internal.RequestDispatcher;
import no.hials.crosscom.mock.internal.RequestHandler;
import no.hials.crosscom.mock.internal.RequestLog;
import no.hials.crosscom.protocol.ServerType;
import no.hials.crosscom.simulator.Controller;
import no.hials.crosscom.simulator.FileTree;
import no.hials.crosscom.simulator.VariableTable;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Stands in for a robot controller with KUKAVARPROXY, or with C3 Bridge ({@link
 * MockServerConfig#server}), over real TCP.
 *
 * <p>It serves one request at a time, whoever sent it, and answers each by one write. A request
 * that arrives in pieces is put together again, which KUKAVARPROXY does not do, and a request is
 * served at once, which a controller cannot; {@link MockServerConfig.Builder#asOnTheController}
 * sets both and the other limits as they are there. A malformed request gets no answer, one of an
 * unknown function the empty answer; the connection stays open.
 *
 * <p>C3 Bridge answers a malformed request with code {@code PROTOCOL}, and closes the connection on
 * an unknown type and when an answer of types 0 and 4 is too long
 * (docs/reference/c3-messages.md#framing). That it drops what arrives while its send blocks is not
 * simulated. Its programs, motions and keys are those of {@link #controller}: select, run and start
 * really do, a motion begins at once and needs the controller's time, and a program has to be
 * stopped before somebody else can move the robot.
 *
 * <p>Threads: one that accepts, called {@code mock-server-PORT-accept}, one for each connection,
 * called {@code mock-server-PORT-client-N}, {@code mock-server-PORT-discovery} and {@code
 * mock-server-PORT-standard-discovery} if they are on, and {@code mock-server-PORT-clock} from the
 * first {@link #controller} on; PORT is the TCP port, and all are daemons. {@link #close} closes
 * all sockets and waits for the threads to end. Any number of servers can run at a time. All
 * methods are safe for use by several threads.
 */
public final class MockServer implements AutoCloseable {
  private static final Logger log = LoggerFactory.getLogger(MockServer.class);

  private final MockServerConfig config;
  private final VariableTable variables = VariableTable.krc4();
  private final FileTree files;
  private final FaultScript faults = new FaultScript();
  private final RequestLog requests;
  private final RequestDispatcher service;
  private final ConnectionAcceptor clients;
  private @Nullable DiscoveryResponder discovery;
  private final @Nullable DiscoveryResponder standardDiscovery;

  /** Guards {@link #controller} and {@link #closed}. */
  private final Object lock = new Object();

  /** Null until it is asked for. */
  private @Nullable Controller controller;

  private boolean closed;

  private MockServer(MockServerConfig config) throws IOException {
    this.config = config;
    requests = new RequestLog(config.recordedRequests());
    files = config.files().orElseGet(FileTree::inMemory);
    C3ProxyVariables bridge = new C3ProxyVariables(config, this::address);
    service = new RequestDispatcher(config, handlers(bridge), faults, requests);
    clients = ConnectionAcceptor.listen(config, service);
    boolean c3 = config.server() == ServerType.C3_BRIDGE;
    DiscoveryAnswers answers = new DiscoveryAnswers(variables, c3 ? bridge : null);
    discovery = openDiscovery(config.discoveryPort(), config.discoveryReplyPort(), answers);
    standardDiscovery = openDiscovery(config.standardDiscoveryPort(), 0, answers);
  }

  private Supplier<RequestHandler> handlers(C3ProxyVariables bridge) {
    if (config.server() == ServerType.KUKAVARPROXY) {
      RequestHandler handler = new KukavarproxyHandler(variables, config);
      return () -> handler;
    }
    C3VariableHandler access = new C3VariableHandler(variables, bridge, config);
    C3ProgramHandler control = new C3ProgramHandler(this::controller);
    return () -> new C3Handler(bridge, access, control, new C3FileHandler(files, this::isSelected));
  }

  /** Says whether one of the interpreters has a module selected. */
  private boolean isSelected(String module) {
    Controller made;
    synchronized (lock) {
      made = controller;
    }
    return made != null
        && Stream.of(made.robot(), made.submit())
            .anyMatch(i -> i.program().filter(module::equalsIgnoreCase).isPresent());
  }

  private @Nullable DiscoveryResponder openDiscovery(
      OptionalInt port, int replyPort, DiscoveryAnswers answers) throws IOException {
    if (port.isEmpty()) {
      return null;
    }
    try {
      return DiscoveryResponder.open(
          new InetSocketAddress(config.bindAddress(), port.getAsInt()), replyPort, answers);
    } catch (IOException e) {
      clients.close();
      if (discovery != null) {
        discovery.close();
      }
      throw e;
    }
  }

  /**
   * Starts a server with the default configuration: on the loopback address, on a free port.
   *
   * @return the server, which listens already
   * @throws IOException if it cannot listen
   */
  public static MockServer start() throws IOException {
    return start(cfg -> {});
  }

  /**
   * Starts a server.
   *
   * @param changes sets what shall differ from the default configuration
   * @return the server, which listens already
   * @throws IOException if it cannot listen, such as on a port that is in use
   */
  public static MockServer start(Consumer<MockServerConfig.Builder> changes) throws IOException {
    return start(MockServerConfig.create(changes));
  }

  /**
   * Starts a server.
   *
   * @param config the configuration
   * @return the server, which listens already
   * @throws IOException if it cannot listen, such as on a port that is in use
   */
  public static MockServer start(MockServerConfig config) throws IOException {
    MockServer server = new MockServer(config);
    server.clients.start();
    if (server.discovery != null) {
      server.clients.threads().start("discovery", server.discovery);
    }
    if (server.standardDiscovery != null) {
      server.clients.threads().start("standard-discovery", server.standardDiscovery);
    }
    log.debug("listening on {}", server.address());
    return server;
  }

  // what it is

  /**
   * Gives the configuration.
   *
   * @return what the server was started with; with the port that was asked for
   */
  public MockServerConfig config() {
    return config;
  }

  /**
   * Gives the address to connect to.
   *
   * @return the address with the port that the server listens on
   */
  public InetSocketAddress address() {
    return clients.address();
  }

  /**
   * Gives the host to connect to.
   *
   * @return the address the server is bound to as a number, such as {@code 127.0.0.1}
   */
  public String host() {
    return address().getAddress().getHostAddress();
  }

  /**
   * Gives the port to connect to.
   *
   * @return the port that the server listens on
   */
  public int port() {
    return address().getPort();
  }

  /**
   * Gives the UDP port on which the server answers the question where controllers are.
   *
   * @return the port, or nothing if discovery is off
   */
  public OptionalInt discoveryPort() {
    return discovery == null ? OptionalInt.empty() : OptionalInt.of(discovery.port());
  }

  /**
   * Gives the UDP port on which the server answers as C3 Bridge does in standard mode.
   *
   * @return the port, or nothing if that is off
   */
  public OptionalInt standardDiscoveryPort() {
    return standardDiscovery == null
        ? OptionalInt.empty()
        : OptionalInt.of(standardDiscovery.port());
  }

  /**
   * Gives the variables of the simulated controller, which can be changed at any time.
   *
   * @return the table that the server serves
   */
  public VariableTable variables() {
    return variables;
  }

  /**
   * Gives the files of the simulated controller, which clients of C3 Bridge reach. A program among
   * them can be selected by a client. What {@link Controller#load(java.nio.file.Path)} loads is
   * there, too, in {@code KRC:\R1\Program}, if the server is C3 Bridge and the tree in memory: a
   * folder of this machine is left to clients, and a list of the controller, such as {@code
   * $config.dat}, stays as it is.
   *
   * @return the tree
   */
  public FileTree files() {
    return files;
  }

  /**
   * Gives the controller behind the variables, which runs programs and moves a robot. Before it is
   * asked for the first time the variables stand still, timers too; from then on its time passes.
   *
   * @return the controller, always the same
   */
  public Controller controller() {
    synchronized (lock) {
      if (closed) {
        throw new IllegalStateException("the server is closed");
      }
      if (controller == null) {
        controller =
            new Controller(
                variables, config.clock(), config.robot(), "mock-server-" + port() + "-clock");
        if (config.server() == ServerType.C3_BRIDGE) {
          controller.connect(files);
        }
      }
      return controller;
    }
  }

  // what it was asked

  /**
   * Gives the last requests, answered or not. A request is there before its answer is sent.
   *
   * @return the requests, in the order in which they were served; a copy
   */
  public List<RecordedRequest> requests() {
    return requests.all();
  }

  /**
   * Waits for the next request that has not been taken yet. {@link #requests} goes on to show it.
   *
   * @param timeout how long to wait at most
   * @return the request, or nothing if none came
   * @throws InterruptedException if the waiting was interrupted
   */
  public Optional<RecordedRequest> takeRequest(Duration timeout) throws InterruptedException {
    return requests.take(timeout.toNanos());
  }

  /**
   * Counts the requests.
   *
   * @return how many came since the start, whether they are still kept or not
   */
  public long requestCount() {
    return requests.count();
  }

  /**
   * Counts what the server dropped without an answer, because it was not a whole request in one
   * read ({@link MockServerConfig#joinSplitRequests}) or came while another was served ({@link
   * MockServerConfig#pendingRequests}). {@link #requests} does not show it.
   *
   * @return how many times bytes were dropped since the start
   */
  public long dropCount() {
    return service.dropCount();
  }

  /** Forgets the requests so far. Their numbers are not used again. */
  public void clearRequests() {
    requests.clear();
  }

  // what goes wrong

  /**
   * Sets what goes wrong with the next requests, one fault each; {@link Fault#none} passes one
   * over. Every request takes one, also a {@code PING} or a malformed one. Faults that wait already
   * come first.
   *
   * @param next the faults of the next request, of the one behind it, and so on
   */
  public void enqueue(Fault... next) {
    faults.enqueue(next);
  }

  /**
   * Sets what goes wrong with each request that a predicate picks, until {@link #clearFaults}.
   *
   * @param predicate picks the requests. It is asked while the request is being served, before it
   *     is executed, so it must be quick, and must not wait for another request
   * @param fault what goes wrong
   */
  public void fault(Predicate<? super RecordedRequest> predicate, Fault fault) {
    faults.add(request -> predicate.test(request) ? Optional.of(fault) : Optional.empty());
  }

  /**
   * Sets what goes wrong, decided for each request, until {@link #clearFaults}. The queue of {@link
   * #enqueue} comes first, then what was set earlier. A {@link FaultRule} chooses by number, name
   * and probability.
   *
   * @param choice gives a request's fault, or nothing. It is asked while the request is being
   *     served, before it is executed, so it must be quick, and must not wait for another request;
   *     it is asked by one thread at a time
   */
  public void faults(Function<? super RecordedRequest, Optional<Fault>> choice) {
    faults.add(choice);
  }

  /** Forgets all faults that have been set. */
  public void clearFaults() {
    faults.clear();
  }

  /**
   * Stops listening, so that new connections are refused, until {@link #acceptConnections}. Open
   * connections stay.
   */
  public void refuseConnections() {
    clients.refuse();
  }

  /**
   * Listens again, on the same port. Does nothing if the server listens.
   *
   * @throws IOException if the port has been taken by somebody else
   */
  public void acceptConnections() throws IOException {
    clients.acceptAgain();
  }

  /** Closes all connections, and goes on listening. */
  public void disconnectClients() {
    clients.disconnect();
  }

  /**
   * Counts the clients.
   *
   * @return how many connections are open
   */
  public int clientCount() {
    return clients.count();
  }

  // the end

  /**
   * Closes all connections, stops listening, and waits until all threads have ended. Does nothing
   * the second time.
   */
  @Override
  public void close() {
    closeController();
    clients.close();
    if (discovery != null) {
      discovery.close();
    }
    if (standardDiscovery != null) {
      standardDiscovery.close();
    }
    clients.threads().join();
  }

  private void closeController() {
    Controller closing;
    synchronized (lock) {
      closed = true;
      closing = controller;
    }
    if (closing != null) {
      closing.close();
    }
  }
}
