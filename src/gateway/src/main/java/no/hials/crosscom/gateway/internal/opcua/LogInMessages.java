package no.hials.crosscom.gateway.internal.opcua;

import io.netty.buffer.ByteBuf;
import io.netty.channel.ChannelFuture;
import io.netty.channel.ChannelHandlerContext;
import io.netty.channel.ChannelInboundHandlerAdapter;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.function.BooleanSupplier;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Closes a connection that sends a large message before its client has logged in: decoded, a
 * message can take more than 40 times its size.
 */
final class LogInMessages extends ChannelInboundHandlerAdapter {
  private static final Logger LOG = LoggerFactory.getLogger(LogInMessages.class);

  /** The maximum size of a message, in bytes. That of a certificate is about 2 kB. */
  private static final int MAX = 65_536;

  private final BooleanSupplier isLoggedIn;

  /**
   * The type of a message, {@code F} or {@code A} for its last chunk, and the size of the chunk.
   */
  private final ByteBuffer header = ByteBuffer.allocate(8).order(ByteOrder.LITTLE_ENDIAN);

  /** The bytes of the chunk that are still to come. */
  private long rest;

  /** The sizes of the messages that are not complete, by the first letters of their types. */
  private final long[] sizes = new long[256];

  LogInMessages(BooleanSupplier isLoggedIn) {
    this.isLoggedIn = isLoggedIn;
  }

  @Override
  public void channelRead(ChannelHandlerContext context, Object message) {
    if (isLoggedIn.getAsBoolean()) {
      context.pipeline().remove(this);
    } else if (message instanceof ByteBuf bytes && isTooLarge(bytes.duplicate())) {
      LOG.debug("OPC UA: {} has sent a large message", context.channel().remoteAddress());
      bytes.release();
      ChannelFuture unused = context.close();
      return;
    }
    context.fireChannelRead(message);
  }

  private boolean isTooLarge(ByteBuf bytes) {
    while (bytes.isReadable()) {
      int skipped = (int) Math.min(rest, bytes.readableBytes());
      bytes.skipBytes(skipped);
      rest -= skipped;
      if (rest == 0 && bytes.isReadable()) {
        header.put(bytes.readByte());
      }
      if (!header.hasRemaining()) {
        long chunk = Integer.toUnsignedLong(header.getInt(4));
        rest = chunk - header.capacity();
        int type = Byte.toUnsignedInt(header.get(0));
        sizes[type] += chunk;
        if (sizes[type] > MAX || rest < 0) {
          return true; // Milo would keep all that follows a chunk without a header
        }
        if (header.get(3) == 'F' || header.get(3) == 'A') {
          sizes[type] = 0;
        }
        header.clear();
      }
    }
    return false;
  }
}
