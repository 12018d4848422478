package no.hials.crosscom.bench;

import java.io.Closeable;
import java.io.IOException;
import java.io.OutputStream;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.util.Arrays;
import java.util.SplittableRandom;
import java.util.concurrent.atomic.AtomicReference;
import java.util.concurrent.locks.LockSupport;
import no.hials.crosscom.mock.MockServer;
import no.hials.crosscom.protocol.Codec;
import no.hials.crosscom.protocol.FrameReader;
import no.hials.crosscom.protocol.MessageType;
import org.jspecify.annotations.Nullable;

/** Passes the exchanges of one client on, and changes one when it is asked to. */
final class MutatingProxy implements Closeable {
  private static final long DELAY_NANOS = 2_000_000;

  private final MockServer robot;
  private final long lateNanos;
  private final ServerSocket listener;
  private final Thread thread;
  private final AtomicReference<@Nullable Order> order = new AtomicReference<>();
  private volatile @Nullable Socket client;

  /** A change of the next exchange of a type. */
  private record Order(Mutation mutation, MessageType type, SplittableRandom random) {}

  /**
   * Starts the proxy.
   *
   * @param lateNanos the time after which an answer is too late
   */
  MutatingProxy(MockServer robot, long lateNanos) throws IOException {
    this.robot = robot;
    this.lateNanos = lateNanos;
    listener = new ServerSocket(0, 50, InetAddress.getLoopbackAddress());
    thread = new Thread(this::accept, "mutating-proxy");
    thread.setDaemon(true);
    thread.start();
  }

  int port() {
    return listener.getLocalPort();
  }

  /** Changes the next exchange of a type. */
  void change(Mutation mutation, MessageType type, long seed) {
    order.set(new Order(mutation, type, new SplittableRandom(seed)));
  }

  /** Changes nothing from now on; returns whether the change that was asked for was made. */
  boolean stop() {
    return order.getAndSet(null) == null;
  }

  private void accept() {
    while (!listener.isClosed()) {
      try (Socket accepted = listener.accept();
          Socket server = new Socket(robot.host(), robot.port())) {
        client = accepted;
        accepted.setTcpNoDelay(true);
        server.setTcpNoDelay(true);
        serve(accepted, server);
      } catch (IOException e) {
        // one side has closed, or this proxy
      }
    }
  }

  /** Passes on until one side closes; the client has one connection at a time. */
  private void serve(Socket from, Socket server) throws IOException {
    FrameReader requests = new FrameReader(from.getInputStream());
    FrameReader answers = new FrameReader(server.getInputStream());
    while (true) {
      byte[] request = frame(requests);
      Order current = orderFor(request);
      if (current != null && current.mutation == Mutation.CUT_REQUEST) {
        order.set(null);
        server
            .getOutputStream()
            .write(Arrays.copyOf(request, current.random.nextInt(request.length)));
        return;
      }
      server.getOutputStream().write(request);
      byte[] answer = frame(answers);
      if (current != null && current.mutation.fits(answer)) {
        order.set(null);
        send(current, answer, from.getOutputStream());
        if (current.mutation == Mutation.CUT_ANSWER) {
          return;
        }
      } else {
        from.getOutputStream().write(answer);
      }
    }
  }

  private @Nullable Order orderFor(byte[] request) {
    Order current = order.get();
    return current != null
            && request.length > Codec.HEADER_LENGTH
            && request[Codec.HEADER_LENGTH] == current.type.code()
        ? current
        : null;
  }

  private void send(Order current, byte[] answer, OutputStream out) throws IOException {
    if (current.mutation == Mutation.DELAYED) {
      LockSupport.parkNanos(DELAY_NANOS);
    } else if (current.mutation == Mutation.LATE) {
      LockSupport.parkNanos(lateNanos);
    }
    out.write(current.mutation.change(answer, current.random));
  }

  private static byte[] frame(FrameReader in) throws IOException {
    int length = in.next();
    if (length < 0) {
      throw new IOException("closed");
    }
    return Arrays.copyOf(in.buffer(), length);
  }

  @Override
  public void close() throws IOException {
    listener.close();
    Socket open = client;
    if (open != null) {
      open.close();
    }
  }
}
