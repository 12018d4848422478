package no.hials.crosscom.gateway.internal.prometheus;

import io.prometheus.metrics.exporter.httpserver.HTTPServer;
import io.prometheus.metrics.model.registry.MultiCollector;
import io.prometheus.metrics.model.snapshots.MetricSnapshots;
import java.io.IOException;
import java.net.InetAddress;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.ThreadPoolExecutor;
import java.util.concurrent.TimeUnit;
import java.util.logging.Level;
import no.hials.crosscom.cell.DaemonThreadFactory;
import no.hials.crosscom.cell.HostAndPort;
import no.hials.crosscom.cell.feed.RobotFeed;
import no.hials.crosscom.cell.feed.Update;
import no.hials.crosscom.gateway.Health;
import no.hials.crosscom.gateway.Output;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Shows the last values of robots and the figures of the gateway at {@code /metrics}. A value that
 * is stale or bad has no series, so that nobody mistakes it for a current value.
 */
final class PrometheusOutput implements Output {
  private static final Logger LOG = LoggerFactory.getLogger(PrometheusOutput.class);

  /** The number of requests that are answered at the same time. */
  private static final int MAX_REQUESTS = 64;

  /**
   * Prints a stack trace for each scraper that goes away. Kept here, because a logger to which
   * nothing refers forgets its level.
   */
  private static final java.util.logging.Logger OF_LOST_SCRAPERS =
      java.util.logging.Logger.getLogger("io.prometheus.metrics.exporter.httpserver");

  static {
    OF_LOST_SCRAPERS.setLevel(Level.OFF);
    // seconds; the server of the JDK reads them once, and waits without an end by default
    setIfAbsent("sun.net.httpserver.maxReqTime", "5");
    setIfAbsent("sun.net.httpserver.maxRspTime", "30");
  }

  private final Map<String, RobotMetrics> robots = new ConcurrentHashMap<>();
  private final Health health;
  private final MultiCollector collector = this::snapshots;
  private final HTTPServer server;

  PrometheusOutput(HostAndPort address, Health health) throws IOException {
    this.health = health;
    health.registry().register(collector);
    try {
      server =
          HTTPServer.builder()
              .inetAddress(InetAddress.getByName(address.host()))
              .port(Objects.requireNonNull(address.port()))
              .registry(health.registry())
              .executorService(executor())
              .buildAndStart();
    } catch (IOException e) {
      health.registry().unregister(collector);
      throw new IOException(
          "[prometheus] cannot listen on "
              + address.host()
              + ":"
              + address.port()
              + ": "
              + e.getMessage(),
          e);
    }
    LOG.info("Prometheus: http://{}:{}/metrics", address.host(), server.getPort());
  }

  private static void setIfAbsent(String property, String value) {
    if (System.getProperty(property) == null) {
      System.setProperty(property, value);
    }
  }

  private static ExecutorService executor() {
    ThreadPoolExecutor executor =
        new ThreadPoolExecutor(
            MAX_REQUESTS,
            MAX_REQUESTS,
            10,
            TimeUnit.SECONDS,
            new LinkedBlockingQueue<>(),
            DaemonThreadFactory.named("prometheus"));
    executor.allowCoreThreadTimeOut(true);
    return executor;
  }

  /** Returns the port that it listens on. */
  int port() {
    return server.getPort();
  }

  @Override
  public void added(RobotFeed robot) {
    robots.put(robot.name(), new RobotMetrics(robot));
  }

  @Override
  public void updated(RobotFeed robot, List<Update> updates) {
    RobotMetrics metrics = robots.get(robot.name());
    if (metrics != null) {
      updates.forEach(metrics::put);
    }
  }

  @Override
  public void removed(RobotFeed robot) {
    robots.remove(robot.name());
  }

  private MetricSnapshots snapshots() {
    MetricFamilies families = new MetricFamilies();
    robots.values().forEach(robot -> robot.addTo(families));
    return families.snapshots();
  }

  @Override
  public void close() {
    server.close();
    health.registry().unregister(collector);
  }
}
