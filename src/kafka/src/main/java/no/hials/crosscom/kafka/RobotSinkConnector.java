package no.hials.crosscom.kafka;

import java.time.Duration;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import no.hials.crosscom.cell.FileException;
import no.hials.crosscom.kafka.internal.ConnectorSettings;
import no.hials.crosscom.kafka.internal.ConnectorVersion;
import no.hials.crosscom.kafka.internal.PlantWatch;
import org.apache.kafka.common.KafkaException;
import org.apache.kafka.common.config.Config;
import org.apache.kafka.common.config.ConfigDef;
import org.apache.kafka.common.config.ConfigValue;
import org.apache.kafka.connect.connector.Task;
import org.apache.kafka.connect.sink.SinkConnector;
import org.jspecify.annotations.Nullable;

/**
 * Writes the variables named in records, if the configuration of the plant allows it. Each record
 * is written at most once; one that fails, or whose outcome is unknown, goes to the dead-letter
 * topic.
 */
public final class RobotSinkConnector extends SinkConnector {
  private @Nullable ConnectorSettings settings;
  private @Nullable PlantWatch plant;

  /** Creates a connector that Connect starts. */
  public RobotSinkConnector() {}

  @Override
  public String version() {
    return ConnectorVersion.own();
  }

  @Override
  public ConfigDef config() {
    return ConnectorSettings.SINK;
  }

  @Override
  public Config validate(Map<String, String> properties) {
    Config config = PlantChecks.check(super.validate(properties));
    for (ConfigValue value : config.configValues()) {
      if (value.name().equals(ConnectorSettings.WRITES) && !Boolean.TRUE.equals(value.value())) {
        value.addErrorMessage("must be true: a write can move a machine");
      }
    }
    if (config.configValues().stream().allMatch(value -> value.errorMessages().isEmpty())) {
      checkAdmin(config, properties);
    }
    return config;
  }

  /** Adds the errors in the settings of the broker client, without connecting it. */
  private static void checkAdmin(Config config, Map<String, String> properties) {
    try {
      ConnectorSettings.of(ConnectorSettings.SINK, properties).admin().close(Duration.ZERO);
    } catch (KafkaException e) {
      String reason = e.getCause() == null ? e.getMessage() : e.getCause().getMessage();
      config.configValues().stream()
          .filter(value -> value.name().equals(ConnectorSettings.BOOTSTRAP))
          .forEach(value -> value.addErrorMessage(String.valueOf(reason)));
    }
  }

  @Override
  public Class<? extends Task> taskClass() {
    return RobotSinkTask.class;
  }

  @Override
  public void start(Map<String, String> properties) {
    ConnectorSettings read = ConnectorSettings.of(ConnectorSettings.SINK, properties);
    settings = read;
    plant =
        new PlantWatch(
            read.getString(ConnectorSettings.PLANT), () -> context().requestTaskReconfiguration());
  }

  @Override
  public List<Map<String, String>> taskConfigs(int maxTasks) {
    if (settings == null || plant == null) {
      throw new IllegalStateException("not started");
    }
    List<List<String>> tasks = Collections.nCopies(maxTasks, List.of());
    try {
      return settings.tasks(plant.text(), tasks);
    } catch (FileException e) {
      // the plant of the running tasks may allow what is forbidden now
      return settings.tasksWithoutPlant(String.valueOf(e.getMessage()), tasks);
    }
  }

  @Override
  public void stop() {
    if (plant != null) {
      plant.close();
    }
  }
}
