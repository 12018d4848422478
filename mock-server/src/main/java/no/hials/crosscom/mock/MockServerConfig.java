package no.hials.crosscom.mock;

import java.io.IOException;
import java.net.InetAddress;
import java.nio.file.Path;
import java.time.Duration;
import java.util.Objects;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.function.Consumer;
import no.hials.crosscom.kinematics.RobotModel;
import no.hials.crosscom.mock.internal.CodePage;
import no.hials.crosscom.protocol.ServerType;
import no.hials.crosscom.protocol.Tail;
import no.hials.crosscom.protocol.Version;
import no.hials.crosscom.simulator.Archive;
import no.hials.crosscom.simulator.Controller;
import no.hials.crosscom.simulator.FileTree;
import no.hials.crosscom.simulator.LoadingMode;
import no.hials.crosscom.simulator.SimulationClock;
import org.jspecify.annotations.Nullable;

/**
 * The behaviour of a {@link MockServer}. Immutable; created by {@link #create}. The {@link Builder}
 * describes the options.
 *
 * <p>The default is as strict as KUKAVARPROXY about the requests, and more tolerant about the time
 * and the pieces in which they arrive, so that a test is fast and does not depend on timing. {@link
 * Builder#asOnTheController} is strict about these, too. With {@link ServerType#C3_BRIDGE} the
 * defaults are those of C3 Bridge where they differ (docs/reference/servers.md). The options can be
 * set in any order. The class is long because it has a documented method for each option.
 */
public final class MockServerConfig {
  private static final int MAX_PORT = 65_535;
  private static final int MAX_RECORDED = 10_000_000;
  private static final int MAX_U8 = 255;

  /** The length of the longest host name. */
  private static final int MAX_COMPUTER_NAME = 255;

  // KUKAVARPROXY since 2019 (docs/reference/kukavarproxy.md#connections)
  private static final int MAX_CLIENTS = 10;
  private static final Duration IDLE_TIMEOUT = Duration.ofSeconds(30);
  private static final int MAX_AGGREGATE = 255;

  private final Options options;

  private MockServerConfig(Options options) {
    this.options = options;
    check(
        isC3() || standardDiscoveryPort().isEmpty(),
        "standardDiscoveryPort needs server C3_BRIDGE",
        server());
    check(
        oneAtATime() || pendingRequests() != PendingRequests.DROP,
        "pendingRequests DROP needs oneAtATime, without which no request is pending",
        oneAtATime());
    check(
        !hasArchive() || files().isEmpty(),
        "archive and files exclude each other: an archive has its own files",
        hasArchive());
  }

  /**
   * Creates a configuration.
   *
   * @param changes sets the options that differ from their defaults
   * @throws IllegalArgumentException if an option is out of its range
   */
  public static MockServerConfig create(Consumer<Builder> changes) {
    Builder builder = new Builder();
    changes.accept(builder);
    return new MockServerConfig(builder.options.clone());
  }

  private boolean isC3() {
    return options.server == ServerType.C3_BRIDGE;
  }

  private boolean isLossy() {
    return options.onTheController && !isC3();
  }

  private static int range(String field, int value, int max) {
    check(value >= 0 && value <= max, field + " must be 0 to " + max, value);
    return value;
  }

  private static void check(boolean holds, String rule, Object value) {
    if (!holds) {
      throw new IllegalArgumentException(rule + ", is " + value);
    }
  }

  private static <T> T or(@Nullable T value, T otherwise) {
    return value == null ? otherwise : value;
  }

  /** Returns the address to listen on. */
  public InetAddress bindAddress() {
    return options.bindAddress;
  }

  /** Returns the TCP port to listen on, 0 for a free one. */
  public int port() {
    return options.port;
  }

  /** Returns the UDP port for discovery, empty if discovery is off. */
  public OptionalInt discoveryPort() {
    return options.discoveryPort;
  }

  /** Returns the port of the sender to which discovery answers, 0 for the port it sent from. */
  public int discoveryReplyPort() {
    return options.discoveryReplyPort;
  }

  /** Returns the UDP port of C3 Bridge's standard discovery, empty if that is off. */
  public OptionalInt standardDiscoveryPort() {
    return options.standardDiscoveryPort;
  }

  boolean isDiscoveryIfFree() {
    return options.discoveryIfFree;
  }

  boolean isStandardDiscoveryIfFree() {
    return options.standardDiscoveryIfFree;
  }

  /** Returns the server that is simulated. */
  public ServerType server() {
    return options.server;
  }

  /** Returns the version of C3 Bridge. */
  public Version version() {
    return options.version;
  }

  /** Returns the name of the computer that C3 Bridge runs on. */
  public String computerName() {
    return options.computerName;
  }

  /** Returns the answer to a refused read. */
  public FailedRead failedRead() {
    return or(options.failedRead, isC3() ? FailedRead.FAILURE_ZERO : FailedRead.EMPTY_SUCCESS);
  }

  /** Returns the tail of the answer to a refused write. */
  public Tail failedWriteTail() {
    return or(options.failedWriteTail, isC3() ? Tail.FAILURE_ZERO : Tail.FAILURE);
  }

  /** Returns the number of the Windows code page. */
  public int codePage() {
    return options.codePage;
  }

  /** Returns whether values are trimmed before they are sent. */
  public boolean trimValues() {
    return or(options.trimValues, !isC3());
  }

  /** Returns the answer to an unknown function number. */
  public UnknownFunction unknownFunction() {
    return or(
        options.unknownFunction, isC3() ? UnknownFunction.CLOSE : UnknownFunction.EMPTY_ANSWER);
  }

  /** Returns whether {@code PING} is answered with {@code PONG}. */
  public boolean ping() {
    return options.ping;
  }

  /** Returns the number of clients that are served at a time, 0 for no limit. */
  public int maxClients() {
    return or(options.maxClients, isC3() ? 0 : MAX_CLIENTS);
  }

  /** Returns the time without a request after which a client is disconnected, zero for no limit. */
  public Duration idleTimeout() {
    return or(options.idleTimeout, isC3() ? Duration.ZERO : IDLE_TIMEOUT);
  }

  /** Returns the longest text of an aggregate that can be written, in bytes, 0 for no limit. */
  public int maxAggregateLength() {
    return options.maxAggregateLength;
  }

  /** Returns the number of requests that are kept. */
  public int recordedRequests() {
    return options.recordedRequests;
  }

  /** Returns the bytes that the kept requests may take. */
  public long recordedBytes() {
    return options.recordedBytes;
  }

  /** Returns the time that the controller takes for a request. */
  public Latency latency() {
    return options.latency;
  }

  /** Returns whether the latency of a request delays all clients. */
  public boolean oneAtATime() {
    return options.oneAtATime;
  }

  /** Returns the treatment of a request that arrives while another is served. */
  public PendingRequests pendingRequests() {
    return or(
        options.pendingRequests,
        isLossy() ? PendingRequests.DROP_OF_SAME_CLIENT : PendingRequests.WAIT);
  }

  /** Returns whether the server joins the pieces of a request. */
  public boolean joinSplitRequests() {
    return or(options.joinSplitRequests, !isLossy());
  }

  /** Returns the clock of the controller. */
  public SimulationClock clock() {
    return options.clock;
  }

  /** Returns the robot that the controller moves. */
  public RobotModel robot() {
    return options.robot;
  }

  /** Returns whether the first motion of a program is a BCO run. */
  public boolean bco() {
    return options.bco;
  }

  /** Returns the files that C3 Bridge serves, empty for files in memory. */
  public Optional<FileTree> files() {
    return options.files;
  }

  /** Returns whether the files of a controller are loaded when the server starts. */
  public boolean hasArchive() {
    return options.archive.isPresent();
  }

  /** Returns how the files of an archive are loaded. */
  public LoadingMode archiveMode() {
    return options.archiveMode;
  }

  @Nullable Archive openArchive() throws IOException {
    return options.archive.isPresent() ? options.archive.get().open() : null;
  }

  /** Reads an archive, or returns one that was read before. */
  @FunctionalInterface
  private interface ArchiveOpener {
    Archive open() throws IOException;
  }

  /** The options as they were set; null stands for a default that depends on the server. */
  private static final class Options implements Cloneable {
    private InetAddress bindAddress = InetAddress.getLoopbackAddress();
    private int port;
    private OptionalInt discoveryPort = OptionalInt.empty();
    private int discoveryReplyPort = 7000;
    private OptionalInt standardDiscoveryPort = OptionalInt.empty();
    private boolean discoveryIfFree;
    private boolean standardDiscoveryIfFree;
    private ServerType server = ServerType.KUKAVARPROXY;
    private Version version = new Version(1, 4, 0);
    private String computerName = "KRC4";
    private int codePage = 1252;
    private @Nullable FailedRead failedRead;
    private @Nullable Tail failedWriteTail;
    private @Nullable Boolean trimValues;
    private @Nullable UnknownFunction unknownFunction;
    private boolean ping = true;
    private @Nullable Integer maxClients;
    private @Nullable Duration idleTimeout;
    private int maxAggregateLength = MAX_AGGREGATE;
    private int recordedRequests = 10_000;
    private long recordedBytes = 16L << 20;
    private Latency latency = Latency.none();
    private boolean oneAtATime = true;
    private @Nullable PendingRequests pendingRequests;
    private @Nullable Boolean joinSplitRequests;
    private SimulationClock clock = SimulationClock.real();
    private RobotModel robot = RobotModel.kr6r900sixx();
    private boolean bco = true;
    private Optional<FileTree> files = Optional.empty();
    private Optional<ArchiveOpener> archive = Optional.empty();
    private LoadingMode archiveMode = LoadingMode.LENIENT;

    /** Whether an option that is null is as on a controller. */
    private boolean onTheController;

    @Override
    public Options clone() {
      try {
        return (Options) super.clone();
      } catch (CloneNotSupportedException e) {
        throw new AssertionError(e);
      }
    }
  }

  /** Sets the options of a configuration. Each method sets one option and returns this builder. */
  public static final class Builder {
    private final Options options = new Options();

    private Builder() {}

    // where the server listens

    /** Sets the address to listen on. The default is the loopback address. */
    public Builder bindAddress(InetAddress value) {
      options.bindAddress = Objects.requireNonNull(value, "bindAddress");
      return this;
    }

    /** Sets the TCP port to listen on, 0 to 65535. The default 0 takes a free port. */
    public Builder port(int value) {
      options.port = range("port", value, MAX_PORT);
      return this;
    }

    /**
     * Sets the UDP port, 0 to 65535, on which the server answers {@code WHEREAREYOU?} with {@code
     * KUKA|MODEL|SERIAL}; 0 takes a free port. By default discovery is off. KUKAVARPROXY uses port
     * 6999, and so does C3 Bridge in legacy mode (docs/reference/wire-format.md#discovery). MODEL
     * is {@code $MODEL_NAME[]}, with quotes only from C3 Bridge; SERIAL is {@code $KR_SERIALNO}. A
     * field is empty if the variable cannot be read.
     */
    public Builder discoveryPort(int value) {
      options.discoveryPort = OptionalInt.of(range("discoveryPort", value, MAX_PORT));
      options.discoveryIfFree = false;
      return this;
    }

    /** Sets the port of discovery, which is off if another program uses the port. */
    public Builder discoveryPortIfFree(int value) {
      discoveryPort(value);
      options.discoveryIfFree = true;
      return this;
    }

    /**
     * Sets the port of the sender to which discovery answers. The default is 7000, as in
     * KUKAVARPROXY; 0 stands for the port the question came from.
     */
    public Builder discoveryReplyPort(int value) {
      options.discoveryReplyPort = range("discoveryReplyPort", value, MAX_PORT);
      return this;
    }

    /**
     * Sets the UDP port, 0 to 65535, of C3 Bridge's standard discovery: it answers {@code
     * WHEREAREYOU?} and the names of {@code @PROXY_} variables to the port they came from. 0 takes
     * a free port. By default it is off; C3 Bridge uses port 7000.
     */
    public Builder standardDiscoveryPort(int value) {
      options.standardDiscoveryPort =
          OptionalInt.of(range("standardDiscoveryPort", value, MAX_PORT));
      options.standardDiscoveryIfFree = false;
      return this;
    }

    /** Sets the port of the standard discovery, which is off if another program uses the port. */
    public Builder standardDiscoveryPortIfFree(int value) {
      standardDiscoveryPort(value);
      options.standardDiscoveryIfFree = true;
      return this;
    }

    // which server it is

    /** Sets the server to simulate. The default is KUKAVARPROXY. */
    public Builder server(ServerType value) {
      options.server = Objects.requireNonNull(value, "server");
      return this;
    }

    /**
     * Sets the version of C3 Bridge, 1.0 to 255.255. The default is 1.4. An older version does not
     * support messages that were added later (docs/reference/c3-messages.md#server-versions).
     * Assumed: a version in which types 6 and 7 have bugs answers them with {@code NOT_IMPLEMENTED}
     * and accesses nothing. The bugs with large files before 1.4 are not simulated.
     */
    public Builder version(Version value) {
      boolean known = value.major() >= 1 && value.major() <= MAX_U8 && value.minor() <= MAX_U8;
      check(known, "version must be 1.0 to 255.255", value);
      options.version = value;
      return this;
    }

    /** Sets the name of the computer that C3 Bridge runs on, at most 255 ASCII characters. */
    public Builder computerName(String value) {
      check(
          value.length() <= MAX_COMPUTER_NAME && value.chars().allMatch(c -> c <= '~'),
          "computerName must be ASCII and have at most " + MAX_COMPUTER_NAME + " characters",
          value);
      options.computerName = value;
      return this;
    }

    // how it answers

    /**
     * Sets the code page of the server's Windows, such as 1251 or 936, in which functions 0 and 1
     * carry texts. A character that the page lacks becomes a similar one, often in ASCII
     * (docs/reference/c3-messages.md#code-pages). The default is 1252.
     */
    public Builder codePage(int value) {
      CodePage unused = CodePage.of(value); // checks it
      options.codePage = value;
      return this;
    }

    /** Sets the answer to a refused read of message 0. The default is that of the server. */
    public Builder failedRead(FailedRead value) {
      options.failedRead = Objects.requireNonNull(value, "failedRead");
      return this;
    }

    /**
     * Sets the tail of the answer to a refused write, a tail of failure. KUKAVARPROXY sends it
     * after the echoed value, by default {@code 00 01 00}; C3 Bridge after an empty value, by
     * default {@code 00 00 00}.
     */
    public Builder failedWriteTail(Tail value) {
      check(!value.success(), "failedWriteTail must say failure", value);
      options.failedWriteTail = value;
      return this;
    }

    /**
     * Sets whether values are trimmed before they are sent. KUKAVARPROXY does so (the default), C3
     * Bridge does not (docs/reference/krl-values.md#arrays).
     */
    public Builder trimValues(boolean value) {
      options.trimValues = value;
      return this;
    }

    /** Sets the answer to an unknown function number. The default is that of the server. */
    public Builder unknownFunction(UnknownFunction value) {
      options.unknownFunction = Objects.requireNonNull(value, "unknownFunction");
      return this;
    }

    /**
     * Sets whether the server answers a read of {@code PING} with {@code PONG} without asking the
     * controller. The default is true, as in KUKAVARPROXY since 2019; before, {@code PING} was a
     * variable like others. C3 Bridge asks the controller first.
     */
    public Builder ping(boolean value) {
      options.ping = value;
      return this;
    }

    // what it allows

    /**
     * Sets the number of clients that are served at a time, 0 for no limit. The server closes
     * further connections at once. The default is 10, as in KUKAVARPROXY, and 0 with C3 Bridge.
     */
    public Builder maxClients(int value) {
      options.maxClients = range("maxClients", value, Integer.MAX_VALUE);
      return this;
    }

    /**
     * Sets the time without a request after which a client is disconnected, at most 24 days. The
     * default is 30 s, as in KUKAVARPROXY, and zero with C3 Bridge, which stands for no limit.
     */
    public Builder idleTimeout(Duration value) {
      check(
          !value.isNegative() && value.toSeconds() <= Integer.MAX_VALUE / 1000,
          "idleTimeout must be 0 to 24 days",
          value);
      options.idleTimeout = value;
      return this;
    }

    /**
     * Sets the longest text of an aggregate that can be written, in bytes. The default is 255
     * (docs/reference/krl-values.md#lengths; assumed for C3 Bridge); 0 stands for no limit.
     */
    public Builder maxAggregateLength(int value) {
      options.maxAggregateLength = range("maxAggregateLength", value, Integer.MAX_VALUE);
      return this;
    }

    /** Sets the number of requests that are kept, 0 to 10,000,000. The default is 10,000. */
    public Builder recordedRequests(int value) {
      options.recordedRequests = range("recordedRequests", value, MAX_RECORDED);
      return this;
    }

    /**
     * Sets the approximate size of the kept requests in bytes; the oldest are discarded first, and
     * the last request is kept in any case. The default is 16 MiB.
     */
    public Builder recordedBytes(long value) {
      check(value >= 0, "recordedBytes must be 0 or more", value);
      options.recordedBytes = value;
      return this;
    }

    // when it answers

    /** Sets the time that the controller takes for a request. The default is 0. */
    public Builder latency(Latency value) {
      options.latency = Objects.requireNonNull(value, "latency");
      return this;
    }

    /**
     * Sets whether the latency of a request delays all clients, as on the controller (the default),
     * or only the client that sent it.
     */
    public Builder oneAtATime(boolean value) {
      options.oneAtATime = value;
      return this;
    }

    /**
     * Sets the treatment of a request that arrives while another is served; it waits by default.
     */
    public Builder pendingRequests(PendingRequests value) {
      options.pendingRequests = Objects.requireNonNull(value, "pendingRequests");
      return this;
    }

    /**
     * Sets whether the server joins the pieces of a request, as C3 Bridge does (the default).
     * KUKAVARPROXY reads at most 2048 bytes at a time and drops the pieces without an answer.
     * Assumed: it takes the next bytes it reads for the start of a request. In both cases
     * KUKAVARPROXY drops the bytes after a request in the same receive
     * (docs/reference/kukavarproxy.md#pieces-of-requests).
     */
    public Builder joinSplitRequests(boolean value) {
      options.joinSplitRequests = value;
      return this;
    }

    // the controller

    /** Sets the clock of {@link MockServer#controller}. The default is real time. */
    public Builder clock(SimulationClock value) {
      options.clock = Objects.requireNonNull(value, "clock");
      return this;
    }

    /**
     * Sets the robot that the controller moves, such as {@code RobotModel.named("KR 210 R2700-2")},
     * and its machine data in the variables. The default is a KR 6 R900 sixx.
     */
    public Builder robot(RobotModel value) {
      options.robot = Objects.requireNonNull(value, "robot");
      return this;
    }

    /**
     * Sets whether the first motion of a program is a BCO run, at whose end it has to be started
     * again, as {@link Controller#simulateBco} does. The default is true.
     */
    public Builder bco(boolean value) {
      options.bco = value;
      return this;
    }

    /** Sets the files that C3 Bridge serves. By default each server has its own in memory. */
    public Builder files(FileTree value) {
      options.files = Optional.of(value);
      return this;
    }

    /**
     * Sets the archive of a controller to load when the server starts: a zip or a folder in any
     * layout, see {@link Archive}. {@link MockServer#archiveReport} has the result for each file. A
     * line that is not understood is a warning, and the rest is loaded. The archive's files are
     * those that C3 Bridge serves, as a copy in memory: a client never changes the archive. Not
     * together with {@link #files}.
     */
    public Builder archive(Path value) {
      return archive(() -> Archive.open(value), LoadingMode.LENIENT);
    }

    /**
     * Sets an archive that was read before, as {@link #archive(Path)} does.
     *
     * @param value the files
     * @param mode {@code STRICT} to refuse each file that has an error
     */
    public Builder archive(Archive value, LoadingMode mode) {
      Objects.requireNonNull(value, "archive");
      return archive(() -> value, mode);
    }

    private Builder archive(ArchiveOpener opener, LoadingMode mode) {
      options.archive = Optional.of(opener);
      options.archiveMode = Objects.requireNonNull(mode, "mode");
      return this;
    }

    /**
     * Resets everything a client can notice to the behaviour of a KR C4 with KUKAVARPROXY since
     * 2019, or with C3 Bridge: the defaults, and {@link Latency#krc4}. With KUKAVARPROXY, {@link
     * #joinSplitRequests} becomes false and {@link #pendingRequests} becomes {@link
     * PendingRequests#DROP_OF_SAME_CLIENT}. Server, version, address, ports and the number of
     * recorded requests stay. {@link MockServer#dropCount} shows whether a client kept the rules.
     *
     * @param seed the seed of the latency
     */
    public Builder asOnTheController(long seed) {
      options.failedRead = null;
      options.failedWriteTail = null;
      options.trimValues = null;
      options.maxClients = null;
      options.idleTimeout = null;
      options.unknownFunction = null;
      options.joinSplitRequests = null;
      options.pendingRequests = null;
      options.onTheController = true;
      return maxAggregateLength(MAX_AGGREGATE)
          .ping(true)
          .bco(true)
          .oneAtATime(true)
          .latency(Latency.krc4(seed));
    }
  }
}
