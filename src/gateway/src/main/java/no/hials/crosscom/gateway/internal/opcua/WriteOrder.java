package no.hials.crosscom.gateway.internal.opcua;

import io.netty.buffer.ByteBuf;
import io.netty.buffer.Unpooled;
import io.netty.channel.Channel;
import java.net.InetSocketAddress;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ConcurrentHashMap;
import no.hials.crosscom.gateway.internal.writing.RobotThreads;
import org.eclipse.milo.opcua.sdk.server.OpcUaServer;
import org.eclipse.milo.opcua.sdk.server.servicesets.AttributeServiceSet;
import org.eclipse.milo.opcua.sdk.server.servicesets.impl.DefaultAttributeServiceSet;
import org.eclipse.milo.opcua.stack.core.StatusCodes;
import org.eclipse.milo.opcua.stack.core.UaException;
import org.eclipse.milo.opcua.stack.core.UaSerializationException;
import org.eclipse.milo.opcua.stack.core.channel.SecurityKeysListener;
import org.eclipse.milo.opcua.stack.core.encoding.EncodingContext;
import org.eclipse.milo.opcua.stack.core.encoding.binary.OpcUaBinaryEncoder;
import org.eclipse.milo.opcua.stack.core.security.CertificateManager;
import org.eclipse.milo.opcua.stack.core.types.UaRequestMessageType;
import org.eclipse.milo.opcua.stack.core.types.UaResponseMessageType;
import org.eclipse.milo.opcua.stack.core.types.structured.EndpointDescription;
import org.eclipse.milo.opcua.stack.core.types.structured.WriteRequest;
import org.eclipse.milo.opcua.stack.core.types.structured.WriteResponse;
import org.eclipse.milo.opcua.stack.core.types.structured.WriteValue;
import org.eclipse.milo.opcua.stack.transport.server.OpcServerTransport;
import org.eclipse.milo.opcua.stack.transport.server.ServerApplicationContext;
import org.eclipse.milo.opcua.stack.transport.server.ServiceRequestContext;
import org.jspecify.annotations.Nullable;

/**
 * Runs the writes of a connection to a robot one after the other, in the order of their arrival:
 * Milo runs each request on a thread of a pool, so that the second could overtake the first.
 * Thread-safe.
 */
final class WriteOrder {
  /** The maximum size of a request, and of those of a connection that wait, in bytes. */
  private static final int MAX_SIZE = 100_000;

  /** The maximum size of all requests that wait, in bytes: decoded, they take a lot more memory. */
  private static final int MAX_WAITING = 1_000_000;

  /** How many times as much an array counts: decoded, it can take 60 times its size. */
  private static final int OTHER_VALUES = 20;

  /** The arrival of the request that a thread runs: Milo does not pass it on. */
  private static final ThreadLocal<RobotWrites.Arrival> CURRENT = new ThreadLocal<>();

  private final RobotWrites writes;
  private final RequestThreads threads;

  /** The requests of each line that are not answered. The first one runs. */
  private final Map<Line, Deque<CompletableFuture<Void>>> lines = new HashMap<>();

  /** The size of the requests of each connection that wait, in bytes. */
  private final Map<Channel, Integer> waitingSizes = new HashMap<>();

  private final Map<ServiceRequestContext, RobotWrites.Arrival> arrivals =
      new ConcurrentHashMap<>();

  /** The writes of a connection to a robot. */
  private record Line(Channel connection, String robot) {}

  WriteOrder(RobotWrites writes, RequestThreads threads) {
    this.writes = writes;
    this.threads = threads;
  }

  /** Returns when the request has arrived that this thread runs. */
  RobotWrites.Arrival arrival() {
    RobotWrites.@Nullable Arrival arrival = CURRENT.get();
    return arrival == null ? writes.arrival() : arrival;
  }

  /** Returns a transport that passes on the requests of another one in order. */
  OpcServerTransport transport(OpcServerTransport transport) {
    return new OpcServerTransport() {
      @Override
      public void bind(ServerApplicationContext server, InetSocketAddress address)
          throws Exception {
        transport.bind(new Ordered(server), address);
      }

      @Override
      public void unbind() throws Exception {
        transport.unbind();
      }
    };
  }

  /** Returns the services that read and write. */
  AttributeServiceSet services(OpcUaServer server) {
    return new DefaultAttributeServiceSet(server) {
      @Override
      public WriteResponse onWrite(ServiceRequestContext context, WriteRequest request)
          throws UaException {
        CURRENT.set(arrivals.get(context));
        try {
          return super.onWrite(context, request);
        } finally {
          CURRENT.remove();
        }
      }
    };
  }

  private static List<WriteValue> values(WriteRequest request) {
    WriteValue[] values = request.getNodesToWrite();
    return values == null ? List.of() : List.of(values);
  }

  /** Returns whether a value is of a type that variables of robots have. */
  private static boolean isPlain(WriteValue write) {
    Object value = write.getValue().value().value();
    return value == null
        || value instanceof Number
        || value instanceof Boolean
        || value instanceof String;
  }

  private Set<Line> lines(Channel connection, WriteRequest request) {
    Set<Line> all = new HashSet<>();
    for (WriteValue value : values(request)) {
      if (value.getNodeId().getIdentifier() instanceof String id) {
        String robot = id.substring(0, Math.max(0, id.indexOf(':')));
        if (writes.hasRobot(robot)) {
          all.add(new Line(connection, robot));
        }
      }
    }
    return all;
  }

  /** Adds a request to its lines, and returns what completes when those before it are answered. */
  private synchronized CompletableFuture<Void> enter(
      Channel connection, Set<Line> of, int size, CompletableFuture<Void> answered)
      throws UaException {
    List<CompletableFuture<Void>> before = new ArrayList<>();
    for (Line line : of) {
      Deque<CompletableFuture<Void>> unanswered = lines.getOrDefault(line, new ArrayDeque<>());
      if (unanswered.size() > RobotThreads.MAX_WAITING) {
        throw new UaException(StatusCodes.Bad_TooManyOperations);
      }
      if (!unanswered.isEmpty()) {
        before.add(unanswered.getLast());
      }
    }
    CompletableFuture<Void> turn =
        CompletableFuture.allOf(before.toArray(CompletableFuture[]::new));
    if (!before.isEmpty()) {
      int all = waitingSizes.values().stream().mapToInt(Integer::intValue).sum();
      if (waitingSizes.getOrDefault(connection, 0) + size > MAX_SIZE || all + size > MAX_WAITING) {
        throw new UaException(StatusCodes.Bad_TooManyOperations);
      }
      waitingSizes.merge(connection, size, Integer::sum);
      turn = turn.thenRun(() -> begin(connection, size));
    }
    of.forEach(line -> lines.computeIfAbsent(line, it -> new ArrayDeque<>()).add(answered));
    return turn;
  }

  /** Called when a request no longer waits. */
  private synchronized void begin(Channel connection, int size) {
    waitingSizes.computeIfPresent(connection, (it, all) -> all == size ? null : all - size);
  }

  /** Removes a request, which is the first one of its lines. */
  private synchronized void leave(Set<Line> of) {
    for (Line line : of) {
      lines.computeIfPresent(
          line,
          (it, unanswered) -> {
            unanswered.removeFirst();
            return unanswered.isEmpty() ? null : unanswered;
          });
    }
  }

  /** The server as the transport sees it. */
  private final class Ordered implements ServerApplicationContext {
    private final ServerApplicationContext server;

    Ordered(ServerApplicationContext server) {
      this.server = server;
    }

    /** Returns the size of a request, in bytes. */
    private int size(WriteRequest request) throws UaException {
      ByteBuf buffer = Unpooled.buffer();
      try {
        new OpcUaBinaryEncoder(server.getEncodingContext())
            .setBuffer(buffer)
            .encodeStruct(null, request, WriteRequest.TYPE_ID);
      } catch (UaSerializationException e) {
        throw new UaException(e.getStatusCode().value(), e);
      }
      boolean isPlain = values(request).stream().allMatch(WriteOrder::isPlain);
      int size = isPlain ? buffer.readableBytes() : OTHER_VALUES * buffer.readableBytes();
      if (size > MAX_SIZE) {
        throw new UaException(StatusCodes.Bad_RequestTooLarge);
      }
      return size;
    }

    /** Called with the requests of a connection in the order of their arrival. */
    @Override
    public CompletableFuture<UaResponseMessageType> handleServiceRequest(
        ServiceRequestContext context, UaRequestMessageType request) {
      if (!(request instanceof WriteRequest write)) {
        return handle(context, request);
      }
      Set<Line> of;
      CompletableFuture<Void> answered = new CompletableFuture<>();
      CompletableFuture<Void> turn;
      try {
        int size = size(write);
        of = lines(context.getChannel(), write);
        turn = enter(context.getChannel(), of, size, answered);
      } catch (UaException e) {
        return CompletableFuture.failedFuture(e);
      }
      arrivals.put(context, writes.arrival());
      return turn.thenCompose(first -> handle(context, request))
          .whenComplete(
              (response, failure) -> {
                arrivals.remove(context);
                leave(of);
                answered.complete(null);
              });
    }

    private CompletableFuture<UaResponseMessageType> handle(
        ServiceRequestContext context, UaRequestMessageType request) {
      return threads.handle(request, () -> server.handleServiceRequest(context, request));
    }

    @Override
    public List<EndpointDescription> getEndpointDescriptions() {
      return server.getEndpointDescriptions();
    }

    @Override
    public CertificateManager getCertificateManager() {
      return server.getCertificateManager();
    }

    @Override
    public EncodingContext getEncodingContext() {
      return server.getEncodingContext();
    }

    @Override
    public Long getNextSecureChannelId() {
      return server.getNextSecureChannelId();
    }

    @Override
    public Long getNextSecureChannelTokenId() {
      return server.getNextSecureChannelTokenId();
    }

    @Override
    public SecurityKeysListener getSecurityKeysListener() {
      return server.getSecurityKeysListener();
    }
  }
}
