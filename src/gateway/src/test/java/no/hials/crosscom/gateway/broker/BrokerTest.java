package no.hials.crosscom.gateway.broker;

import io.prometheus.metrics.model.snapshots.CounterSnapshot;
import io.prometheus.metrics.model.snapshots.GaugeSnapshot;
import io.prometheus.metrics.model.snapshots.MetricSnapshot;
import java.io.IOException;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.concurrent.locks.LockSupport;
import java.util.function.BooleanSupplier;
import no.hials.crosscom.cell.RobotConnection;
import no.hials.crosscom.cell.TomlTable;
import no.hials.crosscom.gateway.Gateway;
import no.hials.crosscom.gateway.GatewayConfig;
import no.hials.crosscom.gateway.LogLines;
import no.hials.crosscom.gateway.OutputKind;
import no.hials.crosscom.gateway.internal.mqtt.MqttKind;
import no.hials.crosscom.mock.MockServer;
import no.hials.crosscom.mock.junit.KukaController;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/** A gateway with one simulated robot, and a broker. */
@Timeout(60)
abstract class BrokerTest {
  private static final long PATIENCE = Duration.ofSeconds(40).toNanos();
  private static final List<OutputKind<?>> KINDS = List.of(new MqttKind());

  static final String READ_ALL =
      """
      [groups.all]
      variables = ["$OV_PRO", "$POS_ACT", "$MODE_OP", "NOSUCH"]
      period = "50ms"
      """;

  @KukaController MockServer robot;
  @TempDir Path folder;

  /** The lines that the gateway logs during the test. */
  final LogLines lines = LogLines.ofGateway();

  @Nullable Gateway gateway;
  @Nullable Mosquitto broker;

  /** Starts a gateway that reads the robot as cell1. */
  Gateway start(String text) throws IOException {
    return start(text, KINDS);
  }

  Gateway start(String text, List<OutputKind<?>> kinds) throws IOException {
    gateway = Gateway.start(config(text, kinds), kinds, RobotConnection::openLazily);
    return gateway;
  }

  /** Returns a configuration with the robot. */
  GatewayConfig config(String text) throws IOException {
    return config(text, KINDS);
  }

  private GatewayConfig config(String text, List<OutputKind<?>> kinds) throws IOException {
    String robots =
        """
        [limits]
        access-time = "1ms"
        load = 100

        [robots.cell1]
        host = "%s:%d"
        timeout = "1s"
        """
            .formatted(robot.host(), robot.port());
    TomlTable root = TomlTable.parse(folder.resolve("plant.toml"), robots + text);
    return GatewayConfig.read(root, folder.resolve("data"), Map.of(), kinds);
  }

  /** Returns the table of a broker on the loopback address. */
  static String mqtt(Mosquitto broker, String... lines) {
    return mqtt(broker.port(), lines);
  }

  /** Returns the table of a broker that is behind a cable. */
  static String mqtt(Cable cable, String... lines) {
    return mqtt(cable.port(), lines);
  }

  private static String mqtt(int port, String... lines) {
    String url = "url = \"tcp://127.0.0.1:" + port + "\"\n";
    return "[mqtt]\n" + url + String.join("\n", lines) + "\n";
  }

  /** Returns a figure of the gateway, summed over its labels. */
  static double figure(Gateway gateway, String name) {
    double sum = 0;
    for (MetricSnapshot one : gateway.health().registry().scrape()) {
      if (one.getMetadata().getName().equals("jopenshowvar_" + name)) {
        if (one instanceof CounterSnapshot counter) {
          sum += counter.getDataPoints().stream().mapToDouble(it -> it.getValue()).sum();
        } else if (one instanceof GaugeSnapshot gauge) {
          sum += gauge.getDataPoints().stream().mapToDouble(it -> it.getValue()).sum();
        }
      }
    }
    return sum;
  }

  static void await(BooleanSupplier condition) {
    long end = System.nanoTime() + PATIENCE;
    while (!condition.getAsBoolean()) {
      if (System.nanoTime() - end > 0) {
        throw new AssertionError("not in time");
      }
      LockSupport.parkNanos(1_000_000);
    }
  }

  @AfterEach
  void close() {
    lines.close();
    if (gateway != null) {
      gateway.close();
    }
    if (broker != null) {
      broker.close();
    }
  }
}
