package no.hials.crosscom.bench;

import java.io.Closeable;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.util.concurrent.atomic.LongAdder;
import no.hials.crosscom.protocol.Codec;

/**
 * A server of minimal cost: it answers every request with the same bytes and the id of the request.
 * It creates no objects while it serves.
 *
 * <p>Threads, all daemons: one accepts connections, and one serves each connection. They end with
 * {@link #close} and with the connection.
 */
final class BareServer implements Closeable {
  private final ServerSocket listener;
  private final byte[] answer;
  private final LongAdder requests = new LongAdder();
  private final LongAdder segments = new LongAdder();

  BareServer(Operation operation) throws IOException {
    answer = operation.answer();
    listener = new ServerSocket(0, 50, InetAddress.getLoopbackAddress());
    start("bare-server-accept", this::accept);
  }

  int port() {
    return listener.getLocalPort();
  }

  /** Returns the number of answered requests. */
  long requests() {
    return requests.sum();
  }

  /**
   * Returns the number of reads that received the requests; a request of two writes mostly needs
   * two.
   */
  long segments() {
    return segments.sum();
  }

  private static void start(String name, Runnable task) {
    Thread thread = new Thread(task, name);
    thread.setDaemon(true);
    thread.start();
  }

  private void accept() {
    try {
      while (true) {
        Socket socket = listener.accept();
        start("bare-server-client", () -> serve(socket));
      }
    } catch (IOException e) {
      // closed
    }
  }

  private void serve(Socket client) {
    try (Socket socket = client) {
      socket.setTcpNoDelay(true);
      InputStream in = socket.getInputStream();
      OutputStream out = socket.getOutputStream();
      byte[] request = new byte[2048];
      byte[] reply = answer.clone();
      while (true) {
        int have = 0;
        while (have < Codec.HEADER_LENGTH || have < Codec.frameLength(request, 0)) {
          int count = in.read(request, have, request.length - have);
          if (count < 0) {
            return;
          }
          segments.increment();
          have += count;
        }
        // before the answer, so that the client that receives it sees the count
        requests.increment();
        reply[0] = request[0];
        reply[1] = request[1];
        out.write(reply);
      }
    } catch (IOException e) {
      // the client has disconnected
    }
  }

  @Override
  public void close() throws IOException {
    listener.close();
  }
}
