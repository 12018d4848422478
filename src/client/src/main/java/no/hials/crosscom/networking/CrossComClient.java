package no.hials.crosscom.networking;

import java.io.Closeable;
import java.io.IOException;
import java.net.InetAddress;
import java.net.SocketException;
import java.net.UnknownHostException;
import java.util.Objects;

/**
 * The client of version 0.1.
 *
 * @deprecated use {@link no.hials.crosscom.CrossComClient}
 */
@Deprecated
public final class CrossComClient implements Closeable {
  private final no.hials.crosscom.CrossComClient client;

  /**
   * Connects.
   *
   * @param host name or address of the controller
   * @param port the server's port, 1 to 65535, usually 7000
   * @throws UnknownHostException never; declared for programs of the original, which catch it
   * @throws IOException if the client could not connect
   */
  public CrossComClient(String host, int port) throws UnknownHostException, IOException {
    client = new no.hials.crosscom.CrossComClient(host, port);
  }

  /**
   * Reads or writes a variable by name.
   *
   * @param request a read or a write
   * @return the result; its value is empty if the controller refused
   * @throws IOException if the exchange fails
   */
  public Callback sendRequest(Request request) throws IOException {
    return new Callback(client.sendRequest(request));
  }

  /**
   * Returns the 16-bit number of two bytes, the higher first.
   *
   * @param bytes contains both bytes
   * @param off the index of the first byte
   * @return 0 to 65535
   */
  public static int getInt(byte[] bytes, int off) {
    return no.hials.crosscom.CrossComClient.getInt(bytes, off);
  }

  // --- methods of Socket that programs of the original call

  /** Returns true: the constructor connects, and as with a Socket closing changes nothing. */
  public boolean isConnected() {
    return client.isConnected();
  }

  /** Returns whether the client was closed. */
  public boolean isClosed() {
    return client.isClosed();
  }

  /** Returns the address of the controller. */
  public InetAddress getInetAddress() {
    return Objects.requireNonNull(client.getInetAddress()); // the constructor has connected
  }

  /** Returns the server's port. */
  public int getPort() {
    return client.getPort();
  }

  /** Returns the local port of the connection. */
  public int getLocalPort() {
    return client.getLocalPort();
  }

  /**
   * Sets the request time-out of the next exchanges.
   *
   * @param millis in ms; 0 for no limit
   * @throws SocketException never; declared for programs of the original, which may catch it
   */
  public void setSoTimeout(int millis) throws SocketException {
    client.setSoTimeout(millis);
  }

  /**
   * Returns the request time-out.
   *
   * @return in ms; 0 for no limit
   * @throws SocketException never; declared for programs of the original, which may catch it
   */
  public int getSoTimeout() throws SocketException {
    return client.getSoTimeout();
  }

  @Override
  public void close() throws IOException {
    client.close();
  }
}
