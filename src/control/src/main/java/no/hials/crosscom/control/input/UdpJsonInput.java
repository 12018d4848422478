package no.hials.crosscom.control.input;

import com.fasterxml.jackson.core.JsonFactory;
import com.fasterxml.jackson.core.JsonParser;
import com.fasterxml.jackson.core.JsonToken;
import com.fasterxml.jackson.core.StreamReadFeature;
import java.io.IOException;
import java.net.DatagramPacket;
import java.net.DatagramSocket;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.atomic.AtomicLong;
import no.hials.crosscom.protocol.value.PrintableText;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Receives input as JSON in UDP datagrams, so that a phone or any program can move the robot:
 *
 * <pre>{@code
 * {"axes": [0.5, -1, 0], "buttons": [true, false], "deadMan": true}
 * }</pre>
 *
 * <p>All fields are optional, but nothing moves without {@code deadMan}; other fields are ignored.
 * The sender must send repeatedly, several times within the maximum age of the input, since the
 * robot stands still without input. An invalid datagram changes nothing and is counted. <b>Everyone
 * who can reach the port can move the robot</b>: it is bound to the loopback address unless another
 * address is given.
 *
 * <p>It runs the daemon thread {@code crosscom-input-PORT} until it is closed.
 */
public final class UdpJsonInput implements InputDevice {
  private static final Logger LOG = LoggerFactory.getLogger(UdpJsonInput.class);
  private static final int MAX_LENGTH = 2048;
  private static final int MAX_VALUES = 100;
  private static final JsonFactory JSON =
      JsonFactory.builder().enable(StreamReadFeature.STRICT_DUPLICATE_DETECTION).build();

  private final DatagramSocket socket;
  private final AtomicLong refused = new AtomicLong();
  private volatile Input latest = Input.NONE;
  private volatile @Nullable IOException failure;

  private UdpJsonInput(DatagramSocket socket) {
    this.socket = socket;
  }

  /**
   * Listens on the loopback address.
   *
   * @param port the UDP port; 0 for a free port
   * @return the device; the caller must close it
   * @throws IOException if the port cannot be used
   */
  public static UdpJsonInput listen(int port) throws IOException {
    return listen(new InetSocketAddress(InetAddress.getLoopbackAddress(), port));
  }

  /**
   * Listens on an address, for senders on other computers.
   *
   * @param address the address of this computer and the UDP port
   * @return the device; the caller must close it
   * @throws IOException if the address cannot be used
   */
  public static UdpJsonInput listen(InetSocketAddress address) throws IOException {
    UdpJsonInput input = new UdpJsonInput(new DatagramSocket(address));
    Thread thread = new Thread(input::receive, "crosscom-input-" + input.port());
    thread.setDaemon(true);
    thread.start();
    return input;
  }

  /** Returns the UDP port that this device listens on. */
  public int port() {
    return socket.getLocalPort();
  }

  /** Returns the number of invalid datagrams. */
  public long refusedDatagrams() {
    return refused.get();
  }

  private void receive() {
    // one byte more than allowed detects a truncated datagram
    DatagramPacket packet = new DatagramPacket(new byte[MAX_LENGTH + 1], MAX_LENGTH + 1);
    while (!socket.isClosed()) {
      try {
        packet.setLength(MAX_LENGTH + 1);
        socket.receive(packet);
      } catch (IOException e) {
        if (!socket.isClosed()) {
          failure = e;
          socket.close();
        }
        return;
      }
      try {
        latest = parse(packet.getData(), packet.getLength());
      } catch (IOException | IllegalArgumentException e) {
        refused.incrementAndGet();
        LOG.debug(
            "a datagram from {} is refused: {}",
            packet.getAddress(),
            PrintableText.of(String.valueOf(e.getMessage())));
      }
    }
  }

  private static Input parse(byte[] bytes, int length) throws IOException {
    if (length > MAX_LENGTH) {
      throw new IOException("a datagram must have at most " + MAX_LENGTH + " bytes, has more");
    }
    List<Double> axes = new ArrayList<>();
    List<Boolean> buttons = new ArrayList<>();
    boolean deadMan = false;
    try (JsonParser json = JSON.createParser(bytes, 0, length)) {
      expect(json, json.nextToken(), JsonToken.START_OBJECT);
      while (json.nextToken() != JsonToken.END_OBJECT) {
        String field = json.currentName();
        json.nextToken();
        switch (field) {
          case "axes" -> readAxes(json, axes);
          case "buttons" -> readButtons(json, buttons);
          case "deadMan" -> deadMan = json.getBooleanValue();
          default -> json.skipChildren();
        }
      }
      if (json.nextToken() != null) {
        throw new IOException("expected one object, found more text");
      }
    }
    return new Input(axes, buttons, deadMan, System.nanoTime());
  }

  private static void readAxes(JsonParser json, List<Double> axes) throws IOException {
    expect(json, json.currentToken(), JsonToken.START_ARRAY);
    while (json.nextToken() != JsonToken.END_ARRAY) {
      axes.add(json.getDoubleValue());
      atMost(axes);
    }
  }

  private static void readButtons(JsonParser json, List<Boolean> buttons) throws IOException {
    expect(json, json.currentToken(), JsonToken.START_ARRAY);
    while (json.nextToken() != JsonToken.END_ARRAY) {
      buttons.add(json.getBooleanValue());
      atMost(buttons);
    }
  }

  private static void atMost(List<?> values) throws IOException {
    if (values.size() > MAX_VALUES) {
      throw new IOException("expected at most " + MAX_VALUES + " values, found more");
    }
  }

  private static void expect(JsonParser json, @Nullable JsonToken found, JsonToken wanted)
      throws IOException {
    if (found != wanted) {
      throw new IOException(
          "expected "
              + wanted
              + " at "
              + json.currentLocation().getColumnNr()
              + ", found "
              + found);
    }
  }

  @Override
  public Input read() throws IOException {
    if (failure != null) {
      throw failure;
    }
    return latest;
  }

  @Override
  public void close() {
    socket.close();
  }
}
