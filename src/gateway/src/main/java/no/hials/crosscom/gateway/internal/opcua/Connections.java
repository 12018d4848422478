package no.hials.crosscom.gateway.internal.opcua;

import static org.eclipse.milo.opcua.stack.core.types.builtin.unsigned.Unsigned.uint;

import io.netty.buffer.UnpooledByteBufAllocator;
import io.netty.channel.Channel;
import io.netty.channel.ChannelFuture;
import io.netty.channel.ChannelFutureListener;
import io.netty.channel.ChannelPipeline;
import io.netty.util.AttributeKey;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.time.Duration;
import java.util.Map;
import java.util.Objects;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.ScheduledFuture;
import java.util.concurrent.TimeUnit;
import java.util.function.LongSupplier;
import java.util.stream.Collectors;
import no.hials.crosscom.gateway.Lasting;
import org.eclipse.milo.opcua.sdk.server.OpcUaServer;
import org.eclipse.milo.opcua.sdk.server.Session;
import org.eclipse.milo.opcua.stack.transport.server.ServiceRequestContext;
import org.eclipse.milo.opcua.stack.transport.server.tcp.OpcTcpServerTransportConfig;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Limits the connections of clients. Milo accepts any number of them from this computer, and waits
 * without an end for a client to log in. Thread-safe.
 */
final class Connections {
  private static final Logger LOG = LoggerFactory.getLogger(Connections.class);

  /** More than sessions, since clients ask for the end points on a connection of their own. */
  private static final int MAX = 150;

  private static final int MAX_OF_ADDRESS = 100;

  /** The time until the first message. Milo keeps each connection that long, also a closed one. */
  private static final Duration LONGEST_SILENCE = Duration.ofSeconds(5);

  private static final Duration LONGEST_UNUSED = Duration.ofSeconds(30);
  private static final Duration LONGEST_CHANNEL = Duration.ofHours(1);

  /** The id of the secure channel on which a session was activated last. */
  private static final AttributeKey<Long> SECURE_CHANNEL =
      AttributeKey.valueOf(Connections.class, "secureChannel");

  private final LongSupplier nanoTime;

  /** The open connections, and when each was opened or seen with a session. */
  private final Map<Channel, Long> open = new ConcurrentHashMap<>();

  private volatile boolean refusing;
  private @Nullable ScheduledFuture<?> checks;

  Connections(LongSupplier nanoTime) {
    this.nanoTime = nanoTime;
  }

  /** Returns the settings of a transport with these limits. */
  OpcTcpServerTransportConfig transport(ExecutorService executor) {
    return OpcTcpServerTransportConfig.newBuilder()
        .setExecutor(executor)
        .setHelloDeadline(uint(LONGEST_SILENCE.toMillis()))
        .setMaximumSecureChannelLifetime(uint(LONGEST_CHANNEL.toMillis()))
        .setChannelPipelineCustomizer(this::accept)
        .build();
  }

  private void accept(ChannelPipeline pipeline) {
    Channel channel = pipeline.channel();
    if (!add(channel)) {
      if (!refusing) {
        LOG.warn(
            "OPC UA: a connection from {} is refused: {} are open",
            channel.remoteAddress(),
            open.size());
      }
      refusing = true;
      ChannelFuture unused = channel.close();
      return;
    }
    refusing = false;
    // without a pool, since Milo releases the buffers of a damaged message twice
    channel.config().setAllocator(UnpooledByteBufAllocator.DEFAULT);
    pipeline.addFirst(new Messages(() -> channel.attr(SECURE_CHANNEL).get() != null));
    ChannelFuture unused =
        channel.closeFuture().addListener((ChannelFutureListener) it -> open.remove(it.channel()));
  }

  private synchronized boolean add(Channel channel) {
    InetAddress address = address(channel);
    long same = open.keySet().stream().filter(it -> Objects.equals(address(it), address)).count();
    if (open.size() >= MAX || same >= MAX_OF_ADDRESS) {
      return false;
    }
    open.put(channel, nanoTime.getAsLong());
    return true;
  }

  private static @Nullable InetAddress address(Channel channel) {
    return channel.remoteAddress() instanceof InetSocketAddress address
        ? address.getAddress()
        : null;
  }

  /** Called when a session is logged in: only requests have its secure channel. */
  static void loggedIn(ServiceRequestContext context) {
    context.getChannel().attr(SECURE_CHANNEL).set(context.getSecureChannel().getChannelId());
  }

  /** Begins to end connections without a session, and sessions that are not logged in. */
  void watch(OpcUaServer server, Users users) {
    LogIns logIns = new LogIns(server, users, nanoTime);
    server.addServiceSet("/", logIns);
    checks =
        server
            .getScheduledExecutorService()
            .scheduleWithFixedDelay(
                Lasting.task(() -> endUnused(server, logIns)), 1, 1, TimeUnit.SECONDS);
  }

  private void endUnused(OpcUaServer server, LogIns logIns) {
    logIns.endUnused(LONGEST_UNUSED);
    Set<Long> used =
        server.getSessionManager().getAllSessions().stream()
            .filter(session -> session.getIdentity() != null)
            .map(Session::getSecureChannelId)
            .collect(Collectors.toSet());
    long now = nanoTime.getAsLong();
    open.replaceAll((channel, since) -> isOneOf(used, channel) ? now : since);
    open.forEach(
        (channel, since) -> {
          if (now - since > LONGEST_UNUSED.toNanos()) {
            LOG.debug("OPC UA: {} has had no session for some time", channel.remoteAddress());
            ChannelFuture unused = channel.close();
          }
        });
  }

  private static boolean isOneOf(Set<Long> used, Channel channel) {
    Long secureChannel = channel.attr(SECURE_CHANNEL).get();
    return secureChannel != null && used.contains(secureChannel);
  }

  void shutdown() {
    if (checks != null) {
      checks.cancel(false);
    }
  }
}
