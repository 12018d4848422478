package no.hials.crosscom.bench;

import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.StandardSocketOptions;
import java.nio.ByteBuffer;
import java.nio.channels.ClosedSelectorException;
import java.nio.channels.SelectionKey;
import java.nio.channels.Selector;
import java.nio.channels.ServerSocketChannel;
import java.nio.channels.SocketChannel;
import java.nio.charset.StandardCharsets;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.concurrent.TimeUnit;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import no.hials.crosscom.protocol.Codec;
import no.hials.crosscom.protocol.MessageType;
import no.hials.crosscom.protocol.Tail;
import no.hials.crosscom.protocol.variable.VariableResponse.ValueResponse;

/**
 * Plays many KUKAVARPROXYs in one thread: answers each read after 5 ms on one port, and never on
 * another. It runs in a process of its own, so that it does not count.
 */
public final class RobotsStandIn {
  /** The number of fields of a structure whose name begins with {@code CELL_}. */
  static final int FIELDS = 15;

  private static final byte[] STRUCTURE =
      Codec.encode(
          new ValueResponse(
              1,
              MessageType.READ,
              IntStream.rangeClosed(1, FIELDS)
                  .mapToObj(i -> "V" + i + " " + i + "23.456787")
                  .collect(Collectors.joining(", ", "{CELL_TYPE: ", "}")),
              Tail.SUCCESS));

  private static final long DELAY_NANOS = TimeUnit.MILLISECONDS.toNanos(5);

  /** A connection, and its request under way. */
  private static final class Robot {
    private final SocketChannel channel;
    private final boolean silent;
    private final ByteBuffer request = ByteBuffer.allocate(512);

    Robot(SocketChannel channel, boolean silent) {
      this.channel = channel;
      this.silent = silent;
    }
  }

  /** An answer that waits for its time. */
  private record Waiting(Robot robot, ByteBuffer answer, long due) {}

  private final Selector selector = Selector.open();
  private final Deque<Waiting> waiting = new ArrayDeque<>();

  private RobotsStandIn() throws IOException {}

  /**
   * Prints the port that answers and the silent one, and serves until its input ends.
   *
   * @param args none
   * @throws IOException if it cannot listen
   */
  public static void main(String[] args) throws IOException {
    new RobotsStandIn().run();
  }

  private void run() throws IOException {
    listen(false);
    listen(true);
    endWithInput();
    try {
      while (true) {
        selector.select(this::serve, timeToNext());
        answerDue();
      }
    } catch (ClosedSelectorException e) {
      // the input has ended
    }
  }

  private void listen(boolean silent) throws IOException {
    ServerSocketChannel server = ServerSocketChannel.open();
    server.bind(new InetSocketAddress(InetAddress.getLoopbackAddress(), 0), 4096);
    server.configureBlocking(false);
    server.register(selector, SelectionKey.OP_ACCEPT, silent);
    System.out.println(server.socket().getLocalPort());
  }

  private void endWithInput() {
    Thread watcher =
        new Thread(
            () -> {
              try {
                while (System.in.read() >= 0) {
                  // wait for the end
                }
                selector.close();
              } catch (IOException e) {
                System.exit(1);
              }
            },
            "input");
    watcher.setDaemon(true);
    watcher.start();
  }

  /** Returns the time to the next answer in ms, at least 1; 0 if none waits. */
  private long timeToNext() {
    Waiting next = waiting.peek();
    return next == null
        ? 0
        : Math.max(1, TimeUnit.NANOSECONDS.toMillis(next.due - System.nanoTime()));
  }

  private void serve(SelectionKey key) {
    try {
      if (key.isAcceptable()) {
        accept((ServerSocketChannel) key.channel(), (Boolean) key.attachment());
      } else {
        read((Robot) key.attachment());
      }
    } catch (IOException e) {
      key.cancel();
    }
  }

  private void accept(ServerSocketChannel server, boolean silent) throws IOException {
    SocketChannel channel = server.accept();
    while (channel != null) {
      channel.configureBlocking(false);
      channel.setOption(StandardSocketOptions.TCP_NODELAY, true);
      channel.register(selector, SelectionKey.OP_READ, new Robot(channel, silent));
      channel = server.accept();
    }
  }

  private void read(Robot robot) throws IOException {
    if (robot.channel.read(robot.request) < 0) {
      robot.channel.close();
      return;
    }
    byte[] bytes = robot.request.array();
    int have = robot.request.position();
    if (have >= Codec.HEADER_LENGTH && have >= Codec.frameLength(bytes, 0)) {
      robot.request.clear();
      if (!robot.silent) {
        String text = new String(bytes, 0, have, StandardCharsets.ISO_8859_1);
        byte[] answer = answerTo(text).clone();
        answer[0] = bytes[0];
        answer[1] = bytes[1];
        waiting.add(new Waiting(robot, ByteBuffer.wrap(answer), System.nanoTime() + DELAY_NANOS));
      }
    }
  }

  private static byte[] answerTo(String request) {
    if (request.contains("CELL_")) {
      return STRUCTURE;
    }
    return (request.contains("$AXIS_ACT") ? Operation.READ_E6AXIS : Operation.READ_INT).answer();
  }

  private void answerDue() {
    long now = System.nanoTime();
    for (Waiting next = waiting.peek();
        next != null && next.due - now <= 0;
        next = waiting.peek()) {
      waiting.remove();
      try {
        next.robot.channel.write(next.answer);
      } catch (IOException e) {
        // the client has disconnected
      }
    }
  }
}
