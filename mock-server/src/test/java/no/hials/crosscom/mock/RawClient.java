package no.hials.crosscom.mock;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.InputStream;
import java.net.Socket;
import java.util.Arrays;
import java.util.HexFormat;
import no.hials.crosscom.protocol.Codec;
import no.hials.crosscom.protocol.FrameReader;
import no.hials.crosscom.protocol.Request;
import no.hials.crosscom.protocol.Response;
import no.hials.crosscom.protocol.ServerType;
import no.hials.crosscom.protocol.variable.VariableRequest.ReadRequest;
import no.hials.crosscom.protocol.variable.VariableRequest.WriteRequest;
import no.hials.crosscom.protocol.variable.VariableResponse.ValueResponse;
import org.jspecify.annotations.Nullable;

/** A socket that sends and receives raw bytes. */
public final class RawClient implements AutoCloseable {
  /** Fails a test that would otherwise hang. */
  private static final int GIVE_UP_MILLIS = 20_000;

  private static final HexFormat HEX = HexFormat.ofDelimiter(" ").withUpperCase();

  private final MockServer server;
  private final Socket socket;
  private final InputStream in;
  private final ServerType type;
  private @Nullable FrameReader frames;

  public RawClient(MockServer server) throws IOException {
    this.server = server;
    socket = new Socket(server.host(), server.port());
    socket.setTcpNoDelay(true);
    socket.setSoTimeout(GIVE_UP_MILLIS);
    in = socket.getInputStream();
    type = server.config().server();
  }

  void send(String hex) throws IOException {
    send(HEX.parseHex(hex));
  }

  void send(byte[] bytes) throws IOException {
    socket.getOutputStream().write(bytes);
  }

  /**
   * Sends a request without an answer, and waits until it is served: KUKAVARPROXY would drop the
   * next request if it received both at once.
   */
  void sendUnanswered(String hex) throws IOException {
    long before = server.requestCount();
    send(hex);
    while (server.requestCount() == before) {
      Thread.onSpinWait();
    }
  }

  /** Closes the sending direction; bytes can still be received. */
  void endSending() throws IOException {
    socket.shutdownOutput();
  }

  /** Receives exactly this many bytes. */
  String receive(int count) throws IOException {
    return HEX.formatHex(in.readNBytes(count));
  }

  /** Receives as many bytes as this text has. */
  String receiveAsManyAs(String hex) throws IOException {
    return receive(HEX.parseHex(hex).length);
  }

  /** Receives all bytes until the server closes the connection. */
  String receiveAll() throws IOException {
    return HEX.formatHex(in.readAllBytes());
  }

  Response exchange(Request request) throws IOException {
    send(Codec.encode(request));
    return response();
  }

  /** Receives one frame. Must not be mixed with the methods that receive bytes. */
  Response response() throws IOException {
    return Codec.decodeResponse(receiveFrame(), type);
  }

  /**
   * Receives the bytes of one frame. Must not be mixed with the other methods that receive bytes.
   */
  byte[] receiveFrame() throws IOException {
    if (frames == null) {
      frames = new FrameReader(in);
    }
    int length = frames.next();
    if (length < 0) {
      throw new IOException("the server closed the connection");
    }
    return Arrays.copyOf(frames.buffer(), length);
  }

  public ValueResponse read(String name) throws IOException {
    return value(new ReadRequest(7, name));
  }

  ValueResponse write(String name, String value) throws IOException {
    return value(new WriteRequest(8, name, value));
  }

  private ValueResponse value(Request request) throws IOException {
    ValueResponse response = (ValueResponse) exchange(request);
    assertThat(response.type()).isEqualTo(request.type());
    return response;
  }

  @Override
  public void close() throws IOException {
    socket.close();
  }
}
