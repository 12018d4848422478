package no.hials.crosscom.gateway;

import java.io.IOException;
import no.hials.crosscom.cell.FileException;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Applies changes of the configuration to a running gateway. A configuration with an error is
 * refused. An output or robot that cannot start is tried again later. Not thread-safe.
 */
final class ConfigFollower {
  private static final Logger LOG = LoggerFactory.getLogger(ConfigFollower.class);

  /** Checks from one attempt to the next. Each attempt costs time and lines in the log. */
  private static final int CHECKS_TO_RETRY = 10;

  private final Gateway gateway;
  private final Source source;
  private GatewayConfig current;
  private int checksToRetry;
  private String failure = "";

  /** Reads the configuration. */
  @FunctionalInterface
  interface Source {
    /**
     * Reads the current configuration.
     *
     * @throws FileException if it has an error
     */
    GatewayConfig read() throws FileException;
  }

  /**
   * Creates a follower.
   *
   * @param first the configuration that the gateway was started with
   */
  ConfigFollower(Gateway gateway, GatewayConfig first, Source source) {
    this.gateway = gateway;
    this.current = first;
    this.source = source;
  }

  /** Applies the configuration if it has changed, and returns whether it was applied. */
  boolean check() {
    GatewayConfig next;
    try {
      next = source.read();
    } catch (FileException e) {
      fail("the new configuration is refused, the old one stays: " + e.getMessage());
      return false;
    }
    boolean again = checksToRetry > 0 && --checksToRetry == 0;
    if (next.equals(current) && !again) {
      if (checksToRetry == 0) {
        failure = "";
      }
      return false;
    }
    current = next;
    try {
      gateway.apply(next);
    } catch (IOException | RuntimeException | Error e) {
      // also an error: the gateway goes on with what it has
      checksToRetry = CHECKS_TO_RETRY;
      fail(
          "the configuration has changed, but a part of it cannot start, which is tried again: "
              + e.getMessage());
      return false;
    }
    checksToRetry = 0;
    failure = "";
    LOG.info("the configuration has changed");
    return true;
  }

  private void fail(String message) {
    if (!message.equals(failure)) {
      LOG.error("{}", message);
    }
    failure = message;
  }
}
