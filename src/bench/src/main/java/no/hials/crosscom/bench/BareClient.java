package no.hials.crosscom.bench;

import java.io.Closeable;
import java.io.DataInputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.net.InetAddress;
import java.net.Socket;

/**
 * The lower bound of the cost of an exchange: a {@link Socket} that sends fixed bytes and reads the
 * bytes of the answer. It checks nothing.
 */
final class BareClient implements Closeable, Exchange {
  private final Socket socket;
  private final OutputStream out;
  private final DataInputStream in;
  private final byte[] request;
  private final byte[] answer;

  BareClient(int port, Operation operation) throws IOException {
    socket = new Socket(InetAddress.getLoopbackAddress(), port);
    socket.setTcpNoDelay(true);
    out = socket.getOutputStream();
    in = new DataInputStream(socket.getInputStream());
    request = operation.request();
    answer = new byte[operation.answer().length];
  }

  /** Returns the last byte of the answer, the success flag. */
  @Override
  public double run() throws IOException {
    out.write(request);
    in.readFully(answer);
    return answer[answer.length - 1];
  }

  /** Returns the bytes of the last answer. */
  byte[] answer() {
    return answer.clone();
  }

  @Override
  public void close() throws IOException {
    socket.close();
  }
}
