package no.hials.crosscom.gateway.broker;

import static java.nio.charset.StandardCharsets.ISO_8859_1;

import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import org.jspecify.annotations.Nullable;

/**
 * A TCP connection to a broker that can be cut, can stop passing on what is sent to it, and can end
 * when a text is sent.
 */
final class Cable implements AutoCloseable {
  private final int target;
  private final ServerSocket server;
  private final Set<Socket> sockets = ConcurrentHashMap.newKeySet();
  private boolean connected;
  private boolean held;
  private boolean waits;
  private @Nullable String forbidden;

  /** Creates a cable that is cut until {@link #connect}. */
  Cable(int target) throws IOException {
    this.target = target;
    this.server = new ServerSocket(0, 50, InetAddress.getLoopbackAddress());
    thread(this::accept);
  }

  int port() {
    return server.getLocalPort();
  }

  synchronized void connect() {
    connected = true;
  }

  /** Passes on nothing to the broker any more; the next cut loses what has arrived. */
  synchronized void hold() {
    held = true;
  }

  /**
   * From now on, ends each connection over which a text is sent, such as a topic; null for none.
   */
  synchronized void endAt(@Nullable String text) {
    forbidden = text;
  }

  private synchronized boolean isForbidden(String sent) {
    return forbidden != null && sent.contains(forbidden);
  }

  private synchronized void awaitRelease() throws InterruptedException {
    waits = held;
    notifyAll();
    while (held) {
      wait();
    }
  }

  /** Waits until something is held. */
  synchronized void awaitHeld() throws InterruptedException {
    while (!waits) {
      wait();
    }
  }

  synchronized void cut() {
    connected = false;
    held = false;
    sockets.forEach(Cable::end);
    sockets.clear();
    notifyAll();
  }

  private static void thread(Runnable task) {
    Thread thread = new Thread(task, "cable");
    thread.setDaemon(true);
    thread.start();
  }

  private void accept() {
    try {
      while (true) {
        join(server.accept());
      }
    } catch (IOException e) {
      // closed
    }
  }

  private synchronized void join(Socket near) {
    if (!connected) {
      end(near);
      return;
    }
    try {
      Socket far = new Socket(InetAddress.getLoopbackAddress(), target);
      sockets.add(near);
      sockets.add(far);
      thread(() -> copy(near, far, true));
      thread(() -> copy(far, near, false));
    } catch (IOException e) {
      end(near);
    }
  }

  private void copy(Socket from, Socket to, boolean toBroker) {
    byte[] buffer = new byte[8192];
    try (InputStream in = from.getInputStream();
        OutputStream out = to.getOutputStream()) {
      for (int read = in.read(buffer); read >= 0; read = in.read(buffer)) {
        if (toBroker) {
          awaitRelease();
          if (isForbidden(new String(buffer, 0, read, ISO_8859_1))) {
            return;
          }
        }
        out.write(buffer, 0, read);
      }
    } catch (IOException | InterruptedException e) {
      // the other side is closed as well
    }
  }

  private static void end(Socket socket) {
    try {
      socket.close();
    } catch (IOException e) {
      throw new IllegalStateException(e);
    }
  }

  @Override
  public void close() throws IOException {
    server.close();
    cut();
  }
}
