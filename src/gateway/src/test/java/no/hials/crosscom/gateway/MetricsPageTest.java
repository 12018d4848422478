package no.hials.crosscom.gateway;

import static org.assertj.core.api.Assertions.assertThat;

import io.prometheus.metrics.model.snapshots.CounterSnapshot;
import io.prometheus.metrics.model.snapshots.MetricSnapshot;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import no.hials.crosscom.cell.RobotConnection;
import no.hials.crosscom.cell.TomlTable;
import no.hials.crosscom.gateway.internal.mqtt.MqttKind;
import no.hials.crosscom.gateway.internal.opcua.OpcUaKind;
import no.hials.crosscom.gateway.internal.prometheus.PrometheusKind;
import no.hials.crosscom.mock.MockServer;
import no.hials.crosscom.mock.junit.KukaController;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/** Compares the figures in {@code docs/reference/gateway.md} with those of a gateway. */
@Timeout(60)
class MetricsPageTest {
  private static final Path PAGE = Path.of("../../docs/reference/gateway.md");
  private static final Pattern ROW = Pattern.compile("(?m)^\\| (`jopenshowvar_[^|]*) \\|");
  private static final Pattern NAME = Pattern.compile("`(jopenshowvar_\\w+)`");

  @KukaController private MockServer robot;
  @TempDir private Path folder;

  private static Set<String> figures(Gateway gateway) {
    Set<String> names = new TreeSet<>();
    for (MetricSnapshot one : gateway.health().registry().scrape()) {
      String name = one.getMetadata().getName();
      names.add(one instanceof CounterSnapshot ? name + "_total" : name);
    }
    return names;
  }

  @Test
  void thePageHasEachFigureOnce() throws Exception {
    List<OutputKind<?>> kinds = List.of(new PrometheusKind(), new MqttKind(), new OpcUaKind());
    String text =
        """
        [robots.cell1]
        host = "%s:%d"

        [prometheus]
        address = "127.0.0.1:0"

        [mqtt]
        url = "tcp://127.0.0.1:1"
        commands = true

        [opcua]
        address = "127.0.0.1:0"
        """
            .formatted(robot.host(), robot.port());
    TomlTable root = TomlTable.parse(Path.of("plant.toml"), text);
    GatewayConfig config = GatewayConfig.read(root, folder, Map.of(), kinds);
    Set<String> figures;
    try (Gateway gateway = Gateway.start(config, kinds, RobotConnection::openLazily)) {
      do {
        figures = figures(gateway);
      } while (!figures.contains("jopenshowvar_value") || !figures.contains("jopenshowvar_state"));
    }

    List<String> onThePage =
        ROW.matcher(Files.readString(PAGE))
            .results()
            .flatMap(row -> NAME.matcher(row.group(1)).results())
            .map((MatchResult name) -> name.group(1))
            .collect(Collectors.toList());

    assertThat(onThePage).containsExactlyInAnyOrderElementsOf(figures);
  }
}
