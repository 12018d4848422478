package no.hials.crosscom.mock.internal;

import java.time.Instant;
import java.util.concurrent.atomic.AtomicLong;
import java.util.concurrent.locks.ReentrantLock;
import java.util.function.LongSupplier;
import java.util.function.Supplier;
import no.hials.crosscom.mock.Fault;
import no.hials.crosscom.mock.Latency;
import no.hials.crosscom.mock.MockServerConfig;
import no.hials.crosscom.mock.PendingRequests;
import no.hials.crosscom.mock.RecordedRequest;
import no.hials.crosscom.mock.UnknownFunction;
import no.hials.crosscom.protocol.Codec;
import no.hials.crosscom.protocol.EmptyResponse;
import no.hials.crosscom.protocol.MalformedFrameException;
import no.hials.crosscom.protocol.MalformedRequestException;
import no.hials.crosscom.protocol.Request;
import no.hials.crosscom.protocol.Response;
import no.hials.crosscom.protocol.ServerType;
import no.hials.crosscom.protocol.Strictness;
import no.hials.crosscom.protocol.UnknownFunctionException;
import no.hials.crosscom.simulator.RefusedException;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** Serves the requests of all connections, one at a time. Safe for use by several threads. */
public final class RequestDispatcher {
  private static final Logger log = LoggerFactory.getLogger(RequestDispatcher.class);

  private final MockServerConfig config;
  private final Supplier<RequestHandler> handlers;
  private final FaultScript faults;
  private final RequestLog requests;
  private final LongSupplier times;
  private final AtomicLong dropped = new AtomicLong();

  /** Held while a request is served. */
  private final ReentrantLock turn;

  /** The number of the last request; guarded by {@link #turn}. */
  private long served;

  public RequestDispatcher(
      MockServerConfig config,
      Supplier<RequestHandler> handlers,
      FaultScript faults,
      RequestLog requests) {
    this.config = config;
    this.faults = faults;
    this.requests = requests;
    this.handlers = handlers;
    times = LatencySampler.of(config.latency());
    // who waits for long must not be passed over; without latency that would only cost time
    turn = new ReentrantLock(!(config.latency() instanceof Latency.None));
  }

  /**
   * What the bytes of a request are.
   *
   * @param request the message, null if they are none
   * @param hex the bytes in hex if there is no message
   * @param malformed why they are none, if only the fields are not
   * @param response the answer if that is all the request needs
   * @param fault what the server does on its own if nothing else goes wrong
   */
  private record Decoded(
      @Nullable Request request,
      @Nullable String hex,
      @Nullable MalformedRequestException malformed,
      @Nullable Response response,
      Fault fault) {}

  /**
   * What came of a request.
   *
   * @param fault what goes wrong with its answer
   * @param response the answer, if there is one
   * @param nanos how long the controller took
   */
  private record Served(Fault fault, @Nullable Response response, long nanos) {}

  /** Makes what executes the requests of a connection; the connection has to close it. */
  RequestHandler open() {
    return handlers.get();
  }

  /**
   * Serves one request: decodes it, executes it and records it.
   *
   * @param handler executes it
   * @param connection the connection's number
   * @param frame the bytes
   * @return what goes out
   */
  ResponsePlan serve(RequestHandler handler, int connection, byte[] frame)
      throws InterruptedException {
    if (log.isTraceEnabled()) {
      log.trace("connection {} < {}", connection, hex(frame));
    }
    Decoded decoded = decode(handler, connection, frame);
    if (config.pendingRequests() != PendingRequests.DROP) {
      turn.lock();
    } else if (!turn.tryLock()) {
      drop(connection, frame.length, "another request is served");
      return ResponsePlan.NOTHING;
    }
    Served result;
    try {
      result = execute(handler, connection, decoded);
      if (config.oneAtATime()) {
        Pause.ofNanos(result.nanos());
      }
    } finally {
      turn.unlock();
    }
    if (!config.oneAtATime()) {
      Pause.ofNanos(result.nanos());
    }
    return deliver(result.fault(), decoded.request(), result.response());
  }

  /** Executes and records a request, in its turn. */
  private Served execute(RequestHandler handler, int connection, Decoded decoded) {
    Request request = decoded.request();
    RecordedRequest recorded =
        new RecordedRequest(served + 1, connection, Instant.now(), request, decoded.hex(), null);
    Fault fault = faults.next(recorded);
    Fault own = decoded.fault();
    Response response = decoded.response();
    long nanos = 0;
    if (fault.executes() && request != null) {
      RequestHandler.Outcome outcome = handler.handle(request);
      response = outcome.response();
      own = response == null ? Fault.closeBefore() : own;
      recorded = afterwards(recorded, outcome.refused());
      nanos = handler.isForServer(request) ? 0 : times.getAsLong();
    } else if (fault.executes() && decoded.malformed() != null) {
      response = handler.malformed(decoded.malformed());
    }
    served++;
    requests.add(recorded);
    return new Served(fault instanceof Fault.None ? own : fault, response, nanos);
  }

  private Decoded decode(RequestHandler handler, int connection, byte[] frame) {
    try {
      Strictness strictness =
          config.server() == ServerType.C3_BRIDGE ? Strictness.LENIENT : Strictness.STRICT;
      Request request = Codec.decodeRequest(frame, config.server(), strictness);
      return handler.knows(request.type())
          ? new Decoded(request, null, null, null, Fault.none())
          : unknown(request.id(), frame);
    } catch (UnknownFunctionException e) {
      log.debug("connection {}: {}", connection, e.getMessage());
      return unknown(e.id(), frame);
    } catch (MalformedRequestException e) {
      log.debug("connection {}: {}", connection, e.getMessage());
      return handler.knows(e.type())
          ? new Decoded(null, hex(frame), e, null, Fault.none())
          : unknown(e.id(), frame);
    } catch (MalformedFrameException e) {
      log.debug("connection {}: {}", connection, e.getMessage());
      return new Decoded(null, hex(frame), null, null, Fault.none());
    }
  }

  private static String hex(byte[] frame) {
    return MalformedFrameException.hex(frame, frame.length);
  }

  private Decoded unknown(int id, byte[] frame) {
    boolean closes = config.unknownFunction() == UnknownFunction.CLOSE;
    return new Decoded(
        null, hex(frame), null, new EmptyResponse(id), closes ? Fault.closeBefore() : Fault.none());
  }

  private static RecordedRequest afterwards(
      RecordedRequest recorded, @Nullable RefusedException refused) {
    if (refused == null) {
      return recorded;
    }
    log.debug(
        "connection {}: {} refused: {}",
        recorded.connection(),
        recorded.request(),
        refused.getMessage());
    return new RecordedRequest(
        recorded.number(),
        recorded.connection(),
        recorded.time(),
        recorded.request(),
        recorded.hex(),
        refused.reason());
  }

  private static ResponsePlan deliver(
      Fault fault, @Nullable Request request, @Nullable Response response) {
    byte[] answer = response == null ? null : Codec.encode(response);
    if (fault instanceof Fault.None) {
      return answer == null ? ResponsePlan.NOTHING : ResponsePlan.of(answer);
    }
    log.debug("fault: {}", fault);
    return ResponsePlan.of(fault, request, answer);
  }

  /** Notes that bytes were dropped without an answer. */
  void drop(int connection, int bytes, String reason) {
    dropped.incrementAndGet();
    log.debug("connection {}: {} bytes dropped: {}", connection, bytes, reason);
  }

  public long dropCount() {
    return dropped.get();
  }
}
