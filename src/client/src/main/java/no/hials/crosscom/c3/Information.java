package no.hials.crosscom.c3;

import java.util.List;
import java.util.Map;
import no.hials.crosscom.CrossComException;
import no.hials.crosscom.CrossComRefusedException;
import no.hials.crosscom.CrossComUnsupportedException;
import no.hials.crosscom.protocol.server.Features;

/**
 * Asks C3 Bridge Interface about itself, and confirms the messages of the controller
 * (docs/reference/c3-messages.md#information-features-and-confirm-all-13-14-and-63).
 *
 * <p>Thread-safe. All methods block for at most the request time-out. They throw {@link
 * CrossComUnsupportedException} on KUKAVARPROXY and on versions without the message; {@link
 * CrossComRefusedException} with the server's code if it refuses; another {@link CrossComException}
 * if the exchange fails.
 *
 * <p>Programs get this object from {@link no.hials.crosscom.CrossComClient#information}.
 */
public interface Information {
  /**
   * Returns version, build, clock and host of the server.
   *
   * @return the server's answer
   * @throws CrossComException if the server does not support it, refuses, or the exchange fails
   */
  BridgeInfo get() throws CrossComException;

  /**
   * Returns the messages that the server supports. {@link
   * no.hials.crosscom.CrossComClient#getServer} returns them without asking again.
   *
   * @return the server's answer
   * @throws CrossComException if the server does not support it, refuses, or the exchange fails
   */
  Features features() throws CrossComException;

  /**
   * Confirms all messages of the controller that can be confirmed.
   *
   * @throws CrossComException if the server does not support it, refuses, or the exchange fails
   */
  void confirmAll() throws CrossComException;

  /**
   * Measures how fast the server reads variables on the controller
   * (docs/reference/c3-messages.md#benchmark-17). The benchmark must end within the request
   * time-out of the client.
   *
   * @param iterations the number of rounds, 0 to 4294967295
   * @param names the variables, 1 to 10
   * @return the time the server took
   * @throws CrossComException if the server does not support it, refuses, or the exchange fails
   */
  BenchmarkResult benchmarkRead(long iterations, List<String> names) throws CrossComException;

  /**
   * Measures how fast the server writes variables on the controller. The benchmark must end within
   * the request time-out of the client. <b>A write can move a machine.</b>
   *
   * @param iterations the number of rounds, 0 to 4294967295
   * @param values KRL texts by the variables' names, 1 to 10
   * @return the time the server took
   * @throws CrossComException if the server does not support it, refuses, or the exchange fails;
   *     the outcome can be unknown
   */
  BenchmarkResult benchmarkWrite(long iterations, Map<String, String> values)
      throws CrossComException;
}
