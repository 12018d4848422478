package no.hials.crosscom.gateway.internal.opcua;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Path;
import java.time.Instant;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import no.hials.crosscom.cell.AuditLog;
import no.hials.crosscom.cell.RobotConnection;
import no.hials.crosscom.cell.TomlTable;
import no.hials.crosscom.cell.feed.Plant;
import no.hials.crosscom.cell.feed.PlantFile;
import no.hials.crosscom.cell.feed.Quality;
import no.hials.crosscom.cell.feed.RobotFeed;
import no.hials.crosscom.cell.feed.Update;
import no.hials.crosscom.cell.feed.Writes;
import no.hials.crosscom.gateway.GatewayContext;
import no.hials.crosscom.gateway.Health;
import no.hials.crosscom.mock.MockServer;
import no.hials.crosscom.mock.junit.KukaController;
import no.hials.crosscom.protocol.value.KrlValue;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class OpcUaOutputTest {
  @KukaController private MockServer robot;
  @TempDir private Path folder;

  /** The parts of a gateway that does not read. */
  private record Context(Plant plant, Path folder, Health health) implements GatewayContext {
    @Override
    public @Nullable RobotFeed robot(String name) {
      return null;
    }

    @Override
    public Writes writes() {
      return new Writes(new AuditLog(folder));
    }
  }

  private Plant plant() throws IOException {
    String text =
        """
        [robots.cell1]
        host = "%s:%d"

        [groups.all]
        variables = ["$POS_ACT", "$POS_ACT.X"]
        period = "1m"

        [variables."$POS_ACT.X"]
        range = [-1000, 1000]
        """
            .formatted(robot.host(), robot.port());
    return PlantFile.read(TomlTable.parse(Path.of("plant.toml"), text), Map.of());
  }

  private static List<Update> updates(RobotFeed feed) {
    KrlValue position = KrlValue.parse("{E6POS: X 1.0, Y 2.0, Z 3.0}");
    return feed.plan().variables().values().stream()
        .map(
            variable ->
                new Update(
                    variable,
                    Instant.now(),
                    Quality.GOOD,
                    Objects.requireNonNull(
                        variable.name().endsWith(".X") ? KrlValue.parse("1.0") : position),
                    ""))
        .toList();
  }

  @Test
  void nodesAndReferencesOfARemovedRobotAreGone() throws Exception {
    Plant plant = plant();
    OpcUaSettings settings = new OpcUaSettings("127.0.0.1", 0, true, List.of(), true, true);
    try (OpcUaOutput output = new OpcUaOutput(settings, new Context(plant, folder, new Health()));
        RobotFeed feed =
            RobotFeed.open(
                plant.plans().get(0), RobotConnection::openLazily, (robot, updates) -> {})) {
      output.updated(feed, updates(feed)); // before the nodes exist
      output.added(feed);
      output.updated(feed, updates(feed));
      int once = output.nodes();
      int references = output.references();
      output.removed(feed);
      assertThat(output.nodes()).isZero();

      output.added(feed);
      output.updated(feed, updates(feed));
      assertThat(output.nodes()).isEqualTo(once);
      assertThat(output.references()).isEqualTo(references);

      output.removed(feed);
      output.updated(feed, updates(feed));
      assertThat(output.nodes()).isZero();
      assertThat(output.references()).isZero();
    }
  }
}
