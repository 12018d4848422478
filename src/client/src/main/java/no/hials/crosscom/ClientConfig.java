package no.hials.crosscom;

import java.nio.charset.Charset;
import java.time.Duration;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import no.hials.crosscom.internal.exchange.TextCharset;
import no.hials.crosscom.protocol.ServerType;
import org.jspecify.annotations.Nullable;

/**
 * The options of a client. Immutable; created by {@link #create}. The {@link Builder} describes the
 * options.
 */
public final class ClientConfig {
  /** The port that KUKAVARPROXY listens on. */
  public static final int DEFAULT_PORT = 7000;

  /** Does nothing; no thread is started for it. */
  static final ConnectionListener NO_LISTENER = event -> {};

  /** One object, so that configurations without a condition are equal. */
  static final BooleanSupplier ALWAYS = () -> true;

  private final String host;
  private final Options options;

  private ClientConfig(String host, Options options) {
    this.host = host;
    this.options = options;
    check(!host.isBlank(), "host must not be blank");
  }

  /**
   * Creates a configuration.
   *
   * @param host name or address of the controller; not blank
   * @param settings sets the options that differ from their defaults
   * @return the configuration
   * @throws IllegalArgumentException if a value is out of its range
   */
  public static ClientConfig create(String host, Consumer<Builder> settings) {
    Builder builder = new Builder(host, new Options());
    settings.accept(builder);
    return builder.build();
  }

  /** Returns a new builder with the host and the options of this configuration. */
  public Builder toBuilder() {
    return new Builder(host, options);
  }

  private static Duration time(String field, Duration value, boolean zeroAllowed) {
    Objects.requireNonNull(value, field);
    boolean inRange =
        value.compareTo(Duration.ofMillis(1)) >= 0
            && value.compareTo(Duration.ofMillis(Integer.MAX_VALUE)) <= 0;
    check(
        inRange || (zeroAllowed && value.isZero()),
        field
            + " must be "
            + (zeroAllowed ? "0 or " : "")
            + "1 to "
            + Integer.MAX_VALUE
            + " ms, is "
            + value);
    return value;
  }

  private static void check(boolean holds, String rule) {
    if (!holds) {
      throw new IllegalArgumentException(rule);
    }
  }

  /** Returns the name or address of the controller. */
  public String host() {
    return host;
  }

  /** Returns the TCP port of the server. */
  public int port() {
    return options.port;
  }

  /** Returns the type of the server if it is set; empty if the client asks the server for it. */
  public Optional<ServerType> server() {
    return Optional.ofNullable(options.server);
  }

  /** Returns the connect time-out. */
  public Duration connectTimeout() {
    return options.connectTimeout;
  }

  /** Returns the request time-out, zero for no limit. */
  public Duration requestTimeout() {
    return options.requestTimeout;
  }

  /** Returns the maximum length of a written aggregate in bytes, zero for no limit. */
  public int maxAggregateLength() {
    return options.maxAggregateLength;
  }

  /** Returns the maximum length of a request in bytes. */
  public int maxRequestLength() {
    return options.maxRequestLength;
  }

  /** Returns the character set of texts on KUKAVARPROXY. */
  public Charset charset() {
    return options.charset;
  }

  /** Returns whether the client reconnects automatically after the connection broke. */
  public boolean reconnect() {
    return options.reconnect;
  }

  /** Returns how long to wait after the first failed attempt to reconnect. */
  public Duration reconnectBackoff() {
    return options.reconnectBackoff;
  }

  /** Returns the longest wait between two attempts. */
  public Duration maxReconnectBackoff() {
    return options.maxReconnectBackoff;
  }

  /** Returns the idle time after which the client reads {@code PING}, zero for never. */
  public Duration keepAlive() {
    return options.keepAlive;
  }

  /** Returns the listener for connects and losses. */
  public ConnectionListener listener() {
    return options.listener;
  }

  /** Returns the condition of each access. */
  public BooleanSupplier accessIf() {
    return options.accessIf;
  }

  /** Returns the maximum number of asynchronous calls that have not ended. */
  public int maxPendingCalls() {
    return options.maxPendingCalls;
  }

  /** Returns the runtime whose threads the client uses. */
  public ClientRuntime runtime() {
    return options.runtime;
  }

  /** Returns whether the other is a configuration with equal options. */
  @Override
  public boolean equals(@Nullable Object other) {
    return other instanceof ClientConfig config && values().equals(config.values());
  }

  @Override
  public int hashCode() {
    return values().hashCode();
  }

  @Override
  public String toString() {
    return "ClientConfig" + values();
  }

  private Map<String, Object> values() {
    Map<String, Object> values = new LinkedHashMap<>();
    values.put("host", host);
    values.put("port", options.port);
    values.put("server", server());
    values.put("connectTimeout", options.connectTimeout);
    values.put("requestTimeout", options.requestTimeout);
    values.put("keepAlive", options.keepAlive);
    values.put("charset", options.charset);
    values.put("maxAggregateLength", options.maxAggregateLength);
    values.put("maxRequestLength", options.maxRequestLength);
    values.put("reconnect", options.reconnect);
    values.put("reconnectBackoff", options.reconnectBackoff);
    values.put("maxReconnectBackoff", options.maxReconnectBackoff);
    values.put("listener", options.listener);
    values.put("accessIf", options.accessIf);
    values.put("maxPendingCalls", options.maxPendingCalls);
    values.put("runtime", options.runtime);
    return values;
  }

  /** The options as they were set. */
  private static final class Options implements Cloneable {
    private int port = DEFAULT_PORT;
    private @Nullable ServerType server;
    private Duration connectTimeout = Duration.ofSeconds(5);
    private Duration requestTimeout = Duration.ofSeconds(3);
    private int maxAggregateLength = 255;
    private int maxRequestLength = 2048;
    private Charset charset = Charset.forName("windows-1252");
    private boolean reconnect = true;
    private Duration reconnectBackoff = Duration.ofMillis(100);
    private Duration maxReconnectBackoff = Duration.ofSeconds(5);
    private Duration keepAlive = Duration.ofSeconds(10);
    private ConnectionListener listener = NO_LISTENER;
    private BooleanSupplier accessIf = ALWAYS;
    private int maxPendingCalls = 1000;
    private ClientRuntime runtime = ClientRuntime.shared();

    @Override
    public Options clone() {
      try {
        return (Options) super.clone();
      } catch (CloneNotSupportedException e) {
        throw new AssertionError(e);
      }
    }
  }

  /** Sets the options. Each method sets one option and returns this builder. */
  public static final class Builder {
    private final Options options;
    private String host;

    private Builder(String host, Options options) {
      this.host = Objects.requireNonNull(host, "host");
      this.options = options.clone();
    }

    /**
     * Creates the configuration.
     *
     * @return the configuration, which later calls of this builder do not change
     * @throws IllegalArgumentException if the host is blank
     */
    public ClientConfig build() {
      return new ClientConfig(host, options.clone());
    }

    /** Sets the name or address of the controller; not blank. */
    public Builder host(String value) {
      host = Objects.requireNonNull(value, "host");
      return this;
    }

    /** Sets the TCP port of the server, 1 to 65535. The default is KUKAVARPROXY's, 7000. */
    public Builder port(int value) {
      check(value >= 1 && value <= 65_535, "port must be 1 to 65535, is " + value);
      options.port = value;
      return this;
    }

    /**
     * Sets the type of the server, for servers that fail to answer the questions for it
     * (docs/reference/servers.md). By default the client asks the server when it has to know.
     */
    public Builder server(ServerType value) {
      options.server = Objects.requireNonNull(value, "server");
      return this;
    }

    // times

    /** Sets the connect time-out; at least 1 ms. The default is 5 s. */
    public Builder connectTimeout(Duration value) {
      options.connectTimeout = time("connect time-out", value, false);
      return this;
    }

    /**
     * Sets the request time-out, from the call to the last byte of the answer, for each exchange;
     * zero for no limit. It includes waiting for the exchanges of other threads. The default is 3
     * s.
     */
    public Builder requestTimeout(Duration value) {
      options.requestTimeout = time("request time-out", value, true);
      return this;
    }

    /**
     * Sets the idle time after which the client reads {@code PING}, zero for never. The server
     * drops a client after 30 s (docs/reference/kukavarproxy.md#connections). The default is 10 s.
     */
    public Builder keepAlive(Duration value) {
      options.keepAlive = time("keep-alive time", value, true);
      return this;
    }

    // texts

    /**
     * Sets the character set of the texts of KUKAVARPROXY, which is that of the controller's
     * Windows (docs/reference/kukavarproxy.md#texts). It must contain ASCII. The default is
     * windows-1252. C3 Bridge does not need it.
     */
    public Builder charset(Charset value) {
      Objects.requireNonNull(value, "charset");
      check(TextCharset.isUsable(value), "charset must have ASCII in the same bytes, is " + value);
      options.charset = value;
      return this;
    }

    // lengths

    /**
     * Sets the maximum length of a written aggregate in bytes, zero for no limit. The default is
     * 255 (docs/reference/krl-values.md#lengths).
     */
    public Builder maxAggregateLength(int value) {
      check(value >= 0, "maximum aggregate length must be 0 or more, is " + value);
      options.maxAggregateLength = value;
      return this;
    }

    /**
     * Sets the maximum length of a request in bytes, 16 to 65539. The default is 2048: KUKAVARPROXY
     * loses the rest (docs/reference/kukavarproxy.md#pieces-of-requests). Messages that only C3
     * Bridge supports may always have 65539.
     */
    public Builder maxRequestLength(int value) {
      check(
          value >= 16 && value <= 65_539,
          "maximum request length must be 16 to 65539, is " + value);
      options.maxRequestLength = value;
      return this;
    }

    // loss of the connection

    /**
     * Sets whether to reconnect automatically after the connection broke (the default), or to leave
     * the client unusable.
     */
    public Builder reconnect(boolean value) {
      options.reconnect = value;
      return this;
    }

    /**
     * Sets how long to wait between attempts to reconnect.
     *
     * @param first after the first failed attempt, then doubled. The default is 100 ms
     * @param most the longest wait; the default is 5 s
     */
    public Builder reconnectBackoff(Duration first, Duration most) {
      options.reconnectBackoff = time("reconnect backoff", first, false);
      options.maxReconnectBackoff = time("maximum reconnect backoff", most, false);
      check(
          most.compareTo(first) >= 0,
          "maximum reconnect backoff must be at least " + first + ", is " + most);
      return this;
    }

    /**
     * Sets the listener for connects and losses, which is called in a separate thread, one event
     * after the other.
     */
    public Builder listener(ConnectionListener value) {
      options.listener = Objects.requireNonNull(value, "listener");
      return this;
    }

    // permission

    /**
     * Sets a condition of each access to the controller, such as a lease: it is asked before each
     * attempt to connect and before each request, also those of watches and of the keep-alive. If
     * it is false, nothing is sent, the connection is closed, and the call fails with {@link
     * CrossComConnectException}. The client reconnects as after a loss. By default there is none.
     *
     * @param value called in several threads, also in those of the client; must not block
     */
    public Builder accessIf(BooleanSupplier value) {
      options.accessIf = Objects.requireNonNull(value, "accessIf");
      return this;
    }

    // threads

    /**
     * Sets how many asynchronous calls may be pending, 1 to 1,000,000. A call is pending until the
     * functions that follow on its future have returned. A call above the limit fails with {@link
     * java.util.concurrent.RejectedExecutionException}. The default is 1000.
     */
    public Builder maxPendingCalls(int value) {
      check(
          value >= 1 && value <= 1_000_000,
          "maximum number of pending calls must be 1 to 1000000, is " + value);
      options.maxPendingCalls = value;
      return this;
    }

    /**
     * Sets the runtime whose threads the client uses. The client is closed when the runtime is. The
     * default is {@link ClientRuntime#shared}.
     */
    public Builder runtime(ClientRuntime value) {
      options.runtime = Objects.requireNonNull(value, "runtime");
      return this;
    }
  }
}
