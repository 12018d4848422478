package no.hials.crosscom.mock;

import java.io.IOException;
import java.io.OutputStream;
import java.net.Socket;
import java.net.SocketTimeoutException;
import java.time.Duration;
import java.util.Arrays;
import java.util.concurrent.TimeUnit;
import no.hials.crosscom.protocol.FrameReader;
import no.hials.crosscom.protocol.MalformedFrameException;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** Serves one client, on a thread of its own, until one of both closes the connection. */
final class Connection implements Runnable {
  private static final Logger log = LoggerFactory.getLogger(Connection.class);
  private static final byte[] NOTHING = new byte[0];

  private final MockServer server;
  private final Socket socket;
  private final int number;

  /** What goes out in front of the next answer. */
  private byte[] heldBack = NOTHING;

  Connection(MockServer server, Socket socket, int number) {
    this.server = server;
    this.socket = socket;
    this.number = number;
  }

  int number() {
    return number;
  }

  /** Ends the connection, from any thread. */
  void abort() {
    try {
      socket.close();
    } catch (IOException e) {
      log.debug("connection {}: close failed", number, e);
    }
  }

  @Override
  public void run() {
    log.debug("connection {} from {} opened", number, socket.getRemoteSocketAddress());
    String reason = "the client closed it";
    try {
      socket.setTcpNoDelay(true);
      Duration idle = server.config().idleTimeout();
      // a positive time-out is never rounded down to 0, which would mean none
      socket.setSoTimeout((int) (idle.isZero() ? 0 : Math.max(1, idle.toMillis())));
      serve();
    } catch (SocketTimeoutException e) {
      reason = "the client was silent for too long";
    } catch (IOException e) {
      reason = e.toString();
    } catch (InterruptedException e) {
      // only close() interrupts; this thread ends anyway
      Thread.currentThread().interrupt();
      reason = "the server was closed";
    } catch (RuntimeException e) {
      // such as from a user's predicate: the client must not wait for an answer in vain
      log.warn("connection {}: serving a request failed", number, e);
      reason = "serving a request failed";
    } finally {
      abort();
      server.forget(this);
      log.debug("connection {} closed: {}", number, reason);
    }
  }

  private void serve() throws IOException, InterruptedException {
    FrameReader reader = new FrameReader(socket.getInputStream());
    OutputStream out = socket.getOutputStream();
    int length = reader.next();
    while (length >= 0) {
      Delivery delivery = server.serve(number, Arrays.copyOf(reader.buffer(), length));
      send(delivery, out);
      if (delivery.ending() != Delivery.Ending.OPEN) {
        end(delivery.ending());
        return;
      }
      length = reader.next();
    }
  }

  private void send(Delivery delivery, OutputStream out) throws IOException, InterruptedException {
    if (delivery.gate() != null) {
      delivery.gate().await();
    }
    sleep(delivery.delay());
    boolean first = true;
    for (byte[] segment : delivery.segments()) {
      byte[] bytes = segment;
      if (heldBack.length > 0) {
        bytes = Arrays.copyOf(heldBack, heldBack.length + segment.length);
        System.arraycopy(segment, 0, bytes, heldBack.length, segment.length);
        heldBack = NOTHING;
      }
      if (delivery.holdBack()) {
        heldBack = bytes;
        continue;
      }
      if (!first) {
        sleep(delivery.pause());
      }
      first = false;
      if (log.isTraceEnabled()) {
        log.trace("connection {} > {}", number, MalformedFrameException.hex(bytes, bytes.length));
      }
      // one write call a segment: with TCP_NODELAY it is a segment of its own on the wire
      out.write(bytes);
    }
  }

  private static void sleep(Duration time) throws InterruptedException {
    if (!time.isZero()) {
      TimeUnit.NANOSECONDS.sleep(time.toNanos());
    }
  }

  private void end(Delivery.Ending ending) throws IOException {
    if (ending == Delivery.Ending.RESET) {
      socket.setSoLinger(true, 0);
    } else {
      socket.shutdownOutput();
    }
  }
}
