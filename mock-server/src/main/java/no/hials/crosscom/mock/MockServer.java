package no.hials.crosscom.mock;

import java.io.IOException;
import java.net.InetSocketAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.locks.ReentrantLock;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.function.Predicate;
import no.hials.crosscom.mock.internal.data.RefusedException;
import no.hials.crosscom.protocol.Codec;
import no.hials.crosscom.protocol.EmptyResponse;
import no.hials.crosscom.protocol.MalformedFrameException;
import no.hials.crosscom.protocol.Request;
import no.hials.crosscom.protocol.Response;
import no.hials.crosscom.protocol.UnknownFunctionException;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Stands in for a robot controller with KUKAVARPROXY, over real TCP.
 *
 * <p>It serves one request at a time, whoever sent it, and answers each by one write. A request
 * that arrives in pieces is put together again (KUKAVARPROXY does not do that). A malformed request
 * gets no answer, one of an unknown function the empty answer; the connection stays open.
 *
 * <p>Threads: one that accepts, called {@code mock-server-PORT-accept}, and one for each
 * connection, called {@code mock-server-PORT-client-N}; all are daemons. {@link #close} closes all
 * sockets and waits for the threads to end. Any number of servers can run at a time. All methods
 * are safe for use by several threads.
 */
public final class MockServer implements AutoCloseable {
  private static final Logger log = LoggerFactory.getLogger(MockServer.class);

  /** Takes a thousand clients that all connect at once. */
  private static final int BACKLOG = 1024;

  /** Parsing takes little stack, since the depth of aggregates is limited. */
  private static final long STACK_BYTES = 256 * 1024;

  /** Keeps a lack of file descriptors from making the accepting thread spin. */
  private static final Duration PAUSE_AFTER_FAILED_ACCEPT = Duration.ofMillis(50);

  private final MockServerConfig config;
  private final VariableTable variables = VariableTable.krc4();
  private final RequestHandler handler;
  private final FaultScript faults = new FaultScript();
  private final RequestLog requests;
  private final InetSocketAddress address;

  /** Held while a request is served. */
  private final ReentrantLock service = new ReentrantLock();

  /** The number of the last request; guarded by {@link #service}. */
  private long served;

  /** Guards what follows. */
  private final Object state = new Object();

  private ServerSocket listener;
  private boolean refusing;
  private boolean closed;
  private int accepted;
  private final Set<Connection> connections = new HashSet<>();

  /** All that may still run; dead ones are removed now and then. */
  private final List<Thread> threads = new ArrayList<>();

  private MockServer(MockServerConfig config) throws IOException {
    this.config = config;
    handler = new RequestHandler(variables, config);
    requests = new RequestLog(config.recordedRequests());
    listener = listen(new InetSocketAddress(config.bindAddress(), config.port()));
    address = new InetSocketAddress(config.bindAddress(), listener.getLocalPort());
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
    synchronized (server.state) {
      server.startAccepting();
    }
    log.debug("listening on {}", server.address);
    return server;
  }

  private static ServerSocket listen(InetSocketAddress at) throws IOException {
    ServerSocket socket = new ServerSocket();
    try {
      socket.bind(at, BACKLOG);
      return socket;
    } catch (IOException | RuntimeException e) {
      socket.close();
      throw new IOException("cannot listen on " + at + ": " + e.getMessage(), e);
    }
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
    return address;
  }

  /**
   * Gives the host to connect to.
   *
   * @return the address the server is bound to as a number, such as {@code 127.0.0.1}
   */
  public String host() {
    return address.getAddress().getHostAddress();
  }

  /**
   * Gives the port to connect to.
   *
   * @return the port that the server listens on
   */
  public int port() {
    return address.getPort();
  }

  /**
   * Gives the variables of the simulated controller, which can be changed at any time.
   *
   * @return the table that the server serves
   */
  public VariableTable variables() {
    return variables;
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
   * #enqueue} comes first, then what was set earlier.
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
    List<Thread> ending;
    synchronized (state) {
      refusing = true;
      closeListener();
      ending = threads.stream().filter(thread -> thread.getName().endsWith("-accept")).toList();
    }
    join(ending);
  }

  /**
   * Listens again, on the same port. Does nothing if the server listens.
   *
   * @throws IOException if the port has been taken by somebody else
   */
  public void acceptConnections() throws IOException {
    synchronized (state) {
      if (closed) {
        throw new IllegalStateException("the server is closed");
      }
      if (refusing) {
        listener = listen(address);
        refusing = false;
        startAccepting();
      }
    }
  }

  /** Closes all connections, and goes on listening. */
  public void disconnectClients() {
    synchronized (state) {
      connections.forEach(Connection::abort);
    }
  }

  /**
   * Counts the clients.
   *
   * @return how many connections are open
   */
  public int clientCount() {
    synchronized (state) {
      return connections.size();
    }
  }

  // connections

  private void startAccepting() {
    ServerSocket socket = listener;
    startThread("accept", () -> accept(socket));
  }

  private void startThread(String role, Runnable task) {
    threads.removeIf(thread -> !thread.isAlive());
    Thread thread = new Thread(null, task, "mock-server-" + port() + "-" + role, STACK_BYTES);
    thread.setDaemon(true);
    thread.start();
    threads.add(thread);
  }

  private void accept(ServerSocket socket) {
    while (true) {
      try {
        admit(socket.accept());
      } catch (IOException e) {
        if (socket.isClosed()) {
          return;
        }
        log.warn("accepting a connection failed", e);
        try {
          Thread.sleep(PAUSE_AFTER_FAILED_ACCEPT.toMillis());
        } catch (InterruptedException interrupted) {
          Thread.currentThread().interrupt();
          return;
        }
      }
    }
  }

  private void admit(Socket client) throws IOException {
    synchronized (state) {
      boolean full = config.maxClients() > 0 && connections.size() >= config.maxClients();
      if (closed || full) {
        log.debug("connection from {} closed at once", client.getRemoteSocketAddress());
        client.close();
        return;
      }
      accepted++;
      Connection connection = new Connection(this, client, accepted);
      connections.add(connection);
      startThread("client-" + accepted, connection);
    }
  }

  void forget(Connection connection) {
    synchronized (state) {
      connections.remove(connection);
    }
  }

  // requests

  /**
   * Serves one request: decodes it, executes it and records it, one at a time over all connections.
   *
   * @param connection the connection's number
   * @param frame the bytes
   * @return what goes out
   */
  Delivery serve(int connection, byte[] frame) {
    if (log.isTraceEnabled()) {
      log.trace("connection {} < {}", connection, MalformedFrameException.hex(frame, frame.length));
    }
    Request request = null;
    Response response = null;
    String hex = null;
    try {
      request = Codec.decodeRequest(frame);
    } catch (UnknownFunctionException e) {
      log.debug("connection {}: {}", connection, e.getMessage());
      hex = MalformedFrameException.hex(frame, frame.length);
      response = new EmptyResponse(e.id());
    } catch (MalformedFrameException e) {
      log.debug("connection {}: {}", connection, e.getMessage());
      hex = MalformedFrameException.hex(frame, frame.length);
    }
    Fault fault;
    service.lock();
    try {
      RecordedRequest recorded =
          new RecordedRequest(served + 1, connection, Instant.now(), request, hex, null);
      fault = faults.next(recorded);
      if (fault.executes() && request != null) {
        RequestHandler.Outcome outcome = handler.handle(request);
        response = outcome.response();
        RefusedException refused = outcome.refused();
        if (refused != null) {
          log.debug("connection {}: {} refused: {}", connection, request, refused.getMessage());
          recorded = recorded.refusedFor(refused.reason());
        }
      }
      served++;
      requests.add(recorded);
    } finally {
      service.unlock();
    }
    return deliver(fault, request, response);
  }

  private static Delivery deliver(
      Fault fault, @Nullable Request request, @Nullable Response response) {
    byte[] answer = response == null ? null : Codec.encode(response);
    if (fault instanceof Fault.None) {
      return answer == null ? Delivery.NOTHING : Delivery.of(answer);
    }
    log.debug("fault: {}", fault);
    return Delivery.of(fault, request, answer);
  }

  // the end

  /**
   * Closes all connections, stops listening, and waits until all threads have ended. Does nothing
   * the second time.
   */
  @Override
  public void close() {
    List<Thread> ending;
    synchronized (state) {
      if (!closed) {
        closed = true;
        closeListener();
        connections.forEach(Connection::abort);
        // ends delays
        threads.forEach(Thread::interrupt);
        log.debug("closed {}", address);
      }
      ending = List.copyOf(threads);
    }
    join(ending);
  }

  private void closeListener() {
    try {
      listener.close();
    } catch (IOException e) {
      log.debug("closing the listening socket failed", e);
    }
  }

  /** Waits without giving up, since these threads end soon: their sockets are closed. */
  private static void join(List<Thread> ending) {
    boolean interrupted = false;
    for (Thread thread : ending) {
      // a thread of the server itself may close it, from a user's predicate
      while (thread != Thread.currentThread() && thread.isAlive()) {
        try {
          thread.join();
        } catch (InterruptedException e) {
          interrupted = true;
        }
      }
    }
    if (interrupted) {
      Thread.currentThread().interrupt();
    }
  }
}
