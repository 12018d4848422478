package no.hials.crosscom;

import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.SocketTimeoutException;
import java.net.StandardSocketOptions;
import java.net.UnknownHostException;
import java.nio.channels.SelectionKey;
import java.nio.channels.SocketChannel;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.Future;
import java.util.concurrent.RejectedExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.regex.Pattern;
import no.hials.crosscom.internal.exchange.SelectorLoop;
import org.jspecify.annotations.Nullable;

/**
 * One attempt to connect, in the threads of the runtime. The connect time-out includes finding the
 * address of a host name.
 */
final class ConnectAttempt implements SelectorLoop.Selectable {
  /** Needs no name server. */
  private static final Pattern NUMERIC =
      Pattern.compile("((25[0-5]|2[0-4]\\d|1?\\d?\\d)(\\.|$)){4}|.*:.*");

  private final ClientConfig config;
  private final SelectorLoop loop;
  private final CompletableFuture<Connection> connection = new CompletableFuture<>();

  // used by the loop
  private @Nullable SocketChannel channel;
  private @Nullable SelectionKey key;

  private ConnectAttempt(ClientConfig config) {
    this.config = config;
    this.loop = config.runtime().loop();
  }

  /**
   * Begins to connect.
   *
   * @return the connection, which the loop has; fails with an {@link IOException}. If it is
   *     completed before, the attempt ends
   */
  static CompletableFuture<Connection> start(ClientConfig config) {
    ConnectAttempt attempt = new ConnectAttempt(config);
    try {
      attempt.start();
    } catch (RejectedExecutionException e) {
      attempt.fail(runtimeClosed(e));
    } catch (OutOfMemoryError e) {
      attempt.fail(new IOException(e.getMessage(), e)); // no thread can be started
    }
    return attempt.connection;
  }

  static IOException runtimeClosed(@Nullable RejectedExecutionException e) {
    return new IOException("the runtime is closed", e);
  }

  private void start() {
    long limit = config.connectTimeout().toMillis();
    Future<?> timeout =
        config
            .runtime()
            .timer()
            .schedule(
                () -> fail(new SocketTimeoutException("no answer within " + limit + " ms")),
                limit,
                TimeUnit.MILLISECONDS);
    CompletableFuture<Connection> unused =
        connection.whenComplete(
            (made, failure) -> {
              timeout.cancel(false);
              if (failure != null) {
                loop.execute(() -> Connection.closeQuietly(channel));
              }
            });
    if (NUMERIC.matcher(config.host()).matches()) {
      resolve();
    } else {
      config.runtime().resolver().execute(this::resolve);
    }
  }

  private void resolve() {
    try {
      InetAddress address = InetAddress.getByName(config.host());
      loop.execute(() -> connect(address));
    } catch (UnknownHostException e) {
      fail(e);
    }
  }

  private void connect(InetAddress address) {
    if (connection.isDone()) {
      return;
    }
    try {
      SocketChannel made = SocketChannel.open();
      channel = made;
      made.setOption(StandardSocketOptions.TCP_NODELAY, true);
      key = loop.register(made, 0, this);
      if (made.connect(new InetSocketAddress(address, config.port()))) {
        ready();
      } else {
        key.interestOps(SelectionKey.OP_CONNECT);
      }
    } catch (IOException | RuntimeException e) {
      fail(e);
    }
  }

  @Override
  public void ready() {
    SocketChannel own = channel;
    SelectionKey ownKey = key;
    if (own == null || ownKey == null || connection.isDone()) {
      return;
    }
    try {
      if (own.finishConnect()) {
        ownKey.interestOps(0);
        Connection made = new Connection(own, config.runtime(), ownKey);
        ownKey.attach(made);
        if (!connection.complete(made)) {
          made.close();
        }
      }
    } catch (IOException | RuntimeException e) {
      fail(e);
    }
  }

  private void fail(Exception e) {
    connection.completeExceptionally(e);
  }

  /** Returns the failure to connect as the client reports it. */
  static CrossComConnectException failure(ClientConfig config, Throwable e) {
    String why;
    if (e instanceof UnknownHostException) {
      why = "the host name is unknown";
    } else {
      why = e.getMessage() == null ? e.getClass().getSimpleName() : e.getMessage();
    }
    String host = config.host();
    String shown = host.contains(":") && !host.startsWith("[") ? "[" + host + "]" : host;
    return new CrossComConnectException(
        "could not connect to " + shown + ":" + config.port() + ": " + why, e);
  }
}
