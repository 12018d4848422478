package no.hials.crosscom.mock.internal;

import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.net.Socket;
import java.net.SocketTimeoutException;
import java.time.Duration;
import java.util.Arrays;
import no.hials.crosscom.mock.MockServerConfig;
import no.hials.crosscom.mock.PendingRequests;
import no.hials.crosscom.protocol.MalformedFrameException;
import no.hials.crosscom.protocol.ServerType;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** Serves one client in its own thread until the client or the server closes the connection. */
final class ClientConnection {
  private static final Logger LOG = LoggerFactory.getLogger(ClientConnection.class);
  private static final byte[] NOTHING = new byte[0];

  private final MockServerConfig config;
  private final RequestDispatcher service;
  private final Socket socket;
  private final int number;

  /** The bytes to send before the next answer. */
  private byte[] heldBack = NOTHING;

  ClientConnection(MockServerConfig config, RequestDispatcher service, Socket socket, int number) {
    this.config = config;
    this.service = service;
    this.socket = socket;
    this.number = number;
  }

  /** Closes the connection. Can be called by any thread. */
  void abort() {
    try {
      socket.close();
    } catch (IOException e) {
      LOG.debug("connection {}: close failed", number, e);
    }
  }

  void run() {
    LOG.debug("connection {} from {} opened", number, socket.getRemoteSocketAddress());
    String reason = "the client closed it";
    try (RequestHandler handler = service.open()) {
      socket.setTcpNoDelay(true);
      Duration idle = config.idleTimeout();
      // a positive time-out must not be rounded down to 0, which means none
      socket.setSoTimeout((int) (idle.isZero() ? 0 : Math.max(1, idle.toMillis())));
      serve(handler);
    } catch (SocketTimeoutException e) {
      reason = "the client was silent for too long";
    } catch (IOException e) {
      reason = e.toString();
    } catch (InterruptedException e) {
      // only close() interrupts; this thread ends anyway
      Thread.currentThread().interrupt();
      reason = "the server was closed";
    } catch (RuntimeException e) {
      // for example from a user's predicate: the client must not wait for an answer
      LOG.warn("connection {}: serving a request failed", number, e);
      reason = "serving a request failed";
    } catch (Error e) {
      // such as too little memory for one request: the other connections are still served
      LOG.error("connection {}: serving a request failed", number, e);
      reason = "serving a request failed";
    } finally {
      abort();
      LOG.debug("connection {} closed: {}", number, reason);
    }
  }

  private void serve(RequestHandler handler) throws IOException, InterruptedException {
    InputStream in = socket.getInputStream();
    OutputStream out = socket.getOutputStream();
    RequestReader frames = frames(in);
    byte[] frame = frames.next();
    while (frame != null) {
      ResponsePlan delivery = service.serve(handler, number, frame);
      hold(delivery);
      if (config.pendingRequests() != PendingRequests.WAIT && !frames.holdsBytes()) {
        dropPending(in);
      }
      send(delivery, out);
      if (delivery.ending() != ResponsePlan.Ending.OPEN) {
        end(delivery.ending());
        return;
      }
      frame = frames.next();
    }
  }

  private RequestReader frames(InputStream in) {
    return config.server() == ServerType.C3_BRIDGE && config.joinSplitRequests()
        ? RequestReader.joined(in)
        : new ReceivedRequests(
            in,
            config.joinSplitRequests(),
            bytes -> service.drop(number, bytes, "not part of a whole request"));
  }

  private static void hold(ResponsePlan delivery) throws InterruptedException {
    if (delivery.gate() != null) {
      delivery.gate().await();
    }
    Pause.of(delivery.delay());
  }

  /** Drops bytes that arrived before the answer: a client that waits for it sends nothing. */
  private void dropPending(InputStream in) throws IOException {
    int bytes = in.available();
    if (bytes > 0) {
      in.skipNBytes(bytes);
      service.drop(number, bytes, "the request before is not answered yet");
    }
  }

  private void send(ResponsePlan delivery, OutputStream out)
      throws IOException, InterruptedException {
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
        Pause.of(delivery.pause());
      }
      first = false;
      if (LOG.isTraceEnabled()) {
        LOG.trace("connection {} > {}", number, MalformedFrameException.hex(bytes, bytes.length));
      }
      // with TCP_NODELAY, each write is a separate segment on the wire
      out.write(bytes);
    }
  }

  private void end(ResponsePlan.Ending ending) throws IOException {
    if (ending == ResponsePlan.Ending.RESET) {
      socket.setSoLinger(true, 0);
    } else {
      socket.shutdownOutput();
    }
  }
}
