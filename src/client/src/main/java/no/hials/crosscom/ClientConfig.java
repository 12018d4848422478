package no.hials.crosscom;

import java.time.Duration;
import java.util.Objects;
import java.util.function.Consumer;

/**
 * What a client is to do. Immutable; made by {@link #create}.
 *
 * @param host name or address of the controller; not blank
 * @param port TCP port of the server, 1 to 65535; KUKAVARPROXY's is 7000
 * @param connectTimeout how long connecting may take; more than zero, default 5 s
 * @param requestTimeout how long one exchange may take, from sending the request to the last byte
 *     of the answer; zero for no limit, default 3 s
 * @param maxAggregateLength how many bytes the text of a written aggregate may have, default 255
 *     (docs/reference/krl-values.md#lengths); zero for no limit
 * @param maxRequestLength how many bytes a request may have, default 2048: KUKAVARPROXY takes no
 *     more at a time and loses the rest (docs/reference/kukavarproxy.md#pieces-of-requests); 16 to
 *     65539. The messages that only C3 Bridge knows may have 65539 whatever this says
 * @param reconnect whether to reconnect automatically after the connection broke, default true
 * @param reconnectBackoff how long to wait after a first failed attempt to connect again; twice as
 *     long after each further one; default 100 ms
 * @param maxReconnectBackoff how long to wait at most between two attempts, default 5 s
 * @param keepAlive after how long without traffic a {@code PING} is read, since the server drops a
 *     client after 30 s (docs/reference/kukavarproxy.md#connections); zero for never, default 10 s
 * @param listener called after connects and losses
 */
public record ClientConfig(
    String host,
    int port,
    Duration connectTimeout,
    Duration requestTimeout,
    int maxAggregateLength,
    int maxRequestLength,
    boolean reconnect,
    Duration reconnectBackoff,
    Duration maxReconnectBackoff,
    Duration keepAlive,
    ConnectionListener listener) {

  /** The port that KUKAVARPROXY listens on. */
  public static final int DEFAULT_PORT = 7000;

  /** Hears nothing; no thread is started for it. */
  static final ConnectionListener NO_LISTENER = event -> {};

  /** Checks every field. */
  public ClientConfig {
    Objects.requireNonNull(host, "host");
    check(!host.isBlank(), "host must not be blank");
    check(port >= 1 && port <= 65_535, "port must be 1 to 65535, is " + port);
    time("connect time-out", connectTimeout, false);
    time("request time-out", requestTimeout, true);
    time("reconnect backoff", reconnectBackoff, false);
    time("greatest reconnect backoff", maxReconnectBackoff, false);
    time("keep-alive time", keepAlive, true);
    check(
        maxReconnectBackoff.compareTo(reconnectBackoff) >= 0,
        "greatest reconnect backoff must be at least "
            + reconnectBackoff
            + ", is "
            + maxReconnectBackoff);
    Objects.requireNonNull(listener, "listener");
    check(
        maxAggregateLength >= 0,
        "greatest aggregate length must be 0 or more, is " + maxAggregateLength);
    check(
        maxRequestLength >= 16 && maxRequestLength <= 65_539,
        "greatest request length must be 16 to 65539, is " + maxRequestLength);
  }

  private static void time(String field, Duration value, boolean zeroAllowed) {
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
  }

  private static void check(boolean holds, String rule) {
    if (!holds) {
      throw new IllegalArgumentException(rule);
    }
  }

  /**
   * Creates a configuration.
   *
   * @param host name or address of the controller
   * @param settings sets the options that differ from their defaults
   * @return the configuration
   * @throws IllegalArgumentException if a value is out of its range
   */
  public static ClientConfig create(String host, Consumer<Builder> settings) {
    Builder builder = new Builder(host);
    settings.accept(builder);
    return builder.build();
  }

  /** Collects the settings of a {@link ClientConfig}. */
  public static final class Builder {
    private final String host;
    private int port = DEFAULT_PORT;
    private Duration connectTimeout = Duration.ofSeconds(5);
    private Duration requestTimeout = Duration.ofSeconds(3);
    private int maxAggregateLength = 255;
    private int maxRequestLength = 2048;
    private boolean reconnect = true;
    private Duration reconnectBackoff = Duration.ofMillis(100);
    private Duration maxReconnectBackoff = Duration.ofSeconds(5);
    private Duration keepAlive = Duration.ofSeconds(10);
    private ConnectionListener listener = NO_LISTENER;

    private Builder(String host) {
      this.host = host;
    }

    /**
     * Sets the port.
     *
     * @param value 1 to 65535
     * @return this
     */
    public Builder port(int value) {
      port = value;
      return this;
    }

    /**
     * Sets how long connecting may take.
     *
     * @param value more than zero
     * @return this
     */
    public Builder connectTimeout(Duration value) {
      connectTimeout = value;
      return this;
    }

    /**
     * Sets how long one exchange may take.
     *
     * @param value zero for no limit
     * @return this
     */
    public Builder requestTimeout(Duration value) {
      requestTimeout = value;
      return this;
    }

    /**
     * Sets how long the text of a written aggregate may be.
     *
     * @param value in bytes; zero for no limit
     * @return this
     */
    public Builder maxAggregateLength(int value) {
      maxAggregateLength = value;
      return this;
    }

    /**
     * Sets how long a request may be.
     *
     * @param value in bytes, 16 to 65539
     * @return this
     */
    public Builder maxRequestLength(int value) {
      maxRequestLength = value;
      return this;
    }

    /**
     * Sets whether to reconnect automatically after the connection broke.
     *
     * @param value false to leave the client unusable after a failure of its connection
     * @return this
     */
    public Builder reconnect(boolean value) {
      reconnect = value;
      return this;
    }

    /**
     * Sets how long to wait between attempts to connect again.
     *
     * @param first after the first failed one; twice as long after each further one
     * @param most at most
     * @return this
     */
    public Builder reconnectBackoff(Duration first, Duration most) {
      reconnectBackoff = first;
      maxReconnectBackoff = most;
      return this;
    }

    /**
     * Sets after how long without traffic the connection is used to keep it.
     *
     * @param value zero for never
     * @return this
     */
    public Builder keepAlive(Duration value) {
      keepAlive = value;
      return this;
    }

    /**
     * Sets the listener for connects and losses.
     *
     * @param value called in a separate thread, one event after the other
     * @return this
     */
    public Builder listener(ConnectionListener value) {
      listener = value;
      return this;
    }

    private ClientConfig build() {
      return new ClientConfig(
          host,
          port,
          connectTimeout,
          requestTimeout,
          maxAggregateLength,
          maxRequestLength,
          reconnect,
          reconnectBackoff,
          maxReconnectBackoff,
          keepAlive,
          listener);
    }
  }
}
