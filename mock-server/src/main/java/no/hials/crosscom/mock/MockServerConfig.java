package no.hials.crosscom.mock;

import java.net.InetAddress;
import java.time.Duration;
import java.util.Objects;
import java.util.function.Consumer;
import no.hials.crosscom.protocol.Tail;

/**
 * How a {@link MockServer} behaves. Immutable; made by {@link #create}.
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
    int recordedRequests) {

  private static final int MAX_PORT = 65_535;
  private static final int MAX_RECORDED = 10_000_000;

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
    private int maxClients = 10;
    private Duration idleTimeout = Duration.ofSeconds(30);
    private int maxAggregateLength = 255;
    private int recordedRequests = 10_000;

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
          recordedRequests);
    }
  }
}
