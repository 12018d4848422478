package no.hials.crosscom.c3;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import no.hials.crosscom.CrossComException;
import no.hials.crosscom.CrossComRefusedException;
import no.hials.crosscom.CrossComUnsupportedException;
import no.hials.crosscom.internal.MessageChannel;
import no.hials.crosscom.protocol.MessageType;
import no.hials.crosscom.protocol.PlainResponse;
import no.hials.crosscom.protocol.Request;
import no.hials.crosscom.protocol.server.Features;
import no.hials.crosscom.protocol.server.FeaturesResponse;
import no.hials.crosscom.protocol.server.InformationResponse;
import no.hials.crosscom.protocol.server.ServerInformation;
import no.hials.crosscom.protocol.server.ServerRequest;
import no.hials.crosscom.protocol.variable.Assignment;
import no.hials.crosscom.protocol.variable.BenchmarkReadRequest;
import no.hials.crosscom.protocol.variable.BenchmarkResponse;
import no.hials.crosscom.protocol.variable.BenchmarkWriteRequest;

/**
 * Asks C3 Bridge Interface about itself, and confirms the messages of the controller (c3-bridge.md,
 * types 13, 14, 17 and 63).
 *
 * <p>For several threads. All methods block for the request time-out at most, and throw: {@link
 * CrossComUnsupportedException} on KUKAVARPROXY and on older versions without the message; {@link
 * CrossComRefusedException} with the server's code if it refused; another {@link CrossComException}
 * if the exchange failed.
 */
public final class Information {
  /** How many variables the server uses of a benchmark (c3-bridge.md, type 17). */
  private static final int MAX_BENCHMARK = 10;

  private final MessageChannel link;

  /**
   * Makes the object of a client. For the client; programs get it from {@link
   * no.hials.crosscom.CrossComClient#information}.
   *
   * @param link sends the messages
   */
  public Information(MessageChannel link) {
    this.link = link;
  }

  /**
   * Asks for version, build, clock and host.
   *
   * @return the answer
   * @throws CrossComException if the server cannot, refused, or the exchange failed
   */
  public BridgeInfo get() throws CrossComException {
    ServerInformation information =
        link.ask(
                new ServerRequest(0, MessageType.INFORMATION),
                InformationResponse.class,
                "request for the server's information")
            .information();
    return new BridgeInfo(
        information.version(),
        information.build(),
        information.time().instant().orElse(null),
        information.computerName());
  }

  /**
   * Asks for the messages that the server knows. {@link no.hials.crosscom.CrossComClient#getServer}
   * gives them without asking again.
   *
   * @return the answer
   * @throws CrossComException if the server cannot, refused, or the exchange failed
   */
  public Features features() throws CrossComException {
    return link.ask(
            new ServerRequest(0, MessageType.FEATURES),
            FeaturesResponse.class,
            "request for the server's features")
        .features();
  }

  /**
   * Confirms all messages of the controller that can be confirmed.
   *
   * @throws CrossComException if the server cannot, refused, or the exchange failed
   */
  public void confirmAll() throws CrossComException {
    link.ask(
        new ServerRequest(0, MessageType.CONFIRM_ALL),
        PlainResponse.class,
        "confirmation of all messages");
  }

  /**
   * Lets the server read variables again and again, and measure the time. It must end within the
   * request time-out of the client.
   *
   * @param iterations how often, 0 to 4294967295
   * @param names the variables, 1 to 10
   * @return how long it took
   * @throws CrossComException if the server cannot, refused, or the exchange failed
   */
  public BenchmarkResult benchmarkRead(long iterations, List<String> names)
      throws CrossComException {
    checkCount(names.size());
    return benchmark(
        new BenchmarkReadRequest(0, iterations, names), "benchmark of reading " + names);
  }

  /**
   * Lets the server write variables again and again, and measure the time. It must end within the
   * request time-out of the client. <b>A write can move a machine.</b>
   *
   * @param iterations how often, 0 to 4294967295
   * @param values KRL texts by the variables' names, 1 to 10
   * @return how long it took
   * @throws CrossComException if the server cannot, refused, or the exchange failed; its outcome
   *     can be unknown
   */
  public BenchmarkResult benchmarkWrite(long iterations, Map<String, String> values)
      throws CrossComException {
    checkCount(values.size());
    List<Assignment> assignments = new ArrayList<>();
    values.forEach((name, value) -> assignments.add(new Assignment(name, value)));
    return benchmark(
        new BenchmarkWriteRequest(0, iterations, assignments),
        "benchmark of writing " + values.keySet());
  }

  private BenchmarkResult benchmark(Request request, String what) throws CrossComException {
    BenchmarkResponse response = link.ask(request, BenchmarkResponse.class, what);
    return new BenchmarkResult(
        response.count(), response.iterations(), Duration.ofMillis(response.differenceMillis()));
  }

  private static void checkCount(int count) {
    if (count < 1 || count > MAX_BENCHMARK) {
      throw new IllegalArgumentException(
          "a benchmark must have 1 to " + MAX_BENCHMARK + " variables, has " + count);
    }
  }
}
