package no.hials.crosscom.mock;

import java.net.InetAddress;
import java.time.Duration;
import java.util.Objects;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.function.Consumer;
import no.hials.crosscom.kinematics.RobotModel;
import no.hials.crosscom.protocol.ServerType;
import no.hials.crosscom.protocol.Tail;
import no.hials.crosscom.protocol.Version;
import no.hials.crosscom.simulator.FileTree;
import no.hials.crosscom.simulator.SimulationClock;
import org.jspecify.annotations.Nullable;

/**
 * How a {@link MockServer} behaves. Immutable; made by {@link #create}.
 *
 * <p>By default it is as strict as KUKAVARPROXY about what a client may ask for, and kinder about
 * when and how its requests arrive, so that a test is quick and does not depend on timing. {@link
 * Builder#asOnTheController} ends the kindness. With {@link ServerType#C3_BRIDGE} as {@link
 * #server} the defaults are those of C3 Bridge where they differ (c3-bridge.md, "Common to all
 * messages"; krl.md 1.8); which they are is decided when all is set, so the order does not matter.
 *
 * @param bindAddress the address to listen on; by default the loopback address, so that nobody
 *     takes the server for a robot's
 * @param port the TCP port to listen on, 0 (the default) for a free one
 * @param failedRead how a refused read is answered; by default as KUKAVARPROXY does since 2019, or
 *     {@link FailedRead#FAILURE_ZERO} with C3 Bridge. Of C3 Bridge's own messages the code decides
 * @param failedWriteTail the tail of the answer to a refused write, behind the echoed value, or
 *     with C3 Bridge behind none; by default {@code 00 01 00}, with C3 Bridge {@code 00 00 00}. It
 *     must say failure
 * @param trimValues whether blanks at the ends of a value are cut off before it is sent, as
 *     KUKAVARPROXY does (the default) and C3 Bridge does not (krl.md 1.4)
 * @param maxClients how many clients are served at a time; one more is accepted and closed at once;
 *     10 by default as in KUKAVARPROXY, with C3 Bridge 0; 0 for no limit
 * @param idleTimeout how long a client may send nothing before it is disconnected; 30 s by default
 *     as in KUKAVARPROXY, with C3 Bridge zero; zero for ever
 * @param maxAggregateLength how many bytes the text of a written aggregate may have; 255 by default
 *     (krl.md 1.7; assumed for C3 Bridge, too), 0 for no limit
 * @param recordedRequests how many of the last requests are kept, 10,000 by default
 * @param joinSplitRequests whether a request that arrives in pieces is put together, the default.
 *     KUKAVARPROXY does not: it reads at most 2048 bytes at a time, answers the whole requests in
 *     them in turn, and drops the rest without an answer (krl.md 1.8). Assumed: what it reads next
 *     is taken for the beginning of a request, whatever it is. C3 Bridge puts it together
 * @param oneAtATime whether the {@link #latency} of a request holds up those of all clients, as on
 *     the controller (the default), or of its own client only
 * @param pendingRequests what becomes of a request that arrives while another is served; by default
 *     it waits
 * @param unknownFunction how a request of an unknown function number is answered; by default as
 *     KUKAVARPROXY does, or C3 Bridge, which closes the connection
 * @param ping whether reading {@code PING} answers {@code PONG} without asking the controller; true
 *     by default, as in KUKAVARPROXY since 2019. Before, it was a variable like others. C3 Bridge
 *     asks the controller first
 * @param latency how long the controller takes for a request; by default no time
 * @param discoveryPort the UDP port on which the question {@code WHEREAREYOU?} is answered with
 *     {@code KUKA|MODEL|SERIAL}, 0 for a free one; nothing (the default) for no discovery.
 *     KUKAVARPROXY has port 6999, and so has C3 Bridge in what it calls legacy mode. MODEL is the
 *     text of {@code $MODEL_NAME[]} without quotes, with C3 Bridge with them (c3-vectors.tsv);
 *     SERIAL the number {@code $KR_SERIALNO}; a field is empty if the variable cannot be read
 * @param discoveryReplyPort the port of the sender that is answered to; 7000 by default as in
 *     KUKAVARPROXY, 0 for the port it sent from
 * @param clock how the time of {@link MockServer#controller} passes; by default as real time
 * @param robot the robot that the controller moves; by default a KR 6 R900 sixx
 * @param server which server it is; KUKAVARPROXY by default
 * @param version the version of C3 Bridge, at least 1.0; 1.4 by default. An older one does not know
 *     the messages that came later (c3-bridge.md, "Minimum server versions"). That it has types 6
 *     and 7 before they are correct is assumed, and so is what is wrong with them: all of them are
 *     answered with {@code NOT_IMPLEMENTED}, and nothing is read or written. What is wrong with
 *     large files before 1.4 is not simulated
 * @param computerName what C3 Bridge calls the computer that it runs on
 * @param standardDiscoveryPort the UDP port on which C3 Bridge answers the same question, and the
 *     names of its {@code @PROXY_} variables, to the port they came from; 0 for a free one, nothing
 *     (the default) for none. C3 Bridge has port 7000
 * @param files the files that clients of C3 Bridge reach; nothing (the default) for a tree in
 *     memory of the server's own
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
    SimulationClock clock,
    RobotModel robot,
    ServerType server,
    Version version,
    String computerName,
    OptionalInt standardDiscoveryPort,
    Optional<FileTree> files) {

  private static final int MAX_PORT = 65_535;
  private static final int MAX_RECORDED = 10_000_000;
  private static final int MAX_U8 = 255;

  /** As many as a host name has at most. */
  private static final int MAX_COMPUTER_NAME = 255;

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
    Objects.requireNonNull(server, "server");
    if (version.major() < 1 || version.major() > MAX_U8 || version.minor() > MAX_U8) {
      throw new IllegalArgumentException("version must be 1.0 to 255.255, is " + version);
    }
    if (computerName.length() > MAX_COMPUTER_NAME || computerName.chars().anyMatch(c -> c > '~')) {
      throw new IllegalArgumentException(
          "computerName must be ASCII and have at most "
              + MAX_COMPUTER_NAME
              + " characters, is "
              + computerName);
    }
    Objects.requireNonNull(files, "files");
    standardDiscoveryPort.ifPresent(value -> range("standardDiscoveryPort", value, MAX_PORT));
    if (server == ServerType.KUKAVARPROXY && standardDiscoveryPort.isPresent()) {
      throw new IllegalArgumentException("standardDiscoveryPort needs server C3_BRIDGE");
    }
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
    private @Nullable FailedRead failedRead;
    private @Nullable Tail failedWriteTail;
    private @Nullable Boolean trimValues;
    private @Nullable Integer maxClients;
    private @Nullable Duration idleTimeout;
    private int maxAggregateLength = MAX_AGGREGATE;
    private int recordedRequests = 10_000;
    private @Nullable Boolean joinSplitRequests;
    private boolean oneAtATime = true;
    private @Nullable PendingRequests pendingRequests;
    private @Nullable UnknownFunction unknownFunction;
    private boolean ping = true;
    private Latency latency = Latency.none();
    private OptionalInt discoveryPort = OptionalInt.empty();
    private int discoveryReplyPort = 7000;
    private SimulationClock clock = SimulationClock.real();
    private RobotModel robot = RobotModel.kr6r900sixx();
    private ServerType server = ServerType.KUKAVARPROXY;
    private Version version = new Version(1, 4, 0);
    private String computerName = "KRC4";
    private OptionalInt standardDiscoveryPort = OptionalInt.empty();
    private Optional<FileTree> files = Optional.empty();

    /** Whether what is not set is as on a controller. */
    private boolean onTheController;

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
     * Sets all that a client can notice as it is on a KR C4 with KUKAVARPROXY since 2019, or with
     * C3 Bridge: the limits and answers, which are the defaults, in place of what was set before;
     * and also {@link Latency#krc4}. With KUKAVARPROXY also {@link #joinSplitRequests} false and
     * {@link #pendingRequests} {@link PendingRequests#DROP_OF_SAME_CLIENT}. Server, version,
     * address, ports and what is recorded stay. {@link MockServer#dropCount} shows whether a client
     * kept to the rules.
     *
     * @param seed the seed of the latency
     * @return this
     */
    public Builder asOnTheController(long seed) {
      failedRead = null;
      failedWriteTail = null;
      trimValues = null;
      maxClients = null;
      idleTimeout = null;
      unknownFunction = null;
      joinSplitRequests = null;
      pendingRequests = null;
      onTheController = true;
      return maxAggregateLength(MAX_AGGREGATE)
          .ping(true)
          .oneAtATime(true)
          .latency(Latency.krc4(seed));
    }

    /**
     * Sets how the time of the controller passes.
     *
     * @param value the clock
     * @return this
     */
    public Builder clock(SimulationClock value) {
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

    /**
     * Sets which server it is.
     *
     * @param value the server
     * @return this
     */
    public Builder server(ServerType value) {
      server = value;
      return this;
    }

    /**
     * Sets the version of C3 Bridge.
     *
     * @param value 1.0 or later
     * @return this
     */
    public Builder version(Version value) {
      version = value;
      return this;
    }

    /**
     * Sets what C3 Bridge calls its computer.
     *
     * @param value a name of at most 255 ASCII characters
     * @return this
     */
    public Builder computerName(String value) {
      computerName = value;
      return this;
    }

    /**
     * Switches the standard mode of C3 Bridge's discovery on.
     *
     * @param value the UDP port, 0 to 65535
     * @return this
     */
    public Builder standardDiscoveryPort(int value) {
      standardDiscoveryPort = OptionalInt.of(value);
      return this;
    }

    /**
     * Sets the files that clients of C3 Bridge reach.
     *
     * @param value a tree, which several servers may share
     * @return this
     */
    public Builder files(FileTree value) {
      files = Optional.of(value);
      return this;
    }

    private static <T> T or(@Nullable T value, T otherwise) {
      return value == null ? otherwise : value;
    }

    private MockServerConfig build() {
      boolean c3 = server == ServerType.C3_BRIDGE;
      boolean lossy = onTheController && !c3;
      return new MockServerConfig(
          bindAddress,
          port,
          or(failedRead, c3 ? FailedRead.FAILURE_ZERO : FailedRead.EMPTY_SUCCESS),
          or(failedWriteTail, c3 ? Tail.FAILURE_ZERO : Tail.FAILURE),
          or(trimValues, !c3),
          or(maxClients, c3 ? 0 : MAX_CLIENTS),
          or(idleTimeout, c3 ? Duration.ZERO : IDLE_TIMEOUT),
          maxAggregateLength,
          recordedRequests,
          or(joinSplitRequests, !lossy),
          oneAtATime,
          or(pendingRequests, lossy ? PendingRequests.DROP_OF_SAME_CLIENT : PendingRequests.WAIT),
          or(unknownFunction, c3 ? UnknownFunction.CLOSE : UnknownFunction.EMPTY_ANSWER),
          ping,
          latency,
          discoveryPort,
          discoveryReplyPort,
          clock,
          robot,
          server,
          version,
          computerName,
          standardDiscoveryPort,
          files);
    }
  }
}
