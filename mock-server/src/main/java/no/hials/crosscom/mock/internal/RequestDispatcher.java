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
  private static final Logger LOG = LoggerFactory.getLogger(RequestDispatcher.class);

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

  /** Creates the dispatcher of one server; a handler serves one connection. */
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
    // fair, so that each client gets its turn; without latency that would only cost time
    turn = new ReentrantLock(!(config.latency() instanceof Latency.None));
  }

  /** The bytes of a request, decoded. */
  private sealed interface Decoded {
    default @Nullable Request request() {
      return null;
    }

    /** Returns the bytes in hex if there is no message. */
    default @Nullable String hex() {
      return null;
    }

    /**
     * Answers the request.
     *
     * @param executes whether a fault lets the server execute it
     */
    Served answer(RequestDispatcher server, RequestHandler handler, boolean executes);
  }

  /** A message. */
  private record Message(Request request) implements Decoded {
    @Override
    public Served answer(RequestDispatcher server, RequestHandler handler, boolean executes) {
      if (!executes) {
        return Served.NOTHING;
      }
      RequestHandler.Handled outcome = handler.handle(request);
      return new Served(
          outcome.response() == null ? Fault.closeBefore() : Fault.none(),
          outcome.response(),
          outcome.refused(),
          handler.isForServer(request) ? 0 : server.times.getAsLong());
    }
  }

  /** A message of a known type whose fields are malformed. */
  private record Malformed(String hex, MalformedRequestException reason) implements Decoded {
    @Override
    public Served answer(RequestDispatcher server, RequestHandler handler, boolean executes) {
      return executes ? new Served(handler.malformed(reason)) : Served.NOTHING;
    }
  }

  /** A message of a type that the server does not know; answered even if it is not executed. */
  private record Unknown(String hex, int id) implements Decoded {
    @Override
    public Served answer(RequestDispatcher server, RequestHandler handler, boolean executes) {
      boolean closes = server.config.unknownFunction() == UnknownFunction.CLOSE;
      return new Served(
          closes ? Fault.closeBefore() : Fault.none(), new EmptyResponse(id), null, 0);
    }
  }

  /** Bytes that are not a message, which no server answers. */
  private record NoMessage(String hex) implements Decoded {
    @Override
    public Served answer(RequestDispatcher server, RequestHandler handler, boolean executes) {
      return Served.NOTHING;
    }
  }

  /**
   * The result of a request.
   *
   * @param fault the fault of the server, if no other fault is set
   * @param response the answer, if there is one
   * @param refused the reason why the controller refused the access, if it did
   * @param nanos the time that the controller took
   */
  private record Served(
      Fault fault, @Nullable Response response, @Nullable RefusedException refused, long nanos) {
    static final Served NOTHING = new Served(null);

    Served(@Nullable Response response) {
      this(Fault.none(), response, null, 0);
    }
  }

  /** Creates the handler for a connection, which must close it. */
  RequestHandler open() {
    return handlers.get();
  }

  /**
   * Decodes, executes and records one request.
   *
   * @param handler executes the request
   * @param connection the number of the connection
   * @param frame the bytes of the request
   */
  ResponsePlan serve(RequestHandler handler, int connection, byte[] frame)
      throws InterruptedException {
    if (LOG.isTraceEnabled()) {
      LOG.trace("connection {} < {}", connection, hex(frame));
    }
    Decoded decoded = decode(handler, connection, frame);
    Request request = decoded.request();
    if (request != null) {
      handler.prepare(request);
    }
    if (config.pendingRequests() != PendingRequests.DROP) {
      turn.lock();
    } else if (!turn.tryLock()) {
      drop(connection, frame.length, "another request is served");
      return ResponsePlan.NOTHING;
    }
    Fault fault;
    Served result;
    try {
      RecordedRequest recorded =
          new RecordedRequest(served + 1, connection, Instant.now(), request, decoded.hex(), null);
      fault = faults.next(recorded);
      result = decoded.answer(this, handler, fault.executes());
      served++;
      requests.add(
          result.refused() == null ? recorded : refused(recorded, result.refused()), frame.length);
      if (config.oneAtATime()) {
        Pause.ofNanos(result.nanos());
      }
    } finally {
      turn.unlock();
    }
    if (!config.oneAtATime()) {
      Pause.ofNanos(result.nanos());
    }
    return deliver(fault == Fault.none() ? result.fault() : fault, request, result.response());
  }

  private Decoded decode(RequestHandler handler, int connection, byte[] frame) {
    try {
      Strictness strictness =
          config.server() == ServerType.C3_BRIDGE ? Strictness.LENIENT : Strictness.STRICT;
      Request request = Codec.decodeRequest(frame, config.server(), strictness);
      return handler.knows(request.type())
          ? new Message(request)
          : new Unknown(hex(frame), request.id());
    } catch (UnknownFunctionException e) {
      LOG.debug("connection {}: {}", connection, e.getMessage());
      return new Unknown(hex(frame), e.id());
    } catch (MalformedRequestException e) {
      LOG.debug("connection {}: {}", connection, e.getMessage());
      return handler.knows(e.type())
          ? new Malformed(hex(frame), e)
          : new Unknown(hex(frame), e.id());
    } catch (MalformedFrameException e) {
      LOG.debug("connection {}: {}", connection, e.getMessage());
      return new NoMessage(hex(frame));
    }
  }

  private static String hex(byte[] frame) {
    return MalformedFrameException.hex(frame, frame.length);
  }

  private static RecordedRequest refused(RecordedRequest recorded, RefusedException refused) {
    LOG.debug(
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
    if (fault != Fault.none()) {
      LOG.debug("fault: {}", fault);
    }
    return ResponsePlan.of(fault, request, response == null ? null : Codec.encode(response));
  }

  /** Counts and logs bytes that are dropped without an answer. */
  void drop(int connection, int bytes, String reason) {
    dropped.incrementAndGet();
    LOG.debug("connection {}: {} bytes dropped: {}", connection, bytes, reason);
  }

  /** Returns how many times bytes were dropped. */
  public long dropCount() {
    return dropped.get();
  }
}
