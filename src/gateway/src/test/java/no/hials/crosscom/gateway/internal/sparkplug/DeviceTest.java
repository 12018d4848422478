package no.hials.crosscom.gateway.internal.sparkplug;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.time.Instant;
import java.util.List;
import java.util.Map;
import java.util.concurrent.atomic.AtomicLong;
import no.hials.crosscom.cell.RobotConnection;
import no.hials.crosscom.cell.TomlTable;
import no.hials.crosscom.cell.feed.PlannedVariable;
import no.hials.crosscom.cell.feed.PlantFile;
import no.hials.crosscom.cell.feed.PollPlan;
import no.hials.crosscom.cell.feed.Quality;
import no.hials.crosscom.cell.feed.RobotFeed;
import no.hials.crosscom.cell.feed.Update;
import no.hials.crosscom.mock.MockServer;
import no.hials.crosscom.mock.junit.KukaController;
import no.hials.crosscom.protocol.value.KrlValue;
import org.eclipse.tahu.message.model.Metric;
import org.eclipse.tahu.message.model.MetricDataType;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

@Timeout(60)
class DeviceTest {
  @KukaController private MockServer robot;
  private RobotFeed feed;
  private Device device;

  @BeforeEach
  void open() throws Exception {
    String text =
        """
        [robots.cell1]
        host = "%s:%d"
        [groups.all]
        variables = ["S", "$POS_ACT", "LIST[]"]
        period = "1s"
        """
            .formatted(robot.host(), robot.port());
    PollPlan plan =
        PlantFile.read(TomlTable.parse(Path.of("plant.toml"), text), Map.of()).plans().get(0);
    feed = RobotFeed.open(plan, RobotConnection::openLazily, (one, updates) -> {});
    device = new Device(feed, new AtomicLong()::incrementAndGet);
  }

  @AfterEach
  void close() throws Exception {
    feed.close();
  }

  private List<DeviceMetric> take(String variable, Quality quality, @Nullable KrlValue value) {
    PlannedVariable planned = feed.plan().variables().get(variable);
    device.take(List.of(new Update(planned, Instant.now(), quality, value, "")));
    return device.takeUnsent();
  }

  private List<DeviceMetric> take(String value) {
    return take("S", Quality.GOOD, KrlValue.parse(value));
  }

  private Metric birthOf(String name) {
    return device.birth().stream().filter(it -> name.equals(it.getName())).findAny().orElseThrow();
  }

  private static Object property(Metric metric, String name) {
    return metric.getProperties().getPropertyMap().get(name).getValue();
  }

  @Test
  void aMetricOfTheStoreBelongsToItsVariable() {
    DeviceMetric x = device.fromStore("$POS_ACT.X", MetricDataType.Float);
    DeviceMetric element = device.fromStore("LIST[2]", MetricDataType.Int32);
    assertThat(x.isOf("$POS_ACT")).isTrue();
    assertThat(element.isOf("LIST[]")).isTrue();
    assertThat(device.fromStore("SUM", MetricDataType.Int32).isOf("S")).isFalse();

    take("$POS_ACT", Quality.GOOD, KrlValue.parse("{X 1.0}"));
    assertThat(property(birthOf("$POS_ACT.X"), "engUnit")).isEqualTo("mm");
    take("$POS_ACT", Quality.BAD, null);

    assertThat(birthOf("$POS_ACT.X").getValue()).isNull();
    assertThat(property(birthOf("$POS_ACT.X"), "Quality")).isEqualTo(0);
    assertThat(property(birthOf("LIST[2]"), "Quality")).isEqualTo(500);
  }

  @Test
  void aFieldThatAStructureHasNoMoreIsBad() throws Exception {
    take("{X 1.0, Y 2.0}");

    List<DeviceMetric> touched = take("{X 3.0}");

    assertThat(touched).extracting(DeviceMetric::name).containsExactly("S.X", "S.Y");
    assertThat(device.birth()).extracting(Metric::getValue).containsExactly(3f, null);
    assertThat(touched.get(1).data().getProperties().getPropertyMap().get("Quality").getValue())
        .isEqualTo(0);
    assertThat(take("{X 3.0}")).extracting(DeviceMetric::name).containsExactly("S.X");

    take("{X 3.0, Y 4.0}");

    assertThat(device.birth()).extracting(Metric::getValue).containsExactly(3f, 4f);
  }

  @Test
  void aLateValueIsStaleButReplacesTheOneBefore() throws Exception {
    take("{X 1.0}");

    List<DeviceMetric> touched = take("S", Quality.STALE, KrlValue.parse("{X 2.0}"));

    assertThat(touched).extracting(DeviceMetric::name).containsExactly("S.X");
    assertThat(birthOf("S.X").getValue()).isEqualTo(2f);
    assertThat(property(birthOf("S.X"), "Quality")).isEqualTo(500);
  }

  @Test
  void aFieldOfTheStoreThatItsStructureHasNoMoreIsBad() throws Exception {
    device.fromStore("S.Y", MetricDataType.Float);

    take("{X 1.0}");

    assertThat(property(birthOf("S.Y"), "Quality")).isEqualTo(0);
  }
}
