package no.hials.crosscom.mock;

import java.io.IOException;
import java.net.BindException;
import java.net.InetSocketAddress;
import java.time.Duration;
import java.util.List;
import java.util.Objects;
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
import no.hials.crosscom.simulator.Archive;
import no.hials.crosscom.simulator.Controller;
import no.hials.crosscom.simulator.FileTree;
import no.hials.crosscom.simulator.LoadReport;
import no.hials.crosscom.simulator.VariableTable;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Simulates a robot controller with KUKAVARPROXY or C3 Bridge ({@link MockServerConfig#server})
 * over real TCP.
 *
 * <p>The server serves one request of all its clients at a time, and sends each answer by one
 * write. By default it joins the pieces of a request, which KUKAVARPROXY does not do, and answers
 * without delay, which a controller cannot; {@link MockServerConfig.Builder#asOnTheController} sets
 * these and the other limits as on a controller. A malformed request gets no answer, a request of
 * an unknown function the empty answer; the connection stays open.
 *
 * <p>C3 Bridge answers a malformed request with code {@code PROTOCOL}. It closes the connection on
 * an unknown type, and if an answer of types 0 and 4 is too long
 * (docs/reference/c3-messages.md#framing). A real one also drops requests that arrive while its
 * send blocks; this is not simulated. Its programs, motions and keys are those of {@link
 * #controller}: a motion starts at once and takes the controller's time, and a program must be
 * stopped before another client can move the robot.
 *
 * <p>Threads, all daemons: {@code mock-server-PORT-accept}; {@code mock-server-PORT-client-N} for
 * each connection; {@code mock-server-PORT-discovery} and {@code
 * mock-server-PORT-standard-discovery} if discovery is on; {@code mock-server-PORT-clock} after the
 * first call of {@link #controller}. PORT is the TCP port. {@link #close} waits for them to end.
 * Thread-safe. Any number of servers can run at the same time.
 */
public final class MockServer implements AutoCloseable {
  private static final Logger LOG = LoggerFactory.getLogger(MockServer.class);

  private final MockServerConfig config;
  private final VariableTable variables;
  private final FileTree files;
  private final @Nullable Archive archive;
  private volatile LoadReport archiveReport = new LoadReport(List.of());
  private final FaultScript faults = new FaultScript();
  private final RequestLog requests;
  private final RequestDispatcher service;
  private final ConnectionAcceptor clients;
  private @Nullable DiscoveryResponder discovery;
  private final @Nullable DiscoveryResponder standardDiscovery;

  /** Guards {@link #controller} and {@link #closed}. */
  private final Object lock = new Object();

  /** Null before its first use. */
  private @Nullable Controller controller;

  private boolean closed;

  private MockServer(MockServerConfig config) throws IOException {
    this.config = config;
    variables = VariableTable.krc4(config.robot());
    requests = new RequestLog(config.recordedRequests(), config.recordedBytes());
    archive = config.openArchive();
    files = archive == null ? config.files().orElseGet(FileTree::inMemory) : archive.tree();
    C3ProxyVariables bridge = new C3ProxyVariables(config, this::address);
    service = new RequestDispatcher(config, handlers(bridge), faults, requests);
    clients = ConnectionAcceptor.listen(config, service);
    boolean c3 = config.server() == ServerType.C3_BRIDGE;
    DiscoveryAnswers answers = new DiscoveryAnswers(variables, c3 ? bridge : null);
    discovery =
        openDiscovery(
            config.discoveryPort(),
            config.isDiscoveryIfFree(),
            config.discoveryReplyPort(),
            answers);
    standardDiscovery =
        openDiscovery(
            config.standardDiscoveryPort(), config.isStandardDiscoveryIfFree(), 0, answers);
  }

  private Supplier<RequestHandler> handlers(C3ProxyVariables bridge) {
    if (config.server() == ServerType.KUKAVARPROXY) {
      RequestHandler handler = new KukavarproxyHandler(variables, config);
      return () -> handler;
    }
    C3VariableHandler access = new C3VariableHandler(variables, bridge, config);
    C3ProgramHandler control = new C3ProgramHandler(this::controller, config.version());
    return () -> new C3Handler(bridge, access, control, new C3FileHandler(files, this::isSelected));
  }

  /** Returns whether one of the interpreters has selected a module. */
  private boolean isSelected(String module) {
    Controller current;
    synchronized (lock) {
      current = controller;
    }
    return current != null
        && Stream.of(current.robot(), current.submit())
            .anyMatch(i -> i.program().filter(module::equalsIgnoreCase).isPresent());
  }

  private @Nullable DiscoveryResponder openDiscovery(
      OptionalInt port, boolean ifFree, int replyPort, DiscoveryAnswers answers)
      throws IOException {
    if (port.isEmpty()) {
      return null;
    }
    try {
      return DiscoveryResponder.open(
          new InetSocketAddress(config.bindAddress(), port.getAsInt()), replyPort, answers);
    } catch (IOException e) {
      if (ifFree && e.getCause() instanceof BindException) {
        return null;
      }
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
   * @return the server, which is listening
   * @throws IOException if it cannot listen
   */
  public static MockServer start() throws IOException {
    return start(cfg -> {});
  }

  /**
   * Starts a server.
   *
   * @param changes sets the options that differ from the default configuration
   * @return the server, which is listening
   * @throws IOException if it cannot listen, for example because the port is in use
   */
  public static MockServer start(Consumer<MockServerConfig.Builder> changes) throws IOException {
    return start(MockServerConfig.create(Objects.requireNonNull(changes, "changes")));
  }

  /**
   * Starts a server.
   *
   * @param config the configuration
   * @return the server, which is listening
   * @throws IOException if it cannot listen, for example because the port is in use
   */
  public static MockServer start(MockServerConfig config) throws IOException {
    MockServer server = new MockServer(Objects.requireNonNull(config, "config"));
    if (server.archive != null) {
      server.controller();
    }
    server.clients.start();
    if (server.discovery != null) {
      server.clients.threads().start("discovery", server.discovery);
    }
    if (server.standardDiscovery != null) {
      server.clients.threads().start("standard-discovery", server.standardDiscovery);
    }
    LOG.debug("listening on {}", server.address());
    return server;
  }

  // address and controller

  /** Returns the configuration that the server was started with. Its port can be 0. */
  public MockServerConfig config() {
    return config;
  }

  /** Returns the address to connect to. */
  public InetSocketAddress address() {
    return clients.address();
  }

  /** Returns the numeric host address to connect to, such as {@code 127.0.0.1}. */
  public String host() {
    return address().getAddress().getHostAddress();
  }

  /** Returns the TCP port that the server listens on. */
  public int port() {
    return address().getPort();
  }

  /** Returns the UDP port for discovery, empty if discovery is off or its port was in use. */
  public OptionalInt discoveryPort() {
    return discovery == null ? OptionalInt.empty() : OptionalInt.of(discovery.port());
  }

  /** Returns the UDP port of C3 Bridge's standard discovery, empty if that is off. */
  public OptionalInt standardDiscoveryPort() {
    return standardDiscovery == null
        ? OptionalInt.empty()
        : OptionalInt.of(standardDiscovery.port());
  }

  /** Returns the variables of the simulated controller. They can be changed at any time. */
  public VariableTable variables() {
    return variables;
  }

  /**
   * Returns the files of the simulated controller, which clients of C3 Bridge reach. A client can
   * select a program among them. With C3 Bridge and files in memory, {@link
   * Controller#load(java.nio.file.Path)} also stores a file in {@code KRC:\R1\Program}. It stores
   * nothing in a folder of this machine, and does not replace a data list of the controller such as
   * {@code $config.dat}.
   */
  public FileTree files() {
    return files;
  }

  /**
   * Returns the controller, which runs programs and moves the robot. The first call starts its
   * clock; before, all variables stand still, including timers. With {@link
   * MockServerConfig.Builder#archive} the clock starts with the server.
   *
   * @throws IllegalStateException if the server is closed
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
        controller.simulateBco(config.bco());
        if (archive != null) {
          archiveReport = controller.load(archive, config.archiveMode());
        }
        if (config.server() == ServerType.C3_BRIDGE) {
          controller.connect(files);
        }
      }
      return controller;
    }
  }

  /**
   * Returns the result of loading {@link MockServerConfig.Builder#archive}.
   *
   * @return the result for each program and data list, and for files that cannot be used; no files
   *     without an archive
   */
  public LoadReport archiveReport() {
    return archiveReport;
  }

  // requests

  /**
   * Returns a copy of the last requests, answered or not, in the order in which they were served. A
   * request is recorded before its answer is sent. The oldest are discarded if they are too many or
   * too large.
   */
  public List<RecordedRequest> requests() {
    return requests.all();
  }

  /**
   * Waits for the next request that has not been taken yet. {@link #requests} still returns it.
   *
   * @param timeout the longest time to wait
   * @return the request, empty after the timeout
   * @throws InterruptedException if the thread is interrupted while it waits
   */
  public Optional<RecordedRequest> takeRequest(Duration timeout) throws InterruptedException {
    return requests.take(timeout.toNanos());
  }

  /**
   * Returns how many of the {@link #requestCount} were not kept, because they were more than {@link
   * MockServerConfig#recordedRequests} or {@link MockServerConfig#recordedBytes}.
   */
  public long discardedRequestCount() {
    return requests.discarded();
  }

  /** Returns the number of requests since the start, kept or not. */
  public long requestCount() {
    return requests.count();
  }

  /**
   * Returns how many times the server has dropped bytes without an answer, because they were not a
   * whole request in one read ({@link MockServerConfig#joinSplitRequests}), followed a request in
   * the same receive (KUKAVARPROXY), or arrived while another request was served ({@link
   * MockServerConfig#pendingRequests}). {@link #requests} does not contain them.
   */
  public long dropCount() {
    return service.dropCount();
  }

  /** Removes the requests so far. Their numbers are not used again. */
  public void clearRequests() {
    requests.clear();
  }

  // faults

  /**
   * Adds faults to the queue. Each request takes one fault, including {@code PING} and malformed
   * requests; {@link Fault#none} skips a request.
   *
   * @param next the faults in the order of the requests
   */
  public void enqueue(Fault... next) {
    faults.enqueue(next);
  }

  /**
   * Sets a fault for all requests that match a predicate, until {@link #clearFaults}.
   *
   * @param predicate chooses the requests; called as the function of {@link #faults}
   * @param fault the fault
   */
  public void fault(Predicate<? super RecordedRequest> predicate, Fault fault) {
    faults.add(request -> predicate.test(request) ? Optional.of(fault) : Optional.empty());
  }

  /**
   * Sets a function that chooses the fault of each request, until {@link #clearFaults}. The queue
   * of {@link #enqueue} has priority, then the functions that were set earlier. A {@link FaultRule}
   * chooses by number, name and probability.
   *
   * @param choice returns the fault of a request, or empty. Called before the request is executed,
   *     by one thread at a time. It must return quickly and must not wait for another request
   */
  public void faults(Function<? super RecordedRequest, Optional<Fault>> choice) {
    faults.add(choice);
  }

  /** Removes all faults that have been set. */
  public void clearFaults() {
    faults.clear();
  }

  /** Refuses new connections until {@link #acceptConnections}. Open connections stay. */
  public void refuseConnections() {
    clients.refuse();
  }

  /**
   * Accepts connections again, on the same port. Does nothing if the server is listening.
   *
   * @throws IOException if another program has taken the port
   */
  public void acceptConnections() throws IOException {
    clients.acceptAgain();
  }

  /** Closes all connections. The server still accepts new ones. */
  public void disconnectClients() {
    clients.disconnect();
  }

  /** Returns the number of open connections. */
  public int clientCount() {
    return clients.count();
  }

  // close

  /**
   * Closes all connections, stops listening, and waits until all threads have ended. A second call
   * does nothing.
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
