package no.hials.crosscom.gateway.internal.opcua;

import static java.nio.charset.StandardCharsets.US_ASCII;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.eclipse.milo.opcua.stack.core.types.builtin.unsigned.Unsigned.uint;
import static org.eclipse.milo.opcua.stack.core.types.enumerated.TimestampsToReturn.Neither;

import io.netty.buffer.ByteBuf;
import io.netty.buffer.ByteBufUtil;
import io.netty.buffer.Unpooled;
import io.netty.channel.embedded.EmbeddedChannel;
import java.io.ByteArrayOutputStream;
import java.io.DataInputStream;
import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.net.InetAddress;
import java.net.Socket;
import java.net.SocketException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.concurrent.ForkJoinPool;
import java.util.concurrent.atomic.AtomicLong;
import javax.management.ObjectName;
import no.hials.crosscom.cell.RobotConnection;
import no.hials.crosscom.cell.TomlTable;
import no.hials.crosscom.cell.feed.Plant;
import no.hials.crosscom.cell.feed.PlantFile;
import no.hials.crosscom.cell.feed.RobotFeed;
import no.hials.crosscom.gateway.Health;
import no.hials.crosscom.gateway.OneRobotContext;
import no.hials.crosscom.mock.MockServer;
import no.hials.crosscom.mock.junit.KukaController;
import org.eclipse.milo.opcua.sdk.client.OpcUaClient;
import org.eclipse.milo.opcua.sdk.server.Session;
import org.eclipse.milo.opcua.stack.core.NodeIds;
import org.eclipse.milo.opcua.stack.core.encoding.DefaultEncodingContext;
import org.eclipse.milo.opcua.stack.core.encoding.binary.OpcUaBinaryDecoder;
import org.eclipse.milo.opcua.stack.core.encoding.binary.OpcUaBinaryEncoder;
import org.eclipse.milo.opcua.stack.core.types.UaRequestMessageType;
import org.eclipse.milo.opcua.stack.core.types.UaResponseMessageType;
import org.eclipse.milo.opcua.stack.core.types.builtin.DateTime;
import org.eclipse.milo.opcua.stack.core.types.builtin.ExtensionObject;
import org.eclipse.milo.opcua.stack.core.types.builtin.LocalizedText;
import org.eclipse.milo.opcua.stack.core.types.builtin.NodeId;
import org.eclipse.milo.opcua.stack.core.types.builtin.StatusCode;
import org.eclipse.milo.opcua.stack.core.types.enumerated.ApplicationType;
import org.eclipse.milo.opcua.stack.core.types.structured.ActivateSessionRequest;
import org.eclipse.milo.opcua.stack.core.types.structured.AnonymousIdentityToken;
import org.eclipse.milo.opcua.stack.core.types.structured.ApplicationDescription;
import org.eclipse.milo.opcua.stack.core.types.structured.CreateSessionRequest;
import org.eclipse.milo.opcua.stack.core.types.structured.CreateSessionResponse;
import org.eclipse.milo.opcua.stack.core.types.structured.GetEndpointsRequest;
import org.eclipse.milo.opcua.stack.core.types.structured.RequestHeader;
import org.eclipse.milo.opcua.stack.core.types.structured.SignatureData;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Clients that connect and do not log in. */
@Timeout(60)
class ConnectionsTest {
  private static final String POLICY = "http://opcfoundation.org/UA/SecurityPolicy#None";

  @KukaController private MockServer robot;

  /** Shared by all tests, since the server's key takes time to create. */
  @TempDir private static Path folder;

  private final AtomicLong now = new AtomicLong();
  private final List<Socket> sockets = new ArrayList<>();
  private RobotFeed feed;
  private OpcUaOutput server;

  @BeforeEach
  void start() throws Exception {
    String text = "[robots.cell1]\nhost = \"%s:%d\"".formatted(robot.host(), robot.port());
    Plant plant = PlantFile.read(TomlTable.parse(Path.of("plant.toml"), text), Map.of());
    feed = RobotFeed.open(plant.plans().get(0), RobotConnection::openLazily, (one, updates) -> {});
    server =
        new OpcUaOutput(
            new OpcUaSettings("127.0.0.1", 0, true, List.of(), true, true),
            new OneRobotContext(plant, feed, folder, new Health()),
            now::get);
    server.ready();
  }

  @AfterEach
  void close() throws Exception {
    for (Socket socket : sockets) {
      socket.close();
    }
    server.close();
    feed.close();
  }

  private String url() {
    return "opc.tcp://127.0.0.1:" + server.port();
  }

  private Socket connect(String from) throws IOException {
    Socket socket = new Socket("127.0.0.1", server.port(), InetAddress.getByName(from), 0);
    sockets.add(socket);
    return socket;
  }

  private static ByteBuffer message(String type) {
    return ByteBuffer.allocate(1000)
        .order(ByteOrder.LITTLE_ENDIAN)
        .put(type.getBytes(US_ASCII))
        .putInt(0);
  }

  private static void putText(ByteBuffer buffer, String text) {
    buffer.putInt(text.length()).put(text.getBytes(US_ASCII));
  }

  /** Sends a message, and returns the first three letters and the rest of the answer. */
  private static ByteBuffer exchange(Socket socket, ByteBuffer message) throws IOException {
    socket.getOutputStream().write(bytes(message));
    return answer(socket);
  }

  private static byte[] bytes(ByteBuffer message) {
    byte[] bytes = new byte[message.position()];
    message.putInt(4, bytes.length).flip();
    message.get(bytes);
    return bytes;
  }

  private static ByteBuffer answer(Socket socket) throws IOException {
    DataInputStream in = new DataInputStream(socket.getInputStream());
    byte[] header = in.readNBytes(8);
    int answer = ByteBuffer.wrap(header).order(ByteOrder.LITTLE_ENDIAN).getInt(4);
    assertThat(new String(header, 0, 3, US_ASCII)).isIn("ACK", "OPN", "MSG");
    return ByteBuffer.wrap(in.readNBytes(answer - 8)).order(ByteOrder.LITTLE_ENDIAN);
  }

  /** Connects and says hello, as each client does first. */
  private Socket hello(String from) throws IOException {
    Socket socket = connect(from);
    ByteBuffer hello = message("HELF").putInt(0);
    hello.putInt(65_536).putInt(65_536).putInt(0).putInt(0);
    putText(hello, url());
    exchange(socket, hello);
    return socket;
  }

  /** Opens a secure channel without security. */
  private static Channel open(Socket socket, int lifetime) throws IOException {
    ByteBuffer open = message("OPNF").putInt(0);
    putText(open, POLICY);
    // no certificates; the sequence number, the request id and the type of the request
    open.putInt(-1)
        .putInt(-1)
        .putInt(1)
        .putInt(1)
        .put((byte) 1)
        .put((byte) 0)
        .putShort((short) 446);
    // the header of a request: no session, time, handle, diagnostics, audit, timeout, more
    open.putShort((short) 0).putLong(0).putInt(1).putInt(0).putInt(-1).putInt(0);
    open.putShort((short) 0).put((byte) 0);
    // protocol, issue, no security, no nonce
    open.putInt(0).putInt(0).putInt(1).putInt(-1).putInt(lifetime);
    ByteBuffer answer = exchange(socket, open);
    int end = answer.limit();
    return new Channel(
        socket, answer.getInt(end - 24), answer.getInt(end - 20), answer.getInt(end - 8));
  }

  /**
   * A secure channel.
   *
   * @param lifetime in ms
   */
  private record Channel(Socket socket, int id, int token, int lifetime) {
    /**
     * Sends a request, and returns the answer.
     *
     * @param number the number of the message on the channel; it is opened with 1
     */
    UaResponseMessageType send(int number, UaRequestMessageType request) throws IOException {
      ByteBuffer answer = exchange(socket, message(number, request)).position(16);
      return (UaResponseMessageType)
          new OpcUaBinaryDecoder(DefaultEncodingContext.INSTANCE)
              .setBuffer(Unpooled.wrappedBuffer(answer))
              .decodeMessage(null);
    }

    private ByteBuffer message(int number, UaRequestMessageType request) {
      ByteBuffer message =
          ConnectionsTest.message("MSGF").putInt(id).putInt(token).putInt(number).putInt(number);
      ByteBuf body = Unpooled.buffer();
      new OpcUaBinaryEncoder(DefaultEncodingContext.INSTANCE)
          .setBuffer(body)
          .encodeMessage(null, request);
      return message.put(body.nioBuffer());
    }
  }

  private static boolean isClosed(Socket socket) throws IOException {
    try {
      return socket.getInputStream().read() < 0;
    } catch (SocketException e) {
      return true; // reset
    }
  }

  @Test
  void aConnectionWithoutASessionIsClosedAndOneWithASessionIsNot() throws Exception {
    OpcUaClient client = OpcUaClient.create(url()).connect();
    Socket hello = hello("127.0.0.1");
    Socket channel = hello("127.0.0.1");
    open(channel, 600_000);
    now.addAndGet(Duration.ofSeconds(30).toNanos());
    Socket later = hello("127.0.0.1");

    now.addAndGet(Duration.ofSeconds(1).toNanos());

    assertThat(isClosed(hello)).isTrue();
    assertThat(isClosed(channel)).isTrue();
    assertThat(open(later, 600_000).lifetime()).isEqualTo(600_000);
    assertLoggedIn(client);

    client.disconnect();
    now.addAndGet(Duration.ofSeconds(30).toNanos());

    assertThat(isClosed(later)).isTrue();
  }

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

  @Test
  void connectionsAreLimited() throws Exception {
    for (int i = 0; i < 100; i++) {
      hello("127.0.0.1");
    }
    assertThat(isClosed(connect("127.0.0.1"))).isTrue();
    for (int i = 0; i < 50; i++) {
      hello("127.0.0.2");
    }
    assertThat(isClosed(connect("127.0.0.2"))).isTrue();

    // all of them, so that new ones find a place
    now.addAndGet(Duration.ofSeconds(31).toNanos());
    for (Socket socket : sockets) {
      assertThat(isClosed(socket)).isTrue();
    }
    hello("127.0.0.1");
    hello("127.0.0.2");
  }

  private CreateSessionRequest createSession(RequestHeader header) {
    ApplicationDescription application =
        new ApplicationDescription(
            "urn:test", "", LocalizedText.english(""), ApplicationType.Client, null, null, null);
    return new CreateSessionRequest(
        header, application, null, url(), "idle", null, null, 1e9, uint(0));
  }

  /** Creates a session on the connection of a client, and does not log in. */
  private void createSession(OpcUaClient client) throws Exception {
    CreateSessionRequest request = createSession(client.newRequestHeader());
    assertThat(client.getTransport().sendRequestMessage(request).get())
        .isInstanceOf(CreateSessionResponse.class);
  }

  private static RequestHeader header(NodeId session) {
    return new RequestHeader(session, DateTime.now(), uint(1), uint(0), "", uint(0), null);
  }

  /** Creates a session on a connection of its own, and returns its token. */
  private NodeId createSession(Channel channel) throws IOException {
    CreateSessionResponse created =
        (CreateSessionResponse) channel.send(2, createSession(header(NodeId.NULL_VALUE)));
    return created.getAuthenticationToken();
  }

  /** Waits for a number of sessions; the test's timeout is the deadline. */
  private void awaitSessions(OpcUaClient client, int number) throws Exception {
    do {
      assertLoggedIn(client);
    } while (server.sessions() != number);
  }

  private static void assertLoggedIn(OpcUaClient client) throws Exception {
    assertThat(client.readValue(0, Neither, NodeIds.Server_ServerStatus_State).statusCode())
        .isEqualTo(StatusCode.GOOD);
  }

  @Test
  void sessionsThatAreNotLoggedInKeepNobodyOut() throws Exception {
    OpcUaClient client = OpcUaClient.create(url()).connect();
    for (int i = 0; i < 200; i++) {
      createSession(client);
    }
    client.disconnect();

    OpcUaClient.create(url()).connect().disconnect();
  }

  @Test
  void theOldestSessionThatIsNotLoggedInEndsWhenThereAreTooMany() throws Exception {
    List<OpcUaClient> clients = new ArrayList<>();
    for (int i = 0; i < 60; i++) {
      OpcUaClient client = OpcUaClient.create(url()).connect();
      clients.add(client);
      createSession(client);
    }

    awaitSessions(clients.get(0), 100);
    for (OpcUaClient client : clients) {
      assertLoggedIn(client);
      client.disconnect();
    }
  }

  @Test
  void manySessionsOfOneAddressDoNotEndThatOfAnother() throws Exception {
    Channel slow = open(hello("127.0.0.2"), 600_000);
    NodeId session = createSession(slow);
    for (int i = 0; i < 100; i++) {
      createSession(open(hello("127.0.0.1"), 600_000));
    }

    UaResponseMessageType answer =
        slow.send(
            3,
            new ActivateSessionRequest(
                header(session),
                new SignatureData(null, null),
                null,
                null,
                ExtensionObject.encode(
                    DefaultEncodingContext.INSTANCE, new AnonymousIdentityToken("anonymous")),
                new SignatureData(null, null)));

    assertThat(answer.getResponseHeader().getServiceResult()).isEqualTo(StatusCode.GOOD);
  }

  @Test
  void aFloodOfLogInsOverAConnectionDoesNotTakeManyThreads() throws Exception {
    ThreadMXBean threads = ManagementFactory.getThreadMXBean();
    threads.resetPeakThreadCount();
    int before = threads.getThreadCount();
    List<Channel> channels = new ArrayList<>();
    for (int i = 0; i < 10; i++) {
      channels.add(open(hello("127.0.0.1"), 600_000));
    }
    for (Channel channel : channels) {
      ByteArrayOutputStream flood = new ByteArrayOutputStream();
      for (int number = 2; number < 62; number++) {
        flood.write(bytes(channel.message(number, createSession(header(NodeId.NULL_VALUE)))));
      }
      channel.socket().getOutputStream().write(flood.toByteArray());
    }

    for (Channel channel : channels) {
      for (int number = 2; number < 62; number++) {
        answer(channel.socket());
      }
    }

    assertThat(threads.getPeakThreadCount() - before).isLessThan(550);
    OpcUaClient.create(url()).connect().disconnect();
  }

  /** Returns the number of sessions that the memory has, also of servers of other tests. */
  private static int sessionsInMemory() throws Exception {
    String histogram =
        (String)
            ManagementFactory.getPlatformMBeanServer()
                .invoke(
                    new ObjectName("com.sun.management:type=DiagnosticCommand"),
                    "gcClassHistogram",
                    new Object[] {new String[0]},
                    new String[] {String[].class.getName()});
    return histogram
        .lines()
        .filter(line -> line.endsWith(" " + Session.class.getName()))
        .mapToInt(line -> Integer.parseInt(line.trim().split("\\s+", -1)[1]))
        .sum();
  }

  @Test
  void sessionsThatHaveEndedTakeNoMemory() throws Exception {
    Channel channel = open(hello("127.0.0.1"), 600_000);
    createSession(channel);
    int before = sessionsInMemory();

    for (int number = 3; number < 203; number++) {
      channel.send(number, createSession(header(NodeId.NULL_VALUE)));
    }

    assertThat(sessionsInMemory()).isBetween(1, before + 100);
  }

  @Test
  void aSessionWithALongNameIsRefused() throws Exception {
    OpcUaClient client = OpcUaClient.create(url()).connect();
    CreateSessionRequest request = createSession(client.newRequestHeader());
    CreateSessionRequest named =
        new CreateSessionRequest(
            request.getRequestHeader(),
            request.getClientDescription(),
            null,
            url(),
            "x".repeat(513),
            null,
            null,
            1e9,
            uint(0));

    assertThatThrownBy(() -> client.getTransport().sendRequestMessage(named).get())
        .hasMessageContaining("Bad_InvalidArgument");
    client.disconnect();
  }

  @Test
  void aSessionThatIsNotLoggedInEndsWithItsConnectionOrAfterSomeTime() throws Exception {
    OpcUaClient leaving = OpcUaClient.create(url()).connect();
    createSession(leaving);
    OpcUaClient staying = OpcUaClient.create(url()).connect();
    createSession(staying);
    awaitSessions(staying, 4);

    leaving.disconnect();
    awaitSessions(staying, 2);

    now.addAndGet(Duration.ofSeconds(31).toNanos());
    awaitSessions(staying, 1);
    staying.disconnect();
  }

  @Test
  void aSecureChannelMustBeRenewedAfterAnHour() throws Exception {
    assertThat(open(hello("127.0.0.1"), Integer.MAX_VALUE).lifetime()).isEqualTo(3_600_000);
  }
}
