package no.hials.crosscom.gateway.internal.opcua;

import static java.nio.charset.StandardCharsets.US_ASCII;
import static org.assertj.core.api.Assertions.assertThat;
import static org.eclipse.milo.opcua.stack.core.types.builtin.unsigned.Unsigned.uint;
import static org.eclipse.milo.opcua.stack.core.types.enumerated.TimestampsToReturn.Neither;

import io.netty.buffer.ByteBuf;
import io.netty.buffer.Unpooled;
import java.io.DataInputStream;
import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.net.InetAddress;
import java.net.Socket;
import java.net.SocketException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
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
import org.eclipse.milo.opcua.stack.core.types.structured.RequestHeader;
import org.eclipse.milo.opcua.stack.core.types.structured.SignatureData;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/** A server, and clients that write to its sockets. */
@Timeout(60)
abstract class SocketClientsTest {
  private static final String POLICY = "http://opcfoundation.org/UA/SecurityPolicy#None";

  @KukaController private MockServer robot;

  /** Shared by all tests, since the server's key takes time to create. */
  @TempDir private static Path folder;

  final AtomicLong now = new AtomicLong();
  final List<Socket> sockets = new ArrayList<>();
  private RobotFeed feed;
  OpcUaOutput server;

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

  String url() {
    return "opc.tcp://127.0.0.1:" + server.port();
  }

  Socket connect(String from) throws IOException {
    Socket socket = new Socket("127.0.0.1", server.port(), InetAddress.getByName(from), 0);
    sockets.add(socket);
    return socket;
  }

  static ByteBuffer message(String type) {
    return ByteBuffer.allocate(1000)
        .order(ByteOrder.LITTLE_ENDIAN)
        .put(type.getBytes(US_ASCII))
        .putInt(0);
  }

  private static void putText(ByteBuffer buffer, String text) {
    buffer.putInt(text.length()).put(text.getBytes(US_ASCII));
  }

  /** Sends a message, and returns the first three letters and the rest of the answer. */
  static ByteBuffer exchange(Socket socket, ByteBuffer message) throws IOException {
    socket.getOutputStream().write(bytes(message));
    return answer(socket);
  }

  static byte[] bytes(ByteBuffer message) {
    byte[] bytes = new byte[message.position()];
    message.putInt(4, bytes.length).flip();
    message.get(bytes);
    return bytes;
  }

  static ByteBuffer answer(Socket socket) throws IOException {
    DataInputStream in = new DataInputStream(socket.getInputStream());
    byte[] header = in.readNBytes(8);
    int answer = ByteBuffer.wrap(header).order(ByteOrder.LITTLE_ENDIAN).getInt(4);
    assertThat(new String(header, 0, 3, US_ASCII)).isIn("ACK", "OPN", "MSG");
    return ByteBuffer.wrap(in.readNBytes(answer - 8)).order(ByteOrder.LITTLE_ENDIAN);
  }

  /** Connects and says hello, as each client does first. */
  Socket hello(String from) throws IOException {
    Socket socket = connect(from);
    ByteBuffer hello = message("HELF").putInt(0);
    hello.putInt(65_536).putInt(65_536).putInt(0).putInt(0);
    putText(hello, url());
    exchange(socket, hello);
    return socket;
  }

  /** Opens a secure channel without security. */
  static Channel open(Socket socket, int lifetime) throws IOException {
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
  record Channel(Socket socket, int id, int token, int lifetime) {
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

    ByteBuffer message(int number, UaRequestMessageType request) {
      ByteBuffer message =
          SocketClientsTest.message("MSGF").putInt(id).putInt(token).putInt(number).putInt(number);
      ByteBuf body = Unpooled.buffer();
      new OpcUaBinaryEncoder(DefaultEncodingContext.INSTANCE)
          .setBuffer(body)
          .encodeMessage(null, request);
      return message.put(body.nioBuffer());
    }
  }

  static boolean isClosed(Socket socket) throws IOException {
    try {
      return socket.getInputStream().read() < 0;
    } catch (SocketException e) {
      return true; // reset
    }
  }

  static RequestHeader header(NodeId session) {
    return new RequestHeader(session, DateTime.now(), uint(1), uint(0), "", uint(0), null);
  }

  static void assertLoggedIn(OpcUaClient client) throws Exception {
    assertThat(client.readValue(0, Neither, NodeIds.Server_ServerStatus_State).statusCode())
        .isEqualTo(StatusCode.GOOD);
  }

  CreateSessionRequest createSession(RequestHeader header) {
    return createSession(header, "idle", 1e9);
  }

  /**
   * Returns a request for a session.
   *
   * @param timeout in ms
   */
  CreateSessionRequest createSession(RequestHeader header, String name, double timeout) {
    ApplicationDescription application =
        new ApplicationDescription(
            "urn:test", "", LocalizedText.english(""), ApplicationType.Client, null, null, null);
    return new CreateSessionRequest(
        header, application, null, url(), name, null, null, timeout, uint(0));
  }

  /** Creates a session on a connection of its own, and returns its token. */
  NodeId createSession(Channel channel) throws IOException {
    CreateSessionResponse created =
        (CreateSessionResponse) channel.send(2, createSession(header(NodeId.NULL_VALUE)));
    return created.getAuthenticationToken();
  }

  /** Logs in without a user, and returns the status of the answer. */
  static StatusCode logIn(Channel channel, NodeId session) throws IOException {
    UaResponseMessageType answer =
        channel.send(
            3,
            new ActivateSessionRequest(
                header(session),
                new SignatureData(null, null),
                null,
                null,
                ExtensionObject.encode(
                    DefaultEncodingContext.INSTANCE, new AnonymousIdentityToken("anonymous")),
                new SignatureData(null, null)));
    return answer.getResponseHeader().getServiceResult();
  }

  /** Returns the number of objects of a class in the memory, also of those of other tests. */
  static int inMemory(Class<?> type) throws Exception {
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
        .filter(line -> line.endsWith(" " + type.getName()))
        .mapToInt(line -> Integer.parseInt(line.trim().split("\\s+", -1)[1]))
        .sum();
  }
}
