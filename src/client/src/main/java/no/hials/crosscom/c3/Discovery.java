package no.hials.crosscom.c3;

import java.io.IOException;
import java.io.InterruptedIOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.StandardProtocolFamily;
import java.net.StandardSocketOptions;
import java.nio.ByteBuffer;
import java.nio.channels.DatagramChannel;
import java.nio.channels.SelectionKey;
import java.nio.channels.Selector;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import no.hials.crosscom.internal.Versions;
import no.hials.crosscom.protocol.ServerType;
import no.hials.crosscom.protocol.Version;
import no.hials.crosscom.protocol.value.PrintableText;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Finds servers by UDP (docs/reference/wire-format.md#discovery). It asks only the addresses in the
 * {@link DiscoveryConfig}.
 *
 * <p>In legacy mode a server answers to a fixed port of this machine, which no other program may
 * use. An answer does not name its question, and is recognised by its form.
 */
public final class Discovery {
  private static final Logger LOG = LoggerFactory.getLogger(Discovery.class);

  private static final String PRESENCE = "WHEREAREYOU?";

  /** The beginning of an answer to that question. */
  private static final String PRESENT = "KUKA|";

  private static final List<String> DETAILS =
      List.of("@PROXY_TYPE", "@PROXY_VERSION", "@PROXY_PORT");

  /** The number of times that each question is sent, because a datagram may get lost. */
  private static final int ROUNDS = 2;

  /** Prevents forged senders from filling the memory. */
  private static final int MAX_FOUND = 1000;

  private final DiscoveryConfig config;
  private final Map<InetAddress, Answers> found = new LinkedHashMap<>();
  private final ByteBuffer buffer = ByteBuffer.allocate(1024);

  private Discovery(DiscoveryConfig config) {
    this.config = config;
  }

  /** The channel and the port of a mode. */
  private record Mode(DatagramChannel channel, int port) {}

  /** The answers of one server so far. */
  private static final class Answers {
    final InetAddress address;
    @Nullable String presence;
    boolean bridge;
    @Nullable Version version;
    int port = 7000;

    /** The last round in which it was asked for details. */
    int askedIn;

    Answers(InetAddress address) {
      this.address = address;
    }

    void take(String text) {
      if (text.startsWith(PRESENT)) {
        presence = text;
      } else if (text.equalsIgnoreCase("C3 BRIDGE INTERFACE")) {
        bridge = true;
      } else if (text.matches("[1-9][0-9]{0,4}") && Integer.parseInt(text) <= 65_535) {
        port = Integer.parseInt(text);
      } else if (Versions.parse(text) != null) {
        version = Versions.parse(text);
      }
    }

    FoundServer server(String known) {
      String[] fields = known.split("\\|", -1);
      return new FoundServer(
          address,
          port,
          unquoted(fields[1]),
          fields.length > 2 ? unquoted(fields[2]) : "",
          bridge ? ServerType.C3_BRIDGE : ServerType.KUKAVARPROXY,
          version);
    }

    /** Removes the quotes of a KRL text. */
    private static String unquoted(String text) {
      boolean quoted = text.length() > 1 && text.startsWith("\"") && text.endsWith("\"");
      return quoted ? text.substring(1, text.length() - 1) : text;
    }
  }

  /**
   * Finds servers, in the calling thread. It takes as long as the time-out.
   *
   * @param config the addresses to ask, and the options
   * @return the servers, in the order of their answers
   * @throws InterruptedIOException if the thread was interrupted
   * @throws IOException if nothing could be sent, or the port for the answers is taken
   */
  public static List<FoundServer> find(DiscoveryConfig config) throws IOException {
    return new Discovery(config).run();
  }

  private List<FoundServer> run() throws IOException {
    List<Mode> modes = new ArrayList<>();
    try (Selector selector = Selector.open()) {
      try {
        if (config.standard()) {
          modes.add(open(selector, 0, config.standardPort()));
        }
        if (config.legacy()) {
          modes.add(open(selector, config.legacyReplyPort(), config.legacyPort()));
        }
        search(selector, modes);
      } finally {
        for (Mode mode : modes) {
          mode.channel.close();
        }
      }
    }
    List<FoundServer> servers = new ArrayList<>();
    for (Answers answers : found.values()) {
      if (answers.presence != null) {
        servers.add(answers.server(answers.presence));
      }
    }
    return List.copyOf(servers);
  }

  private Mode open(Selector selector, int localPort, int port) throws IOException {
    DatagramChannel channel = DatagramChannel.open(StandardProtocolFamily.INET);
    InetAddress local = config.localAddress();
    try {
      channel.setOption(StandardSocketOptions.SO_BROADCAST, true);
      channel.bind(
          local == null
              ? new InetSocketAddress(localPort)
              : new InetSocketAddress(local, localPort));
      channel.configureBlocking(false);
      Mode mode = new Mode(channel, port);
      channel.register(selector, SelectionKey.OP_READ, mode);
      return mode;
    } catch (IOException e) {
      channel.close();
      throw new IOException(
          "cannot listen on UDP port "
              + localPort
              + " for the answers"
              + (localPort == 0 ? "" : " of the legacy mode, which may be left out")
              + ": "
              + e.getMessage(),
          e);
    }
  }

  private void search(Selector selector, List<Mode> modes) throws IOException {
    long start = System.nanoTime();
    long timeout = config.timeout().toNanos();
    for (int round = 1; round <= ROUNDS; round++) {
      askAll(modes);
      long until = start + timeout / ROUNDS * round;
      for (long left = until - System.nanoTime(); left > 0; left = until - System.nanoTime()) {
        selector.select(left / 1_000_000 + 1);
        if (Thread.currentThread().isInterrupted()) {
          throw new InterruptedIOException("the thread was interrupted while it searched");
        }
        for (SelectionKey key : selector.selectedKeys()) {
          receive((Mode) key.attachment(), round, until);
        }
        selector.selectedKeys().clear();
      }
    }
  }

  /** Asks every target, even if a target before it cannot be reached. */
  private void askAll(List<Mode> modes) throws IOException {
    int sent = 0;
    for (Mode mode : modes) {
      for (InetAddress target : config.targets()) {
        sent += send(mode, PRESENCE, target) ? 1 : 0;
      }
    }
    if (sent == 0) {
      throw new IOException("none of these could be asked: " + config.targets());
    }
  }

  /** Sends a question, and returns whether that succeeded. */
  private static boolean send(Mode mode, String question, InetAddress target) {
    byte[] bytes = question.getBytes(StandardCharsets.ISO_8859_1);
    try {
      mode.channel.send(ByteBuffer.wrap(bytes), new InetSocketAddress(target, mode.port));
      return true;
    } catch (IOException e) {
      LOG.debug("cannot ask {}: {}", target, e.getMessage());
      return false;
    }
  }

  /** Receives the waiting answers, but no longer than until the end of the round. */
  private void receive(Mode mode, int round, long until) throws IOException {
    while (until - System.nanoTime() > 0) {
      buffer.clear();
      InetSocketAddress from = (InetSocketAddress) mode.channel.receive(buffer);
      if (from == null) {
        return;
      }
      String text =
          new String(buffer.array(), 0, buffer.position(), StandardCharsets.ISO_8859_1).strip();
      if (LOG.isDebugEnabled()) {
        LOG.debug("{} answered {}", from, PrintableText.shortened(text));
      }
      InetAddress address = from.getAddress();
      if (found.size() == MAX_FOUND && !found.containsKey(address)) {
        continue;
      }
      Answers answers = found.computeIfAbsent(address, Answers::new);
      answers.take(text);
      // once a round: a server that answers every question with its presence would be asked forever
      if (text.startsWith(PRESENT) && answers.askedIn < round) {
        answers.askedIn = round;
        for (String question : DETAILS) {
          send(mode, question, address);
        }
      }
    }
  }
}
