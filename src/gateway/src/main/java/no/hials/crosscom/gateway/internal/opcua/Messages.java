package no.hials.crosscom.gateway.internal.opcua;

import io.netty.buffer.ByteBuf;
import io.netty.buffer.Unpooled;
import io.netty.channel.ChannelDuplexHandler;
import io.netty.channel.ChannelFuture;
import io.netty.channel.ChannelHandlerContext;
import io.netty.channel.ChannelPromise;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.ArrayDeque;
import java.util.Queue;
import java.util.function.BooleanSupplier;
import org.eclipse.milo.opcua.stack.core.channel.EncodingLimits;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Limits the messages of a connection, and closes it when one is too large. Milo gets each chunk in
 * a buffer of its own, since it releases the chunks of a damaged message twice.
 *
 * <p>Before the client has logged in, its messages are passed on one at a time, the next one when
 * the answer to the last one is sent: a client that does not read the answers gets no more of them.
 */
final class Messages extends ChannelDuplexHandler {
  private static final Logger LOG = LoggerFactory.getLogger(Messages.class);

  /** The maximum size of a message, in bytes. Milo's limit does not count the headers. */
  private static final int MAX = EncodingLimits.DEFAULT.getMaxMessageSize();

  /**
   * The maximum size before the log-in: decoded, a message can take more than 40 times its size.
   * That of a certificate is about 2 kB.
   */
  private static final int MAX_BEFORE = 65_536;

  private final BooleanSupplier isLoggedIn;

  /** The bytes that have been read and not passed on. Nothing is read while there are some. */
  private final Queue<ByteBuf> waiting = new ArrayDeque<>();

  /** True from when a message is passed on until its answer is sent, before the log-in. */
  private boolean busy;

  /**
   * The type of a message, {@code F} or {@code A} for its last chunk, and the size of the chunk.
   */
  private final ByteBuffer header = ByteBuffer.allocate(8).order(ByteOrder.LITTLE_ENDIAN);

  /** The bytes of the chunk that are still to come. */
  private long rest;

  /** The sizes of the messages that are not complete, by the first letters of their types. */
  private final long[] sizes = new long[256];

  Messages(BooleanSupplier isLoggedIn) {
    this.isLoggedIn = isLoggedIn;
  }

  @Override
  public void channelRead(ChannelHandlerContext context, Object message) {
    waiting.add((ByteBuf) message);
    passOn(context);
  }

  @Override
  public void read(ChannelHandlerContext context) {
    if (waiting.isEmpty()) {
      context.read();
    }
  }

  @Override
  public void write(ChannelHandlerContext context, Object answer, ChannelPromise promise) {
    ChannelPromise sent = promise.unvoid();
    if (busy) {
      // later, since the handler that writes may still be at work on the message
      sent.addListener(it -> context.executor().execute(() -> answered(context)));
    }
    ChannelFuture unused = context.write(answer, sent);
  }

  private void answered(ChannelHandlerContext context) {
    busy = false;
    passOn(context);
  }

  private void passOn(ChannelHandlerContext context) {
    while (!busy && !waiting.isEmpty() && context.channel().isActive()) {
      ByteBuf chunk = nextChunk();
      if (chunk != null) {
        context.fireChannelRead(chunk);
      } else {
        LOG.debug("OPC UA: {} has sent a large message", context.channel().remoteAddress());
        ChannelFuture unused = context.close();
      }
    }
    context.channel().config().setAutoRead(waiting.isEmpty());
  }

  @Override
  public void handlerRemoved(ChannelHandlerContext context) {
    waiting.forEach(ByteBuf::release);
    waiting.clear();
  }

  /** Returns the next chunk or the part of it that is here, or null if its message is too large. */
  private @Nullable ByteBuf nextChunk() {
    ByteBuf bytes = waiting.element();
    int start = bytes.readerIndex();
    while (header.hasRemaining() && bytes.isReadable()) {
      header.put(bytes.readByte());
      if (!header.hasRemaining() && !beginChunk()) {
        return null;
      }
    }
    int skipped = (int) Math.min(rest, bytes.readableBytes());
    bytes.skipBytes(skipped);
    rest -= skipped;
    if (!header.hasRemaining() && rest == 0) {
      busy = header.get(3) == 'F' && !isLoggedIn.getAsBoolean();
      header.clear();
    }
    ByteBuf chunk = Unpooled.copiedBuffer(bytes.slice(start, bytes.readerIndex() - start));
    if (!bytes.isReadable()) {
      waiting.remove().release();
    }
    return chunk;
  }

  /** Returns whether the chunk of the header may be passed on. */
  private boolean beginChunk() {
    long size = Integer.toUnsignedLong(header.getInt(4));
    rest = size - header.capacity();
    int type = Byte.toUnsignedInt(header.get(0));
    sizes[type] += size;
    if (sizes[type] > (isLoggedIn.getAsBoolean() ? MAX : MAX_BEFORE) || rest < 0) {
      return false; // Milo would keep all that follows a chunk without a header
    }
    if (header.get(3) == 'F' || header.get(3) == 'A') {
      sizes[type] = 0;
    }
    return true;
  }
}
