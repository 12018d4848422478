package no.hials.crosscom.mock;

import java.io.IOException;
import java.net.DatagramPacket;
import java.net.DatagramSocket;
import java.net.InetSocketAddress;
import java.nio.charset.StandardCharsets;
import java.util.function.Supplier;
import no.hials.crosscom.protocol.value.KrlString;
import no.hials.crosscom.protocol.value.KrlValue;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Answers the question where controllers are, by UDP (kukavarproxy.md, "What the server does").
 * Anything else than the question gets no answer.
 */
final class Discovery implements Runnable, AutoCloseable {
  private static final Logger log = LoggerFactory.getLogger(Discovery.class);

  private static final String QUESTION = "WHEREAREYOU?";

  /** One byte more than a question may have (c3-bridge.md), so that a longer one is seen. */
  private static final int BUFFER = 33;

  private final DatagramSocket socket;
  private final VariableTable variables;
  private final int replyPort;

  private Discovery(DatagramSocket socket, VariableTable variables, int replyPort) {
    this.socket = socket;
    this.variables = variables;
    this.replyPort = replyPort;
  }

  /**
   * Listens.
   *
   * @param replyPort the port of the sender to answer to, 0 for the one it sent from
   */
  static Discovery open(InetSocketAddress at, int replyPort, VariableTable variables)
      throws IOException {
    try {
      return new Discovery(new DatagramSocket(at), variables, replyPort);
    } catch (IOException e) {
      throw new IOException("cannot listen on UDP " + at + ": " + e.getMessage(), e);
    }
  }

  int port() {
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
        // such as an ICMP message that nobody listens for an answer; the next may
        if (!socket.isClosed()) {
          log.debug("discovery failed", e);
        }
      }
    }
  }

  private void answer(DatagramPacket question) throws IOException {
    String text =
        new String(question.getData(), 0, question.getLength(), StandardCharsets.ISO_8859_1);
    if (!text.equals(QUESTION)) {
      log.debug("datagram of {} bytes ignored", question.getLength());
      return;
    }
    int port = replyPort == 0 ? question.getPort() : replyPort;
    byte[] answer = answer().getBytes(StandardCharsets.ISO_8859_1);
    socket.send(new DatagramPacket(answer, answer.length, question.getAddress(), port));
    log.debug("discovery answered to {}:{}", question.getAddress().getHostAddress(), port);
  }

  private String answer() {
    return "KUKA|"
        + orNothing(() -> plain(variables.value("$MODEL_NAME[]")))
        + "|"
        + orNothing(() -> plain(variables.value("$KR_SERIALNO")));
  }

  /** Gives a text without its quotes. Assumed: kukavarproxy.md shows neither with nor without. */
  private static String plain(KrlValue value) {
    return value instanceof KrlString string ? string.text() : value.toString();
  }

  /** Leaves a field empty whose variable cannot be read (c3-bridge.md, "Discovery"). */
  private static String orNothing(Supplier<String> field) {
    try {
      return field.get();
    } catch (IllegalArgumentException e) {
      return "";
    }
  }

  /** Ends {@link #run}. */
  @Override
  public void close() {
    socket.close();
  }
}
