package no.hials.crosscom.mock.internal;

import java.io.IOException;
import java.net.InetSocketAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.time.Duration;
import java.util.HashSet;
import java.util.Set;
import java.util.concurrent.locks.LockSupport;
import no.hials.crosscom.mock.MockServerConfig;
import no.hials.crosscom.simulator.internal.ThreadJoiner;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** Accepts clients and keeps their connections. Safe for use by several threads. */
public final class ConnectionAcceptor {
  private static final Logger LOG = LoggerFactory.getLogger(ConnectionAcceptor.class);

  /** Enough for a thousand clients that connect at the same time. */
  private static final int BACKLOG = 1024;

  /** Keeps the thread from spinning if file descriptors run out. */
  private static final Duration PAUSE_AFTER_FAILED_ACCEPT = Duration.ofMillis(50);

  private final MockServerConfig config;
  private final RequestDispatcher service;
  private final InetSocketAddress address;
  private final ServerThreads threads;

  /** Guards the fields below. */
  private final Object state = new Object();

  private ServerSocket listener;
  private @Nullable Thread accepting;
  private boolean refusing;
  private boolean closed;
  private int accepted;
  private final Set<ClientConnection> connections = new HashSet<>();

  private ConnectionAcceptor(
      MockServerConfig config, RequestDispatcher service, ServerSocket listener) {
    this.config = config;
    this.service = service;
    this.listener = listener;
    address = new InetSocketAddress(config.bindAddress(), listener.getLocalPort());
    threads = new ServerThreads("mock-server-" + address.getPort() + "-");
  }

  /** Starts to listen. {@link #start} starts to accept. */
  public static ConnectionAcceptor listen(MockServerConfig config, RequestDispatcher service)
      throws IOException {
    ServerSocket listener = listen(new InetSocketAddress(config.bindAddress(), config.port()));
    return new ConnectionAcceptor(config, service, listener);
  }

  private static ServerSocket listen(InetSocketAddress at) throws IOException {
    ServerSocket socket = new ServerSocket();
    try {
      socket.bind(at, BACKLOG);
      return socket;
    } catch (IOException | RuntimeException e) {
      socket.close();
      throw new IOException("cannot listen on " + text(at) + ": " + e.getMessage(), e);
    }
  }

  /** Returns an address without its host name, such as {@code 127.0.0.1:7000}. */
  static String text(InetSocketAddress address) {
    return address.toString().replaceFirst("^[^/]*/", "");
  }

  /** Returns the address that clients connect to. */
  public InetSocketAddress address() {
    return address;
  }

  /** Returns the threads of the server, which {@link #close} interrupts. */
  public ServerThreads threads() {
    return threads;
  }

  /** Starts to accept clients. */
  public void start() {
    synchronized (state) {
      ServerSocket socket = listener;
      accepting = threads.start("accept", () -> accept(socket));
    }
  }

  /** Stops listening. */
  public void refuse() {
    Thread ending;
    synchronized (state) {
      refusing = true;
      closeListener();
      ending = accepting;
    }
    if (ending != null) {
      ThreadJoiner.join(ending);
    }
  }

  /** Listens again on the same port. */
  public void acceptAgain() throws IOException {
    synchronized (state) {
      if (closed) {
        throw new IllegalStateException("the server is closed");
      }
      if (refusing) {
        listener = listen(address);
        refusing = false;
        start();
      }
    }
  }

  /** Closes all connections. */
  public void disconnect() {
    synchronized (state) {
      connections.forEach(ClientConnection::abort);
    }
  }

  /** Returns the number of connections. */
  public int count() {
    synchronized (state) {
      return connections.size();
    }
  }

  private void accept(ServerSocket socket) {
    while (true) {
      try {
        admit(socket.accept());
      } catch (IOException e) {
        if (socket.isClosed()) {
          return;
        }
        LOG.warn("accepting a connection failed", e);
        try {
          Pause.of(PAUSE_AFTER_FAILED_ACCEPT);
        } catch (InterruptedException interrupted) {
          Thread.currentThread().interrupt();
          return;
        }
      } catch (OutOfMemoryError e) {
        // perhaps because of another thread; nothing is allocated here, not even for the log
        LockSupport.parkNanos(PAUSE_AFTER_FAILED_ACCEPT.toNanos());
      }
    }
  }

  private void admit(Socket client) throws IOException {
    synchronized (state) {
      boolean full = config.maxClients() > 0 && connections.size() >= config.maxClients();
      if (closed || full) {
        LOG.debug("connection from {} closed at once", client.getRemoteSocketAddress());
        client.close();
        return;
      }
      accepted++;
      ClientConnection connection = new ClientConnection(config, service, client, accepted);
      connections.add(connection);
      try {
        threads.start("client-" + accepted, () -> serve(connection));
      } catch (OutOfMemoryError e) {
        // the system has no thread left; those that are connected are still served
        connections.remove(connection);
        connection.abort();
        LOG.error("no thread for connection {}", accepted, e);
      }
    }
  }

  private void serve(ClientConnection connection) {
    try {
      connection.run();
    } finally {
      synchronized (state) {
        connections.remove(connection);
      }
    }
  }

  /** Closes all sockets and ends all pauses, so that the threads end. */
  public void close() {
    synchronized (state) {
      if (!closed) {
        closed = true;
        closeListener();
        connections.forEach(ClientConnection::abort);
        threads.interrupt();
        LOG.debug("closed {}", address);
      }
    }
  }

  private void closeListener() {
    try {
      listener.close();
    } catch (IOException e) {
      LOG.debug("closing the listening socket failed", e);
    }
  }
}
