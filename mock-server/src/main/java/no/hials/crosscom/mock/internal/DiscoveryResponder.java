package no.hials.crosscom.mock.internal;

import java.io.IOException;
import java.net.DatagramPacket;
import java.net.DatagramSocket;
import java.net.InetSocketAddress;
import java.nio.charset.StandardCharsets;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** Answers the questions of discovery by UDP. Other datagrams get no answer. */
public final class DiscoveryResponder implements Runnable, AutoCloseable {
  private static final Logger LOG = LoggerFactory.getLogger(DiscoveryResponder.class);

  /** One byte more than the longest question, to detect a longer one. */
  private static final int BUFFER = 33;

  private final DatagramSocket socket;
  private final DiscoveryAnswers answers;
  private final int replyPort;

  private DiscoveryResponder(DatagramSocket socket, DiscoveryAnswers answers, int replyPort) {
    this.socket = socket;
    this.answers = answers;
    this.replyPort = replyPort;
  }

  /**
   * Starts to listen.
   *
   * @param replyPort the port of the sender that gets the answer, 0 for the port it sent from
   */
  public static DiscoveryResponder open(
      InetSocketAddress at, int replyPort, DiscoveryAnswers answers) throws IOException {
    try {
      return new DiscoveryResponder(new DatagramSocket(at), answers, replyPort);
    } catch (IOException e) {
      throw new IOException(
          "cannot listen on UDP " + ConnectionAcceptor.text(at) + ": " + e.getMessage(), e);
    }
  }

  /** Returns the UDP port. */
  public int port() {
    return socket.getLocalPort();
  }

  @Override
  public void run() {
    DatagramPacket packet = new DatagramPacket(new byte[BUFFER], BUFFER);
    while (!socket.isClosed()) {
      try {
        packet.setLength(BUFFER);
        socket.receive(packet);
        answer(packet);
      } catch (IOException e) {
        // for example an ICMP message that the port of the last answer is closed
        if (!socket.isClosed()) {
          LOG.debug("discovery failed", e);
        }
      }
    }
  }

  private void answer(DatagramPacket question) throws IOException {
    String text =
        new String(question.getData(), 0, question.getLength(), StandardCharsets.ISO_8859_1);
    String answer = answers.to(text);
    if (answer == null) {
      LOG.debug("datagram of {} bytes ignored", question.getLength());
      return;
    }
    int port = replyPort == 0 ? question.getPort() : replyPort;
    byte[] bytes = answer.getBytes(StandardCharsets.ISO_8859_1);
    socket.send(new DatagramPacket(bytes, bytes.length, question.getAddress(), port));
    LOG.debug("discovery answered to {}:{}", question.getAddress().getHostAddress(), port);
  }

  /** Closes the socket, which ends {@link #run}. */
  @Override
  public void close() {
    socket.close();
  }
}
