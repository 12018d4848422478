package no.hials.crosscom;

import java.io.DataInputStream;
import java.io.EOFException;
import java.io.IOException;
import java.io.OutputStream;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.IntPredicate;
import java.util.function.UnaryOperator;
import no.hials.crosscom.mock.MockServer;
import org.jspecify.annotations.Nullable;

/**
 * Stands between a client and a server: can put another server in its place, and others' bytes in
 * place of its answers.
 */
final class Between implements AutoCloseable {
  private static final int HEADER = 4;
  private static final int TYPE = 4;

  private final ServerSocket listener;
  private final Set<Socket> sockets = ConcurrentHashMap.newKeySet();
  private volatile MockServer server;
  private volatile @Nullable IntPredicate changeAt;
  private volatile @Nullable MockServer next;
  private volatile @Nullable IntPredicate lieAt;
  private volatile UnaryOperator<byte[]> lie = answer -> answer;

  Between(MockServer server) throws IOException {
    this.server = server;
    listener = new ServerSocket(0, 50, InetAddress.getLoopbackAddress());
    start(this::accept);
  }

  String host() {
    return listener.getInetAddress().getHostAddress();
  }

  int port() {
    return listener.getLocalPort();
  }

  /** Closes the connection at the next request of some types, which then leads to another one. */
  void changeTo(MockServer other, IntPredicate types) {
    next = other;
    changeAt = types;
  }

  /** Changes the next answer to some types, and closes the connection after it. */
  void lie(IntPredicate types, UnaryOperator<byte[]> change) {
    lie = change;
    lieAt = types;
  }

  /** Leaves the answers as they are from now on. */
  void tellTheTruth() {
    lieAt = null;
  }

  private static void start(Runnable work) {
    Thread thread = new Thread(work, "between");
    thread.setDaemon(true);
    thread.start();
  }

  private void accept() {
    while (!listener.isClosed()) {
      try {
        Socket client = listener.accept();
        sockets.add(client);
        start(() -> serve(client));
      } catch (IOException e) {
        return;
      }
    }
  }

  private void serve(Socket client) {
    try (client;
        Socket robot = new Socket(server.host(), server.port())) {
      sockets.add(robot);
      client.setTcpNoDelay(true);
      DataInputStream questions = new DataInputStream(client.getInputStream());
      DataInputStream answers = new DataInputStream(robot.getInputStream());
      while (exchange(questions, robot.getOutputStream(), answers, client.getOutputStream())) {
        // until one side ends
      }
    } catch (IOException e) {
      // one of both has closed
    } finally {
      sockets.remove(client);
    }
  }

  private boolean exchange(
      DataInputStream questions, OutputStream toServer, DataInputStream answers, OutputStream out)
      throws IOException {
    byte[] question = frame(questions);
    int type = question[TYPE];
    IntPredicate change = changeAt;
    MockServer other = next;
    if (change != null && other != null && change.test(type)) {
      server = other;
      changeAt = null;
      return false;
    }
    toServer.write(question);
    byte[] answer = frame(answers);
    IntPredicate chosen = lieAt;
    if (chosen != null && chosen.test(type)) {
      lieAt = null;
      out.write(lie.apply(answer));
      return false;
    }
    out.write(answer);
    return true;
  }

  private static byte[] frame(DataInputStream in) throws IOException {
    byte[] header = in.readNBytes(HEADER);
    if (header.length < HEADER) {
      throw new EOFException();
    }
    int length = (header[2] & 0xFF) << 8 | (header[3] & 0xFF);
    byte[] frame = new byte[HEADER + length];
    System.arraycopy(header, 0, frame, 0, HEADER);
    in.readFully(frame, HEADER, length);
    return frame;
  }

  @Override
  public void close() throws IOException {
    listener.close();
    for (Socket socket : sockets) {
      socket.close();
    }
  }
}
