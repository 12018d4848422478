package no.hials.crosscom.mock;

import java.net.InetAddress;
import java.time.Duration;
import java.util.Objects;
import java.util.OptionalInt;
import java.util.function.Consumer;
import no.hials.crosscom.kinematics.RobotModel;
import no.hials.crosscom.protocol.Tail;

/**
 * How a {@link MockServer} behaves. Immutable; made by {@link #create}.
 *
 * <p>By default it is as strict as KUKAVARPROXY about what a client may ask for, and kinder about
 * when and how its requests arrive, so that a test is quick and does not depend on timing. {@link
 * Builder#asOnTheController} ends the kindness.
 *
 * @param bindAddress the address to listen on; by default the loopback address, so that nobody
 *     takes the server for a robot's
 * @param port the TCP port to listen on, 0 (the default) for a free one
 * @param failedRead how a refused read is answered; by default as KUKAVARPROXY does since 2019
 * @param failedWriteTail the tail that follows the echoed value of a refused write; by default
 *     {@code 00 01 00}. It must say failure
 * @param trimValues whether blanks at the ends of a value are cut off before it is sent, as
 *     KUKAVARPROXY does (the default) and C3 Bridge does not (krl.md 1.4)
 * @param maxClients how many clients are served at a time; one more is accepted and closed at once;
 *     10 by default as in KUKAVARPROXY, 0 for no limit
 * @param idleTimeout how long a client may send nothing before it is disconnected; 30 s by default
 *     as in KUKAVARPROXY, zero for ever
 * @param maxAggregateLength how many bytes the text of a written aggregate may have; 255 by default
 *     (krl.md 1.7), 0 for no limit
 * @param recordedRequests how many of the last requests are kept, 10,000 by default
 * @param joinSplitRequests whether a request that arrives in pieces is put together, the default.
 *     KUKAVARPROXY does not: it reads at most 2048 bytes at a time, answers the whole requests in
 *     them in turn, and drops the rest without an answer (krl.md 1.8). Assumed: what it reads next
 *     is taken for the beginning of a request, whatever it is
 * @param oneAtATime whether the {@link #latency} of a request holds up those of all clients, as on
 *     the controller (the default), or of its own client only
 * @param pendingRequests what becomes of a request that arrives while another is served; by default
 *     it waits
 * @param unknownFunction how a request of an unknown function number is answered; by default as
 *     KUKAVARPROXY does
 * @param ping whether reading {@code PING} answers {@code PONG} without asking the controller; true
 *     by default, as in KUKAVARPROXY since 2019. Before, it was a variable like others
 * @param latency how long the controller takes for a request; by default no time
 * @param discoveryPort the UDP port on which the question {@code WHEREAREYOU?} is answered with
 *     {@code KUKA|MODEL|SERIAL}, 0 for a free one; nothing (the default) for no discovery.
 *     KUKAVARPROXY has port 6999. MODEL is the text of {@code $MODEL_NAME[]} without quotes, SERIAL
 *     the number {@code $KR_SERIALNO}; a field is empty if the variable cannot be read
 * @param discoveryReplyPort the port of the sender that is answered to; 7000 by default as in
 *     KUKAVARPROXY, 0 for the port it sent from
 * @param clock how the time of {@link MockServer#controller} passes; by default as real time
 * @param robot the robot that the controller moves; by default a KR 6 R900 sixx
 */
public record MockServerConfig(
    InetAddress bindAddress,
    int port,
    FailedRead failedRead,
    Tail failedWriteTail,
    boolean trimValues,
    int maxClients,
    Duration idleTimeout,
    int maxAggregateLength,
    int recordedRequests,
    boolean joinSplitRequests,
    boolean oneAtATime,
    PendingRequests pendingRequests,
    UnknownFunction unknownFunction,
    boolean ping,
    Latency latency,
    OptionalInt discoveryPort,
    int discoveryReplyPort,
    Clock clock,
    RobotModel robot) {

  private static final int MAX_PORT = 65_535;
  private static final int MAX_RECORDED = 10_000_000;

  // of KUKAVARPROXY since 2019 (kukavarproxy.md, krl.md 1.7)
  private static final int MAX_CLIENTS = 10;
  private static final Duration IDLE_TIMEOUT = Duration.ofSeconds(30);
  private static final int MAX_AGGREGATE = 255;

  /** Checks the ranges. */
  public MockServerConfig {
    Objects.requireNonNull(bindAddress, "bindAddress");
    Objects.requireNonNull(failedRead, "failedRead");
    range("port", port, MAX_PORT);
    if (failedWriteTail.success()) {
      throw new IllegalArgumentException("failedWriteTail must say failure, is " + failedWriteTail);
    }
    range("maxClients", maxClients, Integer.MAX_VALUE);
    if (idleTimeout.isNegative() || idleTimeout.toSeconds() > Integer.MAX_VALUE / 1000) {
      throw new IllegalArgumentException("idleTimeout must be 0 to 24 days, is " + idleTimeout);
    }
    range("maxAggregateLength", maxAggregateLength, Integer.MAX_VALUE);
    range("recordedRequests", recordedRequests, MAX_RECORDED);
    Objects.requireNonNull(pendingRequests, "pendingRequests");
    if (pendingRequests == PendingRequests.DROP && !oneAtATime) {
      throw new IllegalArgumentException(
          "pendingRequests DROP needs oneAtATime: what is served at a time is never pending");
    }
    Objects.requireNonNull(unknownFunction, "unknownFunction");
    Objects.requireNonNull(latency, "latency");
    Objects.requireNonNull(clock, "clock");
    Objects.requireNonNull(robot, "robot");
    discoveryPort.ifPresent(value -> range("discoveryPort", value, MAX_PORT));
    range("discoveryReplyPort", discoveryReplyPort, MAX_PORT);
  }

  private static void range(String field, int value, int max) {
    if (value < 0 || value > max) {
      throw new IllegalArgumentException(field + " must be 0 to " + max + ", is " + value);
    }
  }

  /**
   * Makes a configuration.
   *
   * @param changes sets what shall differ from the defaults
   * @return the configuration
   */
  public static MockServerConfig create(Consumer<Builder> changes) {
    Builder builder = new Builder();
    changes.accept(builder);
    return builder.build();
  }

  /** Collects the settings; each method is described at the component of the same name. */
  public static final class Builder {
    private InetAddress bindAddress = InetAddress.getLoopbackAddress();
    private int port;
    private FailedRead failedRead = FailedRead.EMPTY_SUCCESS;
    private Tail failedWriteTail = Tail.FAILURE;
    private boolean trimValues = true;
    private int maxClients = MAX_CLIENTS;
    private Duration idleTimeout = IDLE_TIMEOUT;
    private int maxAggregateLength = MAX_AGGREGATE;
    private int recordedRequests = 10_000;
    private boolean joinSplitRequests = true;
    private boolean oneAtATime = true;
    private PendingRequests pendingRequests = PendingRequests.WAIT;
    private UnknownFunction unknownFunction = UnknownFunction.EMPTY_ANSWER;
    private boolean ping = true;
    private Latency latency = Latency.none();
    private OptionalInt discoveryPort = OptionalInt.empty();
    private int discoveryReplyPort = 7000;
    private Clock clock = Clock.real();
    private RobotModel robot = RobotModel.kr6r900sixx();

    private Builder() {}

    /**
     * Sets the address to listen on.
     *
     * @param value a local address
     * @return this
     */
    public Builder bindAddress(InetAddress value) {
      bindAddress = value;
      return this;
    }

    /**
     * Sets the port to listen on.
     *
     * @param value 0 to 65535
     * @return this
     */
    public Builder port(int value) {
      port = value;
      return this;
    }

    /**
     * Sets how a refused read is answered.
     *
     * @param value the way
     * @return this
     */
    public Builder failedRead(FailedRead value) {
      failedRead = value;
      return this;
    }

    /**
     * Sets the end of the answer to a refused write.
     *
     * @param value a tail of failure
     * @return this
     */
    public Builder failedWriteTail(Tail value) {
      failedWriteTail = value;
      return this;
    }

    /**
     * Sets whether values are trimmed.
     *
     * @param value true to trim
     * @return this
     */
    public Builder trimValues(boolean value) {
      trimValues = value;
      return this;
    }

    /**
     * Sets how many clients are served at a time.
     *
     * @param value 0 or more
     * @return this
     */
    public Builder maxClients(int value) {
      maxClients = value;
      return this;
    }

    /**
     * Sets how long a client may be silent.
     *
     * @param value zero or more
     * @return this
     */
    public Builder idleTimeout(Duration value) {
      idleTimeout = value;
      return this;
    }

    /**
     * Sets how long the text of a written aggregate may be.
     *
     * @param value in bytes, 0 or more
     * @return this
     */
    public Builder maxAggregateLength(int value) {
      maxAggregateLength = value;
      return this;
    }

    /**
     * Sets how many of the last requests are kept.
     *
     * @param value 0 to 10,000,000
     * @return this
     */
    public Builder recordedRequests(int value) {
      recordedRequests = value;
      return this;
    }

    /**
     * Sets whether a request may arrive in pieces.
     *
     * @param value true to put it together
     * @return this
     */
    public Builder joinSplitRequests(boolean value) {
      joinSplitRequests = value;
      return this;
    }

    /**
     * Sets whether clients hold up each other.
     *
     * @param value true for one request at a time over all clients
     * @return this
     */
    public Builder oneAtATime(boolean value) {
      oneAtATime = value;
      return this;
    }

    /**
     * Sets what becomes of a request that comes too early.
     *
     * @param value the way
     * @return this
     */
    public Builder pendingRequests(PendingRequests value) {
      pendingRequests = value;
      return this;
    }

    /**
     * Sets how a request of an unknown function is answered.
     *
     * @param value the way
     * @return this
     */
    public Builder unknownFunction(UnknownFunction value) {
      unknownFunction = value;
      return this;
    }

    /**
     * Sets whether {@code PING} is answered.
     *
     * @param value true to answer it, false to take it for a variable
     * @return this
     */
    public Builder ping(boolean value) {
      ping = value;
      return this;
    }

    /**
     * Sets how long the controller takes for a request.
     *
     * @param value the latency
     * @return this
     */
    public Builder latency(Latency value) {
      latency = value;
      return this;
    }

    /**
     * Switches discovery on.
     *
     * @param value the UDP port, 0 to 65535
     * @return this
     */
    public Builder discoveryPort(int value) {
      discoveryPort = OptionalInt.of(value);
      return this;
    }

    /**
     * Sets the port to which the question where controllers are is answered.
     *
     * @param value 0 to 65535
     * @return this
     */
    public Builder discoveryReplyPort(int value) {
      discoveryReplyPort = value;
      return this;
    }

    /**
     * Sets all that a client can notice as it is on a KR C4 with KUKAVARPROXY since 2019: the
     * limits and answers, which are the defaults, in place of what was set before; and also {@link
     * #joinSplitRequests} false, {@link #pendingRequests} {@link
     * PendingRequests#DROP_OF_SAME_CLIENT} and {@link Latency#krc4}. Address, ports and what is
     * recorded stay. {@link MockServer#dropCount} shows whether a client kept to the rules.
     *
     * @param seed the seed of the latency
     * @return this
     */
    public Builder asOnTheController(long seed) {
      return failedRead(FailedRead.EMPTY_SUCCESS)
          .failedWriteTail(Tail.FAILURE)
          .trimValues(true)
          .maxClients(MAX_CLIENTS)
          .idleTimeout(IDLE_TIMEOUT)
          .maxAggregateLength(MAX_AGGREGATE)
          .unknownFunction(UnknownFunction.EMPTY_ANSWER)
          .ping(true)
          .oneAtATime(true)
          .joinSplitRequests(false)
          .pendingRequests(PendingRequests.DROP_OF_SAME_CLIENT)
          .latency(Latency.krc4(seed));
    }

    /**
     * Sets how the time of the controller passes.
     *
     * @param value the clock
     * @return this
     */
    public Builder clock(Clock value) {
      clock = value;
      return this;
    }

    /**
     * Sets the robot that the controller moves.
     *
     * @param value the robot
     * @return this
     */
    public Builder robot(RobotModel value) {
      robot = value;
      return this;
    }

    private MockServerConfig build() {
      return new MockServerConfig(
          bindAddress,
          port,
          failedRead,
          failedWriteTail,
          trimValues,
          maxClients,
          idleTimeout,
          maxAggregateLength,
          recordedRequests,
          joinSplitRequests,
          oneAtATime,
          pendingRequests,
          unknownFunction,
          ping,
          latency,
          discoveryPort,
          discoveryReplyPort,
          clock,
          robot);
    }
  }
}
