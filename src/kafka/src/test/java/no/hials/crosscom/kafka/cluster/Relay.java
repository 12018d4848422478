package no.hials.crosscom.kafka.cluster;

import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;

/** Connections to a broker that can be cut: the bytes stop, and neither side notices. */
final class Relay implements AutoCloseable {
  private final ServerSocket server = new ServerSocket(0, 50, InetAddress.getLoopbackAddress());
  private final Set<Socket> sockets = ConcurrentHashMap.newKeySet();
  private final Object state = new Object();
  private boolean cut;
  private volatile int target;

  Relay() throws IOException {}

  int port() {
    return server.getLocalPort();
  }

  /** Starts to relay to a port. */
  void to(int port) {
    target = port;
    thread(this::accept);
  }

  void cut() {
    synchronized (state) {
      cut = true;
    }
  }

  void restore() {
    synchronized (state) {
      cut = false;
      state.notifyAll();
    }
  }

  private void pass() throws InterruptedException {
    synchronized (state) {
      while (cut) {
        state.wait();
      }
    }
  }

  private static void thread(Runnable task) {
    Thread thread = new Thread(task, "relay");
    thread.setDaemon(true);
    thread.start();
  }

  private void accept() {
    try {
      while (true) {
        Socket near = server.accept();
        sockets.add(near);
        thread(() -> join(near));
      }
    } catch (IOException e) {
      // closed
    }
  }

  private void join(Socket near) {
    try {
      pass();
      Socket far = new Socket(InetAddress.getLoopbackAddress(), target);
      sockets.add(far);
      thread(() -> copy(near, far));
      copy(far, near);
    } catch (IOException | InterruptedException e) {
      end(near);
    }
  }

  private void copy(Socket from, Socket to) {
    byte[] buffer = new byte[16_384];
    try {
      InputStream in = from.getInputStream();
      OutputStream out = to.getOutputStream();
      for (int count = in.read(buffer); count >= 0; count = in.read(buffer)) {
        pass();
        out.write(buffer, 0, count);
      }
    } catch (IOException | InterruptedException e) {
      // one side has closed
    } finally {
      end(from);
      end(to);
    }
  }

  private void end(Socket socket) {
    sockets.remove(socket);
    try {
      socket.close();
    } catch (IOException e) {
      throw new IllegalStateException(e);
    }
  }

  @Override
  public void close() throws IOException {
    server.close();
    restore();
    Set.copyOf(sockets).forEach(this::end);
  }
}
