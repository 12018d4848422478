package no.hials.crosscom;

import java.io.IOException;
import java.net.InetAddress;
import java.net.SocketException;
import java.time.Duration;
import java.util.Arrays;
import java.util.Objects;
import no.hials.crosscom.KRL.KRLRealArray;
import no.hials.crosscom.KRL.KRLVariable;
import no.hials.crosscom.KRL.structs.KRLE6Axis;
import org.jspecify.annotations.Nullable;

/**
 * The calls of {@link CrossComClient} that only programs of the original need: requests by name,
 * joint angles and torques, and the methods of Socket.
 */
abstract sealed class OriginalAccess extends TypedAccess permits CrossComClient {
  abstract VariableExchange variables();

  abstract ReconnectingConnection connection();

  /** Returns the configuration. */
  public abstract ClientConfig getConfig();

  /**
   * Reads a variable and describes the access in one line.
   *
   * @param name the variable's name
   * @return {@code NAME #read time=Nms #value=VALUE}; the value is empty if the controller refuses
   * @throws CrossComException if the exchange fails
   */
  public String simpleRead(String name) throws IOException {
    return variables().readOrEmpty(name).describe(name);
  }

  /**
   * Writes a variable and describes the access in one line.
   *
   * @param name the variable's name
   * @param val the value as KRL text
   * @return {@code NAME #read time=Nms #value=VALUE}, with the value that the server echoed; empty
   *     if the controller refuses
   * @throws CrossComException if the exchange fails
   */
  public String simpleWrite(String name, String val) throws IOException {
    return variables().writeOrEmpty(name, val).describe(name);
  }

  /**
   * Reads or writes a variable by name.
   *
   * @param request a read or a write
   * @return the result; its value is empty if the controller refuses
   * @throws CrossComException if the exchange fails
   * @deprecated use {@link #readVariable} and {@link #writeVariable}, or {@link
   *     CrossComClient#readText} and {@link CrossComClient#writeText} if the type is not known
   */
  @Deprecated
  public Callback sendRequest(Request request) throws IOException {
    String name = Objects.requireNonNull(request, "request").getVariable();
    String value = request.getValue();
    return new Callback(
        request,
        value == null ? variables().readOrEmpty(name) : variables().writeOrEmpty(name, value));
  }

  /**
   * Reads the positions of the robot axes, {@code $AXIS_ACT}.
   *
   * @return a new array of six: A1 to A6 in degrees
   * @throws CrossComException if reading failed
   */
  public double[] readJointAngles() throws IOException {
    KRLE6Axis axes = KRLVariable.AXIS_ACT();
    readVariable(axes);
    try {
      return axes.asArrayA1ToA6();
    } catch (IllegalStateException e) {
      throw new CrossComValueException(
          axes.getName(),
          axes.getStringValue(),
          "the answer must have A1 to A6, is " + axes.getStringValue(),
          e);
    }
  }

  /**
   * Reads the torques of the robot axes in one access, {@code $TORQUE_AXIS_ACT[]}.
   *
   * @return a new array of six: A1 to A6 in Nm
   * @throws CrossComException if reading failed
   */
  public double[] readJointTorques() throws IOException {
    KRLRealArray torques = new KRLRealArray("$TORQUE_AXIS_ACT[]");
    readVariable(torques);
    if (torques.length() < 6) {
      throw new CrossComValueException(
          torques.getName(),
          torques.getStringValue(),
          "there must be at least 6 torques, there are " + torques.length(),
          null);
    }
    return Arrays.copyOf(Objects.requireNonNull(torques.getValue()), 6);
  }

  // --- methods of Socket that programs of the original call

  /** Returns true: the constructor connects, and as with a Socket closing changes nothing. */
  public boolean isConnected() {
    return true;
  }

  /** Returns the address of the controller; null before the client has connected. */
  public @Nullable InetAddress getInetAddress() {
    Connection last = connection().connection();
    return last == null ? null : last.remoteAddress();
  }

  /** Returns the server's port. */
  public int getPort() {
    return getConfig().port();
  }

  /**
   * Returns the local port of the connection, which changes when the client reconnects; -1 before
   * the client has connected.
   */
  public int getLocalPort() {
    Connection last = connection().connection();
    return last == null ? -1 : last.localPort();
  }

  /**
   * Sets the request time-out of the next exchanges.
   *
   * @param millis in ms; 0 for no limit
   * @throws SocketException never; declared for programs of the original, which may catch it
   * @throws IllegalArgumentException if the time is negative
   */
  public void setSoTimeout(int millis) throws SocketException {
    if (millis < 0) {
      throw new IllegalArgumentException("time-out must be 0 or more ms, is " + millis);
    }
    connection().setTimeout(Duration.ofMillis(millis).toNanos());
  }

  /**
   * Returns the request time-out.
   *
   * @return in ms; 0 for no limit
   * @throws SocketException never; declared for programs of the original, which may catch it
   */
  public int getSoTimeout() throws SocketException {
    return (int) Duration.ofNanos(connection().timeoutNanos()).toMillis();
  }
}
