package no.hials.crosscom.gateway.internal.opcua;

import static java.nio.charset.StandardCharsets.US_ASCII;
import static org.assertj.core.api.Assertions.assertThat;
import static org.eclipse.milo.opcua.stack.core.types.enumerated.TimestampsToReturn.Neither;

import io.netty.buffer.ByteBuf;
import io.netty.buffer.ByteBufUtil;
import io.netty.buffer.Unpooled;
import io.netty.channel.embedded.EmbeddedChannel;
import io.netty.channel.socket.nio.NioSocketChannel;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.net.Socket;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.Collections;
import java.util.List;
import java.util.concurrent.ForkJoinPool;
import java.util.concurrent.atomic.AtomicLong;
import org.eclipse.milo.opcua.sdk.client.OpcUaClient;
import org.eclipse.milo.opcua.stack.core.NodeIds;
import org.eclipse.milo.opcua.stack.core.types.UaRequestMessageType;
import org.eclipse.milo.opcua.stack.core.types.builtin.NodeId;
import org.eclipse.milo.opcua.stack.core.types.structured.GetEndpointsRequest;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Clients that send large or damaged messages, or do not read the answers. */
class MessagesTest extends SocketClientsTest {
  @ParameterizedTest
  @ValueSource(strings = {"MSGC MSGC", "MSGX MSGX", "MSGC OPNA MSGC"})
  void largeMessagesAreNotReadBeforeTheLogIn(String chunks) throws Exception {
    Channel channel = open(hello("127.0.0.1"), 600_000);
    int number = 2;
    for (String type : chunks.split(" ", -1)) {
      int size = type.startsWith("MSG") ? 40_000 : 12;
      ByteBuffer chunk = ByteBuffer.allocate(40_000).order(ByteOrder.LITTLE_ENDIAN);
      chunk.put(type.getBytes(US_ASCII)).putInt(size);
      chunk.putInt(channel.id()).putInt(channel.token()).putInt(number++).putInt(2);
      channel.socket().getOutputStream().write(chunk.array(), 0, size);
    }

    assertThat(isClosed(channel.socket())).isTrue();
  }

  @Test
  void aChunkWithoutAHeaderIsNotRead() throws Exception {
    Socket socket = open(hello("127.0.0.1"), 600_000).socket();

    socket.getOutputStream().write(new byte[] {'O', 'P', 'N', 'C', 0, 0, 0, 0});

    assertThat(isClosed(socket)).isTrue();
  }

  @Test
  void largeMessagesAreReadAfterTheLogIn() throws Exception {
    OpcUaClient client = OpcUaClient.create(url()).connect();
    List<NodeId> nodes = Collections.nCopies(5000, NodeIds.Server_ServerStatus_State);

    assertThat(client.readValues(0, Neither, nodes)).hasSize(5000);
    client.disconnect();
  }

  @Test
  void requestsAreNotReadWhileTheAnswersAreNot() throws Exception {
    Channel channel = open(hello("127.0.0.1"), 600_000);
    UaRequestMessageType request =
        new GetEndpointsRequest(header(NodeId.NULL_VALUE), url(), null, null);
    AtomicLong sent = new AtomicLong();
    Thread sender =
        new Thread(
            () -> {
              try {
                for (int number = 2; true; number++) {
                  byte[] bytes = bytes(channel.message(number, request));
                  channel.socket().getOutputStream().write(bytes);
                  sent.addAndGet(bytes.length);
                }
              } catch (IOException e) {
                // the test is over
              }
            });
    sender.start();

    // the buffers of the operating system have room for about 4 MB
    long before;
    do {
      before = sent.get();
      Thread.sleep(1000);
      assertThat(sent).hasValueLessThan(10_000_000);
    } while (sent.get() != before);
    OpcUaClient.create(url()).connect().disconnect();
    for (int i = 0; i < 2000; i++) {
      answer(channel.socket());
    }
    channel.socket().close();
    sender.join();
  }

  /** A buffer that Milo releases twice would otherwise be that of another message by then. */
  @Test
  void chunksShareNoBuffers() {
    EmbeddedChannel channel = new EmbeddedChannel();
    new Connections(now::get)
        .transport(ForkJoinPool.commonPool())
        .getChannelPipelineCustomizer()
        .accept(channel.pipeline());

    byte[] chunk = bytes(message("MSGC"));
    channel.writeInbound(Unpooled.copiedBuffer(chunk, chunk));
    ByteBuf first = channel.readInbound();
    ByteBuf second = channel.readInbound();
    first.release();

    assertThat(second.refCnt()).isEqualTo(1);
    assertThat(ByteBufUtil.getBytes(second)).isEqualTo(chunk);
    assertThat(channel.alloc().isDirectBufferPooled()).isFalse();
  }

  /** Milo releases the buffers of such a message twice. */
  @Test
  void aConnectionWithADamagedMessageIsClosedAndTakesNoMemory() throws Exception {
    int before = inMemory(NioSocketChannel.class);
    for (int i = 0; i < 50; i++) {
      Channel channel = open(hello("127.0.0.1"), 600_000);
      logIn(channel, createSession(channel));
      ByteArrayOutputStream message = new ByteArrayOutputStream();
      message.write(chunk(channel, "MSGC", 4));
      message.write(chunk(channel, "MSGF", 1)); // must be 5
      channel.socket().getOutputStream().write(message.toByteArray());

      while (!isClosed(channel.socket())) {
        // an error message
      }
    }

    // the server forgets closed connections after 5 s; the test's timeout is the deadline
    while (inMemory(NioSocketChannel.class) > before + 25) {
      Thread.sleep(100);
    }
  }

  private static byte[] chunk(Channel channel, String type, int number) {
    return bytes(
        message(type).putInt(channel.id()).putInt(channel.token()).putInt(number).putInt(4));
  }
}
